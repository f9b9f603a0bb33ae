/* host-tools/arrange/order.c -- drops doubles, joins paths, and draws them in a short order
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/host.h"
#include "base/memory.h"
#include "base/source.h"    /* source_name */
#include "engine/curve.h"   /* curves_free */
#include "arrange/order.h"
#include "arrange/tour.h"

#define SAME   5e-6         /* mm: no line is needed between such ends, see toolpath.c */
#define GRAIN  1e-4         /* mm: curves that agree to this are doubles */
#define CORNER 0.9659       /* cosine of 15 degrees: a larger turn is a corner */
#define SEAMS  64           /* points of a closed path from which it may begin, at most */
#define FANS   16           /* ends near an end that are considered, at most */
#define LOOP   20           /* times the gap: a path of this length may be closed by a line */
#define NONE   SIZE_MAX

static void turn_curve(drawing_curve *c)
{
    const drawing_curve was = *c;

    for (int k = 0; k < 4; k++) {
        memcpy(c->p[k], was.p[3 - k], sizeof c->p[k]);
        c->z[k] = was.z[3 - k];
    }
}

static double apart(const double a[2], const double b[2])
{
    return hypot(a[0] - b[0], a[1] - b[1]);
}


// Doubles
// -------

typedef struct {
    int64_t key[12];
    size_t index;
} whole_curve;

/* One key for both directions of a curve. */
static void set_key(whole_curve *w, const drawing_curve *c)
{
    int64_t forth[12], back[12];

    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++) {
            const double x      = i < 2 ? c->p[k][i] : c->z[k];
            forth[3 * k + i]    = llround(x / GRAIN);
            back[9 - 3 * k + i] = forth[3 * k + i];
        }
    memcpy(w->key, memcmp(forth, back, sizeof forth) < 0 ? forth : back, sizeof w->key);
}

static int compare_wholes(const void *a, const void *b)
{
    const whole_curve *x = a, *y = b;
    const int order      = memcmp(x->key, y->key, sizeof x->key);
    return order != 0 ? order : (x->index > y->index) - (x->index < y->index);
}

/* Leave out curves that are there already. A path is cut where one is missing. */
static void drop_doubles(drawing *d)
{
    whole_curve *all = memory_grow(NULL, d->count * sizeof *all);
    bool *drop       = memory_grow(NULL, d->count * sizeof *drop);
    drawing kept     = { .width = d->width, .height = d->height };

    for (size_t i = 0; i < d->count; i++) {
        set_key(&all[i], &d->curve[i]);
        all[i].index = i;
    }
    qsort(all, d->count, sizeof *all, compare_wholes);
    for (size_t i = 0; i < d->count; i++)
        drop[all[i].index] = i > 0 && memcmp(all[i].key, all[i - 1].key, sizeof all[i].key) == 0;
    for (size_t i = 0; i < d->count; i++)
        if (!drop[i])
            drawing_add_like(&kept, &d->curve[i],
                             i == 0 || drop[i - 1] || d->curve[i].path != d->curve[i - 1].path);
    free(all);
    free(drop);
    drawing_free(d);
    *d = kept;
}


// Joins
// -----

/* Curves first .. last - 1 follow each other. Its ends are 2 i and 2 i + 1. */
typedef struct {
    size_t first, last;
    size_t partner[2];          /* the end that this end is joined to, or NONE */
    bool drawn;
} run;

typedef struct {
    const drawing *d;
    run *all;
    size_t count;
} runs;

static void find_runs(runs *r, const drawing *d)
{
    *r = (runs){ .d = d, .all = memory_grow(NULL, d->count * sizeof *r->all) };
    for (size_t i = 0; i < d->count; i++) {
        if (i == 0 || d->curve[i].path != d->curve[i - 1].path)
            r->all[r->count++] = (run){ i, i, { NONE, NONE }, false };
        r->all[r->count - 1].last = i + 1;
    }
}

/* Place and height of an end, and the direction in which its path leaves there. */
static void end_of(const runs *r, size_t end, double place[3], double way[2])
{
    const run *of          = &r->all[end / 2];
    const bool last        = end % 2 == 1;
    const drawing_curve *c = &r->d->curve[last ? of->last - 1 : of->first];
    const int at           = last ? 3 : 0;
    int k                  = last ? 2 : 1;

    place[0] = c->p[at][0];
    place[1] = c->p[at][1];
    place[2] = c->z[at];
    while (k != 3 - at && apart(c->p[k], c->p[at]) <= SAME)
        k += last ? -1 : 1;
    const double length = apart(c->p[k], c->p[at]);
    for (int i = 0; i < 2; i++)
        way[i] = length > 0 ? (c->p[at][i] - c->p[k][i]) / length : 0;
}

