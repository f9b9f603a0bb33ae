/* tests/target/say.h -- prints words and numbers, letter by letter, in a program without a C
 * library
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

/* Print a line: words and a number. */
static inline void say_line(void (*put)(char), const char *words, uint32_t n)
{
    say_words(put, words);
    put(' ');
    say_number(put, n);
    put('\n');
}

/* The same for a number of 64 bits, in halves of nine digits. */
static inline void say_wide(void (*put)(char), const char *words, uint64_t n)
{
    const uint64_t most = n / 1000000000u;
    uint32_t rest = (uint32_t)(n % 1000000000u);

    if (most == 0) {
        say_line(put, words, rest);
        return;
    }
    say_words(put, words);
    put(' ');
    say_number(put, (uint32_t)most);
    for (uint32_t digit = 100000000u; digit > 0; digit /= 10) {
        put((char)('0' + rest / digit));
        rest %= digit;
    }
    put('\n');
}

#endif
