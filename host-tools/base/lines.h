/* host-tools/base/lines.h -- a text read line by line: its words and numbers, and what is wrong
 * with it
 * SPDX-License-Identifier: MIT
 *
 * What curves and surfaces in the format .loft have in common: `#` starts a comment, blanks, tabs,
 * commas and semicolons separate numbers, a line begins with a word or with a number.
 */
#ifndef LOFT_HOST_LINES_H
#define LOFT_HOST_LINES_H

#include <stdbool.h>

#define LINES_AXES         3
#define LINES_WEIGHT_LEAST (1 / 256.0)  /* of the library */
#define LINES_WEIGHT_MOST  256.0

typedef struct {
    const char *file;
    unsigned line;          /* from 1                      */
    const char *rest;       /* of the line                 */
} lines;

/* The first thing of a text that is neither space nor comment. */
const char *lines_start(const char *text);

/* Call `each` at the first thing of every line that has one, until it gives an exit code; gives
 * that, or 0. */
int lines_read(lines *r, const char *text, int (*each)(void *context), void *context);

/* Print `file:line: what: remedy`; gives EX_DATAERR. */
int lines_wrong(const lines *r, const char *what, const char *remedy);

/* Is there nothing more in this line? */
bool lines_over(const lines *r);

/* Go on behind `word` and blanks if that is the next word; behind the colon if there is one
 * next. */
bool lines_word(lines *r, const char *word);
bool lines_colon(lines *r);

/* Up to `most` finite numbers: their count, or -1 if one is not finite; the same, and nothing may
 * stand behind them. */
int lines_numbers(lines *r, double out[], int most);
int lines_numbers_alone(lines *r, double out[], int most);

/* `x y` or `x y z`: the number of axes (others are 0), or 0 if that is not what stands there. */
int lines_vector(lines *r, double out[LINES_AXES]);

/* A weight within the range of the library. */
bool lines_weight(lines *r, double *out);

#endif
