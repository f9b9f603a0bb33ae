/* tests/target/libc/int128.c -- products, quotients and shifts of 128 bits, if the compiler's
 * library has none
 * SPDX-License-Identifier: MIT
 *
 * clang -Xclang -fforce-enable-int128 calls these functions, by these names. No function may be
 * compiled into a call of itself: shifts work on halves, and products have 64 bits.
 */
#include <stdint.h>

__extension__ typedef unsigned __int128 uwide;
__extension__ typedef __int128 wide;

typedef union {
    uwide whole;
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    struct {
        uint64_t high, low;
    } half;
#else
    struct {
        uint64_t low, high;
    } half;
#endif
} halves;

uwide __multi3(uwide a, uwide b);
wide  __ashlti3(wide a, int n);
uwide __lshrti3(uwide a, int n);
wide  __ashrti3(wide a, int n);
uwide __udivti3(uwide a, uwide b);
uwide __umodti3(uwide a, uwide b);
wide  __divti3(wide a, wide b);
wide  __modti3(wide a, wide b);

uwide __multi3(uwide a, uwide b)
{
    const halves x = { a }, y = { b };
    const uint64_t x1 = x.half.low >> 32, x0 = (uint32_t)x.half.low, y1 = y.half.low >> 32,
                   y0 = (uint32_t)y.half.low;
    const uint64_t low = x0 * y0, mid = x1 * y0 + (low >> 32), other = x0 * y1 + (uint32_t)mid;
    halves r;

    r.half.low = other << 32 | (uint32_t)low;
    r.half.high = x1 * y1 + (mid >> 32) + (other >> 32) + x.half.high * y.half.low +
                  x.half.low * y.half.high;
    return r.whole;
}

wide __ashlti3(wide a, int n)
{
    halves x = { (uwide)a };

    if (n >= 64)
        x.half.high = x.half.low << (n - 64), x.half.low = 0;
    else if (n > 0)
        x.half.high = x.half.high << n | x.half.low >> (64 - n), x.half.low <<= n;
    return (wide)x.whole;
}

uwide __lshrti3(uwide a, int n)
{
    halves x = { a };

    if (n >= 64)
        x.half.low = x.half.high >> (n - 64), x.half.high = 0;
    else if (n > 0)
        x.half.low = x.half.low >> n | x.half.high << (64 - n), x.half.high >>= n;
    return x.whole;
}

wide __ashrti3(wide a, int n)
{
    halves x = { (uwide)a };
    const int64_t high = (int64_t)x.half.high;

    if (n >= 64)
        x.half.low = (uint64_t)(high >> (n - 64)), x.half.high = (uint64_t)(high >> 63);
    else if (n > 0)
        x.half.low = x.half.low >> n | x.half.high << (64 - n), x.half.high = (uint64_t)(high >> n);
    return (wide)x.whole;
}

/* a / b, bit by bit; *rest is the remainder. */
static uwide divided(uwide a, uwide b, uwide *rest)
{
    halves q = { a }, d = { b }, r = { 0 };

    if (q.half.high == 0 && d.half.high == 0 && d.half.low != 0) {
        r.half.low = q.half.low % d.half.low;
        q.half.low /= d.half.low;
        *rest = r.whole;
        return q.whole;
    }
    for (int n = 0; n < 128; n++) {
        r.half.high = r.half.high << 1 | r.half.low >> 63;
        r.half.low = r.half.low << 1 | q.half.high >> 63;
        q.half.high = q.half.high << 1 | q.half.low >> 63;
        q.half.low <<= 1;
        if (r.whole >= d.whole) {
            r.whole -= d.whole;
            q.half.low |= 1;
        }
    }
    *rest = r.whole;
    return q.whole;
}

static uwide size_of(wide a) { return a < 0 ? -(uwide)a : (uwide)a; }

uwide __udivti3(uwide a, uwide b)
{
    uwide rest;
    return divided(a, b, &rest);
}
uwide __umodti3(uwide a, uwide b)
{
    uwide rest;
    divided(a, b, &rest);
    return rest;
}

wide __divti3(wide a, wide b)
{
    uwide rest;
    const uwide q = divided(size_of(a), size_of(b), &rest);
    return (wide)((a < 0) != (b < 0) ? -q : q);
}

wide __modti3(wide a, wide b)
{
    uwide rest;
    divided(size_of(a), size_of(b), &rest);
    return (wide)(a < 0 ? -rest : rest);
}
