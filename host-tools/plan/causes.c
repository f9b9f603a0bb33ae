/* host-tools/plan/causes.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "plan/causes.h"

#define WINDOW   65536      /* moments: half a minute and more around each; the same */
#define MOVES    16384      /* of moves */
#define AT_REST  1e-3       /* mm/s                                                */
#define SLOWLY   0.02       /* of the feed: as good as the speed at a corner */
#define TURN     0.03       /* radians; a smaller turn is not a corner */
#define NEAR     40         /* moments between passing a corner and the slowest one */
#define USED_UP  0.97       /* of the feed */

static causes_moment *moment_at(const causes *c, size_t i)  { return &c->moment[i - c->low]; }
static causes_move   *move_at(const causes *c, size_t k)    { return &c->move[k - c->first]; }

trace_part *causes_part(causes *c, size_t move) { return &move_at(c, move)->part; }


// Corners and stops
// -----------------

static double size_of(const double v[ENGINE_AXES])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* The direction at the end of a move, or at its begin. */
static bool move_direction(const engine_move *m, bool end, double out[ENGINE_AXES])
{
    for (int k = 1; k < 4; k++) {
        const double *from = m->p[end ? 3 - k : 0], *to = m->p[end ? 3 : k];
        for (int i = 0; i < ENGINE_AXES; i++)
            out[i] = to[i] - from[i];
        const double size = size_of(out);
        for (int i = 0; i < ENGINE_AXES; i++)
            out[i] /= size;
        if (size > ENGINE_LSB)
            return true;
    }
    return false;
}

static bool is_corner(const engine_move *before, const engine_move *after)
{
    double a[ENGINE_AXES], b[ENGINE_AXES];

    if (!move_direction(before, true, a) || !move_direction(after, false, b))
        return false;
    for (int i = 0; i < ENGINE_AXES; i++)
        a[i] -= b[i];
    return size_of(a) > TURN;
}

/* The slowest moment near i. */
static size_t slowest_moment(const causes *c, size_t i)
{
    for (int n = 0; n < NEAR; n++) {
        if (i > c->low && moment_at(c, i - 1)->speed < moment_at(c, i)->speed)
            i--;
        else if (i + 1 < c->count && moment_at(c, i + 1)->speed < moment_at(c, i)->speed)
            i++;
    }
    return i;
}

static bool is_held_back(const causes *c, size_t k, float speed)
{
    const causes_moment *m = moment_at(c, k);

    return m->speed <= 1.03 * speed + SLOWLY * move_at(c, m->move)->feed;
}

/* Mark all moments around i that are hardly faster. */
static void hold_back_moments(causes *c, size_t i)
{
    const float speed   = moment_at(c, i)->speed;
    const uint8_t cause = speed < AT_REST ? TRACE_STOP : TRACE_CORNER;

    for (size_t k = i; k < c->count && is_held_back(c, k, speed); k++)
        moment_at(c, k)->cause = cause;
    for (size_t k = i; k > c->low && is_held_back(c, k - 1, speed); k--)
        moment_at(c, k - 1)->cause = cause;
}

/* Between moment i and the one before, of those that are not yet looked at before `end`. */
static void find_corners(causes *c, size_t end)
{
    for (; c->looked < end; c->looked++) {
        const size_t i = c->looked, now = moment_at(c, i)->move,
                     before = i > c->low ? moment_at(c, i - 1)->move : now;
        bool corner = false;
        for (size_t k = before; k < now; k++)
            corner = corner || move_at(c, k + 1)->corner;
        const double feed = fmin(move_at(c, before)->feed, move_at(c, now)->feed);
        const size_t k    = corner ? slowest_moment(c, i) : i;
        if (corner && moment_at(c, k)->speed < USED_UP * feed)
            hold_back_moments(c, k);
        else if (moment_at(c, i)->speed < AT_REST && moment_at(c, i)->cause != TRACE_STOP)
            hold_back_moments(c, i);
    }
}


