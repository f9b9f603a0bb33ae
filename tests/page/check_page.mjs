// tests/page/check_page.mjs -- the page in a browser, and its numbers beside those of the command
// SPDX-License-Identifier: MIT
// usage: node tests/page/check_page.mjs LOFT PLAYWRIGHT CHROMIUM SHOTS
// Nothing sleeps: a row waits for what the page shows.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { readFile, mkdir } from 'node:fs/promises'
import { pathToFileURL } from 'node:url'
import { row, ended, serve, site } from './site.mjs'

const [loft, playwright, executablePath, shots] = process.argv.slice(2)
const { chromium } = (await import(pathToFileURL(playwright))).default
const { load } = await import(new URL('loft.mjs', site))
const { exactPoints, naiveFixed, naiveFloat, off } = await import('../../host-tools/page/exact.js')
const { paths } = await import('../../host-tools/page/paths.js')
const { trapezoid } = await import('../../host-tools/page/trapezoid.js')
const library = await load(await readFile(new URL('loft-q16.wasm', site)), 'q16')

// Numbers from 0 to 1 that are the same in each run.
function* numbers(seed) {
    for (let x = BigInt(seed); ; ) {
        x = (x * 6364136223846793005n + 1442695040888963407n) % 2n ** 64n
        yield Number(x >> 40n) / 2 ** 24
    }
}
const random = numbers(7), next = () => random.next().value
const drawn = () => Array.from({ length: 2 + Math.floor(5 * next()) },
    () => [next() * 120, next() * 90].map(x => Math.round(x * 65536) / 65536))
const text = points => `bezier ${points.length - 1}\n${points.map(p => p.join(' ')).join('\n')}\n`

// The walk of the command, without its start.
function walked(points, n) {
    const out = execFileSync(loft, ['sample', '--n', n, '-'],
        { input: text(points), encoding: 'utf8' })
    return out.trim().split('\n').slice(1).map(line => line.split(/[\s,]+/).slice(0, 2).map(Number))
}

