/* lib/motion/scope.c
 * SPDX-License-Identifier: MIT
 *
 * On a path with direction u and curvature vector k, passed with acceleration a and the square x of
 * the speed, an axis has the acceleration
 *
 *     u a + k x
 *
 * On a piece of length l that begins with x it is u0 a + k0 x at the start and u1 a + k1 (x + 2 a
 * l) = (u1 + 2 l k1) a + k1 x at the end: with w = u0 or u1 + 2 l k1 each axis and end gives two
 * lines in the plane of x and a,
 *
 *     -A <= w a + k x <= A        |w a| <= A (1 -+ k x / A)
 *
 * As u' = k and x' = 2 a, and k is nearly a line, the second derivative of u a + k x along the
 * piece is 5 a (k1 - k0) / l: between the ends it may go beyond both of them by q |a|, q = 5/8 l
 * |k1 - k0|, on one side. On that side w a + k x + q |a| is within A. Where w and k1 - k0 have
 * opposite signs |w| becomes |w| + q, but stays |w| where the bend has to be relieved by w a. Where
 * they have the same sign it stays |w|, or becomes |w| - q where the bend is relieved; if q > |w|
 * there is a line with q - |w| and the other sign of k. Likewise k becomes k +- r on the side to
 * which the curvature goes beyond the line between its ends, by up to r. So the largest a is the
 * least of some falling and rising lines in x, a concave function, and so is -a of the least one.
 * Both are positive at x = 0. Where they meet is the largest x that any acceleration allows: more
 * than where a = 0 is possible, if the piece has to be passed while it speeds up or slows down.
 * Chords between x = 0, a knee and the far end lie inside of the polygon. The knee is where the
 * line that is the least at x = 0 meets that at the far end: a corner of the polygon, unless a
 * third line cuts it off.
 *
 * The far end is as far beyond the cap of the speed as a line can be that passes the cap within the
 * piece.
 *
 * The caps at the ends are such that a line between their squares holds the speeds of the axes,
 * too: |u| v <= V, where a line that is lower in the middle lowers both. Where feed or another axis
 * hold the cap at one station, it is no parabola through three stations, but u is: with
 *
 *     c = 2 |u1| - |u0| - |u2| > 0
 *
 * it is up to c / 8 above its own chords between neighbouring stations. So v <= V / (|u| + c / 8)
 * at the three of them keeps |u| v within V (1 + d^2 / 4) between two whose caps differ by the part
 * d, at most 1/32. What is no parabola of u has, for arcs that turn and change their rate by 1/4,
 * two parts. One goes with c: at most c / 20 (an axis is fastest within the piece where the change
 * of its direction cancels, so that is less than c as well), for which c / 16 is left. The other is
 * the cubic of a turn by 1/8 to both sides at a rate that changes by 1/8 to both sides, (1/8)^3 of
 * u, 0.385 of which are between the stations, 1/1300; with d^2 / 4 that is 1/1000, which is left,
 * too.
 *
 * q16: y = x / far <= 1 and |k| far / A <= 32, so that all lines are below 33 * 2^14.
 */
#include "motion/scope.h"

/* where the speed may change, A / 40 is the most that the curvature's bow may ask for at the cap */
#define BENT    40
#define BOW     128     /* A / 128 it may, as that much is kept for joints */
/* the square of the cap is a line along the piece, to 1/64 of itself */
#define STEEP   LOFT_UNIT(0.015625)
#define TURN    LOFT_REAL(0.03)
#define EDGE    4     /* of 256: the knee is no nearer to the ends */
#define LINES   (4 * LOFT_AXES + 1)
#define RELIEF  32    /* times the acceleration may be needed by a bend that can be relieved */
#define PART    LOFT_UNIT(0.00006103515625)     /* 2^-14 of the far end, for a real to hold it */
#define FASTEST (loft_prod(LOFT_SPEED_MAX, LOFT_SPEED_MAX) / 16)

/* At the part y of the far end a <= most (1 - turn y) and -a <= most (1 + turn y), with turn[1] and
 * turn[0]. The first line is the largest acceleration there is. */
typedef struct {
    loft_acc  length, far;
    loft_unit middle, end;      /* where the middle station is, of the length; the largest y where
                                 * there is an acceleration, */
    loft_acc  least[2];         /* the least lines there: -a, a */
    uint8_t   line[2];
    uint8_t   count, low;       /* how many there are; the least where y = 0 */
    loft_real skew[LOFT_AXES], bow[LOFT_AXES];  /* q with the sign of k1 - k0; r with its side,
                                                 * where it matters */
    loft_real most[LINES], turn[2][LINES];
    loft_real relief[LINES];    /* what |w| is where the bend has to be relieved, if not the same;
                                 * 0 */
    uint8_t   axis[LINES];
} scope;

