/* tests/vectors/vectors_lines.h -- where lines of constant parameters cross a level
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_VECTORS_LINES_H
#define LOFT_TESTS_VECTORS_LINES_H

#include "surface/contour.h"
#include "vectors/vectors.h"        /* row */

#define LINES_MAX 64                /* of a grid */
#define LINE_PLACES 4096

/* A whole number; `-` takes any. */
static inline void expect_number(row *r, const char *column, unsigned got)
{
    char text[24];

    snprintf(text, sizeof text, "%u", got);
    if (!row_is(r, column, "-"))
        row_expect_word(r, column, text);
}

/* How far the nearest of the places on the same line is. */
static inline long double line_distance(long double at[][2], unsigned count, unsigned fixed,
                                        const long double want[2])
{
    long double best = INFINITY;

    for (unsigned k = 0; k < count; k++)
        if (fabsl(at[k][fixed] - want[fixed]) < 0x1p-20L)
            best = fminl(best, fabsl(at[k][1 - fixed] - want[1 - fixed]));
    return best;
}

/* The places on the lines u = k / size (`fixed` 0) or v = k / size (1) where the level has its
 * number: columns size, count, slope, uv. Of a disk v = 1 is v = 0. */
static inline void expect_lines(row *r, loft_surface s, const loft_level *level, unsigned fixed)
{
    static uint8_t memory[LOFT_CONTOUR_BYTES(LINES_MAX, LINES_MAX)];
    static long double found[LINE_PLACES][2], wanted[LINE_PLACES][2];
    const unsigned size = row_count(r, "size", LINES_MAX);
    unsigned here = 0, count = 0;
    loft_contour c;
    loft_vec p;

    if (loft_contour_init_level(&c, s, level, LOFT_REAL(1.0 / 65536), size, size, memory,
                                sizeof memory) != LOFT_OK) {
        row_complain(r, "the surface was refused");
        return;
    }
    while (loft_contour_next(&c, &p) != LOFT_CONTOUR_OVER && here < LINE_PLACES) {
        const long double at[2] = { exact_unit(c.u), exact_unit(c.v) }, line = at[fixed] * size;
        if (fabsl(line - roundl(line)) >= size * 0x1p-23L)       /* k / size is rounded */
            continue;
        found[here][0] = at[0];
        found[here][1] = s.over == LOFT_SURFACE_DISK && at[1] > 0.9999L ? at[1] - 1 : at[1];
        here++;
    }
    const char *text = row_text(r, "uv"), *slope = row_text(r, "slope");
    const long double error = 2 * LSB / row_next(&slope) + 0x1p-23L;
    for (; *text && *text != '-' && count < LINE_PLACES; count++)
        for (unsigned k = 0; k < 2; k++)
            wanted[count][k] = row_next(&text);
    for (unsigned k = 0; k < count; k++)
        row_within(r, "uv", line_distance(found, here, fixed, wanted[k]) * 65536, error * 65536);
    for (unsigned k = 0; k < here; k++)             /* and no others; closed ones give two */
        row_within(r, "uv", line_distance(wanted, count, fixed, found[k]) * 65536, error * 65536);
    expect_number(r, "count", count);
}

#endif
