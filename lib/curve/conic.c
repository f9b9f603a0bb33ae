/* lib/curve/conic.c
 * SPDX-License-Identifier: MIT
 *
 * With the triangle's barycentric coordinates u, v, w of a point, the conic is w0 w2 v^2 - 4 w1^2 u
 * w = 0. Twice the area times u is a0 x + b0 y + .., a0 = y1 - y2, b0 = x2 - x1 and so on in turn,
 * so up to a factor the coefficients of x^2, y^2 and x y are
 *
 *     w0 w2 a1^2 - 4 w1^2 a0 a2      w0 w2 b1^2 - 4 w1^2 b0 b2
 *     2 w0 w2 a1 b1 - 4 w1^2 (a0 b2 + a2 b0)
 *
 * It is a circle if the first two are equal and the third is 0. Bits: two weights and two
 * differences, 4 R + 6.
 *
 * Axes (Lee): with k = w0 w2 / w1^2 and s = k / (2 (k - 1)) the centre is s p0 + (1 - 2 s) p1 + s
 * p2, and c + x U + y V with U = p2 - p0, V = (p0 + p2) / 2 - p1 is on the conic if x^2 / f + y^2 /
 * g = 1, f = s^2 (k - 1) / k, g = 4 s^2 / k. So the squares of the semi-axes, with a sign, are the
 * eigenvalues of f U U^T + g V V^T. Let D = w0 w2 - w1^2: s = w0 w2 / (2 D), f = w0 w2 / (4 D), g =
 * w0 w2 w1^2 / D^2. Near a parabola both products of D agree in all digits of a double, and D^-1
 * multiplies what was lost: D is the determinant of (w0, w1) and (w1, w2), which loft_sci_cross
 * finds to a part of itself.
 *
 * Of the two eigenvalues h +- r, h half the trace and r the root of a sum of squares, the one of
 * the larger magnitude is taken as a sum; the other is the determinant f g (U x V)^2 over it.
 * Nearly straight, U x V cancels likewise. V = (p0 - p1) + U / 2, so it is U x (p0 - p1), of given
 * points.
 */
#include "curve/conic.h"
#include "geom/vec_exact.h"     /* loft_vec_exact_sub */
#include "num/sci.h"            /* loft_sci */

static bool numbers_exact(const loft_weighted p[], unsigned count)
{
    for (unsigned k = 0; k < count; k++) {
        if (!loft_exact_valid(p[k].w))
            return false;
        for (int axis = 0; axis < 2; axis++)
            if (!loft_exact_valid(loft_vec_axis(&p[k].p, axis)))
                return false;
    }
    return true;
}

static int real_sign(loft_real a) { return (a > 0) - (a < 0); }

static loft_exact weight_product(const loft_weighted *a, const loft_weighted *b)
{
    return loft_exact_mul(loft_exact_from_real(a->w), loft_exact_from_real(b->w));
}

static bool same_place(const loft_weighted *a, const loft_weighted *b)
{
    loft_exact d[2];

    loft_vec_exact_sub(&a->p, &b->p, 2, d);
    return loft_exact_sign(d[0]) == 0 && loft_exact_sign(d[1]) == 0;
}

/* Twice the area of the triangle, exactly. */
static loft_exact triangle_area(const loft_weighted p[3])
{
    loft_exact a[2], b[2];

    loft_vec_exact_sub(&p[1].p, &p[0].p, 2, a);
    loft_vec_exact_sub(&p[2].p, &p[0].p, 2, b);
    return loft_exact_det(a[0], a[1], b[0], b[1]);
}

static bool triangle_flat(const loft_weighted p[3])
{
    for (int k = 0; k < 3; k++)
        if (real_sign(p[k].w) == 0)
            return true;
    return loft_exact_sign(triangle_area(p)) == 0;
}

/* Of dependent points: line, point, null. */
static enum loft_conic_kind flat_kind(const loft_weighted p[3])
{
    const loft_weighted *first = NULL;

