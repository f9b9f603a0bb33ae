/* tests/lib/num/test_text.c -- properties of lib/num/text.h
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "check.h"
#include "num/text.h"

__extension__ typedef __int128 wide;

static char digit(arb *a) { return (char)('0' + (int)arb_below(a, 10)); }

/* A number as people write it, with up to that many digits before and behind the point. */
static void write_any(arb *a, unsigned before, unsigned behind, char text[80])
{
    const unsigned m = arb_below(a, before + 1), n = arb_below(a, behind + 1);

    if (arb_below(a, 2))
        *text++ = arb_below(a, 4) ? '-' : '+';
    for (unsigned k = 0; k < m; k++)
        *text++ = digit(a);
    if (n > 0 || m == 0 || arb_below(a, 2))
        *text++ = '.';
    for (unsigned k = 0; k < n || (k == 0 && m == 0); k++)
        *text++ = digit(a);
    *text = '\0';
}

#if LOFT_NUM == LOFT_Q16
/* By definition: floor(v 2^16 + 1/2), of v = n / 10^k in 128 bits. */
static void reads_the_nearest_number(arb *a)
{
    char text[80];
    loft_real x = 77;
    wide n = 0, power = 1;
    bool behind = false;

    write_any(a, 5, 20, text);
    const char *end = loft_real_from_text(text, &x);
    for (const char *c = text; *c; c++) {
        if (*c == '.')
            behind = true;
        if (*c < '0')
            continue;
        n = n * 10 + (*c - '0');
        power *= behind ? 10 : 1;
    }
    n = text[0] == '-' ? -n : n;
    wide whole = n / power, rest = n % power;
    if (rest < 0)
        whole--, rest += power;
    const wide want = whole * 65536 + (2 * rest * 65536 + power) / (2 * power);
    const bool fits = want >= INT32_MIN && want <= INT32_MAX;
    CHECK(fits ? end == text + strlen(text) && x == (loft_real)want : end == NULL && x == 77);
}

/* Halves of an LSB, which are ties, and their neighbours a digit further. */
static void reads_ties_upward(arb *a)
{
    char text[80];
    loft_real x;
    const uint32_t size = arb_below(a, 1u << 16);
    const int minus = arb_below(a, 2) == 1;

    const uint64_t decimals = (uint64_t)(2 * size + 1) * 762939453125u; /* 10^17 / 2^17 */
    snprintf(text, sizeof text, "%s.%017llu", minus ? "-" : "", (unsigned long long)decimals);
    CHECK(loft_real_from_text(text, &x) && x == (minus ? -(int32_t)size : (int32_t)size + 1));
    strcat(text, "0001");
    CHECK(loft_real_from_text(text, &x) && x == (minus ? -(int32_t)size - 1 : (int32_t)size + 1));
}

static void sixteen_decimals_are_exact(arb *a)
{
    char text[LOFT_TEXT_MAX];
    const loft_real x = (loft_real)(arb_next(a) >> 32);
    loft_real back = 0;

    CHECK(loft_to_text(x, 16, text) == strlen(text));
    CHECK(strtold(text, NULL) == (long double)x / 65536);
    CHECK(loft_real_from_text(text, &back) == text + strlen(text) && back == x);
    loft_to_text(x, 5, text);           /* 10^-5 is below an LSB */
    CHECK(loft_real_from_text(text, &back) && back == x);
}

static void ends_of_the_range_fit(arb *a)
{
    loft_real x = 0;
    (void)a;
    CHECK(loft_real_from_text("-32768", &x) && x == INT32_MIN);
    CHECK(loft_real_from_text("-32768.00000762939453125", &x) && x == INT32_MIN);
    CHECK(!loft_real_from_text("-32768.000007629394531251", &x));
    CHECK(loft_real_from_text("32767.99999", &x) && x == INT32_MAX);
    CHECK(loft_real_from_text("32767.999992370605468749", &x) && x == INT32_MAX);
    CHECK(!loft_real_from_text("32767.99999237060546875", &x) && x == INT32_MAX);
    CHECK(!loft_real_from_text("99999999999999999999", &x));
}

static loft_real arb_number(arb *a) { return (loft_real)(arb_next(a) >> 32); }
#else
static void reads_the_nearest_number(arb *a)
{
    char text[80];
    loft_real x = 0;

    write_any(a, 20, 24, text);
    const long double want = strtold(text, NULL);
    const long double ulp = fabsl(want) * BY_NUM(0, FLT_EPSILON, DBL_EPSILON);
    CHECK(loft_real_from_text(text, &x) == text + strlen(text));
    CHECK(fabsl((long double)x - want) <= ulp * BY_NUM(0, 0.50001L, 2) + 1e-22L);
    write_any(a, 6, 9, text);
    CHECK(loft_real_from_text(text, &x) == text + strlen(text));
    CHECK((double)x == (double)(loft_real)strtod(text, NULL));
}

static void reads_ties_upward(arb *a) { (void)a; }

static void sixteen_decimals_are_exact(arb *a)
{
    char text[LOFT_TEXT_MAX];
    const long double whole = (long double)(arb_next(a) >> (1 + arb_below(a, 63)));
    const loft_real x = (loft_real)(whole / 0x1p30L), y = (loft_real)1e19;

    CHECK(loft_to_text(x, 16, text) == strlen(text));
    CHECK(fabsl(strtold(text, NULL) - (long double)x) <=
          0.500001e-16L + 0x1p-60L + fabsl((long double)x) * 0x1p-63L);
    CHECK(loft_to_text(y, 3, text) == 0 && text[0] == '\0' && loft_to_text(-y, 3, text) == 0);
    CHECK(loft_to_text((loft_real)NAN, 3, text) == 0);
}

