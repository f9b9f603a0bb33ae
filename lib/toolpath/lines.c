/* lib/toolpath/lines.c
 * SPDX-License-Identifier: MIT
 *
 * With D_u, D_v, D_uv and D_vv the nets of differences of a net of degrees m x n,
 *
 *     P_u = m D_u    P_v = n D_v    P_uv = m n D_uv    P_vv = n (n - 1) D_vv
 *
 * all of which are exact. N = D_u x D_v is the normal, and its derivative along v
 *
 *     N_v = n D_uv x D_v + (n - 1) D_u x D_vv
 *
 * With nu = N / |N| and w = N_v / |N| the derivative of nu is w - nu (nu w), so that
 *
 *     T   = P + r (nu - z)        T_v = P_v + r (w - nu (nu w))
 *
 * D_u and D_uv are scaled together by a power of two, so that a component of D_u reaches 2^11, and
 * so are D_v and D_vv: short differences lose nothing when a grid rounds them. N is below 2^25, N_v
 * below 2^28.
 */
#include "toolpath/lines.h"

#define SCALED 4096         /* no component of a first difference is larger */

#define Z (LOFT_AXES < 3 ? 0 : 2)

enum { RISE, CROSS, SINK, CUT, LINK, OVER };


/* Nets of differences
 * ------------------- */

/* The differences of order a along u and b along v, a + b <= 2, b_ij of (m - a) x (n - b). */
static void difference_net(const loft_tensor *s, unsigned a, unsigned b, loft_vec out[])
{
    static const signed char share[3][3] = { { 1, 0, 0 }, { -1, 1, 0 }, { 1, -2, 1 } };
    unsigned k = 0;

    for (unsigned i = 0; i + a <= s->m; i++)
        for (unsigned j = 0; j + b <= s->n; j++, k++)
            for (int axis = 0; axis < LOFT_AXES; axis++) {
                loft_real sum = 0;
                for (unsigned x = 0; x <= a; x++)
                    for (unsigned y = 0; y <= b; y++)
                        sum += share[a][x] * share[b][y] *
                               s->p[(i + x) * (s->n + 1u) + j + y].axis[axis];
                out[k].axis[axis] = sum;
            }
}

static bool net_fits(const loft_vec net[], unsigned count, loft_real limit)
{
    for (unsigned k = 0; k < count; k++)
        if (!loft_vec_within(net[k], limit))
            return false;
    return true;
}

/* The power of two that makes the first of two nets as large as it may be; both are multiplied. */
static int32_t scale_nets(loft_vec first[], unsigned firsts, loft_vec second[], unsigned seconds)
{
    int32_t scale = 1;

    for (; scale < 1048576 && net_fits(first, firsts, LOFT_REAL(SCALED / 2)); scale *= 2) {
        for (unsigned k = 0; k < firsts; k++)
            first[k] = loft_vec_add(first[k], first[k]);
        for (unsigned k = 0; k < seconds; k++)
            second[k] = loft_vec_add(second[k], second[k]);
    }
    return scale;
}

static enum loft_status begin_walks(loft_lines *l, const loft_tensor *s)
{
    const unsigned m = s->m, n = s->n, q = n > 1 ? n - 2 : 0;
    const loft_tensor nets[5] = { { s->p, s->m, s->n },
                                  { l->u, (uint8_t)(m - 1), s->n },
                                  { l->v, s->m, (uint8_t)(n - 1) },
                                  { l->uv, (uint8_t)(m - 1), (uint8_t)(n - 1) },
                                  { l->vv, s->m, (uint8_t)q } };
    enum loft_status status = LOFT_OK;
    size_t used = 0;

    difference_net(s, 1, 0, l->u);
    difference_net(s, 0, 1, l->v);
    difference_net(s, 1, 1, l->uv);
    if (n > 1)
        difference_net(s, 0, 2, l->vv);
    for (unsigned k = 0; n == 1 && k <= m; k++)
        l->vv[k] = loft_vec_sub(s->p[0], s->p[0]);
    (void)scale_nets(l->u, m * (n + 1), l->uv, m * n);
    l->scale = scale_nets(l->v, (m + 1) * n, l->vv, (m + 1) * (q + 1));
    for (int k = 0; k < 5 && status == LOFT_OK; k++) {
        const size_t states = LOFT_GRID_STATES((size_t)nets[k].m, (size_t)nets[k].n);
        status = loft_grid_init(&l->walk[k], &nets[k], l->way.rows, l->way.columns,
                                l->memory + used, states);
        used += states;
    }
    return status;
}


/* Tips
 * ---- */

static void add_cross(loft_acc sum[3], const loft_vec *a, const loft_vec *b, int32_t times)
{
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        sum[k] += (loft_prod(loft_vec_axis(a, i), loft_vec_axis(b, j)) -
                   loft_prod(loft_vec_axis(a, j), loft_vec_axis(b, i))) *
                  times;
    }
}

