// host-tools/page/curves.js -- the panel of curves: drag control points, see what the integers do
// SPDX-License-Identifier: MIT
import { element, html, line, upright, digits, facts, graph } from './draw.js'
import { exactPoints, naiveFixed, naiveFloat, off } from './exact.js'

const WIDTH = 120, HEIGHT = 90, ROWS = 9, DEGREE_MAX = 5
const examples = {
    'An arch': [[15.3, 14.7], [31.1, 79.3], [88.9, 80.6], [104.7, 15.2]],
    'A wave': [[10.1, 45.3], [45.7, 88.2], [74.3, 1.9], [109.9, 44.8]],
    'A loop': [[15.2, 15.4], [118.6, 85.1], [1.4, 84.9], [104.8, 15.6]],
    'A cusp': [[20, 20], [100, 80], [20, 80], [100, 20]],
    'A parabola': [[10.3, 10.7], [59.9, 88.9], [110.2, 11.1]],
    'Degree 5': [[10.1, 20.3], [20.7, 88.3], [50.2, 1.9], [70.6, 88.8], [95.3, 1.1], [112.4, 70.9]],
}
const start = { points: examples['An arch'], t: 0.4, steps: 6, tol: -0.5,
    construction: true, walk: true, chords: false, comb: false }

export class Curves {
    constructor(loft, remember) {
        this.loft = loft
        this.remember = remember
        this.view = document.getElementById('curve-view')
        this.form = document.getElementById('curve-controls')
        this.past = []
        for (const name of Object.keys(examples))
            this.form.example.append(html('option', name))
        this.form.addEventListener('input', event => this.changed(event.target))
        for (const name of ['elevate', 'split', 'undo'])
            this.form[name].addEventListener('click', () => this[name]())
        this.view.addEventListener('pointermove', event => this.dragged(event))
        for (const end of ['pointerup', 'pointercancel'])
            this.view.addEventListener(end, () => { this.held = null })
    }

    // What the address says; anything else is the start.
    open(state) {
        this.state = { ...structuredClone(start), ...state }
        for (const name of ['t', 'steps', 'tol'])
            this.form[name].value = this.state[name]
        for (const name of ['construction', 'walk', 'chords', 'comb'])
            this.form[name].checked = this.state[name]
        this.show()
    }

    changed(input) {
        if (input.name === 'example')
            this.replace(structuredClone(examples[input.value]))
        else
            this.state[input.name] = input.type === 'checkbox' ? input.checked : Number(input.value)
        this.show()
    }

    replace(points) {
        this.past.push(structuredClone(this.state.points))
        this.state.points = points
    }

    elevate() {
        this.replace(this.loft.bezier(this.state.points).elevate().map(p => p.slice(0, 2)))
        this.show()
    }

    split() {
        this.replace(this.loft.bezier(this.state.points).split(this.state.t)[0]
            .map(p => p.slice(0, 2)))
        this.show()
    }

    undo() {
        this.state.points = this.past.pop() ?? this.state.points
        this.show()
    }

    // Where the pointer is in the drawing.
    place(event) {
        const p = new DOMPoint(event.clientX, event.clientY)
            .matrixTransform(this.view.getScreenCTM().inverse())
        return [p.x, HEIGHT - p.y]
    }

    dragged(event) {
        if (this.held == null)
            return
        this.move(this.held, this.place(event))
    }

    move(i, [x, y]) {
        const inside = (v, most) => Math.round(Math.min(Math.max(v, 0), most) * 65536) / 65536
        this.state.points[i] = [inside(x, WIDTH), inside(y, HEIGHT)]
        this.show(i)
    }

