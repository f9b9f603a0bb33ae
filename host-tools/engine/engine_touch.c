/* host-tools/engine/engine_touch.c -- where a tool must be to touch all of the surfaces; compiled
 * once per number type
 * SPDX-License-Identifier: MIT
 *
 * With a normal n upward, s its part along the plane of x and y, the tip of a tool that touches a
 * point is (radius - corner) + corner s beside it, on the side of n, and corner (1 - n_z) below it.
 * Sheets are sampled by CELLS cells in all, each cell as two triangles. A place counts where the
 * tool rests on no other part of the surfaces.
 *
 * Between two lines a cusp lies half a step from both. So around the lowest point of a border the
 * line outside of it must be as low as the tangent plane is half a step on. The last of waterlines
 * is where the tool touches the lowest point itself.
 */
#include <math.h>

#include "engine/engine_touch.h"

#define CELLS   16384
#define LEAST   4               /* along a side of a sheet */
#define MOST    64
#define LEVEL   1e-3            /* less of a normal beside z: the surface is level */
#define SLACK   64              /* a radius by this: what a contact may err along its normal */
#define STEEP   (1.0 / 16)      /* the slack there, over its height */

typedef struct {
    loft_drop d;                /* without a floor */
    mill_order *o;
    double half;                /* of a step along a slope, or with o->step along the plane */
    unsigned cells;             /* along a side of a sheet */
} touches;

/* True if the tip may be there. */
static bool is_free(const touches *t, const double tip[3], const double n[3])
{
    const double slack = t->o->radius / SLACK / fmax(n[2], STEEP);
    loft_real x, y;

    return real_of(tip[0], &x) && real_of(tip[1], &y) &&
           double_of(loft_drop_height(&t->d, x, y, NULL)) <= tip[2] + slack;
}

static bool is_within(const mill_order *o, const double tip[3])
{
    return tip[0] >= o->area[0][0] && tip[0] <= o->area[1][0] && tip[1] >= o->area[0][1] &&
           tip[1] <= o->area[1][1];
}

/* The tip that touches p with a normal n, `on` farther along the tangent plane. Beside a wall it is
 * a little off, for a tool that touches one rests on top of it. */
static void find_tip(const mill_order *o, const double p[3], const double n[3], double on,
                     double tip[3])
{
    const double s = hypot(n[0], n[1]), flat = o->radius - o->corner,
                 most = o->radius * (1 + 1.0 / SLACK),
                 beside = fmin(most, flat + o->corner * s + on * n[2] + s * s * (most - o->radius));

    for (int k = 0; k < 2; k++)
        tip[k] = p[k] + (s > LEVEL ? beside * n[k] / s : 0);
    tip[2] = p[2] - o->corner + (s > LEVEL ? fmax(0, o->corner * n[2] - on * s) : o->corner);
}

static void touch(touches *t, const double p[3], const double n[3])
{
    mill_order *const o = t->o;
    double tip[3];

    find_tip(o, p, n, 0, tip);
    if (!o->bounded && !is_within(o, tip) && !(o->floored && tip[2] < o->lowest) &&
        is_free(t, tip, n))
        for (int k = 0; k < 2; k++) {
            o->area[0][k] = fmin(o->area[0][k], tip[k]);
            o->area[1][k] = fmax(o->area[1][k], tip[k]);
        }
    find_tip(o, p, n, o->step > 0 ? t->half / fmax(n[2], LEVEL) : t->half, tip);
    if (!o->floored && tip[2] < o->lowest && (!o->bounded || is_within(o, tip)) &&
        is_free(t, tip, n))
        o->lowest = tip[2];
}

/* Where a wall is upright its outside may be on either side. */
static void touch_triangle(touches *t, const double *const p[3])
{
    double n[3], length = 0;

    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        n[k] = (p[1][i] - p[0][i]) * (p[2][j] - p[0][j]) -
               (p[1][j] - p[0][j]) * (p[2][i] - p[0][i]);
        length += n[k] * n[k];
    }
    length = copysign(sqrt(length), n[2]);
    for (int k = 0; k < 3 && length != 0; k++)
        n[k] /= length;
    const double back[3] = { -n[0], -n[1], n[2] };
    for (int k = 0; k < 3 && length != 0; k++) {
        touch(t, p[k], n);
        if (n[2] < 1.0 / SLACK)
            touch(t, p[k], back);
    }
}

/* The point at a corner of a cell; false where the sheet has none. */
static bool find_point(const touches *t, const loft_sheet *s, unsigned i, unsigned j, double out[3])
{
    const loft_sheet_piece *part = &s->part;
    const double by = ldexp(part->upper ? -1 : 1, -part->level) / t->cells,
                 u = ldexp(part->i + part->upper, -part->level) + by * i,
                 v = ldexp(part->j + part->upper, -part->level) + by * j;
    loft_vec p;

    if (s->surface.eval(s->surface.surface, LOFT_UNIT(u), LOFT_UNIT(v), &p) != LOFT_OK)
        return false;
    point_of(p, out);
    return s->trim == NULL ||
           loft_region_has(s->trim, s->plane ? loft_region_spot(p.axis[0], p.axis[1])
                                             : loft_region_spot(LOFT_REAL(u), LOFT_REAL(v)));
}

static void touch_sheet(touches *t, const loft_sheet *s)
{
    const bool triangle = s->surface.over == LOFT_SURFACE_TRIANGLE;
    double row[2][MOST + 1][3];
    bool has[2][MOST + 1] = { { false } };

    for (unsigned j = 0; j <= t->cells; j++) {
        double(*const now)[3] = row[j % 2], (*const last)[3] = row[(j + 1) % 2];
        bool *const is = has[j % 2], *const was = has[(j + 1) % 2];
        for (unsigned i = 0; i <= t->cells; i++)
            is[i] = !(triangle && i + j > t->cells) && find_point(t, s, i, j, now[i]);
        for (unsigned i = 0; i < t->cells && j > 0; i++) {
            if (was[i] && was[i + 1] && is[i])
                touch_triangle(t, (const double *const[3]){ last[i], last[i + 1], now[i] });
            if (was[i + 1] && is[i] && is[i + 1])
                touch_triangle(t, (const double *const[3]){ last[i + 1], now[i], now[i + 1] });
        }
    }
}

void ENGINE_OF(engine_touch)(const loft_drop *d, mill_order *o)
{
    touches t = { .d = *d, .o = o, .half = o->step / 2 };

    t.d.floor -= 2 * d->cutter.radius;
    t.cells = (unsigned)fmax(LEAST, fmin(MOST, sqrt((double)CELLS / d->count)));
    if (o->pattern == MILL_WATERLINE)
        t.half = 0;
    else if (o->cusp > 0)
        t.half = sqrt(o->cusp * (2 * o->radius - o->cusp));
    for (uint32_t k = 0; k < d->count; k++)
        touch_sheet(&t, &d->sheet[k]);
}
