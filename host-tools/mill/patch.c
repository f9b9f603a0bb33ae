/* host-tools/mill/patch.c -- a surface as a patch that a machine cuts by itself
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "toolpath/lines.h"     /* LOFT_LINES_GOUGE */

#include "base/source.h"        /* source_name */
#include "base/spool.h"         /* spool_grow */
#include "base/host.h"
#include "mill/patch.h"

#define ROWS_MOST 1024.0        /* of lib/toolpath/lines.h */
#define REACH     1024.0

static int32_t raw(double mm) { return (int32_t)lround(mm * 65536); }

static uint16_t feed_of(double speed)
{
    return (uint16_t)fmin(fmax(floor(speed * 60 + 1e-6), 1), 65535);
}


// The net
// -------

/* Point i, j of the surface: i along the lines' parameter that changes from line to line. */
static const double *point_of(const surface *s, const patch_order *o, unsigned i, unsigned j)
{
    return o->axis == 1 ? s->point[i * (s->n + 1) + j].p : s->point[j * (s->n + 1) + i].p;
}

/* The length along which lines follow each other, at most. */
static double length_across(const surface *s, const patch_order *o, unsigned m, unsigned n)
{
    double most = 0;

    for (unsigned j = 0; j <= n; j++) {
        double sum = 0;
        for (unsigned i = 0; i < m; i++) {
            const double *a = point_of(s, o, i, j), *b = point_of(s, o, i + 1, j);
            sum += sqrt(pow(b[0] - a[0], 2) + pow(b[1] - a[1], 2) + pow(b[2] - a[2], 2));
        }
        most = fmax(most, sum);
    }
    return most;
}

/* Refuse a patch that cannot be sent at all. */
static int check_kind(host *h, const surface *s, const char *file)
{
    if ((s->kind != SURFACE_TENSOR && s->kind != SURFACE_BICUBIC) || s->rational ||
        s->m > LOFT_PATCH_DEGREE || s->n > LOFT_PATCH_DEGREE || s->m < 1 || s->n < 1)
        return host_error(h, EX_DATAERR, "patch.degrees",
                          (host_place){ source_name(file), s->line }, "leave out --plan chip",
                          "%s%s of degrees %u x %u: a machine cuts polynomial tensor patches of "
                          "degrees 1 to %d by itself",
                          s->rational ? "rational " : "", surface_name(s->kind), s->m, s->n,
                          LOFT_PATCH_DEGREE);
    for (unsigned k = 0; k < (s->m + 1) * (s->n + 1); k++)
        for (int i = 0; i < ENGINE_AXES; i++)
            if (!(fabs(s->point[k].p[i]) <= REACH))
                return host_error(
                    h, EX_DATAERR, "patch.too-far", (host_place){ source_name(file), s->line },
                    HOST_REMEDY("bring it within +-%g", REACH), "%s: a point at %.6g mm",
                    surface_name(s->kind), s->point[k].p[i]);
    return 0;
}

static int refuse(host *h, const surface *s, const patch_order *o, int fault, const char *file)
{
    const char *what = fault == LOFT_LINES_NORMAL ? "it has no normal somewhere: leave out --plan "
                                                    "chip"
                       : fault == LOFT_LINES_OVERHANG
                           ? "it does not look up everywhere: leave out --plan chip"
                       : fault == LOFT_LINES_LOW ? "the ways above are below it: give more --safe"
                                                 : "it curves more than the ball: give a smaller "
                                                   "--tool";

    if (fault == LOFT_LINES_COARSE)
        return host_error(h, EX_DATAERR, "patch.tolerance",
                          (host_place){ source_name(file), s->line },
                          "give more --tol, or leave out --plan chip",
                          "%s: %u curves a line, the most of this machine, leave --tol %g",
                          surface_name(s->kind), o->columns, o->tol);
    return host_error(h, EX_DATAERR, "patch.ball", (host_place){ source_name(file), s->line }, what,
                      "%s: a ball of %g mm cannot cut it by lines", surface_name(s->kind),
                      2 * o->radius);
}

