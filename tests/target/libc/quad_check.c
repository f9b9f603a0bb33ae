/* tests/target/libc/quad_check.c -- compares quad.c with gcc's __float128, bit for bit
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <string.h>

#include <stdint.h>

#define QUAD(name) own_##name
__extension__ typedef __float128 quad;
#include "quad.c"

static uint64_t state;
static unsigned wrong;

static uint64_t random_64(void)         /* splitmix64 (Steele, Lea, Flood 2014) */
{
    uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/* Any number: few bits or many, near 1 or anywhere, zeros, infinities, NaNs. */
static uwide arbitrary(void)
{
    const uint64_t r = random_64();
    uwide m = ((uwide)random_64() << 64 | random_64()) & (((uwide)1 << 112) - 1);
    unsigned e = (unsigned)(r >> 8) & 0x7fff;

    if (r & 1)
        e = (unsigned)(BIAS - 60 + (int)(r >> 8 & 127));
    if ((r >> 32 & 31) == 0)
        e = (r >> 37 & 3) == 0 ? 0x7fff : (unsigned)(r >> 39 & 1);
    if (r >> 41 & 1)
        m = m >> (r >> 42 & 127) % 112 << (r >> 42 & 127) % 112;        /* few bits */
    if ((r >> 49 & 7) == 0)
        m = (r >> 52 & 1) ? 0 : (((uwide)1 << 112) - 1);
    return (uwide)(r >> 63) << 127 | (uwide)e << 112 | m;
}

static void same(const char *what, quad x, quad y, quad got, quad want)
{
    const uwide a = bits_of(got), b = bits_of(want);

    if (a == b || (nan_(a) && nan_(b)))
        return;
    if (wrong++ < 10)
        printf("%s of %.20Lg and %.20Lg: %016llx %016llx, wanted %016llx %016llx\n", what,
               (long double)x, (long double)y, (unsigned long long)(a >> 64), (unsigned long long)a,
               (unsigned long long)(b >> 64), (unsigned long long)b);
}

#define AGREE(what, got, want)                                                                     \
    do {                                                                                           \
        if (memcmp(&(got), &(want), sizeof(want)) && wrong++ < 10)                                 \
            printf("%s of %.20Lg differs\n", what, (long double)x);                                \
    } while (0)

static void conversions(quad x)
{
    const double d = (double)x, own_d = own_trunctfdf2(x);
    const float f = (float)x, own_f = own_trunctfsf2(x);

    if (!nan_(bits_of(x))) {
        AGREE("double", own_d, d);
        AGREE("float", own_f, f);
    }
    same("double as quad", d, 0, own_extenddftf2(d), d);
    same("float as quad", f, 0, own_extendsftf2(f), f);
    const wide t = (wide)((uwide)random_64() << 64 | random_64()) >> random_64() % 127;
    same("whole number", (quad)t, 0, own_floattitf(t), (quad)t);
    same("whole number of 64 bits", (quad)t, 0, own_floatditf((int64_t)t), (quad)(int64_t)t);
    same("whole number without a sign", (quad)t, 0, own_floatuntitf((uwide)t), (quad)(uwide)t);
    const quad whole = (quad)t * 0.75Q;
    const wide back = own_fixtfti(whole), want = (wide)whole;
    AGREE("toward zero", back, want);
}

int main(void)
{
    for (unsigned n = 0; n < 1000000; n++) {
        const quad x = quad_of(arbitrary()), y = n % 16 == 0   ? x
                                                 : n % 16 == 1 ? -x
                                                               : quad_of(arbitrary());
        same("sum", x, y, own_addtf3(x, y), x + y);
        same("difference", x, y, own_subtf3(x, y), x - y);
        same("product", x, y, own_multf3(x, y), x * y);
        if (n % 8 == 0)
            same("quotient", x, y, own_divtf3(x, y), x / y);
        if ((own_lttf2(x, y) < 0) != (x < y) || (own_letf2(x, y) <= 0) != (x <= y) ||
            (own_gttf2(x, y) > 0) != (x > y) || (own_getf2(x, y) >= 0) != (x >= y) ||
            (own_eqtf2(x, y) == 0) != (x == y))
            wrong++;
        conversions(x);
    }
    printf("%s quad: sums, products, quotients, orders and conversions as those of __float128 "
           "(1000000)\n",
           wrong ? "FAIL" : "ok  ");
    return wrong > 0;
}
