/* lib/num/text.c -- numbers as decimal text and back
 * SPDX-License-Identifier: MIT
 */
#include "num/text.h"

static bool is_digit(char c) { return c >= '0' && c <= '9'; }

#if LOFT_NUM == LOFT_Q16
/* Reading. With 17 decimals f, f / 10^17 is f / 5^17 halves of an LSB: what is behind them can only
 * say whether a remainder is above 0. 5^17 < 2^40, 10^17 < 2^57. */
#define DECIMALS 17
#define HALVES   UINT64_C(762939453125)

typedef struct {
    uint32_t whole;         /* at most 10 times TOO_LARGE */
    uint64_t decimals;
    uint8_t count;          /* of decimals */
    bool more;              /* digits other than 0 behind them */
} digits;

#define NO_DIGITS { 0, 0, 0, false }
#define TOO_LARGE 32769u

static void take_digit(digits *d, unsigned digit, bool behind)
{
    if (!behind) {
        d->whole = d->whole < TOO_LARGE ? d->whole * 10 + digit : TOO_LARGE;
    } else if (d->count < DECIMALS) {
        d->decimals = d->decimals * 10 + digit;
        d->count++;
    } else {
        d->more |= digit > 0;
    }
}

static bool number_of(digits *d, bool minus, loft_real *out)
{
    for (; d->count < DECIMALS; d->count++)
        d->decimals *= 10;
    if (d->whole >= TOO_LARGE)
        return false;
    const uint64_t halves = d->decimals / HALVES;
    const bool tie = !d->more && d->decimals == halves * HALVES && halves % 2 == 1;
    const uint32_t size = (d->whole << 16) + (uint32_t)((halves + 1) / 2) - (minus && tie);

    if (size > (uint32_t)INT32_MAX + minus)
        return false;
    *out = minus ? -(loft_real)(size - (size > 0)) - (size > 0) : (loft_real)size;
    return true;
}

/* Writing: the parts of |a|, the second in steps of 2^-BITS, of which 10 times fits. */
#define BITS 28
typedef uint32_t fraction;

static bool parts_of(loft_real a, uint32_t *whole, fraction *part)
{
    const uint32_t size = a < 0 ? 0 - (uint32_t)a : (uint32_t)a;

    *whole = size >> 16;
    *part  = (size & 0xffffu) << (BITS - 16);
    return true;
}
typedef uint32_t whole_part;

#else
/* Reading. Digits are gathered in 64 bits, 19 at most; a power of ten up to 10^22 is exact. */
#define POWER_MAX 22
#define FULL      UINT64_C(1000000000000000000)

typedef struct {
    uint64_t number;
    uint8_t decimals, zeros;    /* of it; before the point, behind it */
} digits;

#define NO_DIGITS { 0, 0, 0 }

static void take_digit(digits *d, unsigned digit, bool behind)
{
    const bool full = d->number >= FULL;

    if (behind && (full || d->decimals == POWER_MAX))
        return;
    if (full)
        d->zeros = d->zeros <= POWER_MAX ? (uint8_t)(d->zeros + 1) : d->zeros;
    else
        d->number = d->number * 10 + digit;
    d->decimals = (uint8_t)(d->decimals + behind);
}

static bool number_of(const digits *d, bool minus, loft_real *out)
{
    loft_acc power = 1, x = (loft_acc)d->number;

    for (int k = d->decimals + d->zeros; k > 0; k--)
        power *= 10;
    x = d->zeros > 0 ? x * power : x / power;
    if (d->zeros > POWER_MAX || !loft_acc_valid(x))
        return false;
    *out = loft_acc_round(minus ? -x : x);
    return true;
}

/* Writing. Above 2^-8 a double has no bits below 2^-60. */
#define BITS 60
typedef uint64_t fraction;
typedef uint64_t whole_part;

static bool parts_of(loft_real a, uint64_t *whole, fraction *part)
{
    const loft_acc x = a < 0 ? -(loft_acc)a : (loft_acc)a;

    if (!(x < (loft_acc)9223372036854775808.0))
        return false;
    *whole = (uint64_t)x;
    *part  = (fraction)((x - (loft_acc)*whole) * (loft_acc)((fraction)1 << BITS));
    return true;
}
#endif

const char *loft_real_from_text(const char *text, loft_real *out)
{
    digits d = NO_DIGITS;
    const bool minus = *text == '-';
    bool any = false, behind = false;

    for (text += minus || *text == '+'; is_digit(*text) || (*text == '.' && !behind); text++) {
        if (*text == '.') {
            behind = true;
            continue;
        }
        any = true;
        take_digit(&d, (unsigned)(*text - '0'), behind);
    }
    return any && number_of(&d, minus, out) ? text : NULL;
}

/* The decimals of a part; true if it rounds to 1. */
static bool write_part(fraction part, bool odd, unsigned decimals, char text[])
{
    const fraction half = (fraction)1 << (BITS - 1), below = 2 * half - 1;
    unsigned n = 0;

    for (; n < decimals; n++) {
        part *= 10;
        text[n] = (char)('0' + (int)(part >> BITS));
        part &= below;
    }
    odd = n > 0 ? (text[n - 1] - '0') % 2 == 1 : odd;
    if (part < half || (part == half && !odd))
        return false;
    while (n > 0 && text[n - 1] == '9')
        text[--n] = '0';
    if (n > 0)
        text[n - 1]++;
    return n == 0;
}

unsigned loft_to_text(loft_real a, unsigned decimals, char text[LOFT_TEXT_MAX])
{
    char part[LOFT_TEXT_DECIMALS], number[20];
    unsigned n = 0, length = 0;
    whole_part whole;
    fraction rest;
    bool any;

    text[0] = '\0';
    if (!parts_of(a, &whole, &rest))
        return 0;
    decimals = decimals < LOFT_TEXT_DECIMALS ? decimals : LOFT_TEXT_DECIMALS;
    whole += write_part(rest, whole % 2 == 1, decimals, part);
    any = whole > 0;
    for (unsigned k = 0; k < decimals; k++)
        any |= part[k] != '0';
    do
        number[n++] = (char)('0' + (int)(whole % 10));
    while ((whole /= 10) > 0);
    if (a < 0 && any)
        text[length++] = '-';
    while (n > 0)
        text[length++] = number[--n];
    if (decimals > 0)
        text[length++] = '.';
    for (unsigned k = 0; k < decimals; k++)
        text[length++] = part[k];
    text[length] = '\0';
    return length;
}
