// ports/wasm/loft.mjs -- the library in JavaScript: curves in, points out
// SPDX-License-Identifier: MIT
//
//     const loft = await load(bytes, 'q16')
//     loft.bezier([[0, 0], [1, 2], [3, 0]]).walk(64)     // [[x, y, z], ..]
//
// Coordinates are numbers; q16 rounds them to 2^-16. Structures live above __heap_base, each call
// gives back what it took.
const AXES = 3
const OK = 0

export async function load(bytes, num) {
    const { instance } = await WebAssembly.instantiate(bytes, {})
    return new Loft(instance.exports, num)
}

class Loft {
    constructor(exports, num) {
        this.exports = exports
        this.num = num
        this.size = num === 'f64' ? 8 : 4
        this.top = exports.__heap_base.value
    }

    call(name, ...given) { return this.exports[`loft_${name}_${this.num}x${AXES}`](...given) }

    // Memory for one call: `use` gets its address.
    with(bytes, use) {
        const at = (this.top + 15) & ~15
        const missing = at + bytes - this.exports.memory.buffer.byteLength
        if (missing > 0)
            this.exports.memory.grow(Math.ceil(missing / 65536))
        const before = this.top
        this.top = at + bytes
        try { return use(at) } finally { this.top = before }
    }

    put(at, points) {
        const view = new DataView(this.exports.memory.buffer)
        points.forEach((p, i) => {
            for (let k = 0; k < AXES; k++) {
                const where = at + (i * AXES + k) * this.size, x = p[k] ?? 0
                if (this.num === 'q16') view.setInt32(where, Math.round(x * 65536), true)
                else if (this.num === 'f32') view.setFloat32(where, x, true)
                else view.setFloat64(where, x, true)
            }
        })
    }

    get(at) {
        const view = new DataView(this.exports.memory.buffer)
        return Array.from({ length: AXES }, (_, k) => {
            const where = at + k * this.size
            return this.num === 'q16' ? view.getInt32(where, true) / 65536
                : this.num === 'f32' ? view.getFloat32(where, true)
                    : view.getFloat64(where, true)
        })
    }

    bezier(points) { return new Bezier(this, points) }
}

class Bezier {
    constructor(loft, points) { Object.assign(this, { loft, points }) }

    // The points of `steps` equal steps of the parameter, by additions; the start is not repeated.
    walk(steps) {
        const { loft, points } = this
        const room = points.length * AXES * loft.size
        return loft.with(room + 4096, at => {
            const curve = at + room, walk = curve + 64, point = walk + 2048
            loft.put(at, points)
            const status = loft.call('bezier_init', curve, at, points.length - 1) ||
                loft.call('forward_init', walk, curve, steps)
            if (status !== OK)
                throw new RangeError(`a curve that loft does not take: status ${status}`)
            const out = []
            while (loft.call('forward_next', walk, point))
                out.push(loft.get(point))
            return out
        })
    }
}
