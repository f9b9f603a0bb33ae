/* host-tools/read/reader.h -- a kind of file as a row: what speaks for it, and what reads it
 * SPDX-License-Identifier: MIT
 *
 * readers.c lists all rows and takes the one that most speaks for. A reader hands its curves to a
 * drawing, or to a list of curves, and knows nothing of the others. To add one: its file, its row,
 * a line in readers.c, and a sample in tests/tools/test_readers.c.
 */
#ifndef LOFT_READER_H
#define LOFT_READER_H

#include "base/source.h"        /* source */
#include "engine/curve.h"       /* curves */
#include "read/drawing.h"       /* drawing */

/* How much speaks for a kind, in the first part of a file. Content says more than a name. */
enum {
    READER_NOT    = 0,
    READER_REST   = 1,      /* what no other kind takes                     */
    READER_LINE   = 40,     /* some line looks like one of it               */
    READER_ENDING = 60,     /* the name of the file ends so, or a mark does */
    READER_WORD   = 80,     /* the first word is one of it                  */
    READER_SIGNS  = 85,     /* its first lines are as no other kind has     */
    READER_MAGIC  = 90,     /* its first bytes are those of the kind alone  */
    READER_XML    = 100
};

/* What it takes, besides curves. */
enum {
    READER_BYTES   = 1,     /* zeros too: it need not be text            */
    READER_PARTS   = 2,     /* lines, which may be read in parts         */
    READER_LAYERS  = 4,     /* options of layers, colours and text       */
    READER_PROGRAM = 8      /* options of the dialect and of lines       */
};

typedef struct reader reader;
struct reader {
    const char *name;           /* after "is": "a PNG picture" */
    /* One of the scores. `text` holds `size` bytes, followed by a 0. Reads nothing else. */
    int (*probe)(const reader *r, const char *file, const char *text, size_t size);
    /* As a drawing: 0, or an exit code after one message. NULL: the file is refused. */
    int (*read)(host *h, drawing *d, const char *file, source *s);
    /* As a list of curves. NULL: those of the drawing. */
    int (*curves)(host *h, curves *all, const char *file, const char *text);
    unsigned takes;
    const char *remedy;         /* of a kind that is refused: what to do */
    const char *magic;          /* its first bytes, for READER_MAGIC     */
    size_t magic_size;
};

/* The row that most speaks for. NULL after one message: two of them speak alike. */
const reader *reader_of(host *h, const reader *const rows[], size_t count, const char *file,
                        const char *text, size_t size);

/* The score of a row whose magic the text begins with. */
int reader_by_magic(const reader *r, const char *file, const char *text, size_t size);

#endif
