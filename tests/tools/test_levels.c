/* tests/tools/test_levels.c -- a span is cut where the level changes: all of its ticks, the places
 * of the span, the level where the motion passes
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "check.h"
#include "tools/drawn.h"
#include "plan/levels.h"

#define EVENTS 200
#define SPANS  6
#define LSB    (1 / 65536.0)
#define S_MAX  1000.0

static double random_unit(arb *a)      { return (double)(arb_next(a) >> 11) / 9007199254740992.0; }

/* A line of the tool, and spans along it whose speed never turns, for motors of any kind. */
typedef struct {
    kinematics k;
    engine_move line;
    double length;
    engine_span span[SPANS];
    double from[SPANS + 1];         /* mm along it */
    toolpath_event event[EVENTS];
    size_t events;
    double first;                   /* the level before them */
} row;

/* The motors at a place of the line; they are linear in it. */
static void motors_at(const row *r, double along, int32_t out[ENGINE_AXES])
{
    double tool[ENGINE_AXES], near[ENGINE_AXES] = { 0 }, at[ENGINE_AXES];

    for (int i = 0; i < ENGINE_AXES; i++)
        tool[i] = r->line.p[0][i] + along / r->length * (r->line.p[3][i] - r->line.p[0][i]);
    kinematics_motors(&r->k, tool, near, at);
    for (int i = 0; i < ENGINE_AXES; i++)
        out[i] = (int32_t)lround(at[i] / LSB);
}

static void arb_row(row *r, arb *a, double pixel)
{
    double square = 0, along = 0, at = 0;

    memset(r, 0, sizeof *r);
    r->k      = kinematics_usual();
    r->k.kind = arb_below(a, 2) ? &kinematics_corexy_f64 : &kinematics_cartesian;
    kinematics_ready(&r->k);
    for (int i = 0; i < ENGINE_AXES; i++) {
        r->line.p[0][i] = 100 * (random_unit(a) - 0.5);
        r->line.p[3][i] = 100 * (random_unit(a) - 0.5);
        square += pow(r->line.p[3][i] - r->line.p[0][i], 2);
    }
    r->length = sqrt(square);
    for (int n = 0; n < SPANS; n++) {
        double p[4] = { along };
        const double by = r->length / SPANS;
        p[3] = n + 1 == SPANS ? r->length : along + by;
        p[1] = p[0] + by * 0.6 * random_unit(a);
        p[2] = p[3] - (p[3] - p[1]) * random_unit(a);
        for (int k = 0; k < 4; k++)
            motors_at(r, p[k], r->span[n].p[k]);
        r->span[n].ticks = (uint16_t)(1 + arb_below(a, arb_below(a, 3) ? 200 : 3));
        r->from[n]       = along;
        along            = p[3];
    }
    r->from[SPANS] = r->length;
    r->first       = random_unit(a);
    while (r->events < EVENTS) {
        at += pixel * (0.5 + random_unit(a));
        if (at > r->length - 0.001)
            break;
        r->event[r->events++] = (toolpath_event){
            .e = { .doing = DRAWING_SPINS,
                   .way = 4,
                   .along = at,
                   .amount = arb_below(a, 5) ? floor(S_MAX * random_unit(a)) : 0 }
        };
    }
}

static double span_at(const engine_span *s, int i, double t)
{
    const double u = 1 - t;

    return u * u * u * s->p[0][i] + 3 * u * u * t * s->p[1][i] + 3 * u * t * t * s->p[2][i] +
           t * t * t * s->p[3][i];
}

static double along_of(const row *r, const double motors[ENGINE_AXES])
{
    double tool[ENGINE_AXES], at[ENGINE_AXES], sum = 0;

    for (int i = 0; i < ENGINE_AXES; i++)
        at[i] = motors[i] * LSB;
    CHECK(kinematics_tool(&r->k, at, tool));
    for (int i = 0; i < ENGINE_AXES; i++)
        sum += (tool[i] - r->line.p[0][i]) * (r->line.p[3][i] - r->line.p[0][i]) / r->length;
    return sum;
}

