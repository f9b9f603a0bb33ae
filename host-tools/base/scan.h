/* host-tools/base/scan.h -- numbers in text, as SVG writes them: no locale, no hexadecimal, no nan
 * SPDX-License-Identifier: MIT
 *
 * Each function moves `*at` behind what it has read, and leaves it alone when there is nothing to
 * read.
 */
#ifndef LOFT_SCAN_H
#define LOFT_SCAN_H

#include <stdbool.h>

/* White space; and white space with at most one comma in it (true if there was a comma). */
void scan_space(const char **at);
bool scan_comma(const char **at);

/* 12  -.5  +1.5e-3  1.  : the longest number that starts here, so `1.5.5-3e-2` is three of them. */
bool scan_number(const char **at, double *out);

/* Numbers with blanks, commas and semicolons between and behind them, to the end of the line at
 * most; how many of `most` there were. `*at` is then at the first thing that is none. */
int scan_numbers(const char **at, double out[], int most);

/* A letter or a word of letters, digits, - and _; its length, 0 if there is none. `*at` stays. */
int scan_word(const char *at);

#endif
