// host-tools/page/store.js -- what the page knows of the server: its views are told what changes
// SPDX-License-Identifier: MIT
import { Socket } from './socket.js'

export class Store {
    constructor() {
        this.state = {}
        this.you = null
        this.moves = null           // of the plan of this number:
        this.number = 0
        this.here = false
        this.views = []
        this.fault = ''
        this.socket = new Socket({
            hello: result => this.hello(result),
            refused: fault => this.fail(fault),
            changed: parts => this.change(parts),
            lost: () => { this.here = false; this.tell(['here']) },
        })
    }

    watch(view) { this.views.push(view) }
    tell(parts) { for (const view of this.views) view(parts, this) }

    hello(result) {
        Object.assign(this, { you: result.you, options: result.options, here: true, fault: '' })
        this.number = 0
        this.change(result.state, ['here', 'options', 'fault'])
    }

    change(parts, more = []) {
        Object.assign(this.state, parts)
        this.tell([...Object.keys(parts), ...more])
        const { plan } = this.state
        if (plan?.state === 'none' && this.moves) {
            this.moves = null
            this.tell(['moves'])
        } else if (plan?.state === 'ready' && plan.number !== this.number) {
            this.number = plan.number
            this.socket.ask('plan.moves').then(answer => {
                this.moves = answer.plan
                this.tell(['moves'])
            }, fault => this.fail(fault))
        }
    }

    fail(fault) {
        this.fault = fault.message ?? String(fault)
        this.tell(['fault'])
    }

    get controls() { return this.state.control?.holder === this.you }

    // Ask, and show what is refused.
    async ask(method, params) {
        try {
            const result = await this.socket.ask(method, params)
            if (this.fault) {
                this.fault = ''
                this.tell(['fault'])
            }
            return result
        } catch (fault) {
            this.fail(fault)
        }
    }

    async open(file) {
        try {
            const upload = await this.socket.upload(file)
            await this.ask('drawing.open', { upload })
        } catch (fault) {
            this.fail(fault)
        }
    }
}
