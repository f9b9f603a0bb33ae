/* tests/vectors/vectors_made.c -- readers of what is made of curves and surfaces: swept sections,
 * offsets, pieces, arcs, foci, lengths
 * SPDX-License-Identifier: MIT
 *
 * own/made.py makes the rows. Where f32 cannot hold a row's numbers, nothing is compared.
 */
#include <stdlib.h>                         /* strtol */

#include "vectors/vectors_points.h"         /* as_given; row, answer, law */
#include "curve/bspline.h"
#include "curve/circle.h"
#include "curve/conic.h"
#include "curve/measure.h"
#include "curve/nurbs.h"
#include "curve/offset.h"
#include "surface/tensor/sweep.h"
#include "surface/tensor/tensor_rational.h"

#define MOST     (LOFT_DEGREE_MAX + 1)
#define KNOTS    40
#define STATIONS 16
#define PIECES   4
#define NET      (MOST * LOFT_ELEVATE_MAX)

static void sweep_sections(row *r)
{
    static loft_vec p[PIECES * MOST], section[MOST], out[STATIONS * MOST];
    loft_bezier path[PIECES];
    loft_vec up;
    const unsigned pieces = row_count(r, "pieces", PIECES), m = row_count(r, "m", LOFT_DEGREE_MAX),
                   stations = row_count(r, "stations", STATIONS),
                   n = row_count(r, "n", LOFT_DEGREE_MAX);

    row_points(r, "path_q16", pieces * (m + 1), 3, p);
    row_reals(r, "up_q16", 3, up.axis);
    row_points(r, "section_q16", n + 1, 3, section);
    for (unsigned k = 0; k < pieces; k++)
        if (loft_bezier_init(&path[k], p + k * (m + 1), m) != LOFT_OK)
            row_complain(r, "the path was refused");
    if (!as_given(r) || r->complaint[0])
        return;
    const enum loft_status status = loft_sweep_sections(path, pieces, stations, up, section, n,
                                                        out);
    /* f32, f64: 9 frames of 2^-46 each, times a section of 7 */
    expect_vecs(r, "Q", status, out, stations * (n + 1), 3,
                (law){ .lsb = 0.501L, .roundings = 64 });
}

static void curve_offset(row *r)
{
    static loft_real t[80];
    const unsigned count = row_length(r, "t_q16", 80);
    loft_offset_span span;
    loft_cubic c = { 0 };
    loft_offset o;
    unsigned done = 0;

    row_points(r, "P_q16", 4, 2, c.p);
    const loft_real distance = row_real(r, "distance_q16"), tol = row_real(r, "tol_q16");
    row_reals(r, "t_q16", count, t);
    if (!as_given(r))
        return;
    if (loft_offset_init(&o, &c, distance, tol) != LOFT_OK) {
        row_complain(r, "the offset was refused");
        return;
    }
    const char *at = row_text(r, "at"), *behind = row_text(r, "behind");
    while (loft_offset_next(&o, &span))
        for (; done < count && exact_of(t[done]) <= exact_unit(span.to); done++, behind += 2) {
            const long double from = exact_unit(span.from), to = exact_unit(span.to);
            const long double s = (exact_of(t[done]) - from) / (to - from);
            long double sum = 0;
            for (int axis = 0; axis < 2; axis++) {
                long double b[4];
                for (int k = 0; k < 4; k++)
                    b[k] = exact_of(span.curve.p[k].axis[axis]);
                sum += powl(exact_eval(b, 3, s) - row_next(&at), 2);
            }
            row_within(r, "at", sqrtl(sum) * 65536, exact_of(tol) * 65536);
            if (*behind != '-' && (*behind == '1') != span.behind)
                row_complain(r, "at t = %Lg the offset runs the other way", exact_of(t[done]));
        }
    if (done != count)
        row_complain(r, "the offset ends before t = 1");
}

static void weights_of(const loft_weighted p[], unsigned count, loft_vec at[], answer *w)
{
    for (unsigned k = 0; k < count; k++) {
        at[k] = p[k].p;
        answer_real(w, p[k].w);
    }
}

