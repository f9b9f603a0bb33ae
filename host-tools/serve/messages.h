/* host-tools/serve/messages.h -- what a page asks and is told: JSON-RPC 2.0, text in, text out
 * SPDX-License-Identifier: MIT
 *
 *     const int c = serve_join(s);
 *     serve_hear(s, c, "{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"hello\"}", size, now);
 *     while ((text = serve_says(s, c, now, &size)) != NULL)
 *         send it to the page;
 *     serve_step(s, now, &w);
 *
 * It holds the state: the drawing, its plan, the machine, the job, who controls. It knows no socket
 * and waits for nothing (send/task.h). SERVE.md has all messages. A page is told the whole state
 * once, and then what has changed, at most ten times a second and only the newest.
 */
#ifndef LOFT_MESSAGES_H
#define LOFT_MESSAGES_H

#include "serve/preview.h"      /* serve_beside, talk_options */

#define SERVE_PROTOCOL 1
#define SERVE_CLIENTS  16       /* at most */
#define SERVE_TEXT     65536    /* bytes of a message that is heard */
#define SERVE_UPLOAD   (64u << 20)      /* bytes of a drawing */

typedef struct serve serve;

typedef struct {
    talk_options line;          /* port NULL: there is no machine */
    const char *machine;        /* its file, or NULL */
    const char *folder;         /* where the drawing is kept, so that a server that was killed goes
                                 * on with it; it exists */
    const char *token;          /* that a page has to know; NULL: none */
    serve_beside *beside;       /* plans in another process */
    void (*meanwhile)(void *context);   /* called in work that takes long, to let pages in */
    void *context;
} serve_options;

/* Begin, with the drawing of the folder, and connect the machine. Takes the host for its messages.
 */
serve *serve_open(host *h, const serve_options *o, double now);
void   serve_close(serve *s);

/* A page comes: its number, or -1: there are too many; it goes. */
int  serve_join(serve *s);
void serve_leave(serve *s, int client);

/* Hear one text. Returns false if the page is to be let go: it speaks something else, or does not
 * know the token. */
bool serve_hear(serve *s, int client, const char *text, size_t size, double now);

/* The next text for a page, until the next call; NULL: there is none now. Where so many texts wait
 * that it is late, it is to be let go. */
const char *serve_says(serve *s, int client, double now, size_t *size);
bool        serve_is_late(const serve *s, int client);
bool        serve_speaks(const serve *s, int client, double now);   /* is there one? */

/* Take a file, which drawing.open names: its number, or -1 after too many. */
int  serve_upload_begin(serve *s, const char *name);
bool serve_upload_more(serve *s, int upload, const void *bytes, size_t count);
bool serve_upload_end(serve *s, int upload, bool whole);

/* Is this the token? */
bool serve_knows(const serve *s, const char *token);

/* Some milliseconds of work for the machine. */
void serve_step(serve *s, double now, task_wants *w);

/* Hold a job, and end the rest. Returns true when it is done. */
bool serve_stop(serve *s);

#endif