// Between limits
// --------------

static bool is_limit(const causes_moment *m)    { return m->cause < TRACE_CORNER; }

/* Moments from .. to - 1 are between two limits, *after and the last one: the closer is theirs. */
static void fill_gap(causes *c, size_t from, size_t to, const causes_moment *after, size_t at)
{
    for (size_t i = from; i < to; i++) {
        causes_moment *m = moment_at(c, i);
        if (m->cause != TRACE_CAUSES)
            continue;
        if (c->limit == SIZE_MAX && after == NULL)
            m->cause = TRACE_STOP;
        else if (after == NULL || (c->limit != SIZE_MAX && i - c->limit < at - i))
            m->cause = c->limit_cause;
        else
            m->cause = after->cause;
    }
}

static void fill_gaps(causes *c, size_t end)
{
    for (size_t i = c->low, next; i < end; i = next + 1) {
        next = i;
        while (next < c->count && !is_limit(moment_at(c, next)))
            next++;
        const causes_moment *after = next < c->count ? moment_at(c, next) : NULL;
        fill_gap(c, i, next < end ? next : end, after, next);
        if (next < end) {
            c->limit       = next;
            c->limit_cause = after->cause;
        }
    }
}


// The window
// ----------

/* Give moves before `end`, and forget them. */
static void give_moves(causes *c, size_t end)
{
    const size_t gone = end - c->first;

    for (size_t k = c->first; k < end; k++)
        c->done(c->context, k, &move_at(c, k)->part);
    memmove(c->move, c->move + gone, (c->moves - end) * sizeof *c->move);
    c->first = end;
}

/* Sum up moments before `end`, and forget them. */
static void settle(causes *c, size_t end)
{
    const size_t gone = end - c->low;

    fill_gaps(c, end);
    for (size_t i = c->low; i < end; i++) {
        const causes_moment *m = moment_at(c, i);
        causes_part(c, m->move)->share[m->cause] += (double)m->seconds;
    }
    memmove(c->moment, c->moment + gone, (c->count - end) * sizeof *c->moment);
    c->low = end;
    if (c->count > end)
        give_moves(c, moment_at(c, end)->move);
}

/* Half of the window leaves it; corners are found in half of the rest. */
static void advance(causes *c)
{
    const size_t rest = (c->count - c->low) / 2;

    if (rest < 2)
        return;
    find_corners(c, c->count - rest / 2);
    settle(c, c->count - rest);
}

void causes_start(causes *c, causes_done *done, void *context)
{
    *c = (causes){ .done = done, .context = context, .limit = SIZE_MAX };
}

void causes_free(causes *c)
{
    free(c->moment);
    free(c->move);
    *c = (causes){ .count = 0 };
}

void causes_add_move(causes *c, const engine_move *move, double length)
{
    if (c->count > c->low && moment_at(c, c->count - 1)->move - c->first >= MOVES)
        advance(c);
    if (c->moves - c->first == c->move_room) {
        c->move_room = c->move_room ? 2 * c->move_room : 256;
        c->move      = memory_grow(c->move, c->move_room * sizeof *c->move);
    }
    c->move[c->moves - c->first] = (causes_move){ .part = { .length = length },
                                                  .feed   = move->feed,
                                                  .corner = c->moves > 0 &&
                                                            is_corner(&c->last, move) };
    c->last = *move;
    c->moves++;
}

void causes_add(causes *c, const causes_moment *now)
{
    if (c->count - c->low == WINDOW)
        advance(c);
    if (c->count - c->low == c->room) {
        c->room   = c->room ? 2 * c->room : 4096;
        c->moment = memory_grow(c->moment, c->room * sizeof *c->moment);
    }
    c->moment[c->count - c->low] = *now;
    c->count++;
}

void causes_finish(causes *c)
{
    find_corners(c, c->count);
    settle(c, c->count);
    give_moves(c, c->moves);
}