/* The sum of the levels up to a place, in mm of full power. */
static double asked_to(const row *r, double place)
{
    double sum = 0, from = 0, level = r->first;

    for (size_t n = 0; n < r->events && r->event[n].e.along < place; n++) {
        sum += (r->event[n].e.along - from) * level;
        from  = r->event[n].e.along;
        level = levels_of(&r->event[n].e, S_MAX);
    }
    return sum + (place - from) * level;
}

static levels begin(const row *r)
{
    return (levels){ .k = &r->k,
                     .line = &r->line,
                     .s_max = S_MAX,
                     .event = r->event,
                     .left = r->events,
                     .is = r->first,
                     .given = r->first };
}

/* Pieces are all ticks, each once; their ends are the places of the span; an action is a tick. */
static void pieces_are_the_span(arb *a)
{
    row r;

    arb_row(&r, a, 0.01 + 2 * random_unit(a));
    levels l = begin(&r);
    for (int n = 0; n < SPANS; n++) {
        levels_piece piece;
        unsigned at = 0;
        levels_begin(&l, &r.span[n]);
        while (levels_next(&l, &piece)) {
            int32_t p[3][ENGINE_AXES];
            CHECK(piece.from == at && piece.to > at && piece.to <= r.span[n].ticks);
            CHECK(isnan(piece.level) || piece.to == at + 1);
            CHECK(isnan(piece.level) || (piece.level >= 0 && piece.level <= 1));
            levels_cut(&r.span[n], &piece, p);
            for (int i = 0; i < ENGINE_AXES; i++) {
                CHECK_NEAR(p[2][i], span_at(&r.span[n], i, (double)piece.to / r.span[n].ticks),
                           0.51);
                CHECK(piece.to < r.span[n].ticks || p[2][i] == r.span[n].p[3][i]);
                if (piece.from == 0 && piece.to == r.span[n].ticks)
                    CHECK(p[0][i] == r.span[n].p[1][i] && p[1][i] == r.span[n].p[2][i]);
            }
            at = piece.to;
        }
        CHECK(at == r.span[n].ticks);
    }
}

/* The energy up to the end of any tick is what is asked up to there. */
static void energy_follows_the_place(arb *a)
{
    row r;

    arb_row(&r, a, 0.001 + 2 * random_unit(a));
    levels l = begin(&r);
    double sum = 0, level = r.first, along = 0;
    for (int n = 0; n < SPANS; n++) {
        levels_piece piece;
        levels_begin(&l, &r.span[n]);
        while (levels_next(&l, &piece)) {
            level = isnan(piece.level) ? level : piece.level;
            for (unsigned tick = piece.from; tick < piece.to; tick++) {
                double at[ENGINE_AXES];
                for (int i = 0; i < ENGINE_AXES; i++)
                    at[i] = span_at(&r.span[n], i, (tick + 1.0) / r.span[n].ticks);
                const double to = along_of(&r, at);
                sum += (to - along) * level;
                CHECK_NEAR(sum, asked_to(&r, to), 2 * LSB * (double)(r.events + 1));
                along = to;
            }
        }
    }
    CHECK(l.left == 0);
}

/* The output is set as often as it must: never twice to the same, at most twice for a change. */
static void actions_are_few(arb *a)
{
    row r;

    arb_row(&r, a, 0.01 + 2 * random_unit(a));
    levels l     = begin(&r);
    double level = r.first;
    size_t count = 0;
    for (int n = 0; n < SPANS; n++) {
        levels_piece piece;
        levels_begin(&l, &r.span[n]);
        while (levels_next(&l, &piece)) {
            if (isnan(piece.level))
                continue;
            CHECK(piece.level < level || piece.level > level);
            level = piece.level;
            count++;
        }
    }
    CHECK(count <= 2 * r.events);
}

int main(void)
{
    PROPERTY(pieces_are_the_span, 200);
    PROPERTY(energy_follows_the_place, 200);
    PROPERTY(actions_are_few, 200);
    return check_failures();
}
