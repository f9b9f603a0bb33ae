// host-tools/page/socket.js -- the only file that talks to `loft serve` (host-tools/SERVE.md)
// SPDX-License-Identifier: MIT
const AGAIN = 1000      // ms until a lost connection is tried again

// The token stands behind # in the printed address: this tab keeps it, and the address loses it.
function findToken() {
    const given = /^#token=([0-9a-f]+)$/.exec(location.hash)
    if (given) {
        sessionStorage.setItem('token', given[1])
        history.replaceState(null, '', location.pathname)
    }
    return sessionStorage.getItem('token') ?? undefined
}

export class Socket {
    // hello(result), changed(parts) and lost() are told what comes.
    constructor(heard) {
        this.heard = heard
        this.token = findToken()
        this.waiting = new Map()
        this.number = 0
        this.connect()
    }

    connect() {
        this.line = new WebSocket(`ws://${location.host}/`, 'loft')
        this.line.addEventListener('open', () => this.ask('hello', { protocol: 1,
            ...(this.token && { token: this.token }) }).then(this.heard.hello, this.heard.refused))
        this.line.addEventListener('message', event => this.take(JSON.parse(event.data)))
        this.line.addEventListener('close', () => this.close())
    }

    close() {
        for (const { no } of this.waiting.values())
            no(new Error('the server does not answer: is `loft serve` running?'))
        this.waiting.clear()
        this.heard.lost()
        setTimeout(() => this.connect(), AGAIN)
    }

    take(said) {
        if (said.method === 'state')
            return this.heard.changed(said.params.changed)
        const asked = this.waiting.get(said.id)
        this.waiting.delete(said.id)
        if (said.error)
            asked?.no(new Error([said.error.message, said.error.data?.remedy].filter(Boolean)
                .join(': ')))
        else
            asked?.yes(said.result)
    }

    ask(method, params = {}) {
        const id = ++this.number
        return new Promise((yes, no) => {
            if (this.line.readyState !== WebSocket.OPEN)
                return no(new Error('the server does not answer: is `loft serve` running?'))
            this.waiting.set(id, { yes, no })
            this.line.send(JSON.stringify({ jsonrpc: '2.0', id, method, params }))
        })
    }

    // The number of an upload.
    async upload(file) {
        const answer = await fetch(`upload?name=${encodeURIComponent(file.name)}`, { method: 'POST',
            body: file, headers: this.token ? { 'X-Loft-Token': this.token } : {} })
        if (!answer.ok)
            throw new Error(`${file.name}: ${new DOMParser().parseFromString(await answer.text(),
                'text/html').body.textContent.replace(/^\d+/, '')}`)
        return (await answer.json()).upload
    }
}
