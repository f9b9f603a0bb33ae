// ports/wasm/loft.mjs -- the library in JavaScript: curves in, points, chords and motion out
// SPDX-License-Identifier: MIT
//
//     const loft = await load(bytes, 'q16')
//     loft.bezier([[0, 0], [1, 2], [3, 0]]).walk(64)     // [[x, y, z], ..]
//
// Coordinates are numbers; q16 rounds them to 2^-16. Structures live above __heap_base, each call
// gives back what it took. Their sizes and fields come from ports/wasm/layout.c.
const AXES = 3
const OK = 0, ERR_SPACE = -3     // num/status.h
const remedies = { [-1]: 'a count, degree or parameter is out of range',
    [-2]: 'the numbers do not fit: scale it, or take fewer steps' }

export const shapes = ['point', 'line', 'parabola', 'serpentine', 'cusp', 'loop',
    'cusp at infinity']

export async function load(bytes, num) {
    const { instance } = await WebAssembly.instantiate(bytes, {})
    return new Loft(instance.exports, num)
}

// A curve, a limit or a path that the library refuses, with its status.
export class Refused extends RangeError {
    constructor(what, status) {
        super(`loft does not take ${what}: ${remedies[status] ?? `status ${status}`}`)
        this.status = status
    }
}

class Loft {
    constructor(exports, num) {
        this.exports = exports
        this.num = num
        this.size = num === 'f64' ? 8 : 4
        this.top = exports.__heap_base.value
        this.layout = this.readLayout()
    }

    call(name, ...given) { return this.exports[`loft_${name}_${this.num}x${AXES}`](...given) }

    get view() { return new DataView(this.exports.memory.buffer) }

    // { loft_plan: bytes, 'loft_limits.tol': bytes, .. }
    readLayout() {
        const { view } = this, layout = {}, bytes = new Uint8Array(view.buffer)
        for (let at = this.exports.loft_layout.value; view.getUint32(at, true); at += 8) {
            const name = view.getUint32(at, true), end = bytes.indexOf(0, name)
            layout[new TextDecoder().decode(bytes.subarray(name, end))] =
                view.getUint32(at + 4, true)
        }
        return layout
    }

    // Memory for so many bytes each, until `top` is what it was before.
    take(sizes) {
        const at = sizes.map(size => {
            const place = (this.top + 15) & ~15
            this.top = place + size
            return place
        })
        const missing = this.top - this.exports.memory.buffer.byteLength
        if (missing > 0)
            this.exports.memory.grow(Math.ceil(missing / 65536))
        return at
    }

    // Memory for one call: `use` gets an address for each number of bytes.
    with(sizes, use) {
        const before = this.top
        try { return use(...this.take(sizes)) } finally { this.top = before }
    }

    // A loft_real, and a loft_unit, as arguments.
    real(x) { return this.num === 'q16' ? Math.round(x * 65536) : x }
    unit(t) { return this.num === 'q16' ? Math.round(t * 2 ** 24) : t }

    putReal(at, x) {
        const { view } = this
        if (this.num === 'q16') view.setInt32(at, this.real(x), true)
        else if (this.num === 'f32') view.setFloat32(at, x, true)
        else view.setFloat64(at, x, true)
    }

    getNumber(at, one) {
        const { view } = this
        return this.num === 'q16' ? view.getInt32(at, true) / one
            : this.num === 'f32' ? view.getFloat32(at, true)
                : view.getFloat64(at, true)
    }
    getReal(at) { return this.getNumber(at, 65536) }
    getUnit(at) { return this.getNumber(at, 2 ** 24) }

    put(at, points) {
        points.forEach((p, i) => {
            for (let k = 0; k < AXES; k++)
                this.putReal(at + (i * AXES + k) * this.size, p[k] ?? 0)
        })
    }

    get(at) { return Array.from({ length: AXES }, (_, k) => this.getReal(at + k * this.size)) }
    getAll(at, count) {
        return Array.from({ length: count }, (_, i) => this.get(at + i * this.layout.loft_vec))
    }