static loft_acc  twice(loft_acc way, loft_real a) { return 2 * loft_acc_mul(way, a); }
static loft_acc  square(loft_real v)              { return loft_prod(v, v); }
static loft_acc  length_of(const loft_plan_piece *p) { return loft_unit_to_acc(p->length); }

/* Where the bend needs `times` the acceleration; beyond 2^29 it does not matter. */
static loft_acc needed(loft_real accel, loft_real bend, int times)
{
    const loft_acc x = loft_acc_div(loft_to_acc(accel), bend);
    return x < FASTEST ? x * times : RELIEF * FASTEST;
}

/* The curvature that counts for an axis. */
static loft_real bend_of(const loft_budget *b, const loft_arc_shape *s, int k, int i)
{
    return s->tight || b->across > 0 ? 0 : s->bend[k].axis[i];
}

/* Which part of the length ends at the middle station: half of the parameters. Rates are nearly a
 * line. */
static loft_unit middle_of(const loft_arc *arc)
{
    return LOFT_UNIT(0.5) - (arc->ends[0] + arc->ends[1]) / 8;
}

/* |w a| <= A (1 -+ turn x / A), or `turn` and `bow`; that is the curvature as yet. */
static void add_line(scope *s, const loft_budget *b, int axis, loft_real w, loft_real relief,
                     loft_real turn, loft_real bow)
{
    const uint8_t at = s->count++;

    s->most[at]    = loft_real_cap(LOFT_ACCEL_MAX, b->accel[axis], w);
    s->turn[0][at] = bow < 0 ? turn + bow : turn;
    s->turn[1][at] = bow > 0 ? turn + bow : turn;
    s->relief[at]  = relief;
    s->axis[at]    = (uint8_t)axis;
    s->low = s->most[at] < s->most[s->low] ? at : s->low;
}

/* What a has to be multiplied with where it is a at the start. */
static loft_real weight_of(const scope *s, const loft_arc_shape *shape, int k, int i,
                           loft_real bend)
{
    return shape->along[k].axis[i] + (k == 2 ? loft_acc_round(twice(s->length, bend)) : 0);
}

/* The lines of one end. What does not move there has none. */
static void add_lines(scope *s, const loft_budget *b, const loft_arc_shape *shape, int end)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_real k = bend_of(b, shape, end, i), w = weight_of(s, shape, end, i, k),
                        size = loft_real_abs(w);
        const loft_real with = w < 0 ? -s->skew[i] : s->skew[i], turn = w < 0 ? -k : k,
                        bow = w < 0 ? -s->bow[i] : s->bow[i];

        if (!(size > 0 || loft_real_abs(k) > 0 || loft_real_abs(with) > 0))
            continue;
        add_line(s, b, i, with < 0 ? size - with : size,
                 with < 0      ? size
                 : with < size ? size - with
                               : 0,
                 turn, bow);
        if (with > size)
            add_line(s, b, i, with - size, 0, -turn, -bow);
    }
}

/* The far end is no further than where a bend needs all of the acceleration, or RELIEF times as
 * much where it can be relieved. */
static void set_far(scope *s, const loft_budget *b, const loft_arc_shape *shape)
{
    const loft_real far = loft_acc_round(loft_acc_scale(s->far, PART)) + LOFT_REAL_LSB;

    for (int n = 0; n < 3 * LOFT_AXES; n++) {
        const int i = n / 3, at = n % 3;
        const loft_real k = bend_of(b, shape, at, i), size = loft_real_abs(k), accel = b->accel[i];
        if (loft_prod(far, size) > loft_acc_scale(loft_to_acc(accel), PART)) {
            const loft_real w = loft_real_abs(weight_of(s, shape, at, i, k));
            s->far = loft_acc_min(
                s->far, needed(accel, size,
                               loft_prod(LOFT_ACCEL_MAX, w) > loft_to_acc(accel) ? RELIEF : 1));
        }
    }
}

/* What line j becomes where the bend has to be relieved. */
static void add_relief(scope *s, const loft_budget *b, uint8_t j)
{
    s->turn[0][s->count] = s->turn[0][j];
    s->turn[1][s->count] = s->turn[1][j];
    s->most[s->count++]  = loft_real_cap(LOFT_ACCEL_MAX, b->accel[s->axis[j]], s->relief[j]);
}

