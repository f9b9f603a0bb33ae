// host-tools/page/machine.js -- the panel of a server: drawing, plan, machine and job
// SPDX-License-Identifier: MIT
import { html, facts } from './draw.js'
import { Preview } from './preview.js'
import { settings } from './settings.js'
import { Store } from './store.js'

const HELD = 250        // ms until a pressed key is a held one
const STILL = 200       // ms between two words that it is held

const machineWords = { none: 'no machine: begin with loft serve --port PORT', away:
    'no machine answers', connects: 'connecting', idle: 'ready', moves: 'moves', job: 'draws',
    busy: 'has a job: Start goes on with it', held: 'is held in a job: Start goes on with it',
    fault: 'has a fault: restart it' }
const jobWords = { none: 'no job yet', begins: 'begins', draws: 'draws', holds: 'slows down',
    held: 'held', pause: 'pause', aborts: 'ends', waits: 'waits for data', plans: 'plans',
    over: 'over' }

function clock(seconds) {
    const s = Math.max(0, Math.round(seconds))
    return s < 3600 ? `${Math.floor(s / 60)}:${String(s % 60).padStart(2, '0')}`
        : `${Math.floor(s / 3600)}:${String(Math.floor(s / 60) % 60).padStart(2, '0')} h`
}

export class Machine {
    constructor() {
        this.state = {}
        this.part = name => document.getElementById(`machine-${name}`)
        this.preview = new Preview(this.part('view'))
        this.store = new Store()
        this.store.watch((parts, store) => this.show(new Set(parts), store))
        this.buttons()
        this.files()
        this.jog()
        this.slider()
        this.keys()
    }

    open() { this.preview.show() }

    on(name, call) { this.part(name).addEventListener('click', call) }

    buttons() {
        const ask = (name, method, params) =>
            this.on(name, () => this.store.ask(method, params?.()))
        ask('hold', 'job.hold')
        ask('start', 'job.start')
        ask('resume', 'job.resume')
        ask('abort', 'job.abort')
        ask('take', 'control.take')
        ask('connect', 'machine.connect')
        ask('home', 'machine.home')
        ask('unlock', 'machine.unlock')
        ask('zero', 'machine.zero', () => ({ axes: 'xy' }))
        ask('zero-z', 'machine.zero', () => ({ axes: 'z' }))
        ask('park', 'machine.park')
        ask('pen-up', 'machine.pen', () => ({ pen: 'up' }))
        ask('pen-down', 'machine.pen', () => ({ pen: 'down' }))
        ask('close', 'drawing.close')
        this.on('zoom-in', () => this.preview.zoom(1.5))
        this.on('zoom-out', () => this.preview.zoom(1 / 1.5))
        this.on('zoom-all', () => this.preview.fit())
        this.part('override').addEventListener('change', event =>
            this.store.ask('job.override', { percent: Number(event.target.value) }))
    }

    files() {
        const stage = this.part('stage'), input = this.part('file')
        input.addEventListener('change', () => {
            if (input.files[0]) this.store.open(input.files[0])
            input.value = ''
        })
        for (const kind of ['dragover', 'drop'])
            stage.addEventListener(kind, event => event.preventDefault())
        stage.addEventListener('drop', event => {
            const [file] = event.dataTransfer.files
            if (file) this.store.open(file)
        })
    }