    getAcc(at) {
        const { view } = this
        return this.num === 'q16' ? Number(view.getBigInt64(at, true)) / 2 ** 32
            : view.getFloat64(at, true)
    }

    bezier(points) { return new Bezier(this, points) }

    // A patch of (m + 1) (n + 1) points, row by row.
    tensor(points, m, n) {
        return new Surface(this, points, (surface, p, at) => {
            this.check('this patch', this.call('tensor_init', at, p, m, n))
            this.call('surface_from_tensor', surface, at)
        }, [this.layout.loft_tensor])
    }

    // A generalized Bezier patch over a polygon, with Wachspress coordinates: points in the order
    // of polygon/gb.h.
    gb(points, polygon, degree = 3) {
        const { layout } = this, sides = polygon.length
        return new Surface(this, points, (surface, p, patch, spots, domain, disk) => {
            polygon.flat().forEach((x, i) => this.putReal(spots + i * this.size, x))
            const wachspress = this.view.getUint32(this.exports.loft_wachspress.value, true)
            this.check('this polygon', this.call('domain_init', domain, spots, sides))
            this.check('this patch', this.call('gb_init', patch, p, sides, degree) ||
                this.call('disk_from_gb', disk, patch, domain, wachspress))
            this.call('surface_from_disk', surface, disk)
        }, [layout.loft_gb, sides * layout.loft_spot, layout.loft_domain, layout.loft_disk])
    }
    gbCount(sides, degree = 3) { return this.call('gb_count', sides, degree) }

    // The points of a net from its boundary, side by side without the last point of each.
    gbFromBoundary(boundary, sides, degree = 3) {
        const count = this.gbCount(sides, degree), bytes = this.layout.loft_vec
        return this.with([boundary.length * bytes, count * bytes], (given, out) => {
            this.put(given, boundary)
            this.check('this boundary', this.call('gb_from_boundary', given, sides, degree, out))
            return this.getAll(out, count)
        })
    }

    // Spans of a motion along cubics: { ticks, p: [[x, y, z] * 4] }, in order.
    // path: [{ p: [[x, y] * 4], feed }], limits: { speed, accel, jerk, tol, corner, tickHz }, in
    // mm and s, the same for all axes. A jerk of 0 is not limited.
    *plan(path, limits, knots = 352) {
        const { layout } = this, moves = 64, before = this.top
        const [limit, plan, chain, table, move, span] = this.take([
            layout.loft_limits, layout.loft_plan,
            moves * layout.loft_move, knots * layout.loft_knot, layout.loft_move, layout.loft_span])
        try {
            this.putLimits(limit, limits)
            this.check('these limits', this.call('plan_init', plan, limit, chain, moves, table,
                knots))
            yield* this.spans(path, plan, move, span)
        } finally { this.top = before }
    }

    putLimits(at, limits) {
        const field = name => at + this.layout[`loft_limits.${name}`]
        for (let k = 0; k < AXES; k++) {
            this.putReal(field('max_speed') + k * this.size, limits.speed)
            this.putReal(field('max_accel') + k * this.size, limits.accel)
            this.view.setUint32(field('max_jerk') + 4 * k, limits.jerk, true)
        }
        this.putReal(field('tol'), limits.tol)
        this.putReal(field('corner'), limits.corner)
        this.putReal(field('exact'), 0)
        this.view.setUint16(field('tick_hz'), limits.tickHz, true)
    }

    *spans(path, plan, move, span) {
        const SPAN = 0, REST = 2
        let pushed = 0
        for (;;) {
            for (; pushed < path.length; pushed++) {
                this.put(move, path[pushed].p)
                this.putReal(move + this.layout['loft_move.feed'], path[pushed].feed)
                const status = this.call('plan_push', plan, move)
                if (status === ERR_SPACE)
                    break
                this.check(`curve ${pushed + 1}`, status)
            }
            if (pushed === path.length)
                this.call('plan_end', plan)
            const state = this.call('plan_next', plan, span)
            if (state === REST)
                return
            if (state === SPAN)
                yield { ticks: this.view.getUint16(span + this.layout['loft_span.ticks'], true),
                    p: this.getAll(span, 4) }
        }
    }