    for (int k = 0; k < 3; k++) {
        if (real_sign(p[k].w) == 0)
            continue;
        if (!first)
            first = &p[k];
        else if (!same_place(first, &p[k]))
            return LOFT_CONIC_LINE;
    }
    return first ? LOFT_CONIC_POINT : LOFT_CONIC_NULL;
}

/* The sign of w1^2 - w0 w2 */
static int discriminant_sign(const loft_weighted p[3])
{
    return loft_exact_compare(weight_product(&p[1], &p[1]), weight_product(&p[0], &p[2]));
}

/* The denominator w0 (1-t)^2 + 2 w1 t (1-t) + w2 t^2 has no zero if both ends have one sign and, as
 * theorem 2.1 says for that sign, w1 > - sqrt(w0 w2). */
static bool weights_finite(const loft_weighted p[3])
{
    const int sign = real_sign(p[0].w);

    if (sign == 0 || real_sign(p[2].w) != sign)
        return false;
    return real_sign(p[1].w) * sign >= 0 || discriminant_sign(p) < 0;
}

static loft_exact times_int(int32_t k, loft_exact x)
{
    return loft_exact_mul(loft_exact_from_int(k), x);
}

/* w0 w2 a1 b1 times 2 - 4 w1^2 (a0 b2 + a2 b0): twice the coefficient of a square for a = b */
static loft_exact implicit(const loft_weighted p[3], const loft_exact a[3], const loft_exact b[3])
{
    const loft_exact outer = loft_exact_mul(weight_product(&p[0], &p[2]),
                                            times_int(2, loft_exact_mul(a[1], b[1])));
    const loft_exact inner = loft_exact_add(loft_exact_mul(a[0], b[2]), loft_exact_mul(a[2], b[0]));

    return loft_exact_sub(outer, loft_exact_mul(weight_product(&p[1], &p[1]), times_int(4, inner)));
}

static bool is_circle(const loft_weighted p[3])
{
    loft_exact a[3], b[3], d[2];

    for (int k = 0; k < 3; k++) {
        loft_vec_exact_sub(&p[(k + 2) % 3].p, &p[(k + 1) % 3].p, 2, d);
        a[k] = loft_exact_neg(d[1]);
        b[k] = d[0];
    }
    return loft_exact_compare(implicit(p, a, a), implicit(p, b, b)) == 0 &&
           loft_exact_sign(implicit(p, a, b)) == 0;
}

enum loft_status loft_conic_init(loft_conic *out, const loft_weighted p[3])
{
    if (!numbers_exact(p, 3))
        return LOFT_ERR_RANGE;
    out->finite = weights_finite(p);
    out->circle = false;
    if (triangle_flat(p)) {
        out->kind = flat_kind(p);
        return LOFT_OK;
    }
    const int sign = discriminant_sign(p);
    out->kind = sign < 0    ? LOFT_CONIC_ELLIPSE
                : sign == 0 ? LOFT_CONIC_PARABOLA
                            : LOFT_CONIC_HYPERBOLA;
    out->circle = sign < 0 && is_circle(p);
    return LOFT_OK;
}

static loft_sci sci_axis(const loft_weighted *p, int axis)
{
    return loft_sci_from_real(loft_vec_axis(&p->p, axis));
}

/* w0 w2 - w1^2 */
static loft_sci discriminant(const loft_weighted p[3])
{
    const loft_real zero[2] = { 0, 0 }, a[2] = { p[0].w, p[1].w }, b[2] = { p[1].w, p[2].w };
    return loft_sci_cross(zero, a, zero, b);
}

/* (p2 - p0) x (p0 - p1) */
static loft_sci legs_cross(const loft_weighted p[3])
{
    loft_real x[3][2];

    for (int k = 0; k < 3; k++)
        for (int axis = 0; axis < 2; axis++)
            x[k][axis] = loft_vec_axis(&p[k].p, axis);
    return loft_sci_cross(x[0], x[2], x[1], x[0]);
}