/* Of curvatures those parts of the acceleration that they need at the far end. */
static void set_turns(scope *s, const loft_budget *b)
{
    const uint8_t count = s->count;

    for (uint8_t j = 1; j < count; j++) {
        const bool same = !(s->turn[0][j] < s->turn[1][j]);
        for (int fore = same ? 1 : 0; fore < 2; fore++)
            s->turn[fore][j] = loft_acc_quot(loft_acc_mul(s->far, s->turn[fore][j]),
                                             loft_to_acc(b->accel[s->axis[j]]));
        s->turn[0][j] = same ? s->turn[1][j] : s->turn[0][j];
        if (s->relief[j] > 0 && (s->turn[1][j] > LOFT_REAL(1) || s->turn[0][j] < LOFT_REAL(-1)))
            add_relief(s, b, j);
    }
}

/* The least of the lines at y, and which it is. */
static loft_acc least_at(const scope *s, loft_unit y, bool fore, uint8_t *which)
{
    loft_acc least = loft_to_acc(LOFT_ACCEL_MAX);

    *which = 0;
    for (uint8_t j = 1; j < s->count; j++) {
        const loft_real turn = loft_acc_round(loft_acc_scale(loft_to_acc(s->turn[fore][j]), y));
        const loft_acc  a = loft_prod(s->most[j], LOFT_REAL(1) + (fore ? -turn : turn));
        if (a < least) {
            least  = a;
            *which = j;
        }
    }
    return least;
}

static loft_acc slope(const scope *s, uint8_t i, bool fore)
{
    return loft_prod(s->most[i], s->turn[fore][i]);
}

/* The largest y <= 1 where there is an acceleration: Newton's way from the right, on a concave
 * function. */
static void set_end(scope *s)
{
    s->end = LOFT_UNIT(1);
    for (int n = 0; ; n++) {
        for (int fore = 0; fore < 2; fore++)
            s->least[fore] = least_at(s, s->end, fore, &s->line[fore]);
        if (s->least[0] + s->least[1] >= 0 || n == 12)
            return;
        const loft_acc fall = slope(s, s->line[1], true) - slope(s, s->line[0], false);
        const loft_acc both = loft_to_acc(s->most[s->line[0]]) + loft_to_acc(s->most[s->line[1]]);
        s->end = both < fall ? loft_unit_ratio(both, fall) : s->end;
        s->end -= s->end / 4096;
    }
}

static loft_acc knee_of(loft_acc far, uint8_t knee)
{
    return loft_acc_scale(far, LOFT_UNIT(0.00390625) * (loft_unit)knee);
}

/* The knee, in 256ths of the way to the end, and the bounds there and at the end. */
static uint8_t set_knee(const scope *s, bool fore, loft_real bound[2])
{
    const uint8_t i = s->low, j = s->line[fore];
    const loft_acc rise = loft_to_acc(s->most[j] - s->most[i]),
                   more = loft_acc_scale(slope(s, j, fore) - slope(s, i, fore), s->end),
                   fall = fore ? more : -more;
    uint8_t which;
    int knee = 128;

    if (i != j && fall > 0)
        knee = rise < fall ? (int)loft_acc_int(loft_unit_to_acc(loft_unit_ratio(rise, fall)) * 256)
                           : 256;
    knee = knee < EDGE ? EDGE : knee > 256 - EDGE ? 256 - EDGE : knee;
    bound[0] = loft_acc_round(least_at(
        s, loft_unit_round(knee_of(loft_unit_to_acc(s->end), (uint8_t)knee)), fore, &which));
    bound[1] = loft_acc_round(s->least[fore]);
    return (uint8_t)knee;
}

/* The size of a direction or curvature at station k, with what it may rise by between the
 * stations. */
static loft_real crest(const loft_vec at[3], int k, int i)
{
    const loft_real arch = 2 * loft_real_abs(at[1].axis[i]) - loft_real_abs(at[0].axis[i]) -
                           loft_real_abs(at[2].axis[i]),
                    size = loft_real_abs(at[k].axis[i]);
    return size + size / 1024 + (arch > 0 ? 3 * (arch / 16) : 0);
}

