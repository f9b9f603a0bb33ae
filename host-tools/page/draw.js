// host-tools/page/draw.js -- SVG elements, lines and graphs
// SPDX-License-Identifier: MIT
const SVG = 'http://www.w3.org/2000/svg'

export function element(name, attributes = {}, ...children) {
    const made = document.createElementNS(SVG, name)
    for (const [key, value] of Object.entries(attributes))
        made.setAttribute(key, value)
    made.append(...children)
    return made
}

export function html(name, ...children) {
    const made = document.createElement(name)
    made.append(...children)
    return made
}

export const line = (points, kind, closed = false) => element('path', { class: kind,
    d: points.map((p, i) => `${i ? 'L' : 'M'}${p[0].toFixed(5)} ${p[1].toFixed(5)}`).join('') +
        (closed ? 'Z' : '') })

// y points up in drawings, down in SVG.
export const upright = (height, ...children) =>
    element('g', { transform: `translate(0 ${height}) scale(1 -1)` }, ...children)

// A number with so many digits that count, without an exponent.
export function digits(x, count = 3) {
    if (x === 0)
        return '0'
    const places = Math.max(0, count - 1 - Math.floor(Math.log10(Math.abs(x))))
    return x.toFixed(Math.min(places, 12)).replace(/(\.\d*?)0+$/, '$1').replace(/\.$/, '')
}

// terms: [[word, text], ..]
export function facts(list, terms) {
    list.replaceChildren(...terms.flatMap(([word, text]) => [html('dt', word), html('dd', text)]))
}

// A graph: lines [{ points: [[x, y], ..], kind, name }] over the box x: [from, to], y: [from, to],
// levels [{ y, name }] across it, band [from, to].
export function graph(svg, { x, y, lines, levels = [], band, unit = '', scale = v => v }) {
    const [, , , height] = svg.getAttribute('viewBox').split(' ').map(Number)
    const width = svg.clientWidth || 600
    svg.setAttribute('viewBox', `0 0 ${width} ${height}`)
    const left = 64, right = width - 10, top = 22, bottom = height - 22
    const at = ([a, b]) => [left + (right - left) * (a - x[0]) / (x[1] - x[0] || 1),
        bottom + (top - bottom) * (scale(b) - scale(y[0])) / (scale(y[1]) - scale(y[0]) || 1)]
    const parts = []
    if (band) {
        const high = at([x[0], band[1]])[1], low = at([x[0], band[0]])[1]
        parts.push(element('rect', { class: 'band', x: left, width: right - left, y: high,
            height: Math.max(0, low - high) }))
    }
    for (const level of levels) {
        const h = at([x[0], level.y])[1]
        parts.push(element('path', { class: level.kind ?? 'limit', d: `M${left} ${h}H${right}` }),
            element('text', { x: left - 6, y: h + 4, 'text-anchor': 'end' }, level.name))
    }
    let place = left
    for (const one of lines) {
        if (one.points.length > 1)
            parts.push(line(one.points.map(at), `graph ${one.kind}`))
        parts.push(element('text', { x: place, y: 15, class: one.kind }, one.name))
        place += 20 + one.name.length * 6.6
    }
    parts.push(element('path', { class: 'axis', d: `M${left} ${top}V${bottom}H${right}` }),
        element('text', { x: right, y: height - 6, 'text-anchor': 'end' },
            `${digits(x[1], 4)} ${unit}`),
        element('text', { x: left, y: height - 6 }, digits(x[0], 4)))
    svg.replaceChildren(...parts)
}