typedef struct {
    double place[3], way[2];
    size_t end;
} loose_end;

typedef struct {
    size_t a, b;                /* ends */
    double cost;
} possible_join;

static int compare_ends(const void *a, const void *b)
{
    const loose_end *x = a, *y = b;

    if (x->place[0] < y->place[0] || x->place[0] > y->place[0])
        return x->place[0] > y->place[0] ? 1 : -1;
    return (x->end > y->end) - (x->end < y->end);
}

static int compare_joins(const void *a, const void *b)
{
    const possible_join *x = a, *y = b;

    if (x->cost < y->cost || x->cost > y->cost)
        return x->cost > y->cost ? 1 : -1;
    if (x->a != y->a)
        return x->a > y->a ? 1 : -1;
    return (x->b > y->b) - (x->b < y->b);
}

/* Where ends touch, the straighter join is the better one; otherwise the shorter one. */
static double join_cost(const loose_end *a, const loose_end *b, double distance)
{
    return distance > SAME ? distance : a->way[0] * b->way[0] + a->way[1] * b->way[1] - 2;
}

/* May these ends be joined? A short stroke is not closed by a line as long as itself. */
static bool is_join(const runs *r, const loose_end *a, const loose_end *b, double distance,
                    double within)
{
    const run *of = &r->all[a->end / 2];
    double length = 0;

    if (distance > within || fabs(a->place[2] - b->place[2]) > SAME)
        return false;
    if (a->end / 2 != b->end / 2 || distance <= SAME)
        return true;
    for (size_t i = of->first; i < of->last; i++)
        for (int k = 0; k < 3; k++)
            length += apart(r->d->curve[i].p[k], r->d->curve[i].p[k + 1]);
    return length > LOOP * within;
}

/* Ends sorted by x: partners are near in the list. */
static size_t find_joins(const runs *r, const loose_end end[], size_t count, double within,
                         possible_join **out)
{
    size_t found = 0, room = 0;

    for (size_t i = 0; i < count; i++) {
        unsigned fans = 0;
        for (size_t j = i + 1; j < count && end[j].place[0] - end[i].place[0] <= within; j++) {
            const double distance = apart(end[i].place, end[j].place);
            if (!is_join(r, &end[i], &end[j], distance, within))
                continue;
            if (found == room) {
                room = room ? 2 * room : 256;
                *out = memory_grow(*out, room * sizeof **out);
            }
            (*out)[found++] = (possible_join){ end[i].end, end[j].end,
                                               join_cost(&end[i], &end[j], distance) };
            if (++fans == FANS)
                break;
        }
    }
    return found;
}

static void join_runs(runs *r, double within)
{
    loose_end *end      = memory_grow(NULL, 2 * r->count * sizeof *end);
    possible_join *join = NULL;

    for (size_t e = 0; e < 2 * r->count; e++) {
        end[e].end = e;
        end_of(r, e, end[e].place, end[e].way);
    }
    qsort(end, 2 * r->count, sizeof *end, compare_ends);
    const size_t count = find_joins(r, end, 2 * r->count, fmax(within, SAME), &join);
    if (count > 0)
        qsort(join, count, sizeof *join, compare_joins);
    for (size_t k = 0; k < count; k++) {
        size_t *a = &r->all[join[k].a / 2].partner[join[k].a % 2],
               *b = &r->all[join[k].b / 2].partner[join[k].b % 2];
        if (*a != NONE || *b != NONE)
            continue;
        *a = join[k].b;
        *b = join[k].a;
    }
    free(join);
    free(end);
}


// Chains
// ------

/* A line over the gap to the next curve, if there is one, drawn as that is. */
static void bridge_gap(drawing *out, const drawing_curve *next)
{
    const drawing_curve *last = &out->curve[out->count - 1];
    drawing_curve c           = *next;

    if (apart(last->p[3], next->p[0]) <= SAME)
        return;
    for (int k = 0; k < 4; k++) {
        for (int i = 0; i < 2; i++)
            c.p[k][i] = last->p[3][i] + (next->p[0][i] - last->p[3][i]) * k / 3;
        c.z[k] = next->z[0];
    }
    memcpy(c.p[3], next->p[0], sizeof c.p[3]);
    drawing_add_like(out, &c, false);
}