/* The most at station k. */
static loft_real speed_cap(const loft_budget *b, const loft_arc_shape *s, int k, loft_real feed)
{
    loft_acc bend[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        if (b->max_speed[i] < feed)         /* otherwise no direction is too fast */
            feed = loft_real_cap(feed, b->max_speed[i], crest(s->along, k, i));
    if (s->tight || !(b->across > 0))
        return feed;
    for (int i = 0; i < LOFT_AXES; i++)
        bend[i] = loft_to_acc(crest(s->bend, k, i));
    const loft_real size = loft_acc_round(loft_acc_hypot(bend, LOFT_AXES));
    const loft_acc  most = size > 0 ? loft_acc_div(loft_to_acc(b->across), size) : square(feed);
    return most < square(feed) ? loft_acc_sqrt(most) : feed;
}

/* Not nothing, which would be a stop. */
static loft_unit part_of(loft_acc x, loft_acc whole)
{
    const loft_unit part = loft_unit_ratio(x, whole), least = LOFT_UNIT(0.00390625);
    return part < least ? least : part;
}

/* The caps at both ends, such that the line between their squares is not above that in the middle,
 * `at` of the length. */
static bool set_caps(loft_plan_piece *p, const loft_budget *b, const loft_arc_shape *shape,
                     loft_unit at, loft_real feed)
{
    p->cap  = speed_cap(b, shape, 0, feed);
    p->last = speed_cap(b, shape, 2, feed);
    const loft_acc first = square(p->cap), last = square(p->last),
                   middle = loft_acc_lerp(first, last, at);
    const loft_acc most = square(speed_cap(b, shape, 1, feed)),
                   change = first < last ? last - first : first - last;

    if (most < middle) {
        const loft_unit part = part_of(most, middle);
        p->cap  = loft_acc_sqrt(loft_acc_scale(first, part));
        p->last = loft_acc_sqrt(loft_acc_scale(last, part));
        if (part < LOFT_UNIT(1) - STEEP)
            return false;
    }
    return change <= most / 8;
}

/* The bounds of a piece
 * --------------------- */

static loft_real chord_at(const loft_plan_piece *p, loft_acc x, bool fore)
{
    const loft_acc   far = square(p->far), knee = knee_of(far, fore ? p->fore_knee : p->back_knee);
    const loft_real *at  = fore ? p->fore : p->back;

    if (!(x < far))
        return at[1];
    if (x < knee)
        return loft_lerp(p->rest, at[0], loft_unit_ratio(x, knee));
    return loft_lerp(at[0], at[1], loft_unit_ratio(x - knee, far - knee));
}

loft_real loft_scope_most(const loft_plan_piece *p, loft_acc x)  { return chord_at(p, x, true); }

/* With the bound g(x) of -a, a concave function, the line x - 2 l g(x) = end: the left side falls
 * first, from 0 or less, and rises then. At the far end the bend may have to be relieved by braking
 * below `end`; then a line from the cap leads there. */
loft_acc loft_scope_brake(const loft_plan_piece *p, loft_acc end)
{
    const loft_acc l = length_of(p), far = square(p->far), knee = knee_of(far, p->back_knee);
    const loft_acc at_far = far - twice(l, p->back[1]), at_knee = knee - twice(l, p->back[0]),
                   at_0 = -twice(l, p->rest);

    if (end >= at_far)
        return end > far + twice(l, p->fore[1]) ? square(p->cap) : far;
    if (end >= at_knee)
        return loft_acc_lerp(knee, far, loft_unit_ratio(end - at_knee, at_far - at_knee));
    return loft_acc_scale(knee, loft_unit_ratio(end - at_0, at_knee - at_0));
}


/* Pieces and joints
 * ----------------- */

/* How far the curvature, at most 2^14, goes beyond the line between its ends. */
static loft_real bow_of(const loft_budget *b, const loft_arc_shape *s, loft_unit middle, int i)
{
    return bend_of(b, s, 1, i) - loft_lerp(bend_of(b, s, 0, i), bend_of(b, s, 2, i), middle);
}

static void set_sides(scope *s, const loft_plan_piece *p, const loft_budget *b,
                      const loft_arc_shape *shape)
{
    const loft_acc x = square(p->cap > p->last ? p->cap : p->last);

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_real bow = bow_of(b, shape, s->middle, i),
                        turn = loft_acc_round(loft_acc_mul(s->length, bend_of(b, shape, 2, i) -
                                                                          bend_of(b, shape, 0, i)));
        s->skew[i] = turn / 2 + turn / 8;
        s->bow[i]  = loft_acc_mul(x, loft_real_abs(bow)) > loft_to_acc(b->accel[i] / BOW) ? bow : 0;
    }
}

/* Does the curvature's change ask for little between the ends, and the direction not turn much
 * where speed has to change? */
static bool even(const loft_plan_piece *p, const loft_budget *b, const loft_arc_shape *s,
                 loft_unit middle)
{
    const loft_acc x = square(p->cap);

    if (!p->flows && twice(length_of(p), p->rest) > x)
        return false;
    for (int i = 0; i < LOFT_AXES; i++) {
        if (loft_acc_mul(x, loft_real_abs(bow_of(b, s, middle, i))) >
                loft_to_acc(b->accel[i] / BENT) &&
            128 * loft_acc_mul(length_of(p), b->accel[i]) > x)
            return false;
        if (!p->flows && loft_real_abs(s->along[2].axis[i] - s->along[0].axis[i]) > TURN)
            return false;
    }
    return true;
}

