/* tests/target/say.h -- words and numbers, letter by letter, from a program without a C library
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TARGET_SAY_H
#define LOFT_TARGET_SAY_H

#include <stdint.h>

static inline void say_words(void (*put)(char), const char *words)
{
    while (*words)
        put(*words++);
}

static inline void say_number(void (*put)(char), uint32_t n)
{
    char digits[10];
    int k = 0;

    do
        digits[k++] = (char)('0' + n % 10);
    while ((n /= 10) > 0);
    while (k > 0)
        put(digits[--k]);
}

/* A line: words, a number. */
static inline void say_line(void (*put)(char), const char *words, uint32_t n)
{
    say_words(put, words);
    put(' ');
    say_number(put, n);
    put('\n');
}

#endif
