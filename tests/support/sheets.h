/* tests/support/sheets.h -- surfaces with hills for a mill, and what a cutter does to their points
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_SHEETS_H
#define LOFT_TESTS_SHEETS_H

#include "support/exact.h"          /* exact_of; CHECK */
#include "toolpath/drop.h"

#if LOFT_AXES < 3
#  error "sheets need space"
#endif

#define SHEET_POINTS 100

/* One surface of some kind, and its sheet. */
typedef struct {
    loft_vec p[SHEET_POINTS];
    loft_weighted w[SHEET_POINTS];
    union {
        loft_tensor tensor;
        loft_tensor_rational tensor_rational;
        loft_triangle triangle;
        loft_triangle_rational triangle_rational;
    } as;
    loft_sheet sheet;
} hills;

enum { HILLS_TENSOR, HILLS_RATIONAL, HILLS_TRIANGLE, HILLS_TRIANGLE_RATIONAL, HILLS_KINDS };

/* Points over a grid of 8 mm that sways by 2, of any height up to `high`. */
static inline void arb_hills(arb *a, unsigned kind, int32_t high, hills *h)
{
    const bool triangle = kind >= HILLS_TRIANGLE;
    const unsigned m = 1 + arb_below(a, 4), n = triangle ? m : 1 + arb_below(a, 4);
    enum loft_status status = LOFT_OK;

    for (unsigned i = 0; i <= m; i++)
        for (unsigned j = 0; j <= (triangle ? m - i : n); j++) {
            const unsigned k = triangle ? loft_triangle_place(i, j) : i * (n + 1) + j;
            h->p[k].axis[0] = loft_real_from_int(8 * (int32_t)i) + arb_real(a, 2);
            h->p[k].axis[1] = loft_real_from_int(8 * (int32_t)j) + arb_real(a, 2);
            h->p[k].axis[2] = arb_real(a, high);
            h->w[k].p = h->p[k];
            h->w[k].w = loft_real_from_raw(32768 + (int32_t)arb_below(a, 98304));
        }
    if (kind == HILLS_TENSOR && (status = loft_tensor_init(&h->as.tensor, h->p, m, n)) == LOFT_OK)
        status = loft_sheet_from_tensor(&h->sheet, &h->as.tensor);
    if (kind == HILLS_RATIONAL &&
        (status = loft_tensor_rational_init(&h->as.tensor_rational, h->w, m, n)) == LOFT_OK)
        status = loft_sheet_from_tensor_rational(&h->sheet, &h->as.tensor_rational);
    if (kind == HILLS_TRIANGLE &&
        (status = loft_triangle_init(&h->as.triangle, h->p, m)) == LOFT_OK)
        status = loft_sheet_from_triangle(&h->sheet, &h->as.triangle);
    if (kind == HILLS_TRIANGLE_RATIONAL &&
        (status = loft_triangle_rational_init(&h->as.triangle_rational, h->w, m)) == LOFT_OK)
        status = loft_sheet_from_triangle_rational(&h->sheet, &h->as.triangle_rational);
    CHECK(status == LOFT_OK);
}

/* A ball, a flat end or a bull-nose. */
static inline loft_cutter arb_cutter(arb *a, loft_real radius)
{
    const loft_real corner[3] = { radius, 0, radius / 3 };
    loft_cutter c;

    CHECK(loft_cutter_init(&c, radius, corner[arb_below(a, 3)]) == LOFT_OK);
    return c;
}

static inline loft_vec hills_at(const hills *h, loft_unit u, loft_unit v)
{
    loft_vec p = { { 0 } };

    CHECK(h->sheet.surface.eval(h->sheet.surface.surface, u, v, &p) == LOFT_OK);
    return p;
}

/* A place of the domain, i, j of n steps; in a triangle mirrored into it. */
static inline loft_vec hills_of(const hills *h, uint32_t i, uint32_t j, uint32_t n)
{
    const bool beyond = h->sheet.surface.over == LOFT_SURFACE_TRIANGLE && i + j > n;

    return beyond ? hills_at(h, loft_unit_of(n - i, n), loft_unit_of(n - j, n))
                  : hills_at(h, loft_unit_of(i, n), loft_unit_of(j, n));
}

/* How high the tip of a cutter must be over x, y for a point; far below if it is out of reach. */
static inline long double tip_over(const loft_cutter *c, const loft_vec *p, long double x,
                                   long double y)
{
    const long double d = hypotl(exact_of(p->axis[0]) - x, exact_of(p->axis[1]) - y),
                      corner = exact_of(c->corner), beyond = d - (exact_of(c->radius) - corner);

    if (d > exact_of(c->radius))
        return -1e6L;
    return exact_of(p->axis[2]) -
           (beyond > 0 ? corner - sqrtl(fmaxl(0, corner * corner - beyond * beyond)) : 0);
}

#endif
