/* lib/toolpath/sheet.c
 * SPDX-License-Identifier: MIT
 *
 * A function f on a square of side h differs from the bilinear function of its corners by at most
 *
 *     h^2 (|f_uu| + |f_vv|) / 8
 *
 * and on the triangle u, v >= 0, u + v <= h, from the linear function of its corners, by at most
 *
 *     h^2 (|f_uu| + 2 |f_uv| + |f_vv|) / 8
 *
 * With barycentric coordinates l of the place the Taylor series at it gives half of the sum of
 * l_i f''(v_i - x, v_i - x), where the sums of l_i du_i^2, of l_i dv_i^2 and of l_i |du_i dv_i| are
 * at most h^2 / 4. The derivatives are bounded by the differences of the net.
 *
 * Points say more. Let f_k be linear (bilinear) over each piece of level k, and equal to f at its
 * corners. Over such a piece f_(k+1) - f_k is piecewise linear, and 0 at the corners: it is largest
 * at a point between them. So with d_k the largest of these over all pieces of level k
 *
 *     |f - f_k| <= d_k + d_(k+1) + ... + d_(n-1) + |f - f_n|
 *
 * and the last term is at most bend / 4^n.
 *
 * A rational surface P = N / W, measured from a point c within r of all control points, has
 *
 *     P_u  = (N_u - P W_u) / W                        |P| <= r
 *     P_uv = (N_uv - P_u W_v - P_v W_u - P W_uv) / W
 */
#include "num/sci.h"
#include "toolpath/sheet.h"

/* A net in rows: where a point is, and which of the first and second differences exist. */
typedef struct {
    const loft_vec *p;
    const loft_weighted *w;             /* NULL: all weights are 1 */
    unsigned m, n;                      /* degrees; a triangle: both are its degree */
    bool triangle;
    loft_acc centre[3];
} net_view;

static unsigned place_of(const net_view *s, unsigned i, unsigned j)
{
    return s->triangle ? loft_triangle_place(i, j) : i * (s->n + 1) + j;
}

static bool net_has(const net_view *s, unsigned i, unsigned j)
{
    return s->triangle ? i + j <= s->m : i <= s->m && j <= s->n;
}

static const loft_vec *point_of(const net_view *s, unsigned k)
{
    return s->w ? &s->w[k].p : &s->p[k];
}

/* Coordinate `axis` of point k from the centre, times its weight; axis 3: the weight. */
static loft_sci value_of(const net_view *s, unsigned k, int axis)
{
    const loft_sci w = s->w ? loft_sci_from_real(s->w[k].w) : loft_sci_one();

    if (axis == 3)
        return w;
    const loft_acc from = loft_to_acc(loft_vec_axis(point_of(s, k), axis)) - s->centre[axis];
    return loft_sci_mul(loft_sci_of(from), w);
}

/* The largest difference of orders a along u and b along v, a + b <= 2, times its factor. */
static loft_sci largest_difference(const net_view *s, unsigned a, unsigned b, int axis)
{
    static const signed char share[3][3] = { { 1, 0, 0 }, { -1, 1, 0 }, { 1, -2, 1 } };
    loft_sci most = loft_sci_zero();
    int32_t factor = 1;

    for (unsigned i = 0; net_has(s, i + a, 0); i++)
        for (unsigned j = 0; net_has(s, i + a, j + b); j++) {
            loft_sci sum = loft_sci_zero();
            for (unsigned k = 0; k <= a; k++)
                for (unsigned l = 0; l <= b; l++)
                    sum = loft_sci_add(sum,
                                       loft_sci_mul(loft_sci_from_int(share[a][k] * share[b][l]),
                                                    value_of(s, place_of(s, i + k, j + l), axis)));
            if (loft_sci_less(most, loft_sci_abs(sum)))
                most = loft_sci_abs(sum);
        }
    for (unsigned k = 0; k < a; k++)
        factor *= (int32_t)(s->m - k);
    for (unsigned k = 0; k < b; k++)
        factor *= (int32_t)(s->n - k - (s->triangle ? a : 0));
    return loft_sci_mul(most, loft_sci_from_int(factor));
}