/* The semi-axes from the eigenvalues of f U U^T + g V V^T; cross is U x V. */
static void principal(loft_sci f, loft_sci g, const loft_sci u[2], const loft_sci v[2],
                      loft_sci cross, loft_sci out[2])
{
    const loft_sci two = loft_sci_from_int(2);
    loft_sci m[3];                          /* xx, xy, yy */

    for (int k = 0; k < 3; k++) {
        const int i = k == 2, j = k > 0;
        m[k] = loft_sci_add(loft_sci_mul(f, loft_sci_mul(u[i], u[j])),
                            loft_sci_mul(g, loft_sci_mul(v[i], v[j])));
    }
    const loft_sci half = loft_sci_div(loft_sci_add(m[0], m[2]), two),
                   apart = loft_sci_div(loft_sci_sub(m[0], m[2]), two);
    const loft_sci r = loft_sci_sqrt(
        loft_sci_add(loft_sci_mul(apart, apart), loft_sci_mul(m[1], m[1])));
    const loft_sci det = loft_sci_mul(loft_sci_mul(f, g), loft_sci_mul(cross, cross));
    const bool up = loft_sci_sign(half) >= 0;
    const loft_sci large = up ? loft_sci_add(half, r) : loft_sci_sub(half, r);
    const loft_sci other = loft_sci_div(det, large);
    /* the positive one of a hyperbola, the larger one of an ellipse first */
    const bool swap = loft_sci_sign(large) < 0;
    out[0] = loft_sci_sqrt(loft_sci_abs(swap ? other : large));
    out[1] = loft_sci_sqrt(loft_sci_abs(swap ? large : other));
}

static bool round_real(loft_sci x, loft_real *out)
{
    loft_acc wide;

    if (!loft_sci_to_acc(x, &wide) || !loft_acc_valid(wide))
        return false;
    *out = loft_acc_round(wide);
    return true;
}

enum loft_status loft_conic_axes(const loft_weighted p[3], loft_vec *centre, loft_real axes[2])
{
    const loft_sci two = loft_sci_from_int(2);
    loft_conic kind;
    loft_sci u[2], v[2], length[2];
    loft_vec c = { { 0 } };
    loft_real own[2];

    if (loft_conic_init(&kind, p) != LOFT_OK)
        return LOFT_ERR_RANGE;
    if (kind.kind != LOFT_CONIC_ELLIPSE && kind.kind != LOFT_CONIC_HYPERBOLA)
        return LOFT_SINGULAR;
    const loft_sci w1 = loft_sci_from_real(p[1].w), square = loft_sci_mul(w1, w1);
    const loft_sci outer = loft_sci_mul(loft_sci_from_real(p[0].w), loft_sci_from_real(p[2].w));
    const loft_sci d = discriminant(p), s = loft_sci_div(outer, loft_sci_mul(two, d));
    for (int i = 0; i < 2; i++) {
        const loft_sci p0 = sci_axis(&p[0], i), p1 = sci_axis(&p[1], i), p2 = sci_axis(&p[2], i);
        u[i] = loft_sci_sub(p2, p0);
        v[i] = loft_sci_sub(loft_sci_div(loft_sci_add(p0, p2), two), p1);
        const loft_sci x = loft_sci_add(p1, loft_sci_mul(loft_sci_mul(two, s), v[i]));
        if (i < LOFT_AXES && !round_real(x, &c.axis[i < LOFT_AXES ? i : 0]))
            return LOFT_ERR_RANGE;
    }
    const loft_sci f = loft_sci_div(s, two),
                   g = loft_sci_div(loft_sci_mul(outer, square), loft_sci_mul(d, d));
    principal(f, g, u, v, legs_cross(p), length);
    if (!round_real(length[0], &own[0]) || !round_real(length[1], &own[1]))
        return LOFT_ERR_RANGE;
    *centre = c;
    axes[0] = own[0];
    axes[1] = own[1];
    return LOFT_OK;
}

/* Complex numbers: { real, imaginary } */
typedef struct {
    loft_sci x, y;
} plane;

static plane plane_times(plane a, plane b)
{
    const plane out = { loft_sci_sub(loft_sci_mul(a.x, b.x), loft_sci_mul(a.y, b.y)),
                        loft_sci_add(loft_sci_mul(a.x, b.y), loft_sci_mul(a.y, b.x)) };
    return out;
}

