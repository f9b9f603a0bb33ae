// host-tools/page/motion.js -- the panel of motion: limits as sliders, a plan as the chip makes it
// SPDX-License-Identifier: MIT
import { element, html, line, upright, digits, facts, graph } from './draw.js'
import { paths, chain, chords, sharpest } from './paths.js'
import { trapezoid } from './trapezoid.js'

const WIDTH = 120, HEIGHT = 90, TICK_HZ = 1000, SPEED = 500
const powers = ['feed', 'accel', 'jerk', 'tol', 'corner']       // sliders of a power of ten
const units = { feed: 'mm/s', accel: 'mm/s²', jerk: 'mm/s³', tol: 'mm', corner: 'mm' }
const start = { path: 'A star', feed: 2, accel: 3, jerk: 4.6, tol: -2, corner: -1, drawn: null }
const colours = [[68, 40, 130], [49, 104, 142], [33, 145, 140], [94, 201, 98], [240, 200, 40]]

export class Motion {
    constructor(loft, remember) {
        this.loft = loft
        this.remember = remember
        this.view = document.getElementById('motion-view')
        this.form = document.getElementById('motion-controls')
        this.order = 0
        this.worker = new Worker('plan_worker.js', { type: 'module' })
        this.worker.onmessage = ({ data }) => this.planned(data)
        for (const name of Object.keys(paths))
            this.form.path.append(html('option', name))
        this.form.addEventListener('input', event => this.changed(event.target))
        this.form.play.addEventListener('click', () => this.play())
        this.listen()
    }

    listen() {
        const zoom = (id, act) => document.getElementById(id).addEventListener('click', act)
        zoom('zoom-in', () => this.zoom(0.5))
        zoom('zoom-out', () => this.zoom(2))
        zoom('zoom-all', () => this.look(WIDTH / 2, HEIGHT / 2, WIDTH))
        zoom('zoom-corner', () => {
            const [x, y] = sharpest(this.path())
            this.look(x, HEIGHT - y, 60 * 10 ** this.state.corner)
        })
        this.view.addEventListener('wheel', event => {
            event.preventDefault()
            const p = this.place(event)
            this.zoom(event.deltaY > 0 ? 1.25 : 0.8, p[0], HEIGHT - p[1])
        }, { passive: false })
        this.view.addEventListener('pointerdown', event => {
            this.stroke = [this.place(event)]
            this.view.setPointerCapture(event.pointerId)
        })
        this.view.addEventListener('pointermove', event => this.stroked(event))
        this.view.addEventListener('pointerup', () => this.drawn())
    }

    open(state) {
        this.state = { ...start, ...state }
        for (const name of powers)
            this.form[name].value = this.state[name]
        if (!this.state.drawn)
            this.form.path.value = this.state.path
        this.look(WIDTH / 2, HEIGHT / 2, WIDTH)
        this.plan()
    }

    changed(input) {
        if (input.name === 'time')
            return this.moment(this.plans ? Number(input.value) * this.plans.time : 0)
        if (input.name === 'path')
            Object.assign(this.state, { path: input.value, drawn: null })
        else
            this.state[input.name] = Number(input.value)
        this.plan()
    }

    // 0 at the end of the slider: not limited.
    jerk() {
        return this.state.jerk >= Number(this.form.jerk.max) ? 0 : Math.round(10 ** this.state.jerk)
    }

    path() { return this.state.drawn ? chain(this.state.drawn) : paths[this.state.path] }
    limits() {
        const of = name => 10 ** this.state[name]
        return { speed: SPEED, accel: of('accel'), jerk: this.jerk(), tol: of('tol'),
            corner: Math.max(of('corner'), of('tol')), tickHz: TICK_HZ }
    }

    plan() {
        const feed = 10 ** this.state.feed, path = this.path().map(c => ({ p: c.p, feed }))
        this.view.setAttribute('aria-busy', 'true')
        this.worker.postMessage({ id: ++this.order, path, limits: this.limits() })
        for (const name of powers)
            this.form[`${name}-value`].value = name === 'jerk' && !this.jerk() ? 'not limited'
                : `${digits(10 ** this.state[name])} ${units[name]}`
        this.remember('motion', this.state)
    }