/* The length of the vector of largest differences: no derivative of the numerator is longer. */
static loft_sci largest_length(const net_view *s, unsigned a, unsigned b)
{
    loft_sci sum = loft_sci_zero();

    if (!net_has(s, a, b))
        return sum;
    for (int axis = 0; axis < 3; axis++) {
        const loft_sci x = largest_difference(s, a, b, axis);
        sum = loft_sci_add(sum, loft_sci_mul(x, x));
    }
    return loft_sci_sqrt(sum);
}

/* The same for the weights. */
static loft_sci largest_weight(const net_view *s, unsigned a, unsigned b)
{
    return s->w && net_has(s, a, b) ? largest_difference(s, a, b, 3) : loft_sci_zero();
}

typedef struct {
    loft_sci radius, least;             /* around the centre; the smallest weight */
    loft_sci first[2], weight[2];       /* |P_u|, |P_v|, |W_u|, |W_v| */
} quotient;

/* |P| of that order: (N + sum of the rest) / W. */
static loft_sci second_derivative(const net_view *s, const quotient *q, unsigned a, unsigned b)
{
    const unsigned x = a > 0 ? 0 : 1, y = b > 0 ? 1 : 0;
    loft_sci sum = largest_length(s, a, b);

    if (!s->w)
        return sum;
    sum = loft_sci_add(sum, loft_sci_mul(q->first[x], q->weight[y]));
    sum = loft_sci_add(sum, loft_sci_mul(q->first[y], q->weight[x]));
    sum = loft_sci_add(sum, loft_sci_mul(q->radius, largest_weight(s, a, b)));
    return loft_sci_div(sum, q->least);
}

static void measure_quotient(const net_view *s, unsigned count, quotient *q)
{
    q->radius = loft_sci_zero();
    q->least = s->w ? loft_sci_from_real(s->w[0].w) : loft_sci_one();
    for (unsigned k = 0; k < count && s->w; k++) {
        loft_sci sum = loft_sci_zero();
        const loft_sci w = loft_sci_from_real(s->w[k].w);
        for (int axis = 0; axis < 3; axis++) {
            const loft_sci x = loft_sci_div(value_of(s, k, axis), w);
            sum = loft_sci_add(sum, loft_sci_mul(x, x));
        }
        sum = loft_sci_sqrt(sum);
        if (loft_sci_less(q->radius, sum))
            q->radius = sum;
        if (loft_sci_less(w, q->least))
            q->least = w;
    }
    for (unsigned k = 0; k < 2; k++) {
        const unsigned a = k == 0, b = k == 1;
        q->weight[k] = largest_weight(s, a, b);
        q->first[k] = loft_sci_div(
            loft_sci_add(largest_length(s, a, b), loft_sci_mul(q->radius, q->weight[k])), q->least);
    }
}

