/* host-tools/geometry/stretches.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "num/status.h"         /* LOFT_MORE */

#include "base/host.h"
#include "base/memory.h"
#include "geometry/stretches.h"

static bool boxes_apart(const element *a, const element *b, double gap)
{
    for (int i = 0; i < CURVE_AXES; i++)
        if (a->box[0][i] > b->box[1][i] + gap || b->box[0][i] > a->box[1][i] + gap)
            return true;
    return false;
}

static double stretch_gap(const double a[CURVE_AXES], const double b[CURVE_AXES])
{
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

/* True if one stretch begins where the other ends, or before. The seam of a closed curve does not
 * count. */
static bool stretches_touch(const double s[3], double at[3][CURVE_AXES], const double other[3],
                            double other_at[3][CURVE_AXES], double gap, double range)
{
    if (s[0] <= other[2] && other[0] <= s[2])
        return true;
    const bool after = s[0] > other[2];
    return fabs(after ? s[0] - other[2] : other[0] - s[2]) <= range / 100 &&
           stretch_gap(at[after ? 0 : 2], other_at[after ? 2 : 0]) <= gap;
}

static void extend_stretch(double s[3], double at[3][CURVE_AXES], const double other[3],
                           double other_at[3][CURVE_AXES])
{
    for (int k = 0; k < 3; k += 2)
        if (k == 0 ? other[k] < s[k] : other[k] > s[k]) {
            s[k] = other[k];
            memcpy(at[k], other_at[k], sizeof at[k]);
        }
}

/* Curves come in pieces: a stretch that continues in the next piece is one stretch. */
static void add_stretch(stretches *list, stretch c, double gap)
{
    for (size_t k = 0; k < list->count; ) {
        stretch *r = &list->row[k];
        if (!stretches_touch(c.s, c.on_first, r->s, r->on_first, gap, list->range[0]) ||
            !stretches_touch(c.t, c.on_second, r->t, r->on_second, gap, list->range[1])) {
            k++;
            continue;
        }
        stretch *far = r->distance < c.distance ? &c : r, both = r->distance < c.distance ? *r : c;
        extend_stretch(both.s, both.on_first, far->s, far->on_first);
        extend_stretch(both.t, both.on_second, far->t, far->on_second);
        both.overlap = c.overlap || r->overlap;
        c = both;
        memmove(r, r + 1, (--list->count - k) * sizeof *r);
        k = 0;
    }
    if (list->count == list->room) {
        list->room = list->room ? 2 * list->room : 16;
        list->row = memory_grow(list->row, list->room * sizeof *list->row);
    }
    list->row[list->count++] = c;
}

/* Parameters of the curve, and points, at three places of an element. */
static void set_places(const element *x, const double t[3], double out[3], double at[3][CURVE_AXES])
{
    double d[3][CURVE_AXES];

    for (int k = 0; k < 3; k++) {
        piece_eval(&x->p, t[k], d);
        memcpy(at[k], d[0], sizeof at[k]);
        out[k] = element_parameter(x, t[k], at[k]);
    }
}

int stretches_meet(host *h, stretches *list, const engine *e, const element *a, const element *b,
                   double tol)
{
    engine_meeting c[ENGINE_MEETINGS];
    size_t count;
    if (boxes_apart(a, b, tol))
        return EX_OK;
    const int status = e->measure->meet(&a->p, &b->p, tol / 2, c, &count);

    if (status == LOFT_MORE)
        return element_error(
            h, a, "meets another curve in more places than two curves have: give a larger --tol");
    if (status != 0)
        return element_error(h, a, engine_status(status, "no tolerance: give --tol above 0"));
    for (size_t k = 0; k < count; k++) {
        stretch r = { .distance = c[k].distance, .overlap = c[k].overlap };
        memcpy(r.point, c[k].point, sizeof r.point);
        set_places(a, c[k].s, r.s, r.on_first);
        set_places(b, c[k].t, r.t, r.on_second);
        add_stretch(list, r, 4 * tol);
    }
    return EX_OK;
}
