// host-tools/page/main.js -- loads the library, opens the panel that the address names
// SPDX-License-Identifier: MIT
import { load } from './loft.mjs'
import { Curves } from './curves.js'
import { Motion } from './motion.js'
import { Surfaces } from './surfaces.js'

let kinds = { curves: Curves, motion: Motion, surfaces: Surfaces }
const panels = {}
let later = null

// #motion={..}: the panel and its state.
function address() {
    const [name, ...rest] = decodeURIComponent(location.hash.slice(1)).split('=')
    const known = kinds[name] ? name : Object.keys(kinds)[0]
    try { return [known, JSON.parse(rest.join('=') || '{}')] }
    catch { return [known, {}] }
}

// The address follows the state, not more often than browsers allow.
function remember(name, state) {
    clearTimeout(later)
    later = setTimeout(() => history.replaceState(null, '',
        `#${name}=${encodeURIComponent(JSON.stringify(state))}`), 250)
}

function open(loft, name, state) {
    for (const one of Object.keys(kinds)) {
        document.getElementById(one).hidden = one !== name
        document.getElementById(`tab-${one}`).setAttribute('aria-selected', one === name)
    }
    if (!panels[name])
        panels[name] = new kinds[name](loft, remember)
    panels[name].open(state ?? panels[name].state)
}

function fail(fault) {
    const alert = document.getElementById('failure')
    alert.hidden = false
    alert.textContent = `${fault.message ?? fault}: load this page from a server, not from a file`
}

// Is this the page of `loft serve`? Then it has a machine.
async function findServer() {
    const answer = await fetch('index.html')
    if (!answer.headers.has('x-loft'))
        return
    const { Machine } = await import('./machine.js')
    kinds = { machine: Machine, ...kinds }
    document.getElementById('tab-machine').hidden = false
}

async function begin() {
    await findServer()
    const answer = await fetch('loft-q16.wasm')
    if (!answer.ok)
        throw new Error(`loft-q16.wasm: ${answer.status} ${answer.statusText}`)
    const loft = await load(await answer.arrayBuffer(), 'q16')
    for (const name of Object.keys(kinds))
        document.getElementById(`tab-${name}`).addEventListener('click', () => open(loft, name))
    for (const button of document.querySelectorAll('[data-copy]'))
        button.addEventListener('click', () => navigator.clipboard.writeText(
            document.getElementById(button.dataset.copy).textContent))
    window.addEventListener('hashchange', () => open(loft, ...address()))
    open(loft, ...address())
    document.body.dataset.ready = 'yes'
}

begin().catch(fail)