static enum loft_status make_sheet(loft_sheet *s, net_view *net, unsigned count,
                                   loft_surface surface)
{
    loft_sheet made = { .surface = surface, .box = { *point_of(net, 0), *point_of(net, 0) } };
    loft_real most = 0;
    quotient q;

    if (LOFT_AXES < 3)
        return LOFT_ERR_ARG;
    for (unsigned k = 0; k < count; k++) {
        if (!loft_vec_within(*point_of(net, k), LOFT_REAL(LOFT_SHEET_REACH)))
            return LOFT_ERR_RANGE;
        made.box = loft_box_join(made.box, *point_of(net, k));
        for (int axis = 0; axis < 3; axis++) {
            const loft_real x = loft_real_abs(loft_vec_axis(point_of(net, k), axis));
            most = x > most ? x : most;
        }
    }
    for (int axis = 0; axis < 3; axis++)
        net->centre[axis] = loft_acc_mean(loft_to_acc(loft_vec_axis(&made.box.min, axis)),
                                          loft_to_acc(loft_vec_axis(&made.box.max, axis)));
    measure_quotient(net, count, &q);
    loft_sci sum = loft_sci_add(second_derivative(net, &q, 2, 0), second_derivative(net, &q, 0, 2));
    if (net->triangle) {
        const loft_sci mixed = second_derivative(net, &q, 1, 1);
        sum = loft_sci_add(sum, loft_sci_add(mixed, mixed));
    }
    sum = loft_sci_div(sum, loft_sci_from_int(8));
    if (loft_sci_less(loft_sci_from_int(1048575), sum) || !loft_sci_to_acc(sum, &made.bend))
        return LOFT_ERR_RANGE;
    const loft_acc size = loft_to_acc(most);
    /* the sums of sci err by 2^-50 of it; points by 2 ulp per axis, in f64 by 200 */
    made.bend += loft_acc_ratio(made.bend, 1048576) + loft_acc_ulp(size);
    made.fuzz = 4 * loft_real_ulp(size) + 512 * loft_acc_ulp(size);
    *s = made;
    return LOFT_OK;
}

enum loft_status loft_sheet_from_tensor(loft_sheet *s, const loft_tensor *t)
{
    net_view net = { t->p, NULL, t->m, t->n, false, { 0, 0, 0 } };

    return make_sheet(s, &net, (t->m + 1u) * (t->n + 1u), loft_surface_from_tensor(t));
}

enum loft_status loft_sheet_from_tensor_part(loft_sheet *s, const loft_tensor *t, unsigned level,
                                             unsigned i, unsigned j)
{
    const uint32_t n = (uint32_t)1 << (level <= LOFT_SHEET_LEVELS ? level : 0);
    loft_vec across[(LOFT_DEGREE_MAX + 1) * (LOFT_DEGREE_MAX + 1)],
        part[(LOFT_DEGREE_MAX + 1) * (LOFT_DEGREE_MAX + 1)];
    const loft_tensor half = { across, t->m, t->n };
    net_view net = { part, NULL, t->m, t->n, false, { 0, 0, 0 } };

    if (level > LOFT_SHEET_LEVELS || i >= n || j >= n)
        return LOFT_ERR_ARG;
    enum loft_status status = loft_tensor_sub_u(t, loft_unit_of(i, n), loft_unit_of(i + 1, n),
                                                across);
    if (status == LOFT_OK)
        status = loft_tensor_sub_v(&half, loft_unit_of(j, n), loft_unit_of(j + 1, n), part);
    if (status == LOFT_OK)
        status = make_sheet(s, &net, (t->m + 1u) * (t->n + 1u), loft_surface_from_tensor(t));
    if (status != LOFT_OK)
        return status;
    /* the net is rounded twice: 4 points of a difference, in three axes, both directions */
    s->bend += s->fuzz * (int32_t)(t->m * t->m + t->n * t->n);
    s->part = (loft_sheet_piece){ (uint16_t)i, (uint16_t)j, (uint8_t)level, false };
    return LOFT_OK;
}

enum loft_status loft_sheet_from_tensor_rational(loft_sheet *s, const loft_tensor_rational *t)
{
    net_view net = { NULL, t->p, t->m, t->n, false, { 0, 0, 0 } };

    return make_sheet(s, &net, (t->m + 1u) * (t->n + 1u), loft_surface_from_tensor_rational(t));
}

enum loft_status loft_sheet_from_triangle(loft_sheet *s, const loft_triangle *t)
{
    net_view net = { t->p, NULL, t->degree, t->degree, true, { 0, 0, 0 } };

    return make_sheet(s, &net, (t->degree + 1u) * (t->degree + 2u) / 2,
                      loft_surface_from_triangle(t));
}