    handle(i, p) {
        const made = element('circle', { class: 'handle', cx: p[0], cy: p[1], r: 1.6, tabindex: 0,
            role: 'button', 'aria-label': `point ${i}: ${digits(p[0], 4)}, ${digits(p[1], 4)}` })
        made.addEventListener('pointerdown', event => {
            this.past.push(structuredClone(this.state.points))
            this.held = i
            this.view.setPointerCapture(event.pointerId)
            event.preventDefault()
        })
        made.addEventListener('keydown', event => {
            const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1],
                ArrowDown: [0, -1] }[event.key]
            if (!way)
                return
            event.preventDefault()
            const by = event.shiftKey ? 1 / 65536 : 1
            this.move(i, this.state.points[i].map((x, k) => x + way[k] * by))
            this.view.querySelectorAll('.handle')[i].focus()
        })
        return made
    }

    show() {
        const { points, steps } = this.state, curve = this.loft.bezier(points)
        const walked = curve.degree <= DEGREE_MAX ? this.steps(curve, 2 ** steps) : 0
        this.draw(curve, walked ? curve.walk(walked) : [])
        this.errors(points, walked)
        this.table(curve, walked)
        this.say(curve, walked)
        this.texts(points)
        this.form.elevate.disabled = points.length > DEGREE_MAX
        this.form.undo.disabled = !this.past.length
        this.remember('curves', this.state)
    }

    // As many steps as the law of ranges allows (curve/forward.h).
    steps(curve, wanted) {
        const most = [0, 65536, 65536, 1024, 256, 64][curve.degree]
        return Math.min(wanted, most)
    }

    draw(curve, walk) {
        const { state } = this, { points } = state
        const flat = Array.from({ length: 201 }, (_, i) => curve.eval(i / 200))
        const parts = [line(points, 'polygon')]
        if (state.comb)
            parts.push(...this.comb(curve))
        parts.push(line(flat, 'curve'))
        if (state.chords && curve.degree === 3)
            parts.push(line([points[0], ...curve.flatten(10 ** state.tol)], 'chord'))
        if (state.construction)
            parts.push(...this.construction(points, state.t))
        if (state.walk && walk.length <= 256)
            parts.push(...walk.map(p => element('circle', { class: 'dot', cx: p[0], cy: p[1],
                r: walk.length > 64 ? 0.4 : 0.7 })))
        const at = curve.eval(state.t)
        parts.push(element('circle', { class: 'at', cx: at[0], cy: at[1], r: 1.2 }),
            ...points.map((p, i) => this.handle(i, p)))
        this.view.replaceChildren(upright(HEIGHT, ...parts))
    }

    construction(points, t) {
        const parts = []
        for (let row = points; row.length > 1;) {
            row = row.slice(1).map((p, i) => p.map((x, k) => row[i][k] + (x - row[i][k]) * t))
            if (row.length > 1)
                parts.push(line(row, 'step'))
        }
        return parts
    }

    comb(curve) {
        const teeth = [], tips = []
        for (let i = 0; i <= 80; i++) {
            const t = i / 80, p = curve.eval(t), bend = curve.curvature(t)
            if (!bend)
                continue
            const { curvature, tangent } = bend, high = Math.max(-25, Math.min(25, curvature * 150))
            const tip = [p[0] + tangent[1] * high, p[1] - tangent[0] * high]
            teeth.push(line([p, tip], 'comb'))
            tips.push(tip)
        }
        return [...teeth, line(tips, 'comb')]
    }

    // Of x and y: the larger error of each point.
    errors(points, n) {
        const svg = document.getElementById('error-view')
        if (!n) {
            svg.replaceChildren(element('text', { x: 300, y: 120, 'text-anchor': 'middle' },
                'Walks go to degree 5.'))
            return
        }
        const power = BigInt(n) ** BigInt(points.length - 1)
        const axes = [0, 1].map(k => points.map(p => p[k]))
        const exact = axes.map(control => exactPoints(control, n))
        const curve = this.loft.bezier(points).walk(n)
        const graphOf = (value, kind, name) => {
            const worst = Array.from({ length: n }, (_, j) => Math.max(
                ...[0, 1].map(k => Math.abs(off(value(k, j), exact[k][j], power)))))
            return { kind, name: `${name}: at most ${digits(Math.max(...worst), 3)}`,
                points: worst.map((e, j) => [j + 1, Math.max(e, 0.01)]) }
        }
        const fixed = axes.map(control => naiveFixed(control, n))
        const single = axes.map(control => naiveFloat(control, n))
        const lines = [graphOf((k, j) => curve[j][k] * 65536, 'first', 'loft'),
            graphOf((k, j) => fixed[k][j], 'second', 'Q16.16 differences'),
            graphOf((k, j) => single[k][j], 'third', 'float differences')]
        const most = Math.max(10, ...lines.flatMap(one => one.points.map(p => p[1])))
        graph(svg, { x: [1, n], y: [0.01, most], scale: Math.log10, unit: 'steps', lines,
            band: [0.01, 0.5], levels: [0.01, 0.5, 1, 10, 100, 1000, 10000].filter(y => y <= most)
                .map(y => ({ y, name: String(y), kind: 'axis' })) })
    }

    table(curve, n) {
        const table = document.getElementById('difference-table')
        const head = html('tr', html('th', 'step'), html('th', 'x in 2^-16'),
            ...Array.from({ length: curve.degree + 1 }, (_, k) => html('th', `d${k}`)))
        const rows = n ? curve.differences(n, ROWS).slice(0, ROWS) : []
        table.replaceChildren(head, ...rows.map((row, j) => html('tr', html('td', String(j + 1)),
            html('td', String(Math.round(row.point[0] * 65536))),
            ...row.d[0].map(d => html('td', String(d))))))
    }

    say(curve, n) {
        const { t, tol } = this.state, p = curve.eval(t), form = this.form
        form['t-value'].value = digits(t, 3)
        form['steps-value'].value = n || 'none'
        form['tol-value'].value = `${digits(10 ** tol)} mm`
        const terms = [['degree', String(curve.degree)],
            ['point at t', `${p[0].toFixed(5)}, ${p[1].toFixed(5)}`]]
        const bend = curve.curvature(t)
        terms.push(['radius at t', !bend ? 'it stands' : !bend.curvature ? 'straight'
            : `${digits(1 / Math.abs(bend.curvature))} mm`])
        if (curve.degree === 3) {
            const shape = curve.shape()
            terms.push(['kind of the whole curve', shape.kind])
            for (const name of ['inflections', 'cusp', 'loop'])
                if (shape[name].length)
                    terms.push([`${name} at t`, shape[name].map(x => x.toFixed(4)).join(', ')])
            terms.push(['chords', String(curve.flatten(10 ** tol).length)])
        }
        facts(document.getElementById('curve-facts'), terms)
    }

    texts(points) {
        const text = points.map(p => p.map(x => digits(x, 8)).join(' ')).join('\n  ')
        document.getElementById('loft-text').textContent = `bezier ${points.length - 1}\n  ${text}`
        document.getElementById('c-text').textContent = `static const loft_vec p[] = {\n` +
            points.map(p => `    { { ${p.map(x => `LOFT_REAL(${digits(x, 8)})`).join(', ')} } },`)
                .join('\n') + '\n};'
    }
}
