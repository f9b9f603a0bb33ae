/* host-tools/base/text_lines.h -- reads a text line by line: its words, its numbers and its errors
 * SPDX-License-Identifier: MIT
 *
 * This is what curves and surfaces in the format .loft have in common. `#` starts a comment.
 * Blanks, tabs, commas and semicolons separate numbers. A line begins with a word or with a number.
 */
#ifndef LOFT_TEXT_LINES_H
#define LOFT_TEXT_LINES_H

#include <stdbool.h>

#define LINES_AXES         3
#define LINES_WEIGHT_LEAST (1 / 256.0)  /* of the library */
#define LINES_WEIGHT_MOST  256.0

typedef struct {
    struct host *host;      /* base/host.h */
    const char *file;
    unsigned line;          /* from 1                      */
    const char *rest;       /* the rest of the line */
} lines;

/* The first character of a text that is neither white space nor part of a comment. */
const char *lines_start(const char *text);

/* Call `each` at the start of every line that is not empty, until it returns an exit code. Returns
 * that, or 0. */
int lines_read(lines *r, const char *text, int (*each)(void *context), void *context);

/* Tell what is wrong in this line, under this name. Returns EX_DATAERR. */
int lines_wrong(const lines *r, const char *name, const char *what, const char *remedy);

/* True if the rest of the line is empty. */
bool lines_over(const lines *r);

/* Skip `word` and the blanks after it if it is the next word; skip a colon if it comes next. */
bool lines_word(lines *r, const char *word);
bool lines_colon(lines *r);

/* Read up to `most` finite numbers. Returns their count, or -1 if one is not finite. The second
 * function also requires that nothing follows them. */
int lines_numbers(lines *r, double out[], int most);
int lines_numbers_alone(lines *r, double out[], int most);

/* Read `x y` or `x y z`. Returns the number of axes (the others are 0), or 0 if the text is
 * something else. */
int lines_vector(lines *r, double out[LINES_AXES]);

/* Read a weight within the range of the library. */
bool lines_weight(lines *r, double *out);

#endif
