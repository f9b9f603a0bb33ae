/* host-tools/serve/serve.h -- the server of `loft serve`: HTTP and WebSocket, one loop
 * SPDX-License-Identifier: MIT
 *
 * Who may come in, in this order; each refusal says what to do:
 *     Host    an address of this computer, not a name that somebody else points at it (421)
 *     Origin  that of this page, or none (403): for WebSockets and uploads
 *     token   where one is needed: in `hello`, and for uploads in X-Loft-Token (401)
 *     size    of an upload and of a text (413)
 */
#ifndef LOFT_SERVE_H
#define LOFT_SERVE_H

#include "serve/messages.h"     /* serve_options */

typedef struct {
    const char *host;           /* an address or a name of this computer */
    unsigned port;              /* 0: any that is free */
    const char *page;           /* a folder that has the page; NULL: that of the program */
    bool (*ends)(void);         /* asked in each turn */
    void (*ready)(const char *host, unsigned port, const char *token);
} serve_place;

/* True if only this computer can reach it. */
bool serve_is_local(const char *host);

/* Serve until it is to end. Returns 0, or an exit code after one message. */
int serve_run(host *h, const serve_options *o, const serve_place *at);

#endif
