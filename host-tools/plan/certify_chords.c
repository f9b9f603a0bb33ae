/* host-tools/plan/certify_chords.c -- the paths of a plan as chords
 * SPDX-License-Identifier: MIT
 *
 * Where corners have a larger tolerance, chords of the drawing end where that begins and ends.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "plan/certify_chords.h"
#include "plan/bends.h"         /* bends_find */
#include "base/space.h"         /* space_distance */
#include "base/memory.h"

void certify_cubic_of_span(const certify_plan *plan, size_t n, certify_cubic *out)
{
    for (int k = 0; k < 4; k++) {
        double motors[ENGINE_AXES];
        for (int i = 0; i < ENGINE_AXES; i++)
            motors[i] = plan->span[n].p[k][i] * ENGINE_LSB;
        if (!kinematics_tool(plan->k, motors, out->p[k]))
            memcpy(out->p[k], motors, sizeof motors);
    }
}

void certify_cubic_of_move(const certify_plan *plan, size_t n, certify_cubic *out)
{
    memcpy(out->p, plan->move[n].p, sizeof out->p);
}

double certify_bulge(const certify_cubic *c)
{
    double most = 0;

    for (int k = 0; k < 2; k++) {
        double sum = 0;
        for (int i = 0; i < ENGINE_AXES; i++) {
            const double d = c->p[k][i] - 2 * c->p[k + 1][i] + c->p[k + 2][i];
            sum += d * d;
        }
        most = fmax(most, sum);
    }
    return 0.75 * sqrt(most);
}

double certify_length(const certify_cubic *c)
{
    double size = 0;

    for (int k = 0; k < 3; k++)
        size += space_distance(c->p[k], c->p[k + 1]);
    return size;
}

static void make_room(certify_chords *c, size_t n)
{
    if (n >= c->room) {
        c->room = c->room ? 2 * c->room : 1024;
        c->end  = memory_grow(c->end, c->room * sizeof *c->end);
        c->s    = memory_grow(c->s, c->room * sizeof *c->s);
        c->share = memory_grow(c->share, c->room * sizeof *c->share);
        c->of   = memory_grow(c->of, c->room * sizeof *c->of);
    }
}

static void add_end(certify_chords *c, size_t of, const double at[ENGINE_AXES])
{
    const size_t n = c->s == NULL ? 0 : c->chords + 1;

    make_room(c, n);
    c->share[n] = 1;
    c->of[n > 0 ? n - 1 : 0] = of;
    memcpy(c->end[n], at, sizeof c->end[n]);
    c->s[n]   = n > 0 ? c->s[n - 1] + space_distance(at, c->end[n - 1]) : 0;
    c->chords = n;
}

void certify_chords_add(certify_chords *out, size_t of, const certify_cubic *c, double fine,
                        double longest)
{
    const double size = certify_length(c),
                 parts = fmax(fmax(ceil(sqrt(certify_bulge(c) / fine)), ceil(size / longest)), 1);

    for (double k = out->s == NULL ? 0 : 1; k <= parts; k++) {
        double at[ENGINE_AXES];
        certify_eval(c, k / parts, at);
        add_end(out, of, at);
    }
}

void certify_chords_make(certify_chords *out, const certify_plan *plan, certify_source *source,
                         size_t count, double fine)
{
    *out = (certify_chords){ .chords = 0 };
    for (size_t n = 0; n < count; n++) {
        certify_cubic c;
        source(plan, n, &c);
        certify_chords_add(out, n, &c, fine, HUGE_VAL);
    }
}

void certify_chords_forget(certify_chords *c, size_t count)
{
    c->chords -= count;
    memmove(c->end, c->end + count, (c->chords + 1) * sizeof *c->end);
    memmove(c->s, c->s + count, (c->chords + 1) * sizeof *c->s);
    memmove(c->share, c->share + count, c->chords * sizeof *c->share);
    memmove(c->of, c->of + count, c->chords * sizeof *c->of);
}

void certify_chords_free(certify_chords *c)
{
    free(c->end);
    free(c->s);
    free(c->share);
    free(c->of);
}


// Corners
// -------