    check(what, status) {
        if (status !== OK)
            throw new Refused(what, status)
    }
}

// A surface of any kind over u and v in 0..1.
class Surface {
    constructor(loft, points, make, sizes) { Object.assign(this, { loft, points, make, sizes }) }

    use(sizes, use) {
        const { loft, points } = this, { layout } = loft, count = this.sizes.length
        return loft.with([points.length * layout.loft_vec, layout.loft_surface, ...this.sizes,
            ...sizes], (p, surface, ...at) => {
            loft.put(p, points)
            this.make(surface, p, ...at.slice(0, count))
            return use(surface, ...at.slice(count))
        })
    }

    // (rows + 1) (columns + 1) places: { point, cosine } of the normal and the light.
    grid(rows, columns, light) {
        const { loft } = this, { layout } = loft
        return this.use([layout.loft_vec, layout.loft_level, layout.loft_vec, 8],
            (surface, way, level, point, off) => {
                loft.put(way, [light])
                loft.check('this light', loft.call('level_light', level, way, 0))
                return Array.from({ length: (rows + 1) * (columns + 1) }, (_, k) => {
                    const i = Math.floor(k / (columns + 1)), j = k % (columns + 1)
                    const status = loft.call('level_at', level, surface, loft.unit(i / rows),
                        loft.unit(j / columns), point, off)
                    return status < 0 ? null : { point: loft.get(point), cosine: loft.getAcc(off) }
                })
            })
    }

    // The lines where z is `height`: [[[x, y, z], ..], ..].
    contours(height, tol, rows, columns) {
        return this.lines((state, surface, memory, bytes) => this.loft.call('contour_init', state,
            surface, 2, this.loft.real(height), this.loft.real(tol), rows, columns, memory, bytes),
        rows, columns)
    }

    // The lines where the normal and the light have this cosine.
    isophotes(light, cosine, tol, rows, columns) {
        const { loft } = this, { layout } = loft
        return loft.with([layout.loft_vec, layout.loft_level], (way, level) => {
            loft.put(way, [light])
            loft.check('this light', loft.call('level_light', level, way, loft.real(cosine)))
            return this.lines((state, surface, memory, bytes) => loft.call('contour_init_level',
                state, surface, level, loft.real(tol), rows, columns, memory, bytes), rows, columns)
        })
    }

    lines(init, rows, columns) {
        const { loft } = this, { layout } = loft, OVER = 0, START = 1
        const bytes = Math.ceil(((rows + 1) * (columns + 1) + 2 * rows * columns + 7) / 8)
        return this.use([layout.loft_contour, bytes, layout.loft_vec],
            (surface, state, memory, point) => {
                const out = []
                loft.check('this surface', init(state, surface, memory, bytes))
                for (let step; (step = loft.call('contour_next', state, point)) !== OVER;) {
                    if (step === START)
                        out.push([])
                    out.at(-1).push(loft.get(point))
                }
                return out
            })
    }
}

class Bezier {
    constructor(loft, points) { Object.assign(this, { loft, points, degree: points.length - 1 }) }

    // The curve in memory, and room for `sizes`.
    use(sizes, use) {
        const { loft, points } = this
        return loft.with([points.length * loft.layout.loft_vec, loft.layout.loft_bezier, ...sizes],
            (p, curve, ...at) => {
                loft.put(p, points)
                this.check(loft.call('bezier_init', curve, p, this.degree))
                return use(curve, ...at)
            })
    }

    check(status) { this.loft.check('this curve', status) }

