/* host-tools/engine/mill_cuts.c -- lines of a mill, and the order in which they are cut
 * SPDX-License-Identifier: MIT
 *
 * A hill grows downward: its line lies inside the next lower one. A pit shrinks: its line lies
 * around the next lower one. Both ways the higher line is first, so nothing is cut that has
 * material above it. The tool stays at one hill as long as that is near.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tool.h"          /* tool_grow */
#include "engine/mill.h"

mill_cut *mill_cuts_begin(mill_cuts *all, unsigned level)
{
    if (all->count == all->room) {
        all->room = all->room ? 2 * all->room : 64;
        all->cut  = tool_grow(all->cut, all->room * sizeof *all->cut);
    }
    all->cut[all->count] = (mill_cut){ .level = level };
    return &all->cut[all->count++];
}

/* The room is the next power of 2. */
void mill_cuts_add(mill_cuts *all, const double point[ENGINE_AXES])
{
    mill_cut *const c = &all->cut[all->count - 1];

    if ((c->count & (c->count - 1)) == 0)
        c->point = tool_grow(c->point, (c->count ? 2 * c->count : 1) * sizeof *c->point);
    memcpy(c->point[c->count++], point, sizeof *c->point);
}

void mill_cuts_one_way(mill_cuts *all, unsigned axis)
{
    for (size_t i = 0; i < all->count; i++) {
        mill_cut *const c = &all->cut[i];
        if (c->count < 2 || !(c->point[c->count - 1][axis] < c->point[0][axis]))
            continue;
        for (size_t k = 0, last = c->count - 1; k < last; k++, last--) {
            double kept[ENGINE_AXES];
            memcpy(kept, c->point[k], sizeof kept);
            memcpy(c->point[k], c->point[last], sizeof kept);
            memcpy(c->point[last], kept, sizeof kept);
        }
    }
}

void mill_cuts_free(mill_cuts *all)
{
    for (size_t i = 0; i < all->count; i++)
        free(all->cut[i].point);
    free(all->cut);
    *all = (mill_cuts){ 0 };
}

void mill_cut_turn(mill_cut *c, size_t first)
{
    const size_t n = c->count - 1;

    if (first == 0)
        return;
    double (*const old)[ENGINE_AXES] = tool_grow(NULL, n * sizeof *old);

    memcpy(old, c->point, n * sizeof *old);
    for (size_t k = 0; k <= n; k++)
        memcpy(c->point[k], old[(first + k) % n], sizeof *old);
    free(old);
}


/* Which line is before which */

/* The distance of a point from a chord, seen from above. */
static double distance(const double p[ENGINE_AXES], const double a[ENGINE_AXES],
                       const double b[ENGINE_AXES])
{
    const double x = b[0] - a[0], y = b[1] - a[1], length2 = x * x + y * y,
                 along = (p[0] - a[0]) * x + (p[1] - a[1]) * y,
                 t     = length2 > 0 ? fmax(0, fmin(1, along / length2)) : 0;

    return hypot(a[0] + t * x - p[0], a[1] + t * y - p[1]);
}

static bool lies_in(const double p[ENGINE_AXES], const mill_cut *c)
{
    bool in = false;

    for (size_t i = 0, j = c->count - 1; i < c->count; j = i++) {
        const double *const a = c->point[i], *const b = c->point[j];
        if ((a[1] > p[1]) != (b[1] > p[1]) &&
            p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]))
            in = !in;
    }
    return in;
}

static bool depends(const mill_cut *low, const mill_cut *high, double apart)
{
    double box[2][2] = { { INFINITY, INFINITY }, { -INFINITY, -INFINITY } };

    if (lies_in(low->point[0], high) || lies_in(high->point[0], low))
        return true;
    for (size_t j = 0; j < high->count; j++)
        for (int k = 0; k < 2; k++) {
            box[0][k] = fmin(box[0][k], high->point[j][k] - apart);
            box[1][k] = fmax(box[1][k], high->point[j][k] + apart);
        }
    for (size_t i = 0; i < low->count; i++)
        for (size_t j = 0;
             j + 1 < high->count && low->point[i][0] > box[0][0] && low->point[i][0] < box[1][0] &&
             low->point[i][1] > box[0][1] && low->point[i][1] < box[1][1];
             j++)
            if (distance(low->point[i], high->point[j], high->point[j + 1]) < apart)
                return true;
    return false;
}

/* For each cut those of the level above that must be done before: a row of bits. */
static unsigned char *find_before(const mill_cuts *all, double apart)
{
    unsigned char *const before = tool_grow(NULL, all->count * all->count);

    memset(before, 0, all->count * all->count);
    for (size_t i = 0; i < all->count; i++)
        for (size_t j = 0; j < all->count; j++)
            before[i * all->count + j] = all->cut[j].level + 1 == all->cut[i].level &&
                                         depends(&all->cut[i], &all->cut[j], apart);
    return before;
}


/* The order */

typedef struct {
    size_t cut, point;
    double way;
} choice;

static double way_to(const double at[ENGINE_AXES], const double to[ENGINE_AXES])
{
    return hypot(at[0] - to[0], at[1] - to[1]) + fabs(at[2] - to[2]);
}

static bool is_free(const mill_cuts *all, const unsigned char *before, size_t i)
{
    for (size_t j = 0; j < all->count; j++)
        if (before[i * all->count + j] && !all->cut[j].done)
            return false;
    return !all->cut[i].done;
}

/* The nearest line that may be next, and where it begins. From nowhere: the first one. */
static choice find_next(const mill_cuts *all, const unsigned char *before, const double *at)
{
    choice best = { all->count, 0, INFINITY };

    for (size_t i = 0; i < all->count; i++) {
        const mill_cut *const c = &all->cut[i];
        if (!is_free(all, before, i))
            continue;
        if (!at)
            return (choice){ i, 0, 0 };
        for (size_t k = 0; k < (c->closed ? c->count - 1 : 1); k++) {
            const double way = way_to(at, c->point[k]);
            if (way < best.way)
                best = (choice){ i, k, way };
        }
    }
    return best;
}

void mill_cuts_order(mill_cuts *all, double apart)
{
    if (all->count == 0)
        return;
    unsigned char *const before = find_before(all, apart);
    mill_cut *const sorted = tool_grow(NULL, all->count * sizeof *sorted);
    const double *at = NULL;

    for (size_t n = 0; n < all->count; n++) {
        const choice next = find_next(all, before, at);
        mill_cut *const c = &all->cut[next.cut];
        mill_cut_turn(c, next.point);
        c->done = true;
        sorted[n] = *c;
        at = c->point[c->count - 1];
    }
    free(before);
    free(all->cut);
    all->cut = sorted;
    all->room = all->count;
}
