// host-tools/page/preview.js -- the planned moves as true curves: what is drawn, where the tool is
// SPDX-License-Identifier: MIT

// moves: [[curve, end, x1, y1, (z1,) x2, y2, (z2,) x3, y3, (z3)], ..], each from where the one
// before ended.
function unpack({ start, moves }) {
    let from = start.slice(0, 2), before = 0
    return moves.map(([curve, end, ...n]) => {
        const step = n.length / 3, p = [from]
        for (let i = 0; i < 3; i++)
            p.push([n[i * step], n[i * step + 1]])
        const move = { curve, begin: before, end, p }
        from = p[3]
        before = end
        return move
    })
}

function add(path, { p }) {
    path.moveTo(...p[0])
    path.bezierCurveTo(...p[1], ...p[2], ...p[3])
}

const on = (p, t) => [0, 1].map(i => (1 - t) ** 3 * p[0][i] + 3 * (1 - t) ** 2 * t * p[1][i] +
    3 * (1 - t) * t * t * p[2][i] + t ** 3 * p[3][i])

export class Preview {
    constructor(canvas) {
        this.canvas = canvas
        this.moves = []
        this.done = 0               // moves that are behind the tool
        this.at = null
        this.table = null
        this.page = null
        this.fit()
        new ResizeObserver(() => this.show()).observe(canvas)
        matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.show())
        this.drag()
        canvas.addEventListener('wheel', event => {
            event.preventDefault()
            this.zoom(Math.exp(-event.deltaY / 400), event.offsetX, event.offsetY)
        }, { passive: false })
    }

    set(plan, facts) {
        this.moves = plan ? unpack(plan) : []
        this.drawn = new Path2D()
        this.travelled = new Path2D()
        for (const move of this.moves)
            add(move.curve < 0 ? this.travelled : this.drawn, move)
        this.box = facts?.box
        this.page = facts?.page?.[0] > 0 ? facts.page : null
        this.progress(0, null)
        this.fit()
    }

    // The first move of a part of the drawing.
    first(part, parts) {
        const until = part > 0 ? parts[part - 1].until : 0
        return this.moves.findIndex(m => m.end > until + 1e-9)
    }

    progress(done, at) {
        if (done < this.done || !this.behind) {
            this.behind = new Path2D()
            this.done = 0
        }
        for (; this.done < done && this.done < this.moves.length; this.done++)
            if (this.moves[this.done].curve >= 0)
                add(this.behind, this.moves[this.done])
        this.at = at
        this.show()
    }

    // How far the plan is after so many seconds.
    time(seconds) {
        let low = 0, high = this.moves.length
        while (low < high) {
            const middle = (low + high) >> 1
            if (this.moves[middle].end > seconds) high = middle
            else low = middle + 1
        }
        const m = this.moves[low]
        this.progress(low, m ? on(m.p, (seconds - m.begin) / (m.end - m.begin || 1))
            : this.moves.at(-1)?.p[3] ?? null)
    }

    fit() {
        this.scale = 0              // of all, when it is shown
        this.show()
    }

    zoom(by, x = this.canvas.clientWidth / 2, y = this.canvas.clientHeight / 2) {
        this.left = x - (x - this.left) * by
        this.top = y - (y - this.top) * by
        this.scale *= by
        this.show()
    }

    drag() {
        let last = null
        this.canvas.addEventListener('pointerdown', event => {
            last = [event.offsetX, event.offsetY]
            this.canvas.setPointerCapture(event.pointerId)
        })
        this.canvas.addEventListener('pointermove', event => {
            if (!last) return
            this.left += event.offsetX - last[0]
            this.top += event.offsetY - last[1]
            last = [event.offsetX, event.offsetY]
            this.show()
        })
        for (const end of ['pointerup', 'pointercancel'])
            this.canvas.addEventListener(end, () => { last = null })
    }

    show() {
        if (!this.asked)
            this.asked = requestAnimationFrame(() => { this.asked = 0; this.draw() })
    }

    // Everything: drawing, page and table.
    frame() {
        const [x0, y0, x1, y1] = this.box ?? [0, 0, 100, 75]
        const low = [Math.min(x0, 0), Math.min(y0, 0)], high = [x1, y1]
        if (this.page)
            high.forEach((x, i) => { high[i] = Math.max(x, this.page[i]) })
        const width = this.canvas.clientWidth, height = this.canvas.clientHeight
        this.scale = 0.92 * Math.min(width / (high[0] - low[0] || 1),
            height / (high[1] - low[1] || 1))
        this.left = width / 2 - this.scale * (low[0] + high[0]) / 2
        this.top = height / 2 + this.scale * (low[1] + high[1]) / 2
    }

    draw() {
        const { canvas } = this, ratio = devicePixelRatio || 1
        const pen = canvas.getContext('2d'), style = getComputedStyle(canvas)
        const colour = name => style.getPropertyValue(name)
        const size = [canvas.clientWidth * ratio, canvas.clientHeight * ratio].map(Math.round)
        if (!size[0]) return
        if (canvas.width !== size[0] || canvas.height !== size[1])
            [canvas.width, canvas.height] = size
        if (!this.scale) this.frame()
        const { scale } = this
        pen.setTransform(1, 0, 0, 1, 0, 0)
        pen.clearRect(0, 0, ...size)
        pen.setTransform(ratio * scale, 0, 0, -ratio * scale, ratio * this.left, ratio * this.top)
        pen.lineCap = pen.lineJoin = 'round'
        const stroke = (path, name, width, dash = []) => {
            pen.strokeStyle = colour(name)
            pen.lineWidth = width / scale
            pen.setLineDash(dash.map(x => x / scale))
            pen.stroke(path)
        }
        const rectangle = (x, y, w, h) => { const r = new Path2D(); r.rect(x, y, w, h); return r }
        if (this.page) stroke(rectangle(0, 0, ...this.page), '--line', 1.5)
        if (this.table?.[0] && this.table?.[1]) {
            const [[x0, x1], [y0, y1]] = this.table
            stroke(rectangle(x0, y0, x1 - x0, y1 - y0), '--third', 1, [6, 4])
        }
        const axes = new Path2D()
        axes.moveTo(0, 12 / scale); axes.lineTo(0, 0); axes.lineTo(12 / scale, 0)
        stroke(axes, '--quiet', 1.5)
        if (this.moves.length) {
            stroke(this.travelled, '--quiet', 0.8, [3, 4])
            stroke(this.drawn, this.done > 0 ? '--faint' : '--ink', 1.4)
            stroke(this.behind, '--first', 2)
        }
        if (this.at) {
            pen.fillStyle = colour('--second')
            pen.beginPath()
            pen.arc(this.at[0], this.at[1], 5 / scale, 0, 7)
            pen.fill()
        }
    }
}