    // The points of `steps` equal steps of the parameter, by additions; the start is not repeated.
    walk(steps) { return this.differences(steps).map(row => row.point) }

    // The same, each with the state that leads to the next: d[axis] = [d0, d1, ..], in q16 BigInts
    // in units of 2^-32.
    differences(steps, rows = Infinity) {
        const { loft } = this, { layout } = loft
        return this.use([layout.loft_forward, layout.loft_vec], (curve, walk, point) => {
            this.check(loft.call('forward_init', walk, curve, steps))
            const out = []
            while (loft.call('forward_next', walk, point))
                out.push({ point: loft.get(point), d: out.length < rows ? this.state(walk) : null })
            return out
        })
    }

    state(walk) {
        const { loft, degree } = this, { view, layout } = loft
        return Array.from({ length: AXES }, (_, axis) =>
            Array.from({ length: degree + 1 }, (_, k) => {
                const at = walk + layout['loft_forward.axis'] + axis * layout.loft_walk + 8 * k
                return loft.num === 'q16' ? view.getBigInt64(at, true) : view.getFloat64(at, true)
            }))
    }

    eval(t) {
        const { loft } = this
        return this.use([loft.layout.loft_vec], (curve, out) => {
            loft.call('bezier_eval', out, curve, loft.unit(t))
            return loft.get(out)
        })
    }

    deriv(k, t) {
        const { loft } = this
        return this.use([loft.layout.loft_vec], (curve, out) => {
            this.check(loft.call('bezier_deriv', curve, k, loft.unit(t), out))
            return loft.get(out)
        })
    }

    // The curvature at t, > 0 where it turns left, and the direction; null where it stands.
    curvature(t) {
        const { loft } = this
        return this.use([loft.size, loft.layout.loft_vec], (curve, bend, way) => {
            const status = loft.call('bezier_curvature_vec', curve, loft.unit(t), bend, way)
            return status === OK ? { curvature: loft.getReal(bend), tangent: loft.get(way) } : null
        })
    }

    split(t) {
        const { loft } = this, count = this.points.length, bytes = count * loft.layout.loft_vec
        return this.use([bytes, bytes], (curve, left, right) => {
            this.check(loft.call('bezier_split', curve, loft.unit(t), left, right))
            return [loft.getAll(left, count), loft.getAll(right, count)]
        })
    }

    elevate(times = 1) {
        const { loft } = this, count = this.points.length + times
        return this.use([count * loft.layout.loft_vec], (curve, out) => {
            this.check(loft.call('bezier_elevate', curve, times, out))
            return loft.getAll(out, count)
        })
    }

    // Of a cubic: the ends of the longest chords within tol.
    flatten(tol) {
        const { loft } = this, { layout } = loft
        return loft.with([layout.loft_cubic, layout.loft_flatten, layout.loft_vec],
            (cubic, state, point) => {
                const out = []
                loft.put(cubic, this.points)
                this.check(loft.call('flatten_init', state, cubic, loft.real(tol)))
                while (loft.call('flatten_next', state, point))
                    out.push(loft.get(point))
                return out
            })
    }

    // Of a cubic: { kind, inflections: [t], cusp: [t], loop: [t, t] }, decided exactly.
    shape() {
        const { loft } = this, { layout } = loft
        return loft.with([layout.loft_cubic, layout.loft_shape], (cubic, shape) => {
            const at = name => shape + layout[`loft_shape.${name}`]
            const units = (name, count) => Array.from({ length: count },
                (_, i) => loft.getUnit(at(name) + i * loft.size))
            loft.put(cubic, this.points)
            this.check(loft.call('cubic_shape', cubic, shape))
            const byte = name => loft.view.getUint8(at(name))
            return { kind: shapes[loft.view.getInt32(at('kind'), true)],
                inflections: units('inflection', byte('inflections')),
                cusp: units('cusp', byte('cusps')),
                loop: units('loop', 2 * byte('loops')) }
        })
    }
}
