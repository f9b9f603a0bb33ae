/* host-tools/base/source.h -- the text of a file
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_SOURCE_H
#define LOFT_SOURCE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/option.h"    /* option */

struct host;                /* base/host.h */

/* Read all of `file` and append a 0. "-" is standard input, which may be read again. A file that is
 * packed with gzip is unpacked. On failure gives one message, sets *code to a code of
 * <sysexits.h> and returns NULL. */
char *source_read(struct host *h, const char *file, size_t *size, int *code);

/* A file in parts. While it is read, the host gets progress. */
typedef struct source {
    const char *text;           /* this part: whole lines, followed by a 0; all of them if it is of
                                 * one part */
    size_t size;                /* 0: there are no more */
    /* ---- */
    const char *file;
    void *stream;               /* NULL: all is read */
    char *buffer, held;         /* the character that the 0 stands for */
    size_t room, used;
    bool large;                 /* all of it together would be refused */
    unsigned long lines;        /* before the buffer */
    double total;               /* of its bytes, as they lie on the disk; 0: unknown */
    struct host *host;
} source;

/* Begin with the first part, or with all of the file. On failure gives one message and returns a
 * code of <sysexits.h>. Call source_close in any case. */
int  source_open(struct host *h, source *s, const char *file);
int  source_whole(struct host *h, source *s, const char *file);
void source_close(source *s);

/* Go on to the next part. Results as above; so lines of more than 1 MB are refused. The host can
 * stop it: EX_TEMPFAIL. */
int source_part(source *s);

/* Append all that follows to the first part. */
int source_rest(source *s);

/* A text as one part. */
source source_text(const char *text, size_t size);

/* The name of the file in messages. */
const char *source_name(const char *file);

/* Where curves come from: a file, or --points; rows of a table of options. */
typedef struct {
    const char *file, *points;
} source_given;
extern const option source_rows[];
const char *source_given_name(const source_given *from);    /* in messages */

/* True if the text starts with `<`, after at most a byte order mark and white space, or with the
 * mark of UTF-16. */
bool source_is_xml(const char *text);

#endif