static void expect_weighted(row *r, const char *points, const char *weights,
                            enum loft_status status, const loft_weighted p[], unsigned count,
                            unsigned d)
{
    static loft_vec at[NET];
    answer *w = answer_new();

    answer_status(r, w, status);
    weights_of(p, status == LOFT_OK ? count : 0, at, w);
    expect_vecs(r, points, status, at, count, d, (law){ .lsb = 0.501L, .roundings = 128 });
    row_expect(r, weights, w, (law){ .lsb = 0.501L, .roundings = 128 });
}

static void knot_insert(row *r)
{
    static loft_vec p[KNOTS], q[KNOTS + 1];
    static loft_weighted both[KNOTS], out[KNOTS + 1];
    static loft_real knot[KNOTS + MOST], knots[KNOTS + MOST + 1], w[KNOTS];
    const unsigned degree = row_count(r, "p", LOFT_DEGREE_MAX), n = row_count(r, "n", KNOTS),
                   d = dimension(r);
    const bool weighted = row_text(r, "w_q16")[0] != '-';
    enum loft_status status;
    unsigned behind = 0;
    loft_bspline b;
    loft_nurbs x;

    row_reals(r, "U_q16", n + degree + 1, knot);
    const loft_real u = row_real(r, "u_q16");
    if (weighted)
        row_reals(r, "w_q16", n, w);
    r->largest = 0;
    row_points(r, "P_q16", n, d, p);
    for (unsigned k = 0; k < n; k++)
        both[k] = (loft_weighted) { p[k], weighted ? w[k] : LOFT_REAL(1) };
    if (loft_bspline_init(&b, p, n, knot, degree) != LOFT_OK ||
        loft_nurbs_init(&x, both, n, knot, degree) != LOFT_OK) {
        row_complain(r, "the curve was refused");
        return;
    }
    if (!as_given(r))
        return;
    if (weighted) {
        status = loft_nurbs_insert(&x, u, out, knots);
    } else {
        status = loft_bspline_insert(&b, u, q, knots);
        for (unsigned k = 0; k <= n; k++)
            out[k] = (loft_weighted) { q[k], LOFT_REAL(1) };
    }
    expect_weighted(r, "Q", "wQ", status, out, n + 1, d);
    for (unsigned k = 0; k < n + degree + 2; k++) {
        const bool is_new = behind == k && (k == n + degree + 1 || knot[k] > u);
        if (is_new ? knots[k] != u : knots[k] != knot[behind])
            row_complain(r, "knot %u is another one", k);
        behind += !is_new;
    }
}


/* Patches with weights */

typedef struct {
    loft_weighted p[MOST * MOST];
    loft_tensor_rational s;
    long double ratio;
} patch;

static bool read_patch(row *r, patch *x)
{
    static loft_vec p[MOST * MOST];
    static loft_real w[MOST * MOST];
    const unsigned m = row_count(r, "m", LOFT_DEGREE_MAX), n = row_count(r, "n", LOFT_DEGREE_MAX);
    long double least = 256, most = 0;

    row_reals(r, "w_q16", (m + 1) * (n + 1), w);
    r->largest = 0;
    row_points(r, "net_q16", (m + 1) * (n + 1), 3, p);
    for (unsigned k = 0; k < (m + 1) * (n + 1); k++) {
        x->p[k] = (loft_weighted) { p[k], w[k] };
        least = fminl(least, exact_of(w[k]));
        most = fmaxl(most, exact_of(w[k]));
    }
    x->ratio = most / least;
    if (loft_tensor_rational_init(&x->s, x->p, m, n) != LOFT_OK)
        row_complain(r, "the patch was refused");
    return as_given(r) && !r->complaint[0];
}

