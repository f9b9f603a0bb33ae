// host-tools/page/settings.js -- the options of a drawing as controls: made from the table that the
// server sends, which is that of the command
// SPDX-License-Identifier: MIT
import { html } from './draw.js'

const hidden = new Set(['file', 'folder', 'word', 'words'])

function control(row) {
    if (row.kind === 'flag')
        return Object.assign(html('input'), { type: 'checkbox' })
    if (row.choices && row.kind !== 'list') {
        const usual = html('option', `(${row.default ?? 'as usual'})`)
        const select = html('select', Object.assign(usual, { value: '' }))
        for (const word of row.choices)
            select.append(Object.assign(html('option', word), { value: word }))
        return select
    }
    const input = Object.assign(html('input'), { type: 'text', autocomplete: 'off' })
    input.placeholder = row.default ?? row.value ?? ''
    if (row.kind === 'number' || row.kind === 'integer')
        input.inputMode = 'decimal'
    return input
}

// changed(options) is told all that were given.
export function settings(form, rows, changed) {
    const inputs = new Map(), groups = new Map()
    form.replaceChildren()
    for (const row of rows) {
        if (hidden.has(row.kind)) continue
        const heading = row.heading ?? 'more'
        if (!groups.has(heading)) {
            groups.set(heading, html('fieldset', html('legend', heading)))
            form.append(groups.get(heading))
        }
        const input = control(row)
        input.name = row.name
        const label = html('label', html('span', row.name), input)
        label.title = row.help ?? ''
        if (row.unit) label.querySelector('span').append(html('small', ` ${row.unit}`))
        groups.get(heading).append(label)
        inputs.set(row.name, input)
    }
    form.onchange = () => {
        const given = {}
        for (const [name, input] of inputs) {
            if (input.type === 'checkbox' ? input.checked : input.value.trim() !== '')
                given[name] = input.type === 'checkbox' ? true : input.value.trim()
        }
        changed(given)
    }
    form.onsubmit = event => event.preventDefault()
    return given => {
        for (const [name, input] of inputs) {
            if (input === document.activeElement) continue
            if (input.type === 'checkbox') input.checked = given[name] === true
            else input.value = given[name] ?? ''
        }
    }
}