    // A tap moves by the step; a key that stays down moves until it is released.
    jog() {
        let timer = null, held = false
        const press = way => {
            if (timer) return
            timer = setTimeout(() => {
                held = true
                this.store.ask('machine.jog', { way, feed: this.feed() })
                timer = setInterval(() => this.store.ask('machine.jog-on'), STILL)
            }, HELD)
        }
        const release = way => {
            if (!timer) return
            clearTimeout(timer)
            clearInterval(timer)
            timer = null
            if (held) this.store.ask('machine.jog-off')
            else this.store.ask('machine.jog', { way, feed: this.feed(),
                size: Number(this.part('step').value) })
            held = false
        }
        for (const button of document.querySelectorAll('[data-way]')) {
            const { way } = button.dataset
            button.addEventListener('pointerdown', event => {
                button.setPointerCapture(event.pointerId)
                press(way)
            })
            for (const end of ['pointerup', 'pointercancel'])
                button.addEventListener(end, () => release(way))
            button.addEventListener('contextmenu', event => event.preventDefault())
        }
        const ways = { ArrowRight: 'x+', ArrowLeft: 'x-', ArrowUp: 'y+', ArrowDown: 'y-',
            PageUp: 'z+', PageDown: 'z-' }
        const pad = this.part('jog')
        pad.addEventListener('keydown', event => {
            const way = ways[event.key] ?? (' Enter'.includes(event.key)
                ? event.target.dataset.way : null)
            if (!way) return
            event.preventDefault()
            if (!event.repeat) press(way)
        })
        pad.addEventListener('keyup', event => {
            const way = ways[event.key] ?? event.target.dataset.way
            if (way) release(way)
        })
        pad.addEventListener('focusout', () => { if (held) release('') })
    }

    feed() { return Number(this.part('feed').value) }

    slider() {
        this.part('time').addEventListener('input', event => {
            this.preview.time(Number(event.target.value))
            this.part('time-value').textContent = clock(Number(event.target.value))
        })
    }

