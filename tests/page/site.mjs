// tests/page/site.mjs -- a server of build/site, and rows `ok` and `FAIL`
// SPDX-License-Identifier: MIT
import { createServer } from 'node:http'
import { readFile } from 'node:fs/promises'

const kinds = { html: 'text/html', css: 'text/css', js: 'text/javascript', mjs: 'text/javascript',
    wasm: 'application/wasm' }

export const site = new URL('../../build/site/', import.meta.url)

// Serve the folder at a free port of this computer: { address, close }.
export async function serve() {
    const server = createServer(async (ask, answer) => {
        const name = ask.url.split(/[?#]/)[0].slice(1) || 'index.html'
        const body = /^[\w.-]+$/.test(name) ? await readFile(new URL(name, site)).catch(() => null)
            : null
        const kind = kinds[name.split('.').at(-1)] ?? 'text/plain'
        answer.writeHead(body ? 200 : 404, { 'content-type': kind })
        answer.end(body)
    })
    await new Promise(done => server.listen(0, 'localhost', done))
    return { address: `http://localhost:${server.address().port}/`, close: () => server.close() }
}

let passed = 0, failed = 0

// A row: `test` throws, or it holds.
export async function row(name, test) {
    try {
        await test()
        passed++
        console.log(`ok   page: ${name}`)
    } catch (fault) {
        failed++
        const why = String(fault.message ?? fault).split('\n').join('\n     ')
        console.log(`FAIL page: ${name}\n     ${why}`)
    }
}

export function ended() {
    console.log(`${passed} passed, ${failed} failed`)
    process.exit(failed ? 1 : 0)
}