bool certify_chords_cut(certify_chords *c, size_t k, double s)
{
    if (!(s > c->s[k] && s < c->s[k + 1]))
        return false;
    const double z = (s - c->s[k]) / (c->s[k + 1] - c->s[k]);
    double at[ENGINE_AXES];

    for (int i = 0; i < ENGINE_AXES; i++)
        at[i] = c->end[k][i] + z * (c->end[k + 1][i] - c->end[k][i]);
    make_room(c, c->chords + 1);
    memmove(c->end + k + 2, c->end + k + 1, (c->chords - k) * sizeof *c->end);
    memmove(c->s + k + 2, c->s + k + 1, (c->chords - k) * sizeof *c->s);
    memmove(c->share + k + 1, c->share + k, (c->chords - k) * sizeof *c->share);
    memmove(c->of + k + 1, c->of + k, (c->chords - k) * sizeof *c->of);
    memcpy(c->end[k + 1], at, sizeof at);
    c->s[k + 1] = s;
    c->chords++;
    return true;
}

/* Where along the drawing the corner at `at` is: it is about `expected`. */
static double corner_at(const certify_chords *c, const double at[ENGINE_AXES], double expected,
                        double within)
{
    double least = HUGE_VAL, s = expected;

    for (size_t k = 0; k < c->chords; k++) {
        if (c->s[k + 1] < expected - within || c->s[k] > expected + within)
            continue;
        const double d = space_segment_distance(at, c->end[k], c->end[k + 1]);
        if (d < least) {
            least = d;
            s = c->s[k] + fmin(space_distance(at, c->end[k]), c->s[k + 1] - c->s[k]);
        }
    }
    return s;
}

/* The length of the path that is planned up to a bend; chord *k is not behind it. */
static double way_to(const certify_chords *c, const bend *b, size_t *k)
{
    while (*k < c->chords && c->of[*k] < b->move)
        ++*k;
    size_t end = *k;
    while (end < c->chords && c->of[end] == b->move)
        end++;
    return b->t > 0 ? corner_at(c, b->at, (c->s[*k] + c->s[end]) / 2, (c->s[end] - c->s[*k]) / 2)
                    : c->s[*k];
}

/* Chords again, with ends at s. */
static void cut_at(certify_chords *c, const double s[], size_t count)
{
    certify_chords out = { .chords = 0 };
    size_t n = 0;

    add_end(&out, 0, c->end[0]);
    for (size_t k = 0; k < c->chords; k++) {
        for (; n < count && s[n] < c->s[k + 1]; n++)
            if (s[n] > c->s[k]) {
                const double z = (s[n] - c->s[k]) / (c->s[k + 1] - c->s[k]);
                double at[ENGINE_AXES];
                for (int i = 0; i < ENGINE_AXES; i++)
                    at[i] = c->end[k][i] + z * (c->end[k + 1][i] - c->end[k][i]);
                add_end(&out, c->of[k], at);
            }
        add_end(&out, c->of[k], c->end[k + 1]);
    }
    certify_chords_free(c);
    *c = out;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Where the corners of the path that is planned are along the drawing; memory_grow has made it. */
static double *corners_of(const certify_chords *drawn, const certify_plan *plan, size_t *count)
{
    const certify_plan planned = { .move = plan->planned ? plan->planned : plan->move,
                                   .moves = plan->planned ? plan->planned_moves : plan->moves };
    bends b;
    certify_chords path;
    size_t k = 0;
    double at = 0, before = 0;

    bends_find(&b, planned.move, planned.moves);
    certify_chords_make(&path, &planned, certify_cubic_of_move, planned.moves, plan->tol);
    double *s = memory_grow(NULL, (b.count + 1) * sizeof *s);
    for (size_t n = 0; n < b.count; n++) {
        const double now = way_to(&path, &b.bend[n], &k), way = now - before;
        at = corner_at(drawn, b.bend[n].at, at + way, plan->tol + 0.02 * way);
        before = now;
        s[n] = at;
    }
    *count = b.count;
    certify_chords_free(&path);
    bends_free(&b);
    return s;
}

void certify_mark_corners(certify_chords *drawn, const certify_plan *plan)
{
    const double reach = CERTIFY_NEAR * plan->corner;
    size_t count, n = 0;
    double *corner = corners_of(drawn, plan, &count),
           *cut = memory_grow(NULL, (2 * count + 1) * sizeof *cut);

    for (size_t i = 0; i < count; i++) {
        cut[2 * i]     = corner[i] - reach;
        cut[2 * i + 1] = corner[i] + reach;
    }
    qsort(cut, 2 * count, sizeof *cut, by_size);
    cut_at(drawn, cut, 2 * count);
    for (size_t k = 0; k < drawn->chords; k++) {
        const double middle = (drawn->s[k] + drawn->s[k + 1]) / 2;
        while (n < count && corner[n] + reach < middle)
            n++;
        drawn->share[k] = n < count && corner[n] - reach <= middle ? plan->tol / plan->corner : 1;
    }
    free(cut);
    free(corner);
}
