/* tests/vectors/vectors_deficit.c -- reader of angle deficits at a vertex
 * SPDX-License-Identifier: MIT
 */
#include "vectors/vectors_sheet.h"          /* decimal_real, expect_wide */
#include "surface/deficit.h"

#define MOST 6

static void discrete_curvature(row *r)
{
    static const char axis[3] = { 'x', 'y', 'z' };
    const unsigned m = row_count(r, "m", MOST);
    const long double pi = acosl(-1);
    loft_vec p[MOST + 1];
    loft_acc wide[3] = { 0, 0, 0 };
    long double squares = 0, least = 0;
    char column[16];
    loft_deficit d;

    for (unsigned i = 0; i <= m; i++)
        for (int k = 0; k < 3; k++) {
            snprintf(column, sizeof column, i ? "%c%u" : "%c", axis[k], i);
            p[i].axis[k] = decimal_real(r, row_text(r, column));
        }
    for (unsigned i = 1; i <= m; i++) {
        long double square = 0;
        for (int k = 0; k < 3; k++)
            square += powl(exact_of(p[i].axis[k]) - exact_of(p[0].axis[k]), 2);
        squares += square;
        least = i == 1 ? square : fminl(least, square);
    }
    const enum loft_status status = loft_deficit_eval(&p[0], p + 1, m, &d);
    if (status != LOFT_OK || !loft_sci_to_acc(d.angles, &wide[0]) ||
        !loft_sci_to_acc(d.area, &wide[1]) || !loft_sci_to_acc(d.gauss, &wide[2])) {
        row_complain(r, "status %d, or a number does not fit", status);
        return;
    }

    /* what reading rounded turns each edge by that over its length, and the area by that times
     * it */
    const long double angles = decimal(r, row_text(r, "angles")),
                      area = decimal(r, row_text(r, "area")), gauss = decimal(r, row_text(r, "K"));
    const long double turned = r->inexact > 0 ? 8 * m * r->inexact / sqrtl(least) : 0,
                      grown = r->inexact > 0 ? 8 * m * r->inexact * sqrtl(squares) * squares / area
                                             : 0;
    const long double angle_off = m * BY_NUM(0x1p-54L, 0x1p-48L, 0x1p-48L) + turned,
                      area_off = squares * BY_NUM(0x1p-55L, 0x1p-46L, 0x1p-46L) + grown;
    const long double got[3] = { exact_acc(wide[0]), exact_acc(wide[1]), exact_acc(wide[2]) },
                      rounding = BY_NUM(0x1p-33L, 0, 0) + 0x1p-60L;
    if (fabsl((2 * pi - angles) / area - gauss) > 1e-15L * (fabsl(gauss) + 1 / area))
        row_complain(r, "the row's own angles and area give another curvature");
    row_within(r, "angles", fabsl(got[0] - angles) * 65536, (angle_off + rounding) * 65536);
    row_within(r, "area", fabsl(got[1] - area) * 65536, (area_off + rounding) * 65536);
    row_within(r, "K", fabsl(got[2] - gauss) * 65536,
               ((angle_off + area_off * fabsl(gauss)) / area + rounding) * 65536);
}

const vector_system vectors_deficit[] = {
    { "discrete_curvature",
      "id,m,x,y,z,x1,y1,z1,x2,y2,z2,x3,y3,z3,x4,y4,z4,x5,y5,z5,x6,y6,z6,angles,area,K",
      discrete_curvature,
      "angles q16 m 2^-54 + 2^-33, floats m 2^-48; area 2^-55, 2^-46 of the sum of the squared "
      "distances; K as they give" },
    { 0 }
};
