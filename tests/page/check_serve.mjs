// tests/page/check_serve.mjs -- the page of `loft serve` in a browser, beside a simulated machine
// SPDX-License-Identifier: MIT
// usage: node tests/page/check_serve.mjs LOFT PLAYWRIGHT CHROMIUM SHOTS SITE
// Nothing sleeps: a row waits for what the page shows.
import assert from 'node:assert/strict'
import { spawn } from 'node:child_process'
import { mkdtemp, mkdir, writeFile } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { createInterface } from 'node:readline'
import { pathToFileURL } from 'node:url'
import { row, ended } from './site.mjs'

const [loft, playwright, executablePath, shots, site] = process.argv.slice(2)
const { chromium } = (await import(pathToFileURL(playwright))).default
const folder = await mkdtemp(`${tmpdir()}/loft-page-`)
const children = []

// A program, when it has said this: { child, match }.
function runs(args, wanted) {
    const child = spawn(loft, args, { env: { ...process.env, XDG_STATE_HOME: `${folder}/state` },
        stdio: ['ignore', 'pipe', 'pipe'] })
    children.push(child)
    return new Promise((yes, no) => {
        const take = line => {
            const match = wanted.exec(line)
            if (match) yes({ child, match })
        }
        createInterface({ input: child.stdout }).on('line', take)
        createInterface({ input: child.stderr }).on('line', take)
        child.on('exit', code => no(new Error(`${args.join(' ')}: ended with ${code}`)))
    })
}
const gone = child => new Promise(yes => child.exitCode === null && child.signalCode === null
    ? child.on('exit', yes) : yes())

await mkdir(shots, { recursive: true })
await runs(['simulate', '--link', `${folder}/m`, '--speed', 'real'], /^machine: /)
let server = await runs(['serve', '--port', `${folder}/m`, '--listen', '127.0.0.1:0',
    '--page', site],
    /^page: http:\/\/127\.0\.0\.1:(\d+)\//)
const port = server.match[1], address = `http://127.0.0.1:${port}/`
const waves = Array.from({ length: 8 }, (_, k) => `M10 ${10 + 3 * k}C40 ${-10 + 3 * k} 70 ` +
    `${40 + 3 * k} 100 ${10 + 3 * k}`).join('')
await writeFile(`${folder}/waves <b>.svg`, '<svg xmlns="http://www.w3.org/2000/svg" ' +
    'width="110mm" height="100mm" viewBox="0 0 110 100"><path fill="none" stroke="#000" ' +
    `d="${waves}"/></svg>`)

const browser = await chromium.launch({ executablePath, args: ['--no-sandbox'] })
const complaints = []
async function open(size = [1400, 1000], colorScheme = 'light') {
    const [width, height] = size
    const page = await browser.newPage({ viewport: { width, height }, colorScheme })
    page.on('console', said => { if (said.type() === 'error') complaints.push(said.text()) })
    page.on('pageerror', fault => complaints.push(String(fault)))
    await page.goto(address)
    await says(page, 'status', /./)
    return page
}
const part = (page, name) => page.locator(`#machine-${name}`)
const says = (page, name, text) =>
    part(page, name).filter({ hasText: text }).waitFor({ timeout: 120000 })
const click = (page, name) => part(page, name).click()
const shot = (page, name) => page.screenshot({ path: `${shots}/serve-${name}.png`, fullPage: true })

let page
await row('a dropped drawing is planned', async () => {
    page = await open()
    await says(page, 'status', 'ready')
    await part(page, 'file').setInputFiles(`${folder}/waves <b>.svg`)
    await says(page, 'plan', '8 curves')
    await says(page, 'name', /^waves/)
    await shot(page, 'planned')
})
await row('its options are those of the command', async () => {
    const count = await part(page, 'settings').locator('[name]').count()
    assert(count > 30, `${count} controls`)
    await page.locator('summary').click()
    await part(page, 'settings').locator('[name=feed]').fill('20')
    const before = await part(page, 'plan').textContent()
    await part(page, 'settings').locator('[name=feed]').press('Enter')
    await page.waitForFunction(text => {
        const plan = document.getElementById('machine-plan')
        return plan.textContent !== text && plan.dataset.state === 'ready'
    }, before)
    await shot(page, 'options')
    await page.locator('summary').click()
})
await row('a jog moves by its step', async () => {
    await page.locator('[data-way="x+"]').click()
    await says(page, 'x', '1.00')
    await page.locator('[data-way="x-"]').focus()
    await page.keyboard.press('ArrowLeft')
    await says(page, 'x', /^-?0\.00$/)
})
await row('a job starts, is held by a key and goes on', async () => {
    await says(page, 'status', 'ready')
    await click(page, 'start')
    await says(page, 'job', 'draws')
    await page.locator('h1').click()
    await page.keyboard.press('h')
    await says(page, 'job', 'held')
    await shot(page, 'held')
    await click(page, 'resume')
    await says(page, 'job', 'draws')
})
await row('a page that is loaded again is where it was', async () => {
    await page.reload()
    await says(page, 'job', 'draws')
    await says(page, 'name', 'waves')
})
let phone
await row('a phone watches, holds, and takes over', async () => {
    phone = await open([390, 844], 'dark')
    await says(phone, 'job', 'draws')
    await part(phone, 'watch').waitFor()
    assert(await part(phone, 'resume').isDisabled())
    const box = await part(phone, 'hold').boundingBox()
    assert(box.height >= 60 && box.width > 300 && box.y + box.height <= 844)
    await click(phone, 'hold')
    await says(phone, 'job', 'held')
    await says(page, 'job', 'held')
    await phone.screenshot({ path: `${shots}/serve-phone.png` })
    await shot(phone, 'phone-all')
    await click(phone, 'take')
    await part(page, 'watch').waitFor()
    await phone.waitForFunction(() => document.documentElement.scrollWidth <= innerWidth)
})
await row('a killed server comes back, and the job goes on', async () => {
    server.child.kill('SIGKILL')
    await gone(server.child)
    await says(phone, 'status', 'the server does not answer')
    complaints.length = 0               // of the connection
    server = await runs(['serve', '--port', `${folder}/m`, '--listen', `127.0.0.1:${port}`,
        '--page', site], /^page: /)
    await says(phone, 'status', /held|has a job/)
    complaints.length = 0
    await page.close()
    await part(phone, 'start').and(phone.locator(':enabled')).click()
    await says(phone, 'job', 'draws')
    await part(phone, 'override').fill('200')
    await says(phone, 'override-value', '200 %')
    await says(phone, 'job', 'over')
    await says(phone, 'result', 'as commanded')
})
await row('dark and wide, after the job', async () => {
    const dark = await open([1600, 1000], 'dark')
    await says(dark, 'plan', '8 curves')
    await shot(dark, 'dark')
    await dark.locator('#tab-curves').click()
    await dark.locator('#curve-view path').first().waitFor()
    await dark.close()
})
await row('nothing complains', () => assert.deepEqual(complaints, []))

await browser.close()
for (const child of children) child.kill()
ended()
