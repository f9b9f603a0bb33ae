/* host-tools/plan/levels.c
 * SPDX-License-Identifier: MIT
 *
 * The way along the line grows with time, for the line is planned from rest to rest. So the tick in
 * which a place is passed is found by halving.
 */
#include <math.h>
#include <string.h>

#include "plan/levels.h"

double levels_of(const drawing_event *e, double s_max)
{
    return e->way == 0 ? 0 : isnan(e->amount) ? 1 : fmin(e->amount / s_max, 1);
}

/* The cubic of the axis `i` at u, v, w: its blossom. */
static double blossom(const engine_span *s, int i, double u, double v, double w)
{
    double q[3];

    for (int k = 0; k < 3; k++)
        q[k] = s->p[k][i] + u * ((double)s->p[k + 1][i] - s->p[k][i]);
    for (int k = 0; k < 2; k++)
        q[k] += v * (q[k + 1] - q[k]);
    return q[0] + w * (q[1] - q[0]);
}

/* How far along the line the tool is after so many ticks of the span, mm. */
static double along_at(const levels *l, unsigned tick)
{
    const double u = (double)tick / l->span->ticks, (*p)[ENGINE_AXES] = l->line->p;
    double motors[ENGINE_AXES], tool[ENGINE_AXES], sum = 0, square = 0;

    for (int i = 0; i < ENGINE_AXES; i++)
        motors[i] = blossom(l->span, i, u, u, u) * ENGINE_LSB;
    if (!kinematics_tool(l->k, motors, tool))
        memcpy(tool, motors, sizeof tool);
    for (int i = 0; i < ENGINE_AXES; i++) {
        sum += (tool[i] - p[0][i]) * (p[3][i] - p[0][i]);
        square += (p[3][i] - p[0][i]) * (p[3][i] - p[0][i]);
    }
    return sum / sqrt(square);
}

void levels_begin(levels *l, const engine_span *span)
{
    l->span = span;
    l->at = l->looked = 0;
    l->due = NAN;
}

/* The tick from `from` on in which the next change is; the ticks of the span: in none. */
static unsigned change_after(const levels *l, unsigned from)
{
    unsigned low = from, high = l->span->ticks;     /* along(low) < place <= along(high + 1) */

    if (l->left == 0 || along_at(l, high) < l->event->e.along)
        return high;
    for (high--; low < high;) {
        const unsigned middle = low + (high - low) / 2;
        if (along_at(l, middle + 1) < l->event->e.along)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* The level of a tick, the mean over its way; takes the changes in it. */
static double level_in(levels *l, unsigned tick)
{
    const double from = along_at(l, tick), to = along_at(l, tick + 1);
    double sum = 0, at = from;

    while (l->left > 0 && l->event->e.along <= to) {
        const double place = fmax(l->event->e.along, at);
        sum += (place - at) * l->is;
        at = place;
        l->is = levels_of(&l->event->e, l->s_max);
        l->event++;
        l->left--;
    }
    return to > from && at > from ? (sum + (to - at) * l->is) / (to - from) : l->is;
}

/* Find the next tick that has another level. */
static void look(levels *l)
{
    while (isnan(l->due) && l->looked < l->span->ticks) {
        if (!levels_wait(l))
            l->looked = change_after(l, l->looked);
        if (l->looked == l->span->ticks)
            return;
        const double level = level_in(l, l->looked);
        if (level < l->given || level > l->given)
            l->due = level;
        else
            l->looked++;
    }
}

bool levels_next(levels *l, levels_piece *out)
{
    look(l);
    if (l->at == l->span->ticks)
        return false;
    *out = (levels_piece){ l->at, l->looked, NAN };
    if (l->at == l->looked) {
        out->to    = ++l->looked;
        out->level = l->given = l->due;
        l->due                = NAN;
    }
    l->at = out->to;
    return true;
}

void levels_cut(const engine_span *span, const levels_piece *piece, int32_t p[3][ENGINE_AXES])
{
    const double a = (double)piece->from / span->ticks, b = (double)piece->to / span->ticks;

    for (int i = 0; i < ENGINE_AXES; i++) {
        p[0][i] = (int32_t)lround(blossom(span, i, a, a, b));
        p[1][i] = (int32_t)lround(blossom(span, i, a, b, b));
        p[2][i] = (int32_t)lround(blossom(span, i, b, b, b));
    }
}
