/* host-tools/serve/store.h -- the drawing of a server, its options, and files that come: in a
 * folder, so that a server that was killed goes on with them
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_STORE_H
#define LOFT_STORE_H

#include <limits.h>             /* PATH_MAX */

#include "plan/planning.h"

#define STORE_UPLOADS 4
#define STORE_NAME    100       /* bytes of the name of a drawing */
#define STORE_TEXT    8192      /* bytes of its options */

typedef struct {
    char file[PATH_MAX];        /* of the drawing; "": there is none */
    char name[STORE_NAME];      /* as it was called */
    char given[STORE_TEXT];     /* its options, an object of JSON */
    planning how;               /* the same, read */
    /* ---- */
    host *host;
    const char *folder, *machine;
    char *text;                 /* `how` points into it, */
    const char **word;          /* and into that */
    size_t most;                /* bytes of an upload */
    struct {
        FILE *out;
        char name[STORE_NAME];
        size_t size;
        bool whole;
    } upload[STORE_UPLOADS];
} store;

/* Begin with what is in the folder. `machine`: the file of the machine, or NULL. */
void store_begin(store *s, host *h, const char *folder, const char *machine, size_t most);
void store_end(store *s);

/* Take a file in parts: its number, or -1; it is given back by the end that is not whole, or by
 * store_take. What is too large is refused. */
int  store_upload(store *s, const char *name);
bool store_more(store *s, int upload, const void *bytes, size_t count);
bool store_whole(store *s, int upload, bool whole);

/* It becomes the drawing, with these options. Returns 0, or an exit code after one message. */
int store_take(store *s, int upload);
void store_drop(store *s);

/* The drawing has these options from now on. Returns 0, or EX_USAGE: *fault says what is wrong. The
 * second function writes them into the folder. */
int  store_options(store *s, const char *given, option_fault *fault);
void store_keep(const store *s);

/* A text without the folder: as people know the drawing. */
void store_plain(const store *s, const char *text, char *out, size_t room);

#endif