static void ends_of_the_range_fit(arb *a)
{
    char text[60] = "1";
    loft_real x = 7;
    (void)a;
    memset(text + 1, '0', 58);
    text[42] = '\0';                /* 10^41 */
    CHECK(!loft_real_from_text(text, &x) && (double)x == 7);
    text[39] = '\0';                /* 10^38 */
    CHECK(loft_real_from_text(text, &x) && fabs((double)x / 1e38 - 1) < 1e-7);
}

static loft_real arb_number(arb *a)
{
    return (loft_real)ldexp((double)(int64_t)arb_next(a), -1 - (int)arb_below(a, 80));
}
#endif

/* As printf, which rounds the exact value, ties to even; but zero has no sign. */
static void writes_as_printf_does(arb *a)
{
    char text[LOFT_TEXT_MAX], want[LOFT_TEXT_MAX + 8];
    const loft_real x = arb_number(a);
    const unsigned decimals = arb_below(a, BY_NUM(17, 10, 10));
    const double value = BY_NUM((double)x / 65536, (double)x, (double)x);

    if (fabs(value) >= 0x1p63)
        return;
    CHECK(loft_to_text(x, decimals, text) == strlen(text));
    snprintf(want, sizeof want, "%.*f", (int)decimals, value);
    CHECK(strcmp(text, want + (want[0] == '-' && strspn(want, "-0.") == strlen(want))) == 0);
}

static void what_is_no_number_is_refused(arb *a)
{
    static const char *const none[] = {
        "", "-", ".", "+.", "-.e", "x1", " 1", "--1", "+-1", "nan"
    };
    static const struct {
        const char *text;
        int used;
    } rest[] = { { "1.2.3", 3 }, { "5e3", 1 }, { "7.mm", 2 }, { "-.5,", 3 }, { "0012 ", 4 } };
    loft_real x = 3;
    (void)a;

    for (size_t k = 0; k < sizeof none / sizeof *none; k++)
        CHECK(loft_real_from_text(none[k], &x) == NULL && x == (loft_real)3);
    for (size_t k = 0; k < sizeof rest / sizeof *rest; k++)
        CHECK(loft_real_from_text(rest[k].text, &x) == rest[k].text + rest[k].used);
}

static void micrometres_are_thousandths(arb *a)
{
    const int32_t um = (int32_t)arb_below(a, 2 * 32767999u + 1) - 32767999;
    const long double off = (long double)loft_real_from_um(um) / BY_NUM(65536, 1, 1) - um / 1000.0L;
    char text[20];
    loft_real x = 0;

    CHECK(fabsl(off) <= BY_NUM(0x1p-17L, fabsl(um / 1000.0L) * 0x1.00001p-24L,
                               fabsl(um / 1000.0L) * 0x1.00001p-53L));
    snprintf(text, sizeof text, "%s%d.%03d", um < 0 ? "-" : "", abs(um) / 1000, abs(um) % 1000);
    CHECK(loft_real_from_text(text, &x) && fabs((double)(x - loft_real_from_um(um))) <= 0);
}

/* Zeros in front, and decimals that no type can hold, up to 700 of them. */
static void any_number_of_digits_is_read(arb *a)
{
    char text[1500] = "";
    const unsigned zeros = arb_below(a, 700), decimals = arb_below(a, 700);
    const unsigned whole = arb_below(a, 32768);
    size_t n = zeros;
    loft_real x = 0;

    memset(text, '0', zeros);
    n += (size_t)snprintf(text + n, 20, "%u.5", whole);
    for (unsigned k = 0; k < decimals; k++)
        text[n++] = digit(a);
    text[n] = '\0';
    CHECK(loft_real_from_text(text, &x) == text + n);
    CHECK_NEAR((double)x / BY_NUM(65536, 1, 1), strtod(text, NULL),
               BY_NUM(0x1p-17, 0x1p-9, 0x1p-37));
    memset(text, '9', n);
    x = 3;
    CHECK(n < 42 || (loft_real_from_text(text, &x) == NULL && x == (loft_real)3));
}

/* Half an ulp: of floats above 2^21 that is 2^-3, of doubles 2^-32. */
static void any_whole_micrometres_become_a_number(arb *a)
{
    const int32_t most = BY_NUM(32767999, INT32_MAX, INT32_MAX);
    const int32_t off = (int32_t)arb_below(a, 3);

    CHECK_NEAR((double)loft_real_from_um(most - off) / BY_NUM(65536, 1, 1), (most - off) / 1e3,
               BY_NUM(0x1p-17, 0x1p-3, 0x1p-32));
    CHECK_NEAR((double)loft_real_from_um(off - most) / BY_NUM(65536, 1, 1), (off - most) / 1e3,
               BY_NUM(0x1p-17, 0x1p-3, 0x1p-32));
}

int main(void)
{
    EXTREMES(loft_real_from_text, any_number_of_digits_is_read, 2000);
    EXTREMES(loft_real_from_um, any_whole_micrometres_become_a_number, 10);
    PROPERTY(reads_the_nearest_number, 200000);
    PROPERTY(reads_ties_upward, 50000);
    PROPERTY(sixteen_decimals_are_exact, 100000);
    PROPERTY(writes_as_printf_does, 100000);
    PROPERTY(micrometres_are_thousandths, 100000);
    PROPERTY(ends_of_the_range_fit, 1);
    PROPERTY(what_is_no_number_is_refused, 1);
    return check_failures();
}
