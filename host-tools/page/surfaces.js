// host-tools/page/surfaces.js -- the panel of surfaces: nets to drag, waterlines, isophotes
// SPDX-License-Identifier: MIT
import { element, html, line, digits, facts } from './draw.js'

const ROWS = 20, TOL = 0.01, LIGHT = [0.3, -0.5, 0.81]
const start = { example: 'A bicubic patch', points: null, levels: 8, isophotes: 0, turn: -30,
    tilt: 35, net: true, mesh: false }

// Each: its points, the edges of its net, the surface of these points, columns of its grid.
const pentagon = Array.from({ length: 5 }, (_, i) => {
    const a = 2 * Math.PI * i / 5 + Math.PI / 2
    return [Math.cos(a) * 100, Math.sin(a) * 100]
})
const examples = {
    'A bicubic patch': {
        name: 'tensor 3 3',
        points: () => Array.from({ length: 16 }, (_, k) => {
            const i = Math.floor(k / 4), j = k % 4
            const z = [-4, 10, 16, -2, 6, 30, 34, 4, 2, 12, 20, -8, -6, 4, 2, -14]
            return [30 - 20 * i, 20 * j - 30, z[k]]
        }),
        edges: Array.from({ length: 16 }, (_, k) => [k % 4 < 3 ? [k, k + 1] : null,
            k < 12 ? [k, k + 4] : null]).flat().filter(Boolean),
        surface: (loft, points) => loft.tensor(points, 3, 3),
        columns: ROWS, closed: false,
    },
    'A patch with five sides': {
        name: 'gb 5 3',
        points: loft => loft.gbFromBoundary(Array.from({ length: 15 }, (_, k) => {
            const side = Math.floor(k / 3), t = (k % 3) / 3
            const [a, b] = [pentagon[side], pentagon[(side + 1) % 5]]
            const z = k % 3 ? (side % 2 ? 16 : -8) : 4 * side
            return [...a.map((x, i) => 0.4 * (x + (b[i] - x) * t)), z]
        }), 5),
        edges: [],
        surface: (loft, points) => loft.gb(points, pentagon),
        columns: 40, closed: true,
    },
}

export class Surfaces {
    constructor(loft, remember) {
        Object.assign(this, { loft, remember, past: [] })
        this.view = document.getElementById('surface-view')
        this.form = document.getElementById('surface-controls')
        for (const name of Object.keys(examples))
            this.form.example.append(html('option', name))
        this.form.addEventListener('input', event => this.changed(event.target))
        this.form.undo.addEventListener('click', () => {
            this.state.points = this.past.pop() ?? this.state.points
            this.bend()
        })
        this.view.addEventListener('pointerdown', event => this.take(event, null))
        this.view.addEventListener('pointermove', event => this.dragged(event))
        for (const end of ['pointerup', 'pointercancel'])
            this.view.addEventListener(end, () => { this.held = null })
    }

    open(state) {
        this.state = { ...start, ...state }
        if (!examples[this.state.example])
            this.state.example = start.example
        this.state.points ??= this.example().points(this.loft)
        for (const name of ['example', 'levels', 'isophotes', 'turn', 'tilt'])
            this.form[name].value = this.state[name]
        for (const name of ['net', 'mesh'])
            this.form[name].checked = this.state[name]
        this.bend()
    }

    example() { return examples[this.state.example] }

    changed(input) {
        const { name } = input
        this.state[name] = input.type === 'checkbox' ? input.checked
            : name === 'example' ? input.value : Number(input.value)
        if (name === 'example') {
            this.past = []
            this.state.points = this.example().points(this.loft)
        }
        if (['turn', 'tilt', 'net', 'mesh'].includes(name))
            this.show()
        else
            this.bend()
    }

    // The surface of these points: all that does not depend on the view.
    bend() {
        const { columns, surface } = this.example(), { points, levels, isophotes } = this.state
        const made = surface(this.loft, points)
        this.places = made.grid(ROWS, columns, LIGHT)
        const z = this.places.filter(Boolean).map(p => p.point[2])
        const [low, high] = [Math.min(...z), Math.max(...z)]
        this.box = [low, high]
        this.lines = Array.from({ length: levels }, (_, i) =>
            made.contours(low + (high - low) * (i + 0.5) / levels, TOL, ROWS, columns)).flat()
        this.light = Array.from({ length: isophotes }, (_, i) =>
            made.isophotes(LIGHT, 1 - 2 * (i + 0.5) / isophotes, 0.001, ROWS, columns)).flat()
        this.say(points)
        this.show()
        this.remember('surfaces', this.state)
    }

    // On the screen: to the right, down, towards the eye.
    seen([x, y, z]) {
        const [a, b] = [this.state.turn, this.state.tilt].map(d => d * Math.PI / 180)
        const right = x * Math.cos(a) - y * Math.sin(a), back = x * Math.sin(a) + y * Math.cos(a)
        return [right, -(back * Math.sin(b) + z * Math.cos(b)),
            z * Math.sin(b) - back * Math.cos(b)]
    }

