/* host-tools/base/host.h -- what a call tells its program: messages and progress
 * SPDX-License-Identifier: MIT
 *
 *     host h = { .message = print, .progress = draw, .now = seconds };
 *     int code = drawing_read(&h, &d, "part.nc");
 *     if (code != 0) ..           the message has been given: nobody adds another one
 *
 * The program owns the host, one for each job, and two jobs share nothing. A call returns 0 or a
 * code of <sysexits.h>. It prints nothing, ends nothing and waits for nothing.
 */
#ifndef LOFT_TOOLS_HOST_H
#define LOFT_TOOLS_HOST_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <sysexits.h>       /* EX_USAGE, EX_DATAERR, EX_NOINPUT, .. */

/* Where it is: file NULL: nowhere, line 0: in all of the file. */
typedef struct {
    const char *file;
    unsigned line;
} host_place;

/* The texts are valid until the sink returns. They are as files and machines gave them: whoever
 * shows them takes host_put_line, host_put_json or base/say.h. */
typedef struct {
    int code;               /* of <sysexits.h>; EX_OK: a warning */
    const char *name;       /* "gcode.no-feed": it stays when the words improve; "": none yet */
    host_place at;
    const char *what;
    const char *remedy;     /* NULL: none */
} host_message;

typedef struct {
    const char *doing;      /* "reading"; NULL: that work has ended */
    double done, total;     /* total 0: unknown */
    bool brief;             /* mostly it takes less than a second */
} host_progress;

/* All zero: nobody listens. */
typedef struct host {
    void (*message)(void *context, const host_message *m);      /* it may not call the library */
    bool (*progress)(void *context, const host_progress *p);    /* false: stop; the same */
    double (*now)(void *context);       /* seconds of a clock that is never set */
    void *context;
    const char *state;      /* a folder for what outlives the program, as notes of jobs; NULL: none,
                             * nothing is kept; "": none, which is a warning */
    bool strict;            /* a warning is an error: a call that warned ends with EX_DATAERR */
    unsigned warnings, errors;          /* counted here */
    /* ---- */
    double shown;           /* the time of the last progress */
    bool shows;             /* a work has been shown that has not ended */
    struct {                /* standard input, which two readers may want: base/source.c */
        char *text;
        size_t size;
    } input;
} host;

/* Free what the calls have kept. */
void host_close(host *h);

/* Tell what is wrong, and return `code`. */
int host_error(host *h, int code, const char *name, host_place at, const char *remedy,
               const char *what, ...) __attribute__((format(printf, 6, 7)));

/* Tell what is left out or guessed. The call goes on. */
void host_warn(host *h, const char *name, host_place at, const char *remedy, const char *what, ...)
    __attribute__((format(printf, 5, 6)));

/* A remedy with values, HOST_REMEDY("give %g or more", least). It is valid until the block ends. */
#define HOST_REMEDY(...) host_words((char[HOST_WORDS]){ 0 }, __VA_ARGS__)
#define HOST_WORDS 512
const char *host_words(char out[HOST_WORDS], const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* The code of a call that began with so many warnings: `code`, or what strict makes of 0. */
int host_code(const host *h, unsigned warnings, int code);

/* Tell how far a work is, at most ten times a second. Returns false if the call has to undo what it
 * did, and return EX_TEMPFAIL. */
bool host_goes_on(host *h, const host_progress *p);

/* That work has ended. */
void host_has_done(host *h);

/* A message as one line for people, `file:line: what: remedy`, and as one JSON object. What does
 * not print becomes visible. */
void host_put_line(FILE *out, const host_message *m, const char *before, const char *behind);
void host_put_json(FILE *out, const host_message *m);

#endif
