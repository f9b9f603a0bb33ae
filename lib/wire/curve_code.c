/* lib/wire/curve_code.c -- cubics and their feeds
 * SPDX-License-Identifier: MIT
 *
 *     bits 0..5 of the first byte     axis i moves: some point is not p0
 *     bit 6                           straight: p1 and p2 are at the thirds
 *     bit 7                           the feed follows; otherwise it is that of the last curve
 *
 * Then, for each moving axis, e = p3 - p0 of a straight curve, or
 *
 *     e1 = (p1 - p0) - change     change: p3 - p2 of the last curve; e1 is 0 for equal handles
 *     e2 = p2 - 2 p1 + p0
 *     e3 = p3 - 3 p2 + 3 p1 - p0
 *
 * each modulo 2^32. An item with a feed of 0 is a part of a patch (patch_code.h): two points, p1
 * and p2, and it ends where it begins. It always gives its feed, and for each axis with a bit
 *
 *     e1 = (p1 - p0) - change     change: of a part, its p2 - p3: the last point
 *     e2 = p2 - p1
 *
 * After it the last feed is 1, so that no curve becomes a part by leaving out its feed.
 */
#include "wire/curve_code.h"

#include "wire/varint.h"    /* loft_varint_encode */

#define STRAIGHT 0x40u
#define FEED     0x80u

typedef char loft_assert_axes_fit[LOFT_AXES <= 6 ? 1 : -1];

/* The nearest whole number to d / 3, d signed. No d lies half way. */
static uint32_t third(uint32_t d)
{
    return d & 0x80000000u ? 0u - (0u - d + 1u) / 3u : (d + 1u) / 3u;
}

static bool is_straight(const loft_predictor *p, const loft_item *item)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const uint32_t p3 = (uint32_t)item->p[2][i], part = third(p3 - p->position[i]);
        if ((uint32_t)item->p[0][i] != p->position[i] + part ||
            (uint32_t)item->p[1][i] != p3 - part)
            return false;
    }
    return true;
}

bool loft_curve_is_part(const loft_predictor *p, const loft_item *item)
{
    for (int i = 0; i < LOFT_AXES; i++)
        if ((uint32_t)item->p[2][i] != p->position[i])
            return false;
    return item->ticks == 0;
}

static uint8_t put_part(uint8_t *byte, const loft_predictor *p, const loft_item *item)
{
    uint8_t n = 2;

    byte[0] = FEED;
    byte[1] = 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        const uint32_t p1 = (uint32_t)item->p[0][i], p2 = (uint32_t)item->p[1][i];
        const uint32_t e1 = p1 - p->position[i] - p->change[i];
        if (e1 == 0 && p2 == p1)
            continue;
        byte[0] = (uint8_t)(byte[0] | 1u << i);
        n = (uint8_t)(n + loft_residual_encode(byte + n, e1));
        n = (uint8_t)(n + loft_residual_encode(byte + n, p2 - p1));
    }
    return n;
}

static bool moves(const loft_predictor *p, const loft_item *item, int i)
{
    return (uint32_t)item->p[0][i] != p->position[i] || item->p[1][i] != item->p[0][i] ||
           item->p[2][i] != item->p[0][i];
}

uint8_t loft_curve_encode(uint8_t byte[LOFT_CURVE_BYTES], const loft_predictor *p,
                          const loft_item *item)
{
    const bool straight = is_straight(p, item), feed = item->ticks != p->ticks;
    uint8_t n = 1;

    if (item->ticks == 0)
        return put_part(byte, p, item);
    byte[0] = (uint8_t)((straight ? STRAIGHT : 0u) | (feed ? FEED : 0u));
    if (feed)
        n = (uint8_t)(n + loft_varint_encode(byte + n, item->ticks));
    for (int i = 0; i < LOFT_AXES; i++) {
        const uint32_t p0 = p->position[i],          p1 = (uint32_t)item->p[0][i];
        const uint32_t p2 = (uint32_t)item->p[1][i], p3 = (uint32_t)item->p[2][i];
        if (!moves(p, item, i))
            continue;
        byte[0] = (uint8_t)(byte[0] | 1u << i);
        if (straight) {
            n = (uint8_t)(n + loft_residual_encode(byte + n, p3 - p0));
            continue;
        }
        n = (uint8_t)(n + loft_residual_encode(byte + n, p1 - p0 - p->change[i]));
        n = (uint8_t)(n + loft_residual_encode(byte + n, p2 - 2u*p1 + p0));
        n = (uint8_t)(n + loft_residual_encode(byte + n, p3 - 3u*p2 + 3u*p1 - p0));
    }
    return n;
}

const uint8_t *loft_curve_decode(const uint8_t *byte, loft_predictor *p, loft_item *item)
{
    const uint8_t form = *byte++;

    item->ticks     = form & FEED ? (uint16_t)loft_varint_decode(&byte) : p->ticks;
    const bool part = form & FEED && item->ticks == 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        const uint32_t p0 = p->position[i];
        uint32_t p1 = p0, p2 = p0, p3 = p0;
        if (part) {
            const bool moves = (form & 1u << i) != 0;
            p1 += p->change[i] + (moves ? loft_residual_decode(&byte) : 0);
            p2 = p1 + (moves ? loft_residual_decode(&byte) : 0);
        } else if (form & 1u << i && form & STRAIGHT) {
            p3 = p0 + loft_residual_decode(&byte);
            p1 = p0 + third(p3 - p0);
            p2 = p3 - third(p3 - p0);
        } else if (form & 1u << i) {
            p1 = loft_residual_decode(&byte) + p0 + p->change[i];
            p2 = loft_residual_decode(&byte) + 2u*p1 - p0;
            p3 = loft_residual_decode(&byte) + 3u*(p2 - p1) + p0;
        }
        item->p[0][i] = loft_word_signed(p1);
        item->p[1][i] = loft_word_signed(p2);
        item->p[2][i] = loft_word_signed(p3);
        p->position[i] = p3;
        p->change[i]   = part ? p2 - p3 : p3 - p2;
        p->bend[i]     = 0;
    }
    p->ticks = part ? 1 : item->ticks;
    return byte;
}

uint8_t loft_curve_size(const uint8_t *byte, uint8_t left)
{
    const uint8_t form = left > 0 ? byte[0] : 0;
    uint8_t size = 1, residuals = form & STRAIGHT ? 1 : 3;

    if (left == 0 || (form & 0x3Fu) >> LOFT_AXES)
        return 0;
    if (form & FEED) {
        const uint8_t *at = byte + 1;
        const uint8_t n = loft_varint_size(at, (uint8_t)(left - size));
        if (n == 0 || n > 3)
            return 0;
        const uint32_t feed = loft_varint_decode(&at);
        if (feed > 0xFFFFu || (feed == 0 && form & STRAIGHT))
            return 0;
        residuals = feed == 0 ? 2 : residuals;
        size = (uint8_t)(size + n);
    }
    for (uint8_t bit = 1; bit < STRAIGHT; bit = (uint8_t)(bit << 1))
        for (uint8_t k = 0; form & bit && k < residuals; k++) {
            const uint8_t n = loft_varint_size(byte + size, (uint8_t)(left - size));
            if (n == 0)
                return 0;
            size = (uint8_t)(size + n);
        }
    return size;
}
