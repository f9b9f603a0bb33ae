// host-tools/page/plan_worker.js -- plans paths beside the page; the newest order wins
// SPDX-License-Identifier: MIT
import { load } from './loft.mjs'

const loft = fetch('loft-q16.wasm').then(answer => answer.arrayBuffer())
    .then(bytes => load(bytes, 'q16'))
let newest = null

self.onmessage = ({ data }) => {
    if (!newest)
        setTimeout(answer, 0)       // behind the orders that have come already
    newest = data
}

async function answer() {
    const planner = await loft, { id, path, limits } = newest
    newest = null
    try {
        self.postMessage({ id, spans: [...planner.plan(path, limits)] })
    } catch (fault) {
        self.postMessage({ id, fault: fault.message })
    }
}