static plane plane_scaled(plane a, loft_sci by)
{
    const plane out = { loft_sci_mul(a.x, by), loft_sci_mul(a.y, by) };
    return out;
}

/* The root whose larger part is found without cancelling. */
static plane plane_root(plane a)
{
    const loft_sci half = loft_sci_power2(-1);
    const loft_sci size = loft_sci_sqrt(
        loft_sci_add(loft_sci_mul(a.x, a.x), loft_sci_mul(a.y, a.y)));
    const loft_sci more = loft_sci_sqrt(loft_sci_mul(half, loft_sci_add(size, loft_sci_abs(a.x))));
    const loft_sci less = loft_sci_sign(more) > 0 ? loft_sci_div(loft_sci_mul(half, a.y), more)
                                                  : loft_sci_zero();
    const bool right = loft_sci_sign(a.x) >= 0;
    const plane out = { right ? more : less, right ? less : more };
    return out;
}

/* A line through the focus f with the slope i is x + i y = f. It touches the curve: with z = x + i
 * y the polynomial of the weighted z_k - f has a double root, w1^2 (z1 - f)^2 = w0 w2 (z0 - f) (z2
 * - f). With g = f - z1, a = z0 - z1, b = z2 - z1, q = w0 w2, d = q - w1^2:
 *
 *     d g^2 - q (a + b) g + q a b = 0
 *
 * Its roots are the foci; of a parabola d = 0. */
static void find_foci(const plane leg[2], loft_sci q, loft_sci d, bool parabola, plane g[2])
{
    const plane sum = { loft_sci_add(leg[0].x, leg[1].x), loft_sci_add(leg[0].y, leg[1].y) },
                product = plane_times(leg[0], leg[1]);

    if (parabola) {                             /* a b / (a + b) */
        const plane across = { sum.x, loft_sci_neg(sum.y) };
        const loft_sci square = loft_sci_add(loft_sci_mul(sum.x, sum.x),
                                             loft_sci_mul(sum.y, sum.y));
        g[0] = g[1] = plane_scaled(plane_times(product, across),
                                   loft_sci_div(loft_sci_one(), square));
        return;
    }
    const plane half = plane_scaled(sum, loft_sci_div(loft_sci_mul(q, loft_sci_power2(-1)), d)),
                square = plane_times(half, half), rest = plane_scaled(product, loft_sci_div(q, d));
    const plane under = { loft_sci_sub(square.x, rest.x), loft_sci_sub(square.y, rest.y) };
    const plane root = plane_root(under);
    g[0].x = loft_sci_add(half.x, root.x);
    g[0].y = loft_sci_add(half.y, root.y);
    g[1].x = loft_sci_sub(half.x, root.x);
    g[1].y = loft_sci_sub(half.y, root.y);
}

enum loft_status loft_conic_foci(const loft_weighted p[3], loft_vec focus[2], unsigned *count)
{
    loft_vec out[2] = { { { 0 } }, { { 0 } } };
    loft_conic kind;
    plane leg[2], g[2];

    if (LOFT_AXES < 2)
        return LOFT_ERR_ARG;
    if (loft_conic_init(&kind, p) != LOFT_OK)
        return LOFT_ERR_RANGE;
    if (kind.kind > LOFT_CONIC_HYPERBOLA)
        return LOFT_SINGULAR;
    const bool parabola = kind.kind == LOFT_CONIC_PARABOLA;
    const loft_sci x = sci_axis(&p[1], 0), y = sci_axis(&p[1], 1),
                   q = loft_sci_mul(loft_sci_from_real(p[0].w), loft_sci_from_real(p[2].w));
    for (int k = 0; k < 2; k++) {
        leg[k].x = loft_sci_sub(sci_axis(&p[2 * k], 0), x);
        leg[k].y = loft_sci_sub(sci_axis(&p[2 * k], 1), y);
    }
    find_foci(leg, q, discriminant(p), parabola, g);
    for (int k = 0; k < 2; k++)
        if (!round_real(loft_sci_add(g[k].x, x), &out[k].axis[0]) ||
            !round_real(loft_sci_add(g[k].y, y), &out[k].axis[LOFT_AXES > 1]))
            return LOFT_ERR_RANGE;
    *count = parabola ? 1 : 2;
    for (unsigned k = 0; k < *count; k++)
        focus[k] = out[k];
    return LOFT_OK;
}