/* Chords in the polygon, from which the far end may come nearer. */
static void set_bounds(loft_plan_piece *p, const loft_budget *b, const loft_arc_shape *shape,
                       loft_unit middle)
{
    scope s;

    s.most[0] = LOFT_ACCEL_MAX;
    s.turn[0][0] = s.turn[1][0] = 0;
    s.count  = 1;
    s.low    = 0;
    s.length = length_of(p);
    s.middle = middle;
    set_sides(&s, p, b, shape);
    add_lines(&s, b, shape, 0);
    add_lines(&s, b, shape, 2);
    p->rest = s.most[s.low];
    s.far   = square(p->cap) + twice(s.length, p->rest);
    set_far(&s, b, shape);
    set_turns(&s, b);
    set_end(&s);
    p->fore_knee = set_knee(&s, true, p->fore);
    p->back_knee = set_knee(&s, false, p->back);
    p->far = loft_acc_sqrt(loft_acc_scale(s.far, s.end));
    p->cap = p->cap < p->far ? p->cap : p->far;
}

/* A piece that is bent more than its shape can say: half of the acceleration is for its turn. It is
 * shorter than 2^-16 mm. */
static void set_tight_caps(loft_plan_piece *p, const loft_budget *b, const loft_arc_shape *s)
{
    loft_acc x = loft_acc_min(square(p->cap), square(p->last));

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_real turn = loft_real_abs(s->along[2].axis[i] - s->along[0].axis[i]);
        const loft_acc  half = loft_acc_mul(length_of(p), b->accel[i]) / 2;
        x = turn > 0 ? loft_acc_min(x, loft_acc_div(half, turn)) : x;
    }
    p->cap  = loft_acc_sqrt(x);
    p->last = p->cap;
}

static void begin(loft_plan_piece *p)
{
    p->stop = p->sure = false;
    p->brake = 0;
}

bool loft_scope_init(loft_plan_piece *p, const loft_budget *b, const loft_arc *arc,
                     const loft_arc_shape *s, loft_real feed)
{
    const loft_unit middle = middle_of(arc);

    begin(p);
    p->length = loft_unit_round(arc->length);
    const bool steady = set_caps(p, b, s, middle, feed);
    if (s->tight)
        set_tight_caps(p, b, s);
    set_bounds(p, b, s, middle);

    const loft_acc x = square(p->cap), more = square(p->last) - x;
    p->flows = more <= twice(length_of(p), loft_scope_most(p, x)) &&
               -more <= twice(length_of(p), chord_at(p, x, false));
    return steady && even(p, b, s, middle);
}

/* The spline of the samples spreads a change of acceleration, by a, over beats: the speed at its
 * place is off by 0.23 a h. Where the feed changes there is one at both sides of the slower
 * feed. */
static loft_real feed_cap(const loft_budget *b, const loft_vec *along, loft_real feed0,
                          loft_real feed1)
{
    const loft_real slow = feed0 < feed1 ? feed0 : feed1;
    loft_real a = LOFT_ACCEL_MAX;

    if (!(feed0 < feed1 || feed1 < feed0))
        return slow;
    for (int i = 0; i < LOFT_AXES; i++)
        a = loft_real_cap(a, b->accel[i], loft_real_abs(along->axis[i]));
    const loft_real leak = loft_acc_round(loft_budget_beat(b, a) / 2);
    return leak < slow / 2 ? slow - leak : slow / 2;
}

bool loft_scope_join(loft_plan_piece *p, const loft_budget *b, const loft_vec *before,
                     const loft_vec *after, loft_acc spacing, bool corner, loft_real feed0,
                     loft_real feed1)
{
    const loft_acc most = loft_budget_joint(b, before, after, spacing, corner);
    const loft_real cap = feed_cap(b, after, feed0, feed1);
    loft_real rest = LOFT_ACCEL_MAX;

    if (most >= square(cap) && cap >= feed1)
        return false;
    for (int i = 0; i < LOFT_AXES; i++)
        rest = b->accel[i] < rest ? b->accel[i] : rest;
    begin(p);
    p->length = 0;
    p->cap    = loft_acc_sqrt(most);
    p->stop   = p->cap < loft_acc_round(loft_acc_scale(loft_to_acc(rest), b->pulse) / 4);
    p->cap    = p->last = p->cap < cap ? p->cap : cap;
    return true;
}