    planned({ id, spans, fault }) {
        if (id !== this.order)
            return
        const alert = document.getElementById('failure')
        alert.hidden = !fault
        alert.textContent = fault ?? ''
        this.view.removeAttribute('aria-busy')
        if (fault)
            return
        this.plans = { spans, ...states(spans) }
        const limits = this.limits(), feed = 10 ** this.state.feed
        this.other = trapezoid(chords(this.loft, this.path(), limits.tol), { ...limits, feed })
        this.draw()
        this.graphs(limits, feed)
        this.say()
        this.moment(Number(this.form.time.value) * this.plans.time)
    }

    draw() {
        const { tol } = this.limits(), feed = 10 ** this.state.feed
        const given = this.path(), outline = given.map((c, i) =>
            `${i ? '' : `M${c.p[0]}`}C${c.p.slice(1).map(p => p.slice(0, 2)).join(' ')}`).join('')
        const band = element('path', { class: 'drawing', d: outline })
        band.style.strokeWidth = 2 * tol
        this.spot = element('circle', { class: 'at', r: 1 })
        this.view.replaceChildren(upright(HEIGHT, band,
            element('path', { class: 'outline', d: outline }),
            ...coloured(this.plans.at, feed), this.spot))
        this.resize()
    }

    graphs(limits, feed) {
        const { at, time } = this.plans, most = Math.max(time, this.other.time)
        const box = id => document.getElementById(id)
        const peak = Math.max(feed, ...at.map(s => s.speed)) * 1.05
        graph(box('speed-view'), { x: [0, most], y: [0, peak], unit: 's',
            levels: [{ y: feed, name: `${digits(feed)} mm/s` }],
            lines: [{ kind: 'second', name: `trapezoid: ${this.other.time.toFixed(3)} s`,
                points: this.other.samples },
            { kind: 'first', name: `loft: ${time.toFixed(3)} s`,
                points: at.map(s => [s.time, s.speed]) }] })
        const pair = (id, limit, of) => graph(box(id), { x: [0, most],
            y: [-1.1 * limit, 1.1 * limit], unit: 's',
            levels: [limit, 0, -limit].map(y => ({ y, name: digits(y) })),
            lines: ['first', 'second'].map((kind, k) => ({ kind, name: 'xy'[k],
                points: at.map(s => [s.time, s[of][k]]) })) })
        pair('accel-view', limits.accel, 'accel')
        pair('jerk-view', limits.jerk || this.plans.worst.jerk, 'jerk')
    }

    say() {
        const { spans, time, length, worst } = this.plans, limits = this.limits()
        const share = (name, limit) => limit
            ? `${(100 * worst[name] / limit).toFixed(1)} % of the limit`
            : `${Math.round(worst[name])}`
        facts(document.getElementById('motion-facts'), [
            ['time of loft', `${time.toFixed(3)} s`],
            ['time of trapezoids', `${this.other.time.toFixed(3)} s, jerk not limited`],
            ['length', `${length.toFixed(1)} mm`],
            ['curves of the path', String(this.path().length)],
            ['spans on the wire', String(spans.length)],
            ['largest acceleration', share('accel', limits.accel)],
            ['largest jerk', share('jerk', limits.jerk)]])
    }

    // Show the moment `seconds` of the plan.
    moment(seconds) {
        if (!this.plans)
            return
        const { at, time } = this.plans
        const s = at[Math.max(0, at.findIndex(one => one.time >= Math.min(seconds, time)))] ?? at[0]
        this.spot.setAttribute('cx', s.p[0])
        this.spot.setAttribute('cy', s.p[1])
        this.form['time-value'].value = `${seconds.toFixed(3)} s, ${s.speed.toFixed(1)} mm/s`
    }

    play() {
        const { time } = this.plans ?? { time: 0 }
        let first = null
        const step = now => {
            first ??= now
            const seconds = Math.min((now - first) / 1000, time)
            this.form.time.value = time ? seconds / time : 0
            this.moment(seconds)
            if (seconds < time)
                requestAnimationFrame(step)
        }
        requestAnimationFrame(step)
    }