/* True if h3 - 3 h2 + 3 h1 - h0 = 0 for h = w x (axis) or h = w (axis -1). */
static bool third_difference_zero(const loft_weighted p[4], int axis)
{
    static const int8_t factor[4] = { -1, 3, -3, 1 };
    loft_exact sum = loft_exact_from_int(0);

    for (int k = 0; k < 4; k++) {
        loft_exact h = loft_exact_from_real(p[k].w);
        if (axis >= 0)
            h = loft_exact_mul(h, loft_exact_from_real(loft_vec_axis(&p[k].p, axis)));
        sum = loft_exact_add(sum, times_int(factor[k], h));
    }
    return loft_exact_sign(sum) == 0;
}

static bool cubic_exact(const loft_weighted p[4])
{
    for (int k = 0; k < 4; k++)
        if (!loft_exact_valid(p[k].w) || !loft_vec_exact_valid(&p[k].p, 1, LOFT_AXES))
            return false;
    return true;
}

/* Refuse numbers that cannot be exact, and a cubic that is no conic. */
static enum loft_status check_cubic(const loft_weighted p[4])
{
    if (!cubic_exact(p))
        return LOFT_ERR_RANGE;
    for (int axis = -1; axis < LOFT_AXES; axis++)
        if (!third_difference_zero(p, axis))
            return LOFT_SINGULAR;
    return LOFT_OK;
}

/* The point (a h_i + b h_j) / by, h = (w x, w), w not 0. */
static enum loft_status mix_points(const loft_weighted *first, int32_t a, const loft_weighted *last,
                                   int32_t b, int32_t by, loft_weighted *out)
{
    const loft_sci u = loft_sci_mul(loft_sci_from_int(a), loft_sci_from_real(first->w)),
                   v = loft_sci_mul(loft_sci_from_int(b), loft_sci_from_real(last->w)),
                   w = loft_sci_add(u, v);

    if (loft_sci_sign(w) == 0)
        return LOFT_SINGULAR;
    if (!round_real(loft_sci_div(w, loft_sci_from_int(by)), &out->w))
        return LOFT_ERR_RANGE;
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_sci x = loft_sci_mul(u, loft_sci_from_real(first->p.axis[i])),
                       y = loft_sci_mul(v, loft_sci_from_real(last->p.axis[i]));
        if (!round_real(loft_sci_div(loft_sci_add(x, y), w), &out->p.axis[i]))
            return LOFT_ERR_RANGE;
    }
    return LOFT_OK;
}

enum loft_status loft_conic_from_cubic(const loft_weighted p[4], loft_weighted out[3])
{
    const loft_weighted ends[2] = { p[0], p[3] };
    loft_weighted middle;
    enum loft_status status = check_cubic(p);

    if (status == LOFT_OK)
        status = mix_points(&p[1], 3, &p[0], -1, 2, &middle);
    if (status != LOFT_OK)
        return status;
    out[0] = ends[0];
    out[1] = middle;
    out[2] = ends[1];
    return LOFT_OK;
}

/* With h_m = (3 h_1 - h_0) / 2 the half has (h_0 + h_m) / 2 and (h_0 + 2 h_m + h_3) / 4. */
enum loft_status loft_conic_from_half_cubic(const loft_weighted p[4], loft_weighted out[3])
{
    const loft_weighted start = p[0];
    loft_weighted half[2];
    enum loft_status status = check_cubic(p);

    if (status == LOFT_OK)
        status = mix_points(&p[0], 1, &p[1], 3, 4, &half[0]);
    if (status == LOFT_OK)
        status = mix_points(&p[1], 3, &p[3], 1, 4, &half[1]);
    if (status != LOFT_OK)
        return status;
    out[0] = start;
    out[1] = half[0];
    out[2] = half[1];
    return LOFT_OK;
}
