/* tests/tools/test_tour.c -- the way between strokes: each once, the shortest of few, near a lower
 * bound of many
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>
#include <time.h>

#include "check.h"
#include "arrange/tour.h"
#include "tools/drawn.h"
#include "tools/tour_bound.h"

double tool_clock(void) { return 0; }      /* for the progress bar, which is not shown */

#define MOST 2000

typedef struct {
    double point[4 * MOST][2];
    tour_stroke stroke[MOST];
    tour_problem t;
} problem;

static double random_unit(arb *a)      { return (double)(arb_next(a) >> 11) / 9007199254740992.0; }

/* Strokes of random place, direction and length; `round` of 4 are closed, of 3 points. */
static void make_problem(problem *p, arb *a, size_t count, unsigned round, double clusters)
{
    size_t used = 0;

    for (size_t i = 0; i < count; i++) {
        const double turn = 6.2831853 * random_unit(a), part = floor(clusters * random_unit(a)),
                     far = clusters > 0 ? 10 : 200, length = far / 20 * random_unit(a);
        const double x = far * random_unit(a) + 37 * fmod(part * 5, 7),
                     y = far * random_unit(a) + 29 * fmod(part * 3, 11);
        const bool closed = arb_below(a, 4) < round;
        p->stroke[i] = (tour_stroke){ used, closed ? 3 : 2, closed };
        for (size_t k = 0; k < p->stroke[i].count; k++) {
            p->point[used][0]   = x + length * (double)k * cos(turn + (double)k);
            p->point[used++][1] = y + length * (double)k * sin(turn + (double)k);
        }
    }
    p->t = (tour_problem){ .host = &heard,
                           .point = (const double(*)[2])p->point,
                           .stroke  = p->stroke,
                           .count   = count,
                           .from    = { 3, 4 },
                           .effort  = 0.02 };
}

static void check_visits(const problem *p, const tour_visit way[])
{
    bool seen[MOST] = { false };

    for (size_t k = 0; k < p->t.count; k++) {
        CHECK(way[k].stroke < p->t.count && !seen[way[k].stroke] &&
              way[k].point < p->stroke[way[k].stroke].count);
        seen[way[k].stroke] = true;
    }
}

/* Try all orders from place `done` on. */
static double shortest(const problem *p, tour_visit way[], size_t done)
{
    double least = HUGE_VAL;

    if (done == p->t.count)
        return tour_length(&p->t, way);
    for (size_t k = done; k < p->t.count; k++) {
        const tour_visit was = way[done], one = way[k];
        way[k] = was;
        for (size_t point = 0; point < p->stroke[one.stroke].count; point++) {
            way[done] = (tour_visit){ one.stroke, point };
            least     = fmin(least, shortest(p, way, done + 1));
        }
        way[done] = was;
        way[k]    = one;
    }
    return least;
}

static void few_strokes_have_the_shortest_way(arb *a)
{
    static problem p;
    tour_visit way[6], all[6];

    make_problem(&p, a, 1 + arb_below(a, 5), arb_below(a, 5), 0);
    p.t.returns = arb_below(a, 2) == 1;
    for (size_t k = 0; k < p.t.count; k++)
        all[k] = (tour_visit){ k, 0 };
    const double found = tour_find(&p.t, way);
    check_visits(&p, way);
    CHECK_NEAR(found, tour_length(&p.t, way), 1e-9);
    CHECK_NEAR(found, shortest(&p, all, 0), 1e-6);
}

/* Each stroke once, never longer than given, and the same again. */
static void ways_are_whole_and_repeatable(arb *a)
{
    static problem p;
    static tour_visit way[MOST], again[MOST];

    make_problem(&p, a, 1 + arb_below(a, 300), arb_below(a, 5), arb_below(a, 2) * 9.0);
    p.t.returns = arb_below(a, 2) == 1;
    p.t.effort  = arb_below(a, 3) * 0.01;
    for (size_t k = 0; k < p.t.count; k++)
        way[k] = (tour_visit){ k, 0 };
    const double given = tour_length(&p.t, way);
    CHECK(tour_find(&p.t, way) <= given);
    check_visits(&p, way);
    (void)tour_find(&p.t, again);
    CHECK(memcmp(way, again, p.t.count * sizeof *way) == 0);
}

/* All in one point, on one line, or in the best order already. */
static void odd_places_are_taken(arb *a)
{
    static problem p;
    static tour_visit way[MOST];

    make_problem(&p, a, 200, 0, 0);
    for (size_t k = 0; k < 400; k++)
        p.point[k][0] = p.point[k][1] = 7;
    CHECK_NEAR(tour_find(&p.t, way), hypot(4, 3), 1e-9);
    check_visits(&p, way);
    for (size_t k = 0; k < 400; k++) {          /* dashes of a line, shuffled */
        p.point[k][0] = (double)((k / 2 * 77) % 200) * 2 + (double)(k % 2);
        p.point[k][1] = 4;
    }
    CHECK_NEAR(tour_find(&p.t, way), 3 + 199, 1e-9);
    check_visits(&p, way);
}

/* Random strokes, clusters of them, and a table of dashes: within 5 % of the lower bound, which
 * itself is below the shortest way; 6 % for clusters, where it is lower still. */
static void many_strokes_come_near_the_bound(arb *a)
{
    static problem p;
    static tour_visit way[MOST];
    static double end[2 * MOST][2];
    const size_t count = 200;

    for (int kind = 0; kind < 3; kind++) {
        make_problem(&p, a, count, 0, kind == 1 ? 12 : 0);
        for (size_t i = 0; i < count && kind == 2; i++)
            for (size_t k = 0; k < 2; k++) {
                p.point[2 * i + k][0] = 3 * (double)(i * 7 % 20) + 1.5 * (double)k;
                p.point[2 * i + k][1] = 3 * (double)(i * 7 % 200 / 20);
            }
        memcpy(end, p.point, sizeof end);
        p.t.effort         = 0.3;
        const double found = tour_find(&p.t, way),
                     bound = tour_bound((const double (*)[2])end, count, p.t.from, found, 300);
        const double most  = kind == 1 ? 1.06 : 1.05;
        if (!(found <= most * bound && bound <= found + 1e-6))
            printf("kind %d: %.2f mm, bound %.2f: %.4f\n", kind, found, bound, found / bound);
        CHECK(found <= most * bound);
        CHECK(bound <= found + 1e-6);
        check_visits(&p, way);
    }
}

int main(void)
{
    PROPERTY(few_strokes_have_the_shortest_way, 200);
    PROPERTY(ways_are_whole_and_repeatable, 60);
    PROPERTY(odd_places_are_taken, 1);
    PROPERTY(many_strokes_come_near_the_bound, 2);
    return check_failures();
}