/* Draw the runs that are joined, from one of its ends on. Returns whether they close. */
static bool draw_chain(const runs *r, size_t end, drawing *out)
{
    const size_t begin = out->count;

    for (size_t e = end; e != NONE && !r->all[e / 2].drawn;
         e = r->all[e / 2].partner[e % 2 == 0 ? 1 : 0]) {
        run *of = &r->all[e / 2];
        of->drawn = true;
        for (size_t i = of->first; i < of->last; i++) {
            drawing_curve c = r->d->curve[e % 2 == 0 ? i : of->first + of->last - 1 - i];
            if (e % 2 == 1)
                turn_curve(&c);
            if (out->count > begin && i == of->first)
                bridge_gap(out, &c);
            drawing_add_like(out, &c, out->count == begin);
        }
    }
    const drawing_curve first = out->curve[begin];
    const bool closed         = r->all[end / 2].partner[end % 2] != NONE;
    if (closed)
        bridge_gap(out, &first);
    return closed;
}

typedef struct {
    drawing d;                  /* chain by chain */
    size_t *first;              /* curve of each chain, and the end of the last one */
    bool *closed;
    size_t count;
} chains;

/* Open chains begin at an end without a partner; what is left then is closed. */
static void make_chains(chains *c, runs *r)
{
    *c = (chains){ .first  = memory_grow(NULL, (r->count + 1) * sizeof *c->first),
                   .closed = memory_grow(NULL, (r->count + 1) * sizeof *c->closed) };
    for (int closed = 0; closed < 2; closed++)
        for (size_t e = 0; e < 2 * r->count; e++)
            if (!r->all[e / 2].drawn && (closed || r->all[e / 2].partner[e % 2] == NONE)) {
                c->first[c->count]    = c->d.count;
                c->closed[c->count++] = draw_chain(r, e, &c->d);
            }
    c->first[c->count] = c->d.count;
}


// Seams
// -----

typedef struct {
    double (*point)[2];
    size_t *curve;              /* that begins there */
    tour_stroke *stroke;        /* of each chain */
    size_t count, room;
} seams;

static void add_seam(seams *s, const double at[2], size_t begins)
{
    if (s->count == s->room) {
        s->room  = s->room ? 2 * s->room : 256;
        s->point = memory_grow(s->point, s->room * sizeof *s->point);
        s->curve = memory_grow(s->curve, s->room * sizeof *s->curve);
    }
    memcpy(s->point[s->count], at, sizeof s->point[0]);
    s->curve[s->count++] = begins;
}

static bool is_corner(const drawing_curve *a, const drawing_curve *b)
{
    double in[2], out[2];
    int j = 2, k = 1;

    while (j > 0 && apart(a->p[j], a->p[3]) <= SAME)
        j--;
    while (k < 3 && apart(b->p[k], b->p[0]) <= SAME)
        k++;
    for (int i = 0; i < 2; i++) {
        in[i]  = a->p[3][i] - a->p[j][i];
        out[i] = b->p[k][i] - b->p[0][i];
    }
    return in[0] * out[0] + in[1] * out[1] < CORNER * hypot(in[0], in[1]) * hypot(out[0], out[1]);
}

/* The joints of a closed chain that are corners, or all; of many, every second, third .. one. */
static void add_joints(seams *s, const chains *c, size_t chain, bool corners)
{
    const size_t first = c->first[chain], last = c->first[chain + 1], before = s->count;
    size_t found = 0;

    for (int pass = 0; pass < 2; pass++) {
        const size_t step = 1 + found / SEAMS;
        size_t k          = 0;
        for (size_t i = first; i < last; i++) {
            const drawing_curve *a = &c->d.curve[i == first ? last - 1 : i - 1],
                                *b = &c->d.curve[i];
            if ((!corners || is_corner(a, b)) && k++ % step == 0 && pass == 1)
                add_seam(s, b->p[0], i);
        }
        found = k;
    }
    if (s->count == before)         /* no corner: the beginning in the file */
        add_joints(s, c, chain, false);
}

static void add_nearest_joint(seams *s, const chains *c, size_t chain, const double to[2])
{
    size_t best = c->first[chain];

    for (size_t i = best; i < c->first[chain + 1]; i++)
        if (apart(c->d.curve[i].p[0], to) < apart(c->d.curve[best].p[0], to))
            best = i;
    add_seam(s, c->d.curve[best].p[0], best);
}

static void find_seams(seams *s, const chains *c, bool corners, const double *near)
{
    *s = (seams){ .stroke = memory_grow(NULL, c->count * sizeof *s->stroke) };
    for (size_t i = 0; i < c->count; i++) {
        const drawing_curve *first = &c->d.curve[c->first[i]],
                            *last  = &c->d.curve[c->first[i + 1] - 1];
        s->stroke[i] = (tour_stroke){ .first = s->count, .closed = c->closed[i] };
        if (!c->closed[i]) {
            add_seam(s, first->p[0], c->first[i]);
            add_seam(s, last->p[3], c->first[i]);
        } else if (near != NULL) {
            add_nearest_joint(s, c, i, near);
        } else {
            add_joints(s, c, i, corners);
        }
        s->stroke[i].count = s->count - s->stroke[i].first;
    }
}