await row('40 walks are those of the command, bit for bit', () => {
    for (let i = 0; i < 40; i++) {
        const points = drawn(), ours = library.bezier(points).walk(48)
        assert.deepEqual(ours.map(p => p.slice(0, 2).map(x => Math.round(x * 65536))),
            walked(points, 48).map(p => p.map(x => Math.round(x * 65536))))
    }
})
await row('200 walks of 2^m steps are within 1/2 unit of exact fractions', () => {
    for (let i = 0; i < 200; i++) {
        const points = drawn(), n = 32, power = BigInt(n) ** BigInt(points.length - 1)
        const walk = library.bezier(points).walk(n)
        for (const k of [0, 1]) {
            const exact = exactPoints(points.map(p => p[k]), n)
            walk.forEach((p, j) => assert(Math.abs(off(p[k] * 65536, exact[j], power)) <= 0.5))
        }
    }
})
await row('walks that round go off, but not far in 4 steps', () => {
    for (let i = 0; i < 100; i++) {
        const points = drawn(), n = 4, power = BigInt(n) ** BigInt(points.length - 1)
        const control = points.map(p => p[0]), exact = exactPoints(control, n)
        for (const walk of [naiveFixed(control, n), naiveFloat(control, n)])
            walk.forEach((x, j) => assert(Math.abs(off(x, exact[j], power)) <= 20))
    }
})
await row('a split curve and a raised one lie on the curve', () => {
    for (let i = 0; i < 50; i++) {
        const points = drawn(), curve = library.bezier(points), t = next()
        const near = (p, q) => p.forEach((x, k) => assert(Math.abs(x - q[k]) < 3 / 65536))
        near(library.bezier(curve.split(0.5)[0]).eval(t), curve.eval(t / 2))
        near(library.bezier(curve.elevate()).eval(t), curve.eval(t))
    }
})
await row('each path ends where it should, at rest, within its limits', () => {
    const limits = { speed: 500, accel: 1000, jerk: 40000, tol: 0.01, corner: 0.1, tickHz: 1000 }
    for (const path of Object.values(paths)) {
        const spans = [...library.plan(path.map(c => ({ p: c.p, feed: 100 })), limits)]
        const end = spans.at(-1).p, aim = path.at(-1).p[3]
        aim.forEach((x, k) => assert(Math.abs(end[3][k] - x) <= 1 / 65536))
        for (const { p, ticks } of spans)
            for (const k of [0, 1]) {
                const T = ticks / 1000, [a, b, c, d] = p.map(q => q[k])
                for (const second of [c - 2 * b + a, d - 2 * c + b])
                    assert(Math.abs(6 * second / T ** 2) <= limits.accel * 1.0001)
            }
    }
})
await row('20 grids of patches are those of the command, within a unit', () => {
    const whole = p => p.map(x => Math.round(x * 65536))
    for (let i = 0; i < 20; i++) {
        const points = Array.from({ length: 16 }, () =>
            [next() * 60, next() * 60, next() * 30].map(x => Math.round(x * 65536) / 65536))
        const out = execFileSync(loft, ['sample', '--n', 8, '-'], { encoding: 'utf8',
            input: `tensor 3 3\n${points.map(p => p.join(' ')).join('\n')}\n` })
        const theirs = out.split('\n').filter(Boolean)
            .map(line => whole(line.split(' ').map(Number)))
        const ours = library.tensor(points, 3, 3).grid(8, 8, [0, 0, 1]).map(p => whole(p.point))
        // the command walks the grid; each rounds once: they differ by one unit at most
        assert.equal(ours.length, theirs.length)
        ours.forEach((p, k) => p.forEach((x, axis) => assert(Math.abs(x - theirs[k][axis]) <= 1)))
    }
})
await row('waterlines are at their height', () => {
    const points = Array.from({ length: 16 }, (_, k) => [k >> 2, k & 3, next()].map(x => x * 10))
    const patch = library.tensor(points, 3, 3)
    for (const height of [2, 5, 8])
        for (const path of patch.contours(height, 0.01, 16, 16))
            path.forEach(p => assert(Math.abs(p[2] - height) <= 0.01 + 1 / 65536))
})
await row('a trapezoid over one line has its time', () => {
    const limits = { speed: 500, accel: 1000, corner: 0, feed: 100 }
    assert(Math.abs(trapezoid([[0, 0], [100, 0]], limits).time - 1.1) < 1e-9)
})

// --- in a browser ---
await mkdir(shots, { recursive: true })
const server = await serve()
const browser = await chromium.launch({ executablePath, args: ['--no-sandbox'] })
const complaints = []

async function open(address = '', size = [1400, 1000], colorScheme = 'light') {
    const [width, height] = size
    const page = await browser.newPage({ viewport: { width, height }, colorScheme })
    page.on('console', said => {
        if (['error', 'warning'].includes(said.type()))
            complaints.push(said.text())
    })
    page.on('pageerror', fault => complaints.push(String(fault)))
    await page.goto(server.address + address)
    await page.waitForSelector('body[data-ready]')
    return page
}
const planned = page => page.waitForFunction(() =>
    document.querySelector('#motion-facts dd') &&
    !document.querySelector('#motion-view[aria-busy]'))
const fact = (page, list, word) => page.locator(`#${list} dt:text-is("${word}") + dd`).innerText()

