/* ports/host/duration.h -- a duration as people read it
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_DURATION_H
#define LOFT_HOST_DURATION_H

#define HOST_DURATION 32        /* characters that hold one */

/* Put the digits of a number behind `to`, at least so many. */
static inline char *host_digits(char *to, unsigned long long number, int least)
{
    char last[24];
    int count = 0;

    for (; number > 0 || count < least; number /= 10)
        last[count++] = (char)('0' + number % 10);
    while (count > 0)
        *to++ = last[--count];
    return to;
}

/* Write `12.5 s` with so many decimals (0..3), from a minute on `3:09`, from an hour on `3:09:12`;
 * `--:--` for what is unknown: no number, or more than 10^9 s. Safe in a signal handler. */
static inline const char *host_duration(char text[HOST_DURATION], double seconds, int decimals)
{
    static const unsigned long long scales[] = { 1, 10, 100, 1000 };
    const unsigned long long scale = scales[decimals];
    char *to = text;

    if (!(seconds >= 0 && seconds <= 1e9)) {
        for (const char *from = "--:--"; *from != '\0'; from++)
            *to++ = *from;
        *to = '\0';
        return text;
    }
    const unsigned long long parts = (unsigned long long)(seconds * (double)scale + 0.5),
                             whole = (unsigned long long)(seconds + 0.5);
    if (parts < 60 * scale) {
        to = host_digits(to, parts / scale, 1);
        if (decimals > 0) {
            *to++ = '.';
            to    = host_digits(to, parts % scale, decimals);
        }
        *to++ = ' ';
        *to++ = 's';
    } else {
        if (whole >= 3600) {
            to    = host_digits(to, whole / 3600, 1);
            *to++ = ':';
        }
        to    = host_digits(to, whole / 60 % 60, whole >= 3600 ? 2 : 1);
        *to++ = ':';
        to    = host_digits(to, whole % 60, 2);
    }
    *to = '\0';
    return text;
}

#endif