static void patch_slopes(row *r)
{
    static patch x;
    const bool fits = read_patch(r, &x);
    const loft_unit u = row_unit(r, "u_q16"), v = row_unit(r, "v_q16");
    loft_vec by_u = { { 0 } }, by_v = { { 0 } };

    if (!fits)
        return;
    const enum loft_status status = loft_tensor_rational_deriv(&x.s, u, v, &by_u, &by_v);
    const long double d = x.s.m > x.s.n ? x.s.m : x.s.n, sum = x.s.m + x.s.n;
    const law l = { .lsb = 0.5L + d * sum * x.ratio * 0x1p-26L,
                    .roundings = 32 * d * (sum + 1) * x.ratio };
    expect_vec(r, "Pu", status, by_u, 3, l);
    expect_vec(r, "Pv", status, by_v, 3, l);
}

static void patch_split(row *r)
{
    static patch x;
    static loft_weighted left[MOST * MOST], right[MOST * MOST];
    const bool fits = read_patch(r, &x);
    const loft_unit t = row_unit(r, "t_q16");

    if (!fits)
        return;
    const unsigned count = (x.s.m + 1u) * (x.s.n + 1u);
    const enum loft_status status = row_is(r, "along", "u")
                                        ? loft_tensor_rational_split_u(&x.s, t, left, right)
                                        : loft_tensor_rational_split_v(&x.s, t, left, right);
    expect_weighted(r, "L", "wL", status, left, count, 3);
    expect_weighted(r, "R", "wR", status, right, count, 3);
}

static void patch_raise(row *r)
{
    static patch x;
    static loft_weighted out[NET];
    const bool fits = read_patch(r, &x), along_u = row_is(r, "along", "u");
    const unsigned times = row_count(r, "times", LOFT_DEGREE_MAX);

    if (!fits)
        return;
    const enum loft_status status = along_u ? loft_tensor_rational_elevate_u(&x.s, times, out)
                                            : loft_tensor_rational_elevate_v(&x.s, times, out);
    expect_weighted(r, "Q", "wQ", status, out,
                    (x.s.m + 1u + (along_u ? times : 0)) * (x.s.n + 1u + (along_u ? 0 : times)), 3);
}


/* Arcs, foci, lengths */

static void arc_place(row *r)
{
    const int32_t turns = (int32_t)strtol(row_text(r, "turns"), NULL, 10);
    const bool centre = row_is(r, "kind", "centre"), large = row_is(r, "large", "1");
    loft_vec from, to, data = { { 0 } }, at = { { 0 } };
    loft_circle c;

    row_points(r, "from_q16", 1, 3, &from);
    row_points(r, "to_q16", 1, 3, &to);
    row_points(r, "data_q16", 1, 2, &data);
    const long double largest = r->largest;
    const loft_real degrees = row_real(r, "degrees_q16");
    const loft_unit t = row_unit(r, "t_q16");
    r->largest = largest;
    if (!as_given(r))
        return;
    enum loft_status status = centre ? loft_circle_from_centre(&c, from, to, LOFT_PLANE_XY, data,
                                                               turns)
                                     : loft_circle_from_ellipse(&c, from, to, LOFT_PLANE_XY,
                                                                data.axis, degrees, large, turns);
    if (status == LOFT_OK)
        status = loft_circle_eval(&c, t, &at);
    /* near half a turn the centre of an ellipse errs by 2^-28 of the radius, 2^-25 in floats */
    expect_vecs(
        r, "at", status, &at, 1, 3,
        (law){ .lsb = 0.501L + (centre ? 0 : 0x1p-7L), .roundings = centre ? 64 : 0x1p28L });
}