enum loft_status loft_sheet_from_triangle_rational(loft_sheet *s, const loft_triangle_rational *t)
{
    net_view net = { NULL, t->p, t->degree, t->degree, true, { 0, 0, 0 } };

    return make_sheet(s, &net, (t->degree + 1u) * (t->degree + 2u) / 2,
                      loft_surface_from_triangle_rational(t));
}


/* Measured sheets */

#define ROOM (3 * LOFT_SHEET_MEASURED + 1)

/* A piece of a sheet, with its corners. */
typedef struct {
    loft_vec corner[4];
    loft_sheet_piece at;
} piece;

typedef struct {
    const loft_sheet *s;
    loft_acc most[LOFT_SHEET_MEASURED];     /* d_k */
    loft_box box;
    unsigned levels;
    bool failed;
} measure;

static bool is_triangle(const loft_sheet *s) { return s->surface.over == LOFT_SURFACE_TRIANGLE; }

static unsigned corners_of(const loft_sheet *s) { return is_triangle(s) ? 3 : 4; }

static loft_vec find_corner(measure *m, const loft_sheet_piece *at, unsigned k)
{
    const loft_surface *f = &m->s->surface;
    const uint32_t n = (uint32_t)1 << at->level;
    uint32_t step[2];
    loft_vec p = { { 0 } };

    loft_sheet_piece_corner(at, k, step);
    if (f->eval(f->surface, loft_unit_of(step[0], n), loft_unit_of(step[1], n), &p) != LOFT_OK)
        m->failed = true;
    else
        m->box = loft_box_join(m->box, p);
    return p;
}

static loft_acc mean_of(const loft_vec *a, const loft_vec *b, int axis)
{
    return loft_acc_mean(loft_to_acc(loft_vec_axis(a, axis)), loft_to_acc(loft_vec_axis(b, axis)));
}

/* The mean of what is around a point of the grid over a piece: of two corners, or of all four in
 * the middle of a square. */
static loft_acc mean_around(const loft_vec grid[9], unsigned spot, bool triangle, int axis)
{
    const unsigned x = spot % 3, y = spot / 3;

    if (x == 1 && y == 1)
        return triangle ? mean_of(&grid[2], &grid[6], axis)
                        : loft_acc_mean(mean_of(&grid[0], &grid[2], axis),
                                        mean_of(&grid[6], &grid[8], axis));
    return x == 1 ? mean_of(&grid[3 * y], &grid[3 * y + 2], axis)
                  : mean_of(&grid[x], &grid[x + 6], axis);
}

/* A point of the grid is so far from that. */
static void measure_spot(measure *m, const loft_vec grid[9], unsigned spot, unsigned below)
{
    loft_acc off[3];

    for (int k = 0; k < 3; k++)
        off[k] = loft_to_acc(loft_vec_axis(&grid[spot], k)) -
                 mean_around(grid, spot, is_triangle(m->s), k);
    m->most[below] = loft_acc_max(m->most[below], loft_acc_hypot(off, 3));
}

/* Measure a piece, and divide it. */
static void divide(measure *m, const piece *p, piece out[4])
{
    const unsigned corners = corners_of(m->s), below = (unsigned)(p->at.level - m->s->part.level);
    loft_vec grid[9];
    unsigned known = 0;

    for (unsigned k = 0; k < corners; k++) {
        const unsigned spot = loft_sheet_piece_own(&p->at, k);
        grid[spot] = p->corner[k];
        known |= 1u << spot;
    }
    for (unsigned k = 0; k < 4; k++) {
        out[k].at = loft_sheet_piece_quarter(&p->at, is_triangle(m->s), k);
        for (unsigned n = 0; n < corners; n++) {
            const unsigned spot = loft_sheet_piece_spot(&p->at, &out[k].at, n);
            if (!(known >> spot & 1)) {
                grid[spot] = find_corner(m, &out[k].at, n);
                measure_spot(m, grid, spot, below);
                known |= 1u << spot;
            }
            out[k].corner[n] = grid[spot];
        }
    }
}