/* Walk to the next point, and put the tip there into `row`. */
static void add_tip(loft_lines *l, unsigned slot)
{
    const loft_acc radius = loft_to_acc(l->way.radius);
    const int32_t n = l->n, side = l->down ? -1 : 1;
    loft_acc normal[3] = { 0, 0, 0 }, change[3] = { 0, 0, 0 }, along = 0;
    loft_tip *const tip = &l->row[slot];
    loft_unit unit[3];
    loft_real turn[3];
    loft_vec d[5];

    for (int k = 0; k < 5; k++)
        if (!loft_grid_next(&l->walk[k], &d[k]))
            return;
    add_cross(normal, &d[1], &d[2], side);
    add_cross(change, &d[3], &d[2], side * n);
    add_cross(change, &d[1], &d[4], side * (n - 1));
    const loft_acc length = loft_acc_hypot(normal, 3);
    for (int k = 0; k < 3; k++) {
        unit[k] = loft_unit_ratio(normal[k], length);
        turn[k] = loft_acc_quot(change[k], length);
        along += loft_acc_scale(loft_to_acc(turn[k]), unit[k]);
    }
    tip->tip = d[0];
    tip->handle = loft_vec_sub(d[0], d[0]);
    for (int k = 0; k < 3 && k < LOFT_AXES; k++) {
        const loft_acc lift = loft_acc_scale(radius, unit[k]) - (k == 2 ? radius : 0),
                       rate = loft_to_acc(turn[k]) - loft_acc_scale(along, unit[k]),
                       slope = loft_acc_ratio(loft_to_acc(d[2].axis[k]) * n, l->scale) +
                               loft_acc_mul(rate, l->way.radius);
        tip->tip.axis[k] = loft_acc_round(loft_to_acc(d[0].axis[k]) + lift);
        tip->handle.axis[k] = loft_acc_round(loft_acc_ratio(slope, 3 * l->way.columns));
    }
    for (int k = 3; k < LOFT_AXES; k++)
        tip->tip.axis[k] = l->start.axis[k];
}


/* Lines
 *
 * A line is cut from one end of `row` to the other; the places that it leaves free take the points
 * of the next one, which come along v. So that one lies in the order in which this one was cut. */

/* True if this line is cut toward the end of `row`. */
static bool goes_up(const loft_lines *l) { return l->back == l->mirrored; }

/* Its place number k, in the order of cutting. */
static unsigned slot_of(const loft_lines *l, unsigned k)
{
    return goes_up(l) ? k : l->way.columns - k;
}

static void begin_line(loft_lines *l)
{
    l->mirrored = !goes_up(l);
    l->back = !l->way.one_way && !l->back;
    l->line++;
    l->place = 0;
}

static void straight(loft_lines *l, const loft_vec *to, loft_cubic *out)
{
    out->p[0] = l->at;
    out->p[1] = loft_vec_lerp(l->at, *to, loft_unit_of(1, 3));
    out->p[2] = loft_vec_lerp(l->at, *to, loft_unit_of(2, 3));
    out->p[3] = l->at = *to;
}

/* The next curve of this line, if it has one. */
static bool cut_curve(loft_lines *l, loft_cubic *out)
{
    if (l->place == l->way.columns)
        return false;
    const unsigned slot = slot_of(l, l->place);
    const loft_tip a = l->row[slot], b = l->row[slot_of(l, l->place + 1u)];

    out->p[0] = a.tip;
    out->p[1] = l->back ? loft_vec_sub(a.tip, a.handle) : loft_vec_add(a.tip, a.handle);
    out->p[2] = l->back ? loft_vec_add(b.tip, b.handle) : loft_vec_sub(b.tip, b.handle);
    out->p[3] = l->at = b.tip;
    add_tip(l, slot);
    if (++l->place == l->way.columns)
        add_tip(l, slot_of(l, l->place));
    return true;
}

/* After a line: the way to the next one, or home. */
static void turn(loft_lines *l)
{
    l->leaving = l->line == l->way.rows;
    if (!l->leaving)
        begin_line(l);
    l->phase = l->leaving || !l->near || l->way.one_way ? RISE : LINK;
}

bool loft_lines_next(loft_lines *l, loft_cubic *out, bool *cuts)
{
    for (;;) {
        loft_vec to = l->leaving ? l->start : l->row[slot_of(l, l->place)].tip;
        const uint8_t phase = l->phase;
        switch (phase) {
        case CUT:
            *cuts = true;
            if (cut_curve(l, out))
                return true;
            turn(l);
            continue;
        case RISE:
            to = l->at;
            to.axis[Z] = l->way.safe;
            break;
        case CROSS: to.axis[Z] = l->way.safe; break;
        case SINK:
        case LINK: break;
        default: return false;
        }
        l->phase = (uint8_t)(phase < SINK ? phase + 1 : l->leaving ? OVER : CUT);
        *cuts = phase >= SINK && !l->leaving;
        if (loft_vec_equal(l->at, to))
            continue;
        straight(l, &to, out);
        return true;
    }
}

enum loft_status loft_lines_init(loft_lines *l, const loft_tensor *s, const loft_lines_way *way,
                                 const loft_vec *start, loft_tip row[], size_t count)
{
    loft_acc normal[3] = { 0, 0, 0 };

    if (loft_lines_check(s, way, &l->near) != LOFT_LINES_FINE)
        return LOFT_SINGULAR;
    if (count <= way->columns)
        return LOFT_ERR_SPACE;
    l->way = *way;
    l->row = row;
    l->n = s->n;
    l->at = l->start = *start;
    l->line = l->place = 0;
    l->phase = RISE;
    l->back = l->mirrored = l->leaving = false;
    const enum loft_status status = begin_walks(l, s);
    if (status != LOFT_OK)
        return status;
    add_cross(normal, &l->u[0], &l->v[0], 1);
    l->down = normal[2] < 0;
    for (unsigned k = 0; k <= way->columns; k++)
        add_tip(l, k);
    return LOFT_OK;
}