static void conic_foci(row *r)
{
    static const char *const name[] = { "ellipse", "parabola", "hyperbola", "line", "point", "" };
    loft_vec p[3], focus[2] = { { { 0 } } };
    loft_real w[3];
    loft_weighted both[3];
    loft_conic kind;
    unsigned count = 0;
    long double want[2][2], off[2] = { 0, 0 };

    row_reals(r, "w_q16", 3, w);
    row_points(r, "P_q16", 3, 2, p);
    for (unsigned k = 0; k < 3; k++)
        both[k] = (loft_weighted) { p[k], w[k] };
    if (!as_given(r))
        return;
    const char *text = row_text(r, "foci");
    long double far = 0;
    for (long double x; isfinite(x = row_next(&text)); )
        far = fmaxl(far, fabsl(x));
    const enum loft_status status = loft_conic_foci(both, focus, &count);
    if (BY_NUM(far >= 32768, false, false)) {
        if (status != LOFT_ERR_RANGE)
            row_complain(r, "a focus does not fit, and the status is %d", status);
        return;
    }
    if (loft_conic_init(&kind, both) != LOFT_OK || status != LOFT_OK) {
        row_complain(r, "the conic was refused");
        return;
    }
    row_expect_word(r, "kind", name[kind.kind]);
    text = row_text(r, "foci");
    for (unsigned k = 0; k < count; k++)
        for (int axis = 0; axis < 2; axis++)
            want[k][axis] = row_next(&text);
    for (unsigned k = 0; k < count; k++)
        for (int axis = 0; axis < 2; axis++)
            for (unsigned other = 0; other < 2; other++)
                off[other] = fmaxl(off[other], fabsl(exact_of(focus[k].axis[axis]) -
                                                     want[other && count == 2 ? 1 - k : k][axis]));
    const long double s = kind.kind == LOFT_CONIC_PARABOLA
                              ? 1
                              : fabsl(exact_of(w[0]) * exact_of(w[2])) /
                                    fabsl(exact_of(w[0]) * exact_of(w[2]) -
                                          powl(exact_of(w[1]), 2));
    const long double e = BY_NUM(0x1p-52L, 0x1p-44L, 0x1p-44L);
    row_within(r, "foci", fminl(off[0], off[1]) * 65536,
               65536 * (BY_NUM(0.51L * LSB, ulp(r->largest), ulp_double(fmaxl(r->largest, far))) +
                        4 * sqrtl(e) * s * r->largest));
}

static void cubic_length(row *r)
{
    const loft_real tol = LOFT_REAL(0.0009765625);
    long double polygon = 0;
    loft_cubic c = { 0 };

    row_points(r, "P_q16", 4, 3, c.p);
    if (!as_given(r))
        return;
    for (unsigned k = 0; k < 3; k++) {
        long double sum = 0;
        for (int axis = 0; axis < 3; axis++)
            sum += powl(exact_of(c.p[k + 1].axis[axis]) - exact_of(c.p[k].axis[axis]), 2);
        polygon += sqrtl(sum);
    }
    const char *text = row_text(r, "length");
    const long double want = row_next(&text);
    row_within(r, "length", fabsl(exact_acc(loft_cubic_arclen(&c, tol)) - want) * 65536,
               65536 * (exact_of(tol) +
                        BY_NUM(0x1p-27L * polygon + LSB, 0x1p-40L * polygon, 0x1p-40L * polygon)));
}

const vector_system vectors_made[] = {
    { "sweep_sections", "pieces,m,path_q16,stations,up_q16,n,section_q16,Q", sweep_sections,
      "1/2 LSB + 2^-16 LSB" },
    { "curve_offset", "P_q16,distance_q16,tol_q16,t_q16,at,behind", curve_offset,
      "behind exact, at tol" },
    { "knot_insert", "p,n,d,U_q16,P_q16,w_q16,u_q16,Q,wQ", knot_insert, "0.501 LSB" },
    { "patch_slopes", "m,n,net_q16,w_q16,u_q16,v_q16,Pu,Pv", patch_slopes,
      "1/2 LSB + d (m + n) R 2^-26 LSB" },
    { "patch_split", "m,n,net_q16,w_q16,along,t_q16,L,wL,R,wR", patch_split, "0.501 LSB" },
    { "patch_raise", "m,n,net_q16,w_q16,along,times,Q,wQ", patch_raise, "0.501 LSB" },
    { "arc_place", "kind,from_q16,to_q16,data_q16,degrees_q16,large,turns,t_q16,at", arc_place,
      "1/2 LSB, ellipses 1/2 LSB + 2^-7 LSB" },
    { "conic_foci", "P_q16,w_q16,kind,foci", conic_foci,
      "1/2 LSB + 4 sqrt(2^-52) s L, as curve/conic.h" },
    { "cubic_length", "P_q16,length", cubic_length, "2^-10, as asked, and the arithmetic" },
    { 0 }
};