await row('a point is dragged, and moved by keys', async () => {
    const page = await open(), handle = page.locator('.handle').nth(1)
    const before = await page.locator('#loft-text').innerText(), box = await handle.boundingBox()
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2)
    await page.mouse.down()
    await page.mouse.move(box.x + 80, box.y + 60, { steps: 5 })
    await page.mouse.up()
    const dragged = await page.locator('#loft-text').innerText()
    assert.notEqual(dragged, before)
    await handle.focus()
    await page.keyboard.press('ArrowRight')
    assert.notEqual(await page.locator('#loft-text').innerText(), dragged)
    await page.getByRole('button', { name: 'Undo' }).click()
    assert.equal(await page.locator('#loft-text').innerText(), before)
    await page.close()
})
await row('every example of curves is shown, its error at most 1/2', async () => {
    const page = await open()
    for (const name of await page.locator('#curve-controls option').allInnerTexts()) {
        await page.selectOption('#curve-controls [name=example]', name)
        const said = await page.locator('#error-view text.first').innerHTML()
        assert(Number(said.split('at most ')[1]) <= 0.5, `${name}: ${said}`)
    }
    for (const name of ['chords', 'comb'])
        await page.check(`[name=${name}]`)
    await page.screenshot({ path: `${shots}/curves-light.png`, fullPage: true })
    await page.close()
})
await row('degree, piece and undo', async () => {
    const page = await open()
    await page.getByRole('button', { name: 'Raise the degree' }).click()
    assert.equal(await fact(page, 'curve-facts', 'degree'), '4')
    await page.getByRole('button', { name: 'Keep 0..t' }).click()
    await page.getByRole('button', { name: 'Undo' }).click()
    await page.getByRole('button', { name: 'Undo' }).click()
    assert.equal(await fact(page, 'curve-facts', 'degree'), '3')
    await page.close()
})
await row('the address keeps the curve', async () => {
    const page = await open()
    await page.selectOption('#curve-controls [name=example]', 'A loop')
    const said = await page.locator('#loft-text').innerText(), x = said.split(/\s+/)[4]
    await page.waitForFunction(one => location.hash.includes(one), x)
    const address = page.url()
    const again = await open(address.slice(server.address.length))
    assert.equal(await again.locator('#loft-text').innerText(), said)
    await Promise.all([page.close(), again.close()])
})
await row('every path is planned within its limits', async () => {
    const page = await open('#motion')
    for (const name of await page.locator('#motion-controls option').allInnerTexts()) {
        await page.selectOption('#motion-controls [name=path]', name)
        await planned(page)
        for (const word of ['largest acceleration', 'largest jerk'])
            assert(parseFloat(await fact(page, 'motion-facts', word)) <= 100.1, `${name}: ${word}`)
    }
    await page.screenshot({ path: `${shots}/motion-light.png`, fullPage: true })
    await page.close()
})
await row('a path is drawn with the pointer', async () => {
    const page = await open('#motion')
    await planned(page)
    const view = await page.locator('#motion-view').boundingBox()
    await page.mouse.move(view.x + 100, view.y + 300)
    await page.mouse.down()
    for (let i = 1; i < 20; i++)
        await page.mouse.move(view.x + 100 + 20 * i, view.y + 300 + 80 * Math.sin(i / 3))
    await page.mouse.up()
    await planned(page)
    assert(Number(await fact(page, 'motion-facts', 'curves of the path')) >= 15)
    await page.locator('#zoom-corner').click()
    await page.close()
})
await row('every surface is shown, turned and bent', async () => {
    const page = await open('#surfaces')
    for (const name of await page.locator('#surface-controls option').allInnerTexts()) {
        await page.selectOption('#surface-controls [name=example]', name)
        await page.fill('#surface-controls [name=isophotes]', '12')
        assert.ok(await page.locator('#surface-view .water').count() >= 8, `waterlines of ${name}`)
        assert.ok(await page.locator('#surface-view .light').count() >= 2, `isophotes of ${name}`)
        const before = await page.locator('#surface-text').innerText()
        await page.locator('#surface-view .handle').nth(5).focus()
        await page.keyboard.press('ArrowUp')
        assert.notEqual(await page.locator('#surface-text').innerText(), before)
        const view = await page.locator('#surface-view').boundingBox()
        await page.mouse.move(view.x + 20, view.y + 20)
        await page.mouse.down()
        await page.mouse.move(view.x + 120, view.y + 60, { steps: 4 })
        await page.mouse.up()
        assert.notEqual(await page.inputValue('#surface-controls [name=turn]'), '-30')
    }
    await page.screenshot({ path: `${shots}/surfaces-light.png`, fullPage: true })
    await page.close()
})
await row('on a phone nothing is wider than the screen, in the dark', async () => {
    for (const name of ['curves', 'motion', 'surfaces']) {
        const page = await open(`#${name}`, [390, 844], 'dark')
        if (name === 'motion')
            await planned(page)
        assert(await page.evaluate(() => document.documentElement.scrollWidth) <= 390)
        await page.screenshot({ path: `${shots}/${name}-phone.png`, fullPage: true })
        await page.close()
    }
})
await row('the browser complains of nothing', () => assert.deepEqual(complaints, []))

await browser.close()
server.close()
ended()