    // H holds, wherever the focus is, but where one writes.
    keys() {
        document.addEventListener('keydown', event => {
            if (event.key.toLowerCase() !== 'h' || event.ctrlKey || event.metaKey ||
                    /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName))
                return
            this.store.ask('job.hold')
        })
    }

    show(parts, store) {
        const { state } = store
        if (parts.has('options'))
            this.give = settings(this.part('settings'), store.options, given =>
                store.ask('drawing.options', given))
        if (parts.has('drawing') || parts.has('options')) this.showDrawing(state.drawing)
        if (parts.has('plan') || parts.has('moves')) this.showPlan(state.plan, store, parts)
        if (parts.has('machine') || parts.has('here')) this.showMachine(state.machine, store)
        if (parts.has('job') || parts.has('moves')) this.showJob(state.job, store)
        if (parts.has('lines')) this.showLines(state.lines)
        this.showControl(store)
    }

    showDrawing({ name, options }) {
        this.part('name').textContent = name ?? 'Drop a drawing here, or choose one'
        this.part('close').hidden = !name
        this.give?.(options)
    }

    showPlan(plan, store, parts) {
        if (parts.has('moves')) {
            this.preview.set(store.moves, plan.facts)
            this.preview.progress(0, store.state.machine?.at ?? null)
            const slider = this.part('time')
            slider.max = plan.facts?.seconds ?? 0
            slider.value = 0
            this.part('time-value').textContent = clock(0)
        }
        const f = plan.facts
        this.part('plan').dataset.state = plan.state
        const words = { none: 'no drawing', plans: `plans, ${Math.round(100 * plan.part)} %`,
            ready: 'planned', failed: 'cannot be planned' }
        const rows = [['Plan', words[plan.state]]]
        if (f && plan.state === 'ready')
            rows.push(['Time', clock(f.seconds)],
                ['Size', `${[2, 3].map(i => (f.box[i] - f.box[i - 2]).toFixed(1)).join(' x ')} mm`],
                ['Drawn', `${(f.drawn / 1000).toFixed(2)} m, ${f.curves} curves`],
                ['Travelled', `${(f.travelled / 1000).toFixed(2)} m`])
        facts(this.part('plan'), rows)
        this.part('warnings').replaceChildren(...plan.messages.map(m => this.message(m)))
    }

    message(m) {
        const where = m.file ? `${m.file}${m.line ? `:${m.line}` : ''}: ` : ''
        const item = html('li', `${where}${m.what}${m.remedy ? `: ${m.remedy}` : ''}`)
        item.className = m.code ? 'error' : 'warning'
        return item
    }

    showMachine(machine, store) {
        const word = store.here ? machineWords[machine.state] : 'the server does not answer'
        const status = this.part('status')
        status.textContent = word
        status.dataset.state = store.here ? machine.state : 'away'
        this.part('port').textContent = machine.port ?? ''
        this.part('connect').hidden = machine.state !== 'away'
        this.part('closed').textContent = [machine.closed && `closed: ${machine.closed}`,
            machine.doubt && 'its place is in doubt: home it, or zero it']
            .filter(Boolean).join('; ')
        this.part('unlock').hidden = !machine.closed
        this.preview.table = machine.table
        if (machine.at) this.showPlace(machine.at)
    }

    showPlace(at) {
        at.forEach((x, i) => { this.part('xyz'[i]).textContent = x.toFixed(2) })
        if (!this.timed()) this.preview.progress(this.preview.done, at)
    }

    timed() { return Number(this.part('time').value) > 0 && !this.busy }

    showJob(job, store) {
        this.busy = !['none', 'over'].includes(job.state)
        const status = this.part('job')
        const failed = job.state === 'over' && job.code !== 0
        status.textContent = failed ? 'ended' : jobWords[job.state] ?? job.state
        status.dataset.state = failed ? 'failed' : job.state
        this.part('result').textContent = job.state === 'over' ? job.result : job.pause != null
            ? job.pause || 'the program pauses' : ''
        this.part('result').classList.toggle('pause', job.pause != null)
        this.part('bar').value = job.state === 'over' && !failed ? 1 : job.part ?? 0
        this.part('left').textContent = job.part != null
            ? `${(100 * job.part).toFixed(0)} %, ${clock(job.left)} left` : ''
        this.part('feed-now').textContent = job.feed != null
            ? `${job.feed.toFixed(1)} mm/s, queue ${job.queued}` : ''
        if (job.override && document.activeElement !== this.part('override'))
            this.part('override').value = job.override
        this.part('override-value').textContent = `${job.override ?? 100} %`
        if (this.busy && job.at) {
            job.at.forEach((x, i) => { this.part('xyz'[i]).textContent = x.toFixed(2) })
            const parts = store.state.plan.facts?.parts
            if (parts && store.moves)
                this.preview.progress(this.preview.first(job.parts[0], parts) + job.moves, job.at)
        } else if (job.state === 'over' && !failed && store.moves && this.was) {
            this.preview.progress(this.preview.moves.length, this.preview.at)
        }
        this.was = this.busy
        this.part('time').disabled = this.busy
    }

    showLines(lines) {
        const list = this.part('lines')
        list.replaceChildren(...lines.slice(-12).reverse().map(l => l.message
            ? this.message(l.message) : html('li', l.text)))
    }

    showControl(store) {
        const { job, machine, plan, control } = store.state
        const mine = store.here && (store.controls || control?.holder == null)
        const rests = mine && machine?.state === 'idle'
        const set = (name, on) => { this.part(name).disabled = !on }
        for (const name of ['home', 'zero', 'zero-z', 'park', 'pen-up', 'pen-down'])
            set(name, rests)
        for (const button of document.querySelectorAll('[data-way]')) button.disabled =
            !mine || !['idle', 'moves'].includes(machine?.state)
        set('start', mine && plan?.state === 'ready' && ['idle', 'busy', 'held'].includes(
            machine?.state))
        set('resume', mine && ['held', 'pause', 'holds'].includes(job?.state))
        set('abort', mine && (this.busy || ['busy', 'held', 'moves'].includes(machine?.state)))
        set('hold', store.here)
        set('override', mine && this.busy)
        this.part('watch').hidden = !store.here || mine
        this.part('fault').textContent = store.fault
        this.part('fault').hidden = !store.fault
        this.part('file').disabled = !mine || this.busy
        for (const input of this.part('settings').elements) input.disabled = !mine || this.busy
        document.body.dataset.served = store.here ? 'yes' : 'no'
    }
}