    show() {
        const seen = this.places.map(p => p && { at: this.seen(p.point), cosine: p.cosine })
        const { points, net, mesh } = this.state, places = points.map(p => this.seen(p))
        const lift = path => path.map(p => this.seen(p))
        const parts = this.cells(seen, mesh)
        parts.push(...this.lines.map(path => line(lift(path), 'water')),
            ...this.light.map(path => line(lift(path), 'light')))
        if (net)
            parts.push(...this.example().edges.map(edge =>
                line(edge.map(k => places[k]), 'polygon')),
            ...places.map((p, k) => this.handle(p, k)))
        this.view.replaceChildren(...parts)
        for (const name of ['levels', 'isophotes'])
            this.form[`${name}-value`].value = this.state[name]
        for (const name of ['turn', 'tilt'])
            this.form[`${name}-value`].value = `${this.state[name]}°`
        this.form.undo.disabled = !this.past.length
    }

    // Cells of the grid, the farthest first.
    cells(seen, mesh) {
        const { columns } = this.example(), cells = []
        for (let i = 0; i < ROWS; i++)
            for (let j = 0; j < columns; j++) {
                const k = i * (columns + 1) + j
                const corner = [seen[k], seen[k + 1], seen[k + columns + 2], seen[k + columns + 1]]
                if (corner.every(Boolean))
                    cells.push(corner)
            }
        const mean = (corner, of) => corner.reduce((sum, c) => sum + of(c), 0) / 4
        cells.sort((a, b) => mean(a, c => c.at[2]) - mean(b, c => c.at[2]))
        return cells.map(corner => {
            const made = line(corner.map(c => c.at), mesh ? 'cell mesh' : 'cell', true)
            const bright = Math.abs(mean(corner, c => c.cosine))
            made.style.fill = made.style.stroke = `hsl(205 45% ${28 + 50 * bright}%)`
            if (mesh)
                made.style.stroke = ''
            return made
        })
    }

    handle(p, k) {
        const name = this.state.points[k].map(x => digits(x, 4)).join(', ')
        const made = element('circle', { class: 'handle', cx: p[0], cy: p[1], r: 1.3, tabindex: 0,
            role: 'button', 'aria-label': `point ${k}: ${name}` })
        made.addEventListener('pointerdown', event => {
            event.stopPropagation()
            this.take(event, k)
        })
        made.addEventListener('keydown', event => {
            const up = { ArrowUp: 1, ArrowDown: -1 }[event.key]
            if (!up)
                return
            event.preventDefault()
            this.keep()
            this.state.points[k] = this.state.points[k].map((x, i) => i === 2 ? x + up : x)
            this.bend()
            this.view.querySelectorAll('.handle')[k].focus()
        })
        return made
    }

    keep() { this.past.push(structuredClone(this.state.points)) }

    take(event, k) {
        if (k !== null)
            this.keep()
        this.held = { k, at: this.place(event) }
        this.view.setPointerCapture(event.pointerId)
        event.preventDefault()
    }

    place(event) {
        const p = new DOMPoint(event.clientX, event.clientY)
            .matrixTransform(this.view.getScreenCTM().inverse())
        return [p.x, p.y]
    }

    // A point moves in the plane of the screen; beside points the view turns.
    dragged(event) {
        if (!this.held)
            return
        const at = this.place(event), by = at.map((x, i) => x - this.held.at[i])
        this.held.at = at
        if (this.held.k === null) {
            this.state.turn = ((this.state.turn + by[0] + 540) % 360) - 180
            this.state.tilt = Math.min(90, Math.max(0, this.state.tilt + by[1]))
            for (const name of ['turn', 'tilt'])
                this.form[name].value = this.state[name] = Math.round(this.state[name])
            this.show()
            return
        }
        const [a, b] = [this.state.turn, this.state.tilt].map(d => d * Math.PI / 180)
        const back = -by[1] * Math.sin(b), right = by[0]
        const move = [right * Math.cos(a) + back * Math.sin(a),
            back * Math.cos(a) - right * Math.sin(a), -by[1] * Math.cos(b)]
        this.state.points[this.held.k] = this.state.points[this.held.k].map((x, i) =>
            Math.round(Math.min(Math.max(x + move[i], -80), 80) * 65536) / 65536)
        this.bend()
    }

    say(points) {
        const [low, high] = this.box.map(z => z.toFixed(3))
        facts(document.getElementById('surface-facts'), [
            ['control points', String(points.length)],
            ['height of the grid, mm', `${low} to ${high}`],
            ['points of waterlines', String(this.lines.flat().length)],
            ['each within', `${TOL} mm of its height`]])
        document.getElementById('surface-text').textContent = `${this.example().name}\n` +
            points.map(p => p.map(x => digits(x, 8)).join(' ')).join('\n')
    }
}
