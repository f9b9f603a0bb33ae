/* host-tools/base/scan.c -- numbers in text
 * SPDX-License-Identifier: MIT
 */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "base/scan.h"

void scan_space(const char **at) { *at += strspn(*at, " \t\r\n\f"); }

bool scan_comma(const char **at)
{
    scan_space(at);
    if (**at != ',')
        return false;
    ++*at;
    scan_space(at);
    return true;
}

static const char *digits(const char *s) { return s + strspn(s, "0123456789"); }

/* The end of the number that starts at `s`; `s` itself if there is none. */
static const char *number_end(const char *s)
{
    const char *whole = s + (*s == '+' || *s == '-'), *end = digits(whole);
    size_t count = (size_t)(end - whole);

    if (*end == '.') {
        const char *fraction = end + 1;
        end = digits(fraction);
        count += (size_t)(end - fraction);
    }
    if (count == 0)
        return s;
    if (*end == 'e' || *end == 'E') {
        const char *power = end + 1 + (end[1] == '+' || end[1] == '-');
        if (isdigit((unsigned char)*power))
            end = digits(power);
    }
    return end;
}

bool scan_number(const char **at, double *out)
{
    const char *end = number_end(*at);
    char *taken;

    if (end == *at)
        return false;
    *out = strtod(*at, &taken);
    if (taken != end)           /* 0x10 is a zero, followed by garbage */
        *out = 0;
    *at = end;
    return true;
}

int scan_numbers(const char **at, double out[], int most)
{
    static const char between[] = ",; \t\r";
    int count = 0;

    for (*at += strspn(*at, between); count < most && scan_number(at, &out[count]);
         *at += strspn(*at, between))
        count++;
    return count;
}

int scan_word(const char *at)
{
    int length = 0;

    while (isalnum((unsigned char)at[length]) || at[length] == '-' || at[length] == '_')
        length++;
    return length;
}