// All of it
// ---------

static void draw_visit(const chains *c, const seams *s, const tour_visit *v, drawing *out)
{
    const size_t first = c->first[v->stroke], n = c->first[v->stroke + 1] - first,
                 from  = s->curve[s->stroke[v->stroke].first + v->point] - first;
    const bool back    = !c->closed[v->stroke] && v->point == 1;

    for (size_t k = 0; k < n; k++) {
        drawing_curve one = c->d.curve[first + (back ? n - 1 - k : (from + k) % n)];
        if (back)
            turn_curve(&one);
        drawing_add_like(out, &one, k == 0);
    }
}

static int order_chains(host *h, const order_options *o, chains *c, bool corners,
                        const double *near, const double from[2], bool returns, drawing *out)
{
    tour_visit *way = memory_grow(NULL, c->count * sizeof *way);
    seams s;

    find_seams(&s, c, corners, near);
    const tour_problem t = { .host = h,
                             .point = (const double(*)[2])s.point,
                             .stroke  = s.stroke,
                             .count   = c->count,
                             .from    = { from[0], from[1] },
                             .returns = returns,
                             .effort  = o->effort };
    const bool found = tour_find(&t, way) >= 0;
    for (size_t k = 0; k < c->count; k++)
        draw_visit(c, &s, &way[k], out);
    free(way);
    free(s.point);
    free(s.curve);
    free(s.stroke);
    return found ? 0 : EX_TEMPFAIL;
}

const option order_rows[] = {
    OPTION_HEADING("order of the paths"),
    { "order", OPTION_TEXT(order_options, how), .choices = "file|layer|best", .standard = "file",
      .help = "of the paths: as in the file, or with the least travel: within each layer of "
              "Inkscape, or in all. What follows is for these two (file)" },
    { "order-time", OPTION_NUMBER(order_options, effort), .least = 0, .most = 3600, .unit = "s",
      .standard = "2",
      .help = "work of about S seconds. It is counted, so that the same command gives the same "
              "order" },
    { "join", OPTION_NUMBER(order_options, join), .least = 0, .most = 10, .unit = "mm",
      .standard = "0.005", .help = "ends this close are joined by a line" },
    { "seam", OPTION_TEXT(order_options, seam), .value = "WHERE",
      .help = "where closed paths begin: any, corner, or X,Y: near to it (any)" },
    { "doubles", OPTION_FLAG(order_options, doubles),
      .help = "draw twice what the drawing has twice" },
    { 0 }
};

static int seam_of(host *h, const order_options *o, bool *corners, double near[2], bool *nearest)
{
    int length = 0;

    *corners = o->seam != NULL && strcmp(o->seam, "corner") == 0;
    *nearest = o->seam != NULL && sscanf(o->seam, "%lf,%lf%n", &near[0], &near[1], &length) == 2 &&
               o->seam[length] == '\0' && isfinite(near[0]) && isfinite(near[1]);
    if (o->seam == NULL || *corners || *nearest || strcmp(o->seam, "any") == 0)
        return 0;
    return host_error(h, EX_USAGE, "order.seam", (host_place){ NULL, 0 }, "give any, corner or X,Y",
                      "--seam %s", o->seam);
}

int order_apply(host *h, const order_options *o, drawing *d, const double from[2], bool returns,
                const char *file)
{
    drawing ordered = { .width = d->width, .height = d->height };
    double near[2]  = { 0, 0 };
    bool corners, nearest;
    chains c;
    runs r;
    int code = seam_of(h, o, &corners, near, &nearest);

    if (code != 0 || o->how == NULL || strcmp(o->how, "file") == 0)
        return code;
    if (d->program)
        return host_error(h, EX_USAGE, "order.program", (host_place){ source_name(file), 0 },
                          "leave --order out",
                          "is a program, which says every motion: its order is that of the file");
    if (d->count == 0)
        return 0;
    if (d->of != NULL)
        curves_free(d->of);
    free(d->of);
    d->of = NULL;
    if (!o->doubles)
        drop_doubles(d);
    find_runs(&r, d);
    join_runs(&r, o->join);
    make_chains(&c, &r);
    code = order_chains(h, o, &c, corners, nearest ? near : NULL, from, returns, &ordered);
    free(r.all);
    free(c.first);
    free(c.closed);
    drawing_free(&c.d);
    drawing_free(d);
    *d = ordered;
    return code;
}
