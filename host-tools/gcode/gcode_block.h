/* host-tools/gcode/gcode_block.h -- one line of G-code as words: letters with their numbers
 * SPDX-License-Identifier: MIT
 *
 * Blanks count nowhere, and small letters are capital letters. A number is written out, or is an
 * expression [1 + 2 * SIN[30]], or a parameter #5 or #<name>. `#5 = 2` sets a parameter after the
 * whole line is read.
 */
#ifndef LOFT_GCODE_BLOCK_H
#define LOFT_GCODE_BLOCK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define GCODE_LINE_MAX  65536   /* characters of a line */
#define GCODE_CODES     16      /* G words, and M words, of a line */
#define GCODE_SETTINGS  16      /* parameters that a line sets */
#define GCODE_NUMBERED  5603    /* parameters #1 .. #5602 */
#define GCODE_NAMED     1024    /* parameters #<name> */
#define GCODE_NAME_MAX  64
#define GCODE_RADIUS    ('Z' + 1)       /* @ and ^, polar coordinates, as if they were letters */
#define GCODE_ANGLE     ('Z' + 2)

typedef struct {
    char name[GCODE_NAME_MAX];
    double value;
    unsigned depth;             /* of the subroutine that it belongs to; 0: the program, or all */
} gcode_named;

/* All parameters of a program. */
typedef struct {
    double number[GCODE_NUMBERED];
    gcode_named named[GCODE_NAMED];
    unsigned count;
    unsigned depth;             /* subroutines in each other */
    double value, returned;     /* of the last one; whether it gave one */
} gcode_parameters;

typedef struct {
    struct host *host;          /* base/host.h */
    const char *file;
    unsigned line;
    bool printer;               /* of a 3-D printer: M words take text, checksums follow * */
    bool skip;                  /* leave out lines that begin with / */
    gcode_parameters *at;
    const struct gcode_program *of;     /* for what a parameter tells of it */
    uint32_t *used;             /* bits as of `has`: letters whose numbers were asked for */
    /* ---- */
    uint32_t has;               /* bit n: the letter 'A' + n, except G and M; GCODE_RADIUS .. */
    double value[28];
    short g[GCODE_CODES], m[GCODE_CODES];       /* in tenths: G5.1 is 51 */
    unsigned gs, ms;
    const char *say;            /* (MSG,text), or NULL, and its length */
    size_t say_length;
    bool percent;               /* the line is % */
    char unknown[24];           /* of a printer: a command that is no letter with a number, or "" */
} gcode_block;

/* As it is written. */
#define GCODE_SHOWN(letter) \
    ((letter) == GCODE_RADIUS ? '@' : (letter) == GCODE_ANGLE ? '^' : (letter))
#define GCODE_BIT(letter) (1u << ((letter) - 'A'))

static inline bool gcode_has(const gcode_block *b, char letter)
{
    return (b->has & GCODE_BIT(letter)) != 0;
}

/* The number of a letter, which thereby has a use in the line. */
static inline double gcode_value(const gcode_block *b, char letter)
{
    *b->used |= GCODE_BIT(letter);
    return b->value[letter - 'A'];
}

/* Read a line of `length` characters, without its newline, into the second half of *b. Returns 0,
 * or EX_DATAERR after one message. */
int gcode_block_read(gcode_block *b, const char *text, size_t length);

/* Tell what is wrong in this line. Returns EX_DATAERR. */
int gcode_wrong(const gcode_block *b, const char *name, const char *what, const char *remedy);

#endif
