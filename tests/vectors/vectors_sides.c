/* tests/vectors/vectors_sides.c -- readers of what is asked of S-patches: normals and curvatures,
 * the light on them, triangles of them; of toric patches as tensor products
 * SPDX-License-Identifier: MIT
 *
 * own/sides.py makes the rows. Where f32 cannot hold a row's numbers, nothing is compared.
 */
#include "vectors/vectors_lines.h"          /* expect_lines */
#include "vectors/vectors_points.h"         /* as_given; row, answer, law */
#include "polygon/disk.h"
#include "polygon/spatch_triangle.h"
#include "polygon/toric_tensor.h"
#include "polygon/wachspress.h"

#define POINTS 500

typedef struct {
    loft_vec p[POINTS];
    loft_spot v[LOFT_SIDES_MAX];
    loft_spatch s;
    loft_domain d;
    long double largest;        /* of the net */
} patch;

static bool read_patch(row *r, patch *x)
{
    loft_vec v[LOFT_SIDES_MAX];
    const unsigned sides = row_count(r, "sides", LOFT_SIDES_MAX),
                   depth = row_count(r, "depth", LOFT_DEGREE_MAX);
    const unsigned count = loft_multiindex_count(sides, depth);

    if (count > POINTS) {
        row_complain(r, "%u points are more than %d", count, POINTS);
        return false;
    }
    row_points(r, "net_q16", count, 3, x->p);
    x->largest = r->largest;
    row_points(r, "v_q16", sides, 2, v);
    for (unsigned k = 0; k < sides; k++)
        x->v[k] = (loft_spot) { { v[k].axis[0], v[k].axis[1] } };
    if (loft_spatch_init(&x->s, x->p, NULL, sides, depth) != LOFT_OK ||
        loft_domain_init(&x->d, x->v, sides) != LOFT_OK)
        row_complain(r, "the patch was refused");
    return !r->complaint[0];
}

static long double number(row *r, const char *column)
{
    const char *text = row_text(r, column);
    return row_next(&text);
}

static void expect_within(row *r, const char *column, long double got, long double error)
{
    row_within(r, column, fabsl(got - number(r, column)) * 65536, error * 65536);
}

static void spatch_curvature(row *r)
{
    static patch x;
    loft_jet phi[LOFT_SIDES_MAX];
    loft_differential here;
    loft_vec normal = { { 0 } }, at;
    loft_curvatures k;

    if (!read_patch(r, &x))
        return;
    row_points(r, "at_q16", 1, 2, &at);
    if (!as_given(r))
        return;
    const loft_spot spot = { { at.axis[0], at.axis[1] } };
    if (loft_wachspress_jet(&x.d, spot, phi) != LOFT_OK ||
        loft_spatch_differential(&x.s, phi, &here) != LOFT_OK ||
        loft_differential_normal(&here, &normal) != LOFT_OK ||
        loft_differential_curvatures(&here, &k) != LOFT_OK) {
        row_complain(r, "the place was refused");
        return;
    }
    /* polygon/spatch.h, and the same again for the coordinates */
    const long double a = number(r, "A"), b = number(r, "B"),
                      step = 2 * x.largest * BY_NUM(0x1p-44L, 0x1p-36L, 0x1p-36L);
    const char *first = row_text(r, "rise1"), *second = row_text(r, "rise2");
    long double error[3];
    for (int i = 0; i < 3; i++)
        error[i] = step * (a * row_next(&first) + (b + a * a) * row_next(&second));
    const char *text = row_text(r, "N");
    for (int axis = 0; axis < 3; axis++)
        row_within(r, "N", fabsl(exact_of(normal.axis[axis]) - row_next(&text)) * 65536,
                   65536 * (error[0] + BY_NUM(0.501L * LSB, 0x1p-24L, 0x1p-46L)));
    expect_within(r, "gauss", exact_acc(k.gauss), error[1] + BY_NUM(0x1p-31L, 0, 0));
    expect_within(r, "mean", exact_acc(k.mean), error[2] + BY_NUM(0x1p-31L, 0, 0));
}

static void spatch_isophote(row *r)
{
    static patch x;
    loft_level level;
    loft_disk disk;
    loft_vec d = { { 0 } };

    if (!read_patch(r, &x))
        return;
    row_points(r, "D_q16", 1, 3, &d);
    const loft_real cosine = row_real(r, "cos_q16");
    if (!as_given(r))
        return;
    if (loft_level_light(&level, d, cosine) == LOFT_OK &&
        loft_disk_from_spatch(&disk, &x.s, &x.d, loft_wachspress_eval) == LOFT_OK)
        expect_lines(r, loft_surface_from_disk(&disk), &level, 1);
    else
        row_complain(r, "the patch or the direction was refused");
}

/* The largest distance of two control points, or more. */
static long double reach_of(const loft_vec p[], unsigned count)
{
    long double sum = 0;

    for (int axis = 0; axis < 3; axis++) {
        long double low = exact_of(p[0].axis[axis]), high = low;
        for (unsigned k = 1; k < count; k++) {
            low  = fminl(low, exact_of(p[k].axis[axis]));
            high = fmaxl(high, exact_of(p[k].axis[axis]));
        }
        sum += (high - low) * (high - low);
    }
    return sqrtl(sum);
}

