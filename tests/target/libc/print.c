/* tests/target/libc/print.c -- text
 * SPDX-License-Identifier: MIT
 */
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>

#include "math.h"
#include "semihost.h"           /* semihost_write */
#include "stdio.h"
#include "stdlib.h"
#include "string.h"

static char line[160];
static size_t used;

static void put(char c)
{
    line[used++] = c;
    if (c == '\n' || used == sizeof line - 1) {
        line[used] = 0;
        semihost_write(line);
        used = 0;
    }
}

static void put_text(const char *text)
{
    while (*text)
        put(*text++);
}

static void put_whole(uint64_t value, unsigned base)
{
    char digit[24];
    int n = 0;

    do {
        digit[n++] = "0123456789abcdef"[value % base];
        value /= base;
    } while (value);
    while (n)
        put(digit[--n]);
}

/* d.dddddddddddddddde+x: 17 digits name a double. */
static void put_real(double x)
{
    long double m = fabs(x);
    int e = 0;

    if (!isfinite(x)) {
        put_text(isnan(x) ? "nan" : x < 0 ? "-inf" : "inf");
        return;
    }
    for (; m >= 10; e++)
        m /= 10;
    for (; m != 0 && m < 1; e--)
        m *= 10;
    uint64_t digits = (uint64_t)(m * 1e16L + 0.5L);
    if (digits >= 100000000000000000u) {
        digits /= 10;
        e++;
    }
    if (x < 0)
        put('-');
    put((char)('0' + digits / 10000000000000000u));
    put('.');
    for (uint64_t unit = 1000000000000000u; unit; unit /= 10)
        put((char)('0' + digits / unit % 10));
    put_text(e < 0 ? "e-" : "e+");
    put_whole((uint64_t)(e < 0 ? -e : e), 10);
}

/* Print the value for one `%`. Returns the text after it. */
static const char *put_value(const char *format, va_list *values)
{
    int longs = 0;

    while (strchr("-+ #0123456789.", *format) != NULL && *format)
        format++;
    for (; *format == 'l' || *format == 'z' || *format == 'L'; format++)
        longs += *format == 'l';
    switch (*format) {
    case 'd': {
        const int64_t value = longs > 1 ? va_arg(*values, long long)
                              : longs   ? va_arg(*values, long)
                                        : va_arg(*values, int);
        if (value < 0)
            put('-');
        put_whole(value < 0 ? -(uint64_t)value : (uint64_t)value, 10);
        break;
    }
    case 'u':
    case 'x':
        put_whole(longs > 1 ? va_arg(*values, unsigned long long)
                  : longs   ? va_arg(*values, unsigned long)
                            : va_arg(*values, unsigned),
                  *format == 'x' ? 16 : 10);
        break;
    case 'e':
    case 'f':
    case 'g':   put_real(va_arg(*values, double));              break;
    case 's':   put_text(va_arg(*values, const char *));        break;
    case 'c':   put((char)va_arg(*values, int));                break;
    default:    put(*format);                                   break;
    }
    return format + 1;
}

int printf(const char *format, ...)
{
    va_list values;

    va_start(values, format);
    while (*format)
        if (*format == '%')
            format = put_value(format + 1, &values);
        else
            put(*format++);
    va_end(values);
    return 0;
}

void abort(void)
{
    put_text("abort\n");
    semihost_exit(70);
}

void *memchr(const void *in, int value, size_t count)
{
    for (const unsigned char *p = in; count; count--, p++)
        if (*p == (unsigned char)value)
            return (void *)(uintptr_t)p;
    return NULL;
}

size_t strlen(const char *text)
{
    size_t n = 0;
    while (text[n])
        n++;
    return n;
}

int strcmp(const char *a, const char *b)
{
    while (*a && *a == *b)
        a++, b++;
    return (unsigned char)*a - (unsigned char)*b;
}

char *strchr(const char *text, int c)
{
    for (; *text; text++)
        if (*text == (char)c)
            return (char *)(uintptr_t)text;
    return c ? NULL : (char *)(uintptr_t)text;
}

unsigned long long strtoull(const char *text, char **end, int base)
{
    unsigned long long value = 0;

    for (; *text >= '0' && *text <= '9' && base == 10; text++)
        value = 10 * value + (unsigned)(*text - '0');
    if (end)
        *end = (char *)(uintptr_t)text;
    return value;
}