/* Visit all pieces. Of those of the last level that are turned round, others have all sides. */
static void visit_pieces(measure *m)
{
    const loft_sheet *const s = m->s;
    piece stack[ROOM] = { { .at = s->part } }, child[4];
    unsigned count = 1;

    for (unsigned k = 0; k < corners_of(s); k++) {
        stack[0].corner[k] = find_corner(m, &s->part, k);
        if (k == 0)
            m->box.min = m->box.max = stack[0].corner[0];
    }
    while (count > 0 && !m->failed) {
        const piece p = stack[--count];
        const bool last = p.at.level + 1u == s->part.level + m->levels;
        if (last && p.at.upper != s->part.upper)
            continue;
        divide(m, &p, child);
        for (unsigned k = 0; k < 4 && !last; k++)
            stack[count++] = child[k];
    }
}

static void shrink_box(loft_box *box, const loft_box *points, loft_acc by)
{
    const loft_real beyond = loft_acc_round(
        by + 2 * loft_real_ulp(loft_to_acc(LOFT_REAL(LOFT_SHEET_REACH))));

    for (int k = 0; k < LOFT_AXES; k++) {
        const loft_real low = points->min.axis[k] - beyond, high = points->max.axis[k] + beyond;
        if (low > box->min.axis[k])
            box->min.axis[k] = low;
        if (high < box->max.axis[k])
            box->max.axis[k] = high;
    }
}

void loft_sheet_measure(loft_sheet *s, loft_acc near)
{
    measure m = { .s = s };
    unsigned n = 0;

    while (n < LOFT_SHEET_MEASURED && s->part.level + n < LOFT_SHEET_FINEST &&
           loft_sheet_gap(s, s->part.level + n) - s->fuzz > near)
        n++;
    m.levels = n;
    if (n > 0)
        visit_pieces(&m);
    if (n == 0 || m.failed)
        return;
    const loft_acc rounded = 4 * loft_acc_ulp(loft_to_acc(LOFT_REAL(LOFT_SHEET_REACH)));
    loft_acc gap = loft_sheet_gap(s, s->part.level + n) - s->fuzz;
    shrink_box(&s->box, &m.box, gap);
    for (unsigned k = n; k-- > 0;) {
        gap += m.most[k] + loft_acc_ratio(m.most[k], 1048576) + rounded;
        s->gap[k] = loft_acc_min(gap, loft_sheet_gap(s, s->part.level + k) - s->fuzz);
    }
    s->measured = (uint8_t)n;
}


/* Trimmed sheets */

/* i of 2^level steps, as a coordinate. */
static loft_real step_of(unsigned i, unsigned level)
{
    return loft_acc_round(
        loft_acc_ratio(loft_to_acc(LOFT_REAL(1)) * (int32_t)i, (int32_t)1 << level));
}

enum loft_region_part loft_sheet_part_of(const loft_sheet *s, const loft_box *box,
                                         const loft_sheet_piece *p)
{
    if (!s->trim)
        return LOFT_REGION_IN;
    if (s->plane)
        return loft_region_part_of(
            s->trim, loft_region_spot(loft_vec_axis(&box->min, 0), loft_vec_axis(&box->min, 1)),
            loft_region_spot(loft_vec_axis(&box->max, 0), loft_vec_axis(&box->max, 1)));
    return loft_region_part_of(
        s->trim, loft_region_spot(step_of(p->i, p->level), step_of(p->j, p->level)),
        loft_region_spot(step_of(p->i + 1u, p->level), step_of(p->j + 1u, p->level)));
}

bool loft_sheet_trim(loft_sheet *s, const loft_region *r, bool plane)
{
    s->trim = r;
    s->plane = plane;
    return loft_sheet_part_of(s, &s->box, &s->part) != LOFT_REGION_OUT;
}