static void spatch_triangle(row *r)
{
    static patch x;
    static loft_weighted p[LOFT_SPATCH_TRIANGLE_MAX];
    loft_triangle_rational t;
    loft_vec share;

    if (!read_patch(r, &x))
        return;
    const unsigned edge   = row_count(r, "edge", LOFT_SIDES_MAX - 1),
                   degree = x.s.depth * (x.s.sides - 2u);
    row_points(r, "share_q16", 1, 2, &share);
    if (!as_given(r))
        return;
    if (loft_spatch_triangle(&x.s, &x.d, edge, p) != LOFT_OK ||
        loft_triangle_rational_init(&t, p, degree) != LOFT_OK) {
        row_complain(r, "the triangle was refused");
        return;
    }
    const loft_bary u = { loft_unit_from(share.axis[0]), loft_unit_from(share.axis[1]) };
    const loft_vec at = loft_triangle_rational_eval(&t, u);
    const long double reach = reach_of(x.p, loft_multiindex_count(x.s.sides, x.s.depth));
    long double least = 256;
    for (unsigned k = 0; k < LOFT_TRIANGLE_POINTS(degree); k++)
        least = fminl(least, exact_of(p[k].w));
    /* polygon/spatch_triangle.h and surface/triangle/triangle_rational.h */
    const long double error = BY_NUM(1.001L * LSB + reach * (0x1p-17L / least + 0x1p-48L),
                                     2 * x.largest * 0x1p-23L + reach * 0x1p-22L,
                                     (6 * degree + 5) * x.largest * 0x1p-52L + reach * 0x1p-40L);
    const char *text = row_text(r, "P");
    for (int axis = 0; axis < 3; axis++)
        row_within(r, "P", fabsl(exact_of(at.axis[axis]) - row_next(&text)) * 65536, error * 65536);
}

static bool read_toric(row *r, loft_lattice_polygon *l, loft_toric *t)
{
    static loft_vec p[POINTS];
    static loft_real c[POINTS], w[POINTS];
    const unsigned sides = row_count(r, "sides", LOFT_SIDES_MAX);
    loft_vec v[LOFT_SIDES_MAX];
    loft_whole at[LOFT_SIDES_MAX];

    row_points(r, "v_q16", sides, 2, v);
    for (unsigned k = 0; k < sides; k++)
        for (int i = 0; i < 2; i++)
            at[k].at[i] = (int8_t)exact_of(v[k].axis[i]);
    if (loft_lattice_polygon_init(l, at, sides) != LOFT_OK) {
        row_complain(r, "the polygon was refused");
        return false;
    }
    const unsigned count = loft_lattice_polygon_count(l);
    row_points(r, "net_q16", count, 3, p);
    row_reals(r, "c_q16", count, c);
    row_reals(r, "w_q16", count, w);
    if (!r->complaint[0] && loft_toric_init(t, l, p, c, w) != LOFT_OK)
        row_complain(r, "the patch was refused");
    return !r->complaint[0];
}

/* u of s: the nearest parameter. */
static loft_unit balanced(long double s, loft_sci balance)
{
    loft_acc wide = 0;

    if (!loft_sci_to_acc(balance, &wide))
        return 0;
    const long double a = exact_acc(wide);
    return LOFT_UNIT((double)(a * s / (1 - s + a * s)));
}

static void toric_tensor(row *r)
{
    static loft_weighted p[LOFT_TORIC_TENSOR_MAX];
    loft_lattice_polygon l;
    loft_tensor_rational s;
    loft_toric t;

    if (!read_toric(r, &l, &t) || !as_given(r))
        return;
    const unsigned vertex = row_count(r, "vertex", l.sides - 1u);
    if (loft_toric_tensor(&t, vertex, p, &s) != LOFT_OK) {
        row_complain(r, "the quarter was refused");
        return;
    }
    const loft_unit u = balanced(number(r, "s"),
                                 loft_toric_balance(&t, (vertex + l.sides - 1) % l.sides)),
                    v = balanced(number(r, "t"), loft_toric_balance(&t, vertex));
    const loft_vec at = loft_tensor_rational_eval(&s, u, v);
    long double least = 256;
    for (unsigned k = 0; k < (s.m + 1u) * (s.n + 1u); k++)
        least = fminl(least, exact_of(p[k].w));
    /* polygon/toric_tensor.h, surface/tensor/tensor_rational.h, and the rounding of u and v */
    const unsigned count    = loft_lattice_polygon_count(&l);
    const long double reach = reach_of(t.p, count), slope = number(r, "slope");
    const long double error[3] = {
        1.01L * LSB + reach * 0x1p-17L / least + slope * 0x1p-24L,
        (r->largest + reach) * 0x1p-22L + slope * 0x1p-24L,
        (count + 6u * (s.m + s.n) + 5) * r->largest * 0x1p-52L + (reach + slope) * 0x1p-50L,
    };
    const char *text = row_text(r, "P");
    for (int axis = 0; axis < 3; axis++)
        row_within(r, "P", fabsl(exact_of(at.axis[axis]) - row_next(&text)) * 65536,
                   error[BY_NUM(0, 1, 2)] * 65536);
}

const vector_system vectors_sides[] = {
    { "spatch_curvature", "sides,depth,v_q16,net_q16,at_q16,N,gauss,mean,A,B,rise1,rise2",
      spatch_curvature, "that of the derivatives in polygon/spatch.h, twice" },
    { "spatch_isophote", "sides,depth,v_q16,net_q16,D_q16,cos_q16,size,count,slope,uv",
      spatch_isophote, "count exact, uv 2 LSB over the slope + 2^-23" },
    { "spatch_triangle", "sides,depth,v_q16,net_q16,edge,share_q16,P", spatch_triangle,
      "q16: 1.001 LSB + E 2^-17 / v" },
    { "toric_tensor", "sides,v_q16,net_q16,c_q16,w_q16,vertex,s,t,P,slope", toric_tensor,
      "q16: 1.01 LSB + E 2^-17 / v + slope 2^-24" },
    { 0 }
};