/* The fewest columns that keep the tolerance: a power of two, then between that and half of it. */
static int choose_columns(lines_patch *p, const patch_order *o)
{
    unsigned low = 0, high = 1;
    int fault;

    for (;; high *= 2) {
        high = high < o->columns ? high : o->columns;
        p->head.columns = (uint16_t)high;
        fault = o->lines(p, NULL, NULL);
        if (fault != LOFT_LINES_COARSE || high == o->columns)
            break;
        low = high;
    }
    while (fault == LOFT_LINES_FINE && high - low > 1) {
        const unsigned middle = low + (high - low) / 2;
        p->head.columns       = (uint16_t)middle;
        if (o->lines(p, NULL, NULL) == LOFT_LINES_FINE)
            high = middle;
        else
            low = middle;
    }
    p->head.columns = (uint16_t)high;
    return fault;
}

int patch_make(host *h, lines_patch *p, const surface *s, const patch_order *o,
               const double start[ENGINE_AXES], const char *file)
{
    const int code = check_kind(h, s, file);
    double top     = -HUGE_VAL;

    if (code != 0)
        return code;
    const unsigned m = o->axis == 1 ? s->m : s->n, n = o->axis == 1 ? s->n : s->m;
    const double rows = fmax(ceil(length_across(s, o, m, n) / o->step - 1e-6), 1);
    if (rows > ROWS_MOST)
        return host_error(h, EX_DATAERR, "patch.lines", (host_place){ source_name(file), s->line },
                          "give more --step",
                          "%s: %.0f lines %.6g mm apart: a machine cuts %.0f by itself",
                          surface_name(s->kind), rows + 1, o->step, ROWS_MOST + 1);
    *p = (lines_patch){ .head = { .radius = raw(o->radius),
                                  .tol = (int32_t)floor(o->tol * 65536),
                                  .rows = (uint16_t)rows,
                                  .feed = feed_of(o->feed),
                                  .rapid = feed_of(o->travel),
                                  .m = (uint8_t)m,
                                  .n = (uint8_t)n,
                                  .one_way = o->one_way } };
    for (unsigned k = 0; k < (m + 1) * (n + 1); k++) {
        const double *at = point_of(s, o, k / (n + 1), k % (n + 1));
        for (int i = 0; i < ENGINE_AXES; i++)
            p->net[k][i] = raw(at[i]);
        top = fmax(top, at[2]);
    }
    for (int i = 0; i < ENGINE_AXES; i++)
        p->place[i] = raw(start[i]);
    p->head.safe    = raw(top + o->above);
    const int fault = choose_columns(p, o);
    return fault == LOFT_LINES_FINE ? 0 : refuse(h, s, o, fault, file);
}

unsigned patch_items(const lines_patch *p, loft_item item[LOFT_PATCH_PARTS])
{
    const unsigned count = (p->head.m + 1u) * (p->head.n + 1u);
    unsigned items       = 0;

    loft_patch_item(&item[items++], &p->head, p->place);
    for (unsigned k = 0; k < count; k += 2)
        loft_patch_points(&item[items++], p->net[k], p->net[k + 1 < count ? k + 1 : k], p->place);
    return items;
}


// The path
// --------

typedef struct {
    toolpath *path;
    drawing *d;
    unsigned line;
    size_t room;
    bool cut;                   /* the last move cut */
} path_making;

static double length_of(const engine_move *m)
{
    double sum = 0;

    for (int k = 0; k < 3; k++)
        sum += sqrt(pow(m->p[k + 1][0] - m->p[k][0], 2) + pow(m->p[k + 1][1] - m->p[k][1], 2) +
                    pow(m->p[k + 1][2] - m->p[k][2], 2));
    return sum;
}

static void add_move(void *context, const engine_move *m, bool cuts)
{
    path_making *to = context;
    toolpath *t     = to->path;

    if (t->count == to->room) {
        to->room = to->room ? 2 * to->room : 256;
        t->move  = spool_grow(t->move, to->room * sizeof *t->move);
        t->curve = spool_grow(t->curve, to->room * sizeof *t->curve);
    }
    t->move[t->count]  = *m;
    t->curve[t->count] = cuts ? to->d->count : TOOLPATH_TRAVEL;
    t->count++;
    *(cuts ? &t->drawn : &t->travelled) += length_of(m);
    if (cuts) {
        double p[4][3];
        memcpy(p, m->p, sizeof p);
        drawing_add_space(to->d, p, m->feed, !to->cut, to->line);
        t->curves++;
    }
    to->cut = cuts;
}

void patch_path(const lines_patch *p, const patch_order *o, unsigned line, toolpath *path,
                drawing *d)
{
    path_making to = { .path = path, .d = d, .line = line };

    *path = (toolpath){ 0 };
    (void)o->lines(p, add_move, &to);
}
