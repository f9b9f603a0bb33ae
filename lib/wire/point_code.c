/* lib/wire/point_code.c
 * SPDX-License-Identifier: MIT
 */
#include "wire/point_code.h"

/* A point is one group of residuals for each three axes. The last group may have one or two.
 *
 *     0..124      residuals r0 r1 r2 in -2..2:  (r0 + 2) + 5 (r1 + 2) + 25 (r2 + 2); absent axes
 *                                               count as r = 0
 *     125         each residual in one byte, int8
 *     126         each in two bytes, int16, low byte first
 *     127         each in four bytes, int32
 *     128..255    b - 127 points whose residuals are all 0; only at the start of a point
 */
#define STILL   62u     /* all residuals 0, in a group after the first */
#define WIDE8  125u
#define RUN    LOFT_POINT_RUN

static uint8_t group_axes(int first)
{
    return (uint8_t)(LOFT_AXES - first < 3 ? LOFT_AXES - first : 3);
}

/* The number of bytes of each residual; 0 if all fit into the one-byte code. */
static uint8_t width_of(const uint32_t r[3])
{
    uint8_t width = 0;
    for (int i = 0; i < 3; i++) {
        const uint8_t w = r[i] + 2u <= 4u             ? 0
                          : r[i] + 0x80u <= 0xFFu     ? 1
                          : r[i] + 0x8000u <= 0xFFFFu ? 2
                                                      : 4;
        if (w > width)
            width = w;
    }
    return width;
}

static uint8_t put_group(uint8_t *byte, const uint32_t r[3], uint8_t axes)
{
    const uint8_t width = width_of(r);
    uint8_t n = 0;
    if (width == 0) {
        byte[0] = (uint8_t)(STILL + r[0] + 5u*r[1] + 25u*r[2]);
        return 1;
    }
    byte[n++] = (uint8_t)(WIDE8 + width / 2);
    for (uint8_t i = 0; i < axes; i++)
        for (uint8_t k = 0; k < width; k++)
            byte[n++] = (uint8_t)(r[i] >> (8 * k));
    return n;
}

uint8_t loft_point_encode(uint8_t byte[LOFT_POINT_BYTES], const uint32_t residual[LOFT_AXES])
{
    uint8_t n = 0;
    for (int first = 0; first < LOFT_AXES; first += 3) {
        uint32_t r[3] = { 0, 0, 0 };
        for (int i = first; i < LOFT_AXES && i < first + 3; i++)
            r[i - first] = residual[i];
        n = (uint8_t)(n + put_group(byte + n, r, group_axes(first)));
    }
    return n;
}

/* The digits of the code: three short loops instead of divisions. */
static void get_digits(uint8_t code, uint32_t r[3])
{
    for (r[2] = (uint32_t)-2; code >= 25; code = (uint8_t)(code - 25))
        r[2]++;
    for (r[1] = (uint32_t)-2; code >= 5; code = (uint8_t)(code - 5))
        r[1]++;
    r[0] = code - (uint32_t)2;
}

static const uint8_t *get_group(const uint8_t *byte, uint32_t r[3], uint8_t axes)
{
    const uint8_t code = *byte++;
    if (code < WIDE8) {
        get_digits(code, r);
        return byte;
    }
    const uint8_t width = (uint8_t)(1u << (code - WIDE8));
    for (uint8_t i = 0; i < axes; i++) {
        /* the sign, shifted out at width 4 */
        r[i] = byte[width - 1] & 0x80u ? 0xFFFFFFFFu : 0u;
        for (uint8_t k = width; k > 0; k--)
            r[i] = (r[i] << 8) | byte[k - 1];
        byte += width;
    }
    return byte;
}

const uint8_t *loft_point_decode(const uint8_t *byte, uint32_t residual[LOFT_AXES])
{
    for (int first = 0; first < LOFT_AXES; first += 3) {
        uint32_t r[3];
        byte = get_group(byte, r, group_axes(first));
        for (int i = first; i < LOFT_AXES && i < first + 3; i++)
            residual[i] = r[i - first];
    }
    return byte;
}

uint8_t loft_point_size(const uint8_t *byte, uint8_t left)
{
    uint16_t size = 0;
    for (int first = 0; first < LOFT_AXES; first += 3) {
        if (size >= left || byte[size] >= RUN)
            return 0;
        const uint8_t code = byte[size];
        size = (uint16_t)(size + 1u +
                          (code < WIDE8 ? 0u : (unsigned)group_axes(first) << (code - WIDE8)));
    }
    return (uint8_t)(size <= left ? size : 0);
}
