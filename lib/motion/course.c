/* lib/motion/course.c
 * SPDX-License-Identifier: MIT
 *
 *   survey      forward over the chain: cut every curve into arcs; a node where a curve begins, where the
 *               direction jumps, and after LOFT_COURSE_PIECES arcs. Its speed: what the jump allows.
 *   look back   from rest at the end backward: lower each node's speed to what can still be braked in time.
 *   run         forward, node by node: the pieces of one node in the table, their speeds lowered backward from
 *               the next node's and forward from the speed that was really reached; then beat by beat.
 *
 *        v^2   ______ most         \      look back: reach from the right
 *             /      \   __         \
 *            /        \_/  \    run: reach from the left, too
 *           0               0
 */
#include "motion/course.h"

static loft_acc smaller(loft_acc x, loft_acc y) { return x < y ? x : y; }


/* Survey
 * ------ */

/* Where the path was heading when it was last seen to have a direction. */
typedef struct {
    loft_vec direction;
    loft_acc extent;                /* of the curve before               */
    bool     known, smooth;         /* smooth: the curve just goes on    */
} heading;

/* The largest distance of a control point from the first: 0 for a curve that is a point. */
static loft_acc extent_of(const loft_cubic *c)
{
    loft_acc most = 0;
    for (int k = 1; k < 4; k++) {
        const loft_acc d = loft_vec_distance(c->p[0], c->p[k]);
        most = d > most ? d : most;
    }
    return most;
}

/* The square of the speed that the joint between the heading and `arc` allows; LOFT_SPEED_MAX squared if it is smooth. */
static loft_acc turn(heading *h, const loft_budget *b, const loft_arc *arc, loft_acc spacing)
{
    loft_acc most = loft_prod(LOFT_SPEED_MAX, LOFT_SPEED_MAX);
    loft_arc_shape shape;

    if (arc->dust) {
        h->smooth = false;
        return most;
    }
    loft_arc_measure(arc, &shape);
    if (h->known && !(h->smooth && !arc->speck))
        most = loft_budget_joint(b, h->direction, shape.along[0], spacing);
    h->direction = shape.along[2];
    h->known  = true;
    h->smooth = !arc->speck;
    return most;
}

static bool add_node(loft_course *c, uint32_t curve, uint32_t from, loft_acc speed2)
{
    if (c->node >= c->node_count)
        return false;
    c->nodes[c->node++] = (loft_plan_node){ speed2, curve, from };
    return true;
}

static bool survey_curve(loft_course *c, uint32_t curve, heading *h)
{
    const loft_acc extent = extent_of(&c->chain[curve].curve);
    const loft_acc feed2  = loft_prod(c->chain[curve].feed, c->chain[curve].feed);
    unsigned pieces = LOFT_COURSE_PIECES;
    uint32_t at = 0;

    if (!(extent > 0))
        return true;
    loft_arc_from(&c->whole, &c->chain[curve].curve);
    h->smooth = false;
    while (at < LOFT_ARC_WHOLE) {
        const uint32_t next = loft_arc_next(&c->arc, &c->whole, at);
        const loft_acc most = turn(h, &c->budget, &c->arc, at == 0 ? smaller(extent, h->extent) : extent);
        if (c->arc.length > 0) {
            if (pieces == LOFT_COURSE_PIECES || most < feed2) {
                if (!add_node(c, curve, at, most))
                    return false;
                pieces = 0;
            }
            pieces++;
        }
        at = next;
    }
    h->extent = extent;
    return true;
}

/* The nodes, and one more that stands for the end. */
static enum loft_status survey(loft_course *c)
{
    heading h = { .known = false };

    c->node = 0;
    for (uint32_t i = 0; i < c->count; i++)
        if (!survey_curve(c, i, &h))
            return LOFT_ERR_SPACE;
    if (!add_node(c, c->count, 0, 0))
        return LOFT_ERR_SPACE;
    c->node_count = c->node - 1;
    return LOFT_OK;
}


/* Speeds
 * ------ */

/* The pieces of a node, in order. */
static void load(loft_course *c, uint32_t node)
{
    const loft_plan_node *n = &c->nodes[node];
    const loft_move *move = &c->chain[n->curve];
    const uint32_t end = n[1].curve == n->curve ? n[1].from : LOFT_ARC_WHOLE;

    c->node   = node;
    c->pieces = 0;
    loft_arc_from(&c->whole, &move->curve);
    for (uint32_t at = n->from; at < end; ) {
        const uint32_t next = loft_arc_next(&c->arc, &c->whole, at);
        loft_piece *p = &c->table[c->pieces];
        if (c->arc.length > 0) {
            loft_piece_init(p, &c->budget, &c->arc, move->feed);
            p->first = at;
            p->last  = next;
            c->pieces++;
        }
        at = next;
    }
}

/* Lower the speeds in the table to what can be braked to c->end; gives that at its beginning. */
static loft_acc look_back(loft_course *c)
{
    loft_acc x = c->end;

    for (unsigned j = c->pieces; j-- > 0; ) {
        loft_piece *p = &c->table[j];
        p->start = x = loft_piece_reach(p, &c->budget, smaller(x, p->most[1]), true);
    }
    return x;
}