    place(event) {
        const p = new DOMPoint(event.clientX, event.clientY)
            .matrixTransform(this.view.getScreenCTM().inverse())
        return [p.x, HEIGHT - p.y]
    }

    stroked(event) {
        if (!this.stroke)
            return
        const p = this.place(event), last = this.stroke.at(-1), fine = this.width / 200
        if (Math.hypot(p[0] - last[0], p[1] - last[1]) < fine)
            return
        this.stroke.push(p)
        this.trail?.remove()
        this.trail = upright(HEIGHT, line(this.stroke, 'chord'))
        this.view.append(this.trail)
    }

    drawn() {
        const stroke = this.stroke
        this.stroke = null
        if (!stroke || stroke.length < 3)
            return
        this.state.drawn = stroke.map(p => p.map(x => Math.round(x * 1000) / 1000))
        this.plan()
    }

    look(x, y, width) {
        Object.assign(this, { middle: [x, y], width })
        this.resize()
    }
    zoom(by, x = this.middle[0], y = this.middle[1]) {
        this.look(x + (this.middle[0] - x) * by, y + (this.middle[1] - y) * by,
            Math.min(Math.max(this.width * by, 0.01), 2 * WIDTH))
    }
    resize() {
        const { middle: [x, y], width: w } = this, h = w * HEIGHT / WIDTH
        this.view.setAttribute('viewBox', `${x - w / 2} ${y - h / 2} ${w} ${h}`)
        this.spot?.setAttribute('r', w / 100)
    }
}

// What a span does at four times of it; the last also of its end.
function states(spans) {
    const at = [], worst = { accel: 0, jerk: 0 }
    let time = 0, length = 0
    spans.forEach(({ p, ticks }, i) => {
        const T = ticks / TICK_HZ
        for (const u of i + 1 < spans.length ? [0, 0.25, 0.5, 0.75] : [0, 0.25, 0.5, 0.75, 1]) {
            const state = moment(p, T, u)
            at.push({ time: time + u * T, ...state })
            for (const name of ['accel', 'jerk'])
                worst[name] = Math.max(worst[name], ...state[name].map(Math.abs))
        }
        time += T
    })
    for (let i = 1; i < at.length; i++)
        length += Math.hypot(...at[i].p.map((x, k) => x - at[i - 1].p[k]))
    return { at, time, length, worst }
}

// A cubic at u of T seconds: place, speed, acceleration, jerk.
function moment(p, T, u) {
    const of = k => {
        const [a, b, c, d] = p.map(q => q[k]), v = 1 - u
        const first = [b - a, c - b, d - c], second = [c - 2 * b + a, d - 2 * c + b]
        return [a * v ** 3 + 3 * b * u * v * v + 3 * c * u * u * v + d * u ** 3,
            3 * (first[0] * v * v + 2 * first[1] * u * v + first[2] * u * u) / T,
            6 * (second[0] * v + second[1] * u) / T ** 2, 6 * (second[1] - second[0]) / T ** 3]
    }
    const x = of(0), y = of(1)
    return { p: [x[0], y[0]], speed: Math.hypot(x[1], y[1]), accel: [x[2], y[2]],
        jerk: [x[3], y[3]] }
}

function coloured(at, feed) {
    const parts = [], shade = s => Math.round(20 * Math.min(1, s.speed / feed)) / 20
    for (let i = 0; i + 1 < at.length;) {
        let j = i + 1
        while (j + 1 < at.length && shade(at[j]) === shade(at[i]))
            j++
        const made = line(at.slice(i, j + 1).map(s => s.p), 'graph')
        made.setAttribute('stroke', colour(shade(at[i])))
        parts.push(made)
        i = j
    }
    return parts
}

function colour(share) {
    const place = share * (colours.length - 1), i = Math.min(Math.floor(place), colours.length - 2)
    return `rgb(${colours[i].map((c, k) => Math.round(c + (colours[i + 1][k] - c) * (place - i)))})`
}
