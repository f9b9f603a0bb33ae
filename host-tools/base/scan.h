/* host-tools/base/scan.h -- numbers in text, as SVG writes them: no locale, no hexadecimal, no nan
 * SPDX-License-Identifier: MIT
 *
 * Each function moves `*at` past what it has read. If there is nothing to read, `*at` stays.
 */
#ifndef LOFT_SCAN_H
#define LOFT_SCAN_H

#include <stdbool.h>

/* Skip white space; skip white space with at most one comma in it (true if there was a comma). */
void scan_space(const char **at);
bool scan_comma(const char **at);

/* 12  -.5  +1.5e-3  1.  : read the longest number that starts here, so `1.5.5-3e-2` holds three. */
bool scan_number(const char **at, double *out);

/* Read numbers, separated and followed by blanks, commas and semicolons, up to the end of the line.
 * Returns how many of `most` there were. `*at` is then at the first character after them. */
int scan_numbers(const char **at, double out[], int most);

/* The length of a letter, or of a word of letters, digits, - and _; 0 if there is none. `*at`
 * stays. */
int scan_word(const char *at);

#endif