/* Lower them to what can be reached from the square `x`; sets c->end. */
static void look_ahead(loft_course *c, loft_acc x)
{
    for (unsigned j = 0; j < c->pieces; j++) {
        loft_piece *p = &c->table[j];
        p->start = smaller(p->start, x);
        x = loft_piece_reach(p, &c->budget, p->start, false);
    }
    c->end = smaller(c->end, x);
}

static void set_speeds(loft_course *c)
{
    c->nodes[0].speed2 = 0;
    for (uint32_t k = c->node_count; k-- > 0; ) {
        load(c, k);
        c->end = c->nodes[k + 1].speed2;
        c->nodes[k].speed2 = smaller(c->nodes[k].speed2, look_back(c));
    }
}


/* Running
 * ------- */

static void begin_piece(loft_course *c)
{
    const loft_piece *p = &c->table[c->piece];
    const loft_acc end  = c->piece + 1u < c->pieces ? p[1].start : c->end;

    loft_arc_cut(&c->arc, &c->whole, p->first, p->last);
    c->phases = (uint8_t)loft_piece_phases(p, &c->budget, end, c->phase);
    c->now    = 0;
    c->passed = c->done = 0;
}

static void begin_node(loft_course *c, uint32_t node, loft_acc speed2)
{
    load(c, node);
    c->end = c->nodes[node + 1].speed2;
    look_back(c);
    look_ahead(c, speed2);
    c->piece = 0;
    begin_piece(c);
}

/* The next phase; false at the end of the chain. */
static bool begin_phase(loft_course *c)
{
    c->passed += c->phase[c->now].length;
    c->done = 0;
    if (++c->now < c->phases)
        return true;
    if (++c->piece < c->pieces) {
        begin_piece(c);
        return true;
    }
    if (c->node + 1 >= c->node_count)
        return false;
    begin_node(c, c->node + 1, c->end);
    return true;
}

/* Go on for one beat. Within a phase the length passed in the part t of a beat is v t + a t^2 / 2; a rest of the
 * phase that is passed takes 2 rest / (v0 + v1). v and the speed at the end follow from the lengths
 * (loft_phase_speed), so that errors of time do not add up to errors of place. */
static void run_beat(loft_course *c)
{
    loft_unit left = LOFT_UNIT(1);

    while (left > 0 && !c->over) {
        const loft_phase *p = &c->phase[c->now];
        const loft_acc v    = loft_budget_beat(&c->budget, loft_phase_speed(p, c->done));
        const loft_acc both = v + loft_budget_beat(&c->budget, loft_acc_sqrt(p->to));
        const loft_acc rest = p->length - c->done;

        if (both > 0 && 2 * rest > loft_acc_scale(both, left)) {
            const loft_acc gain = loft_acc_ratio(loft_budget_beat(&c->budget, p->accel) * c->budget.beat, c->budget.tick_hz);
            const loft_acc step = loft_acc_scale(v + loft_acc_scale(gain, left) / 2, left);
            c->done += step < 0 ? 0 : smaller(step, rest);
            return;
        }
        if (both > 0) {
            const loft_unit taken = loft_unit_ratio(2 * rest, both);
            left = taken < left ? left - taken : 0;
        }
        c->over = !begin_phase(c);
    }
}

static enum loft_status check_chain(const loft_move chain[], uint32_t count)
{
    if (count == 0)
        return LOFT_ERR_ARG;
    for (uint32_t i = 0; i < count; i++) {
        if (!(chain[i].feed > 0))
            return LOFT_ERR_ARG;
        if (chain[i].feed < LOFT_SPEED_MIN || chain[i].feed > LOFT_SPEED_MAX)
            return LOFT_ERR_RANGE;
        for (int k = 0; k < 4; k++)
            if (!loft_vec_within(chain[i].curve.p[k], LOFT_PLAN_REACH))
                return LOFT_ERR_RANGE;
        if (i > 0 && !loft_vec_equal(chain[i].curve.p[0], chain[i - 1].curve.p[3]))
            return LOFT_ERR_ARG;
    }
    return LOFT_OK;
}

enum loft_status loft_course_init(loft_course *c, const loft_budget *budget, const loft_move chain[], uint32_t count,
                                  loft_plan_node nodes[], uint32_t node_count)
{
    enum loft_status status = check_chain(chain, count);

    c->budget     = *budget;
    c->chain      = chain;
    c->count      = count;
    c->nodes      = nodes;
    c->node_count = node_count;
    c->over       = true;
    if (status == LOFT_OK)
        status = survey(c);
    if (status != LOFT_OK || c->node_count == 0)
        return status;

    set_speeds(c);
    begin_node(c, 0, 0);
    c->over = false;
    return LOFT_OK;
}

bool loft_course_next(loft_course *c, loft_acc out[LOFT_AXES])
{
    run_beat(c);
    if (!c->over)
        loft_arc_eval(&c->arc, smaller(c->passed + c->done, c->arc.length), out);
    for (int i = 0; i < LOFT_AXES && c->over; i++)
        out[i] = loft_wide(c->chain[c->count - 1].curve.p[3].axis[i]);
    return !c->over;
}
