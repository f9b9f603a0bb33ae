/* lib/motion/scope.c
 * SPDX-License-Identifier: MIT
 *
 * On a path with direction u and curvature vector k, passed with acceleration a and the square x of the speed, an axis has the
 * acceleration
 *
 *     u a + k x
 *
 * On a piece of length l that begins with x it is u0 a + k0 x at the start and u1 a + k1 (x + 2 a l) = (u1 + 2 l k1) a + k1 x at
 * the end: with w = u0 or u1 + 2 l k1 each axis and end gives two lines in the plane of x and a,
 *
 *     -A <= w a + k x <= A        |w a| <= A (1 -+ k x / A)
 *
 * As u' = k and x' = 2 a, and k is nearly a line, the second derivative of u a + k x along the piece is 5 a (k1 - k0) / l: between the ends
 * it may go beyond both of them by q |a|, q = 5/8 l |k1 - k0|, on one side. On that side w a + k x + q |a| is within A. Where w and k1 - k0 have
 * opposite signs |w| becomes |w| + q, but stays |w| where the bend has to be relieved by w a. Where they have the same sign it stays |w|, or becomes
 * |w| - q where the bend is relieved; if q > |w| there is a line with q - |w| and the other sign of k. Likewise k becomes k +- r on the side to which
 * the curvature goes beyond the line between its ends, by up to r. So the largest a is the least of some
 * falling and rising lines in x, a concave function, and so is -a of the least one. Both are positive at x = 0. Where they meet is
 * the largest x that any acceleration allows: more than where a = 0 is possible, if the piece has to be passed while it speeds up
 * or slows down. Chords between x = 0, a knee and the far end lie inside of the polygon. The knee is where the line that is the
 * least at x = 0 meets that at the far end: a corner of the polygon, unless a third line cuts it off.
 *
 * The far end is as far beyond the cap of the speed as a line can be that passes the cap within the piece.
 *
 * q16: y = x / far <= 1 and |k| far / A <= 32, so that all lines are below 33 * 2^14.
 */
#include "motion/scope.h"

#define BENT    40      /* where the speed may change, A / 40 is the most that the curvature's bow may ask for at the cap           */
#define BOW     128     /* A / 128 it may, as that much is kept for joints                                                       */
#define STEEP   64      /* the square of the cap is a line along the piece, to 1/64 of itself                                     */
#define TURN    LOFT_REAL(0.03)
#define EDGE    4     /* of 256: the knee is no nearer to the ends                                                              */
#define LINES   (4 * LOFT_AXES + 1)
#define FASTEST (loft_prod(LOFT_SPEED_MAX, LOFT_SPEED_MAX) / 16)

/* At the part y of the far end a <= most (1 - turn y) and -a <= most (1 + turn y), with turn[1] and turn[0]. The first line is the largest
 * acceleration there is. */
typedef struct {
    loft_real most[LINES], turn[2][LINES];
    loft_real relief[LINES];        /* what |w| is where the bend has to be relieved, if not the same; 0 */
    uint8_t   axis[LINES], count;
    loft_real skew[LOFT_AXES], bow[LOFT_AXES];  /* q with the sign of k1 - k0; r with its side, where it matters */
    loft_acc  far;
} scope;

static loft_real size_of(loft_real x)             { return x < 0 ? -x : x; }
static loft_acc  smaller(loft_acc x, loft_acc y)  { return x < y ? x : y; }
static loft_acc  twice(loft_acc way, loft_real a) { return 2 * loft_acc_mul(way, a); }
static loft_acc  length_of(const loft_plan_piece *p) { return loft_unit_wide(p->length); }

/* Where the bend needs `times` the acceleration; beyond 2^29 it does not matter. */
static loft_acc needed(loft_real accel, loft_real bend, int times)
{
    const loft_acc x = loft_acc_div(loft_wide(accel), bend);
    return x < FASTEST ? x * times : 32 * FASTEST;
}

/* The curvature that counts for an axis. */
static loft_real bend_of(const loft_budget *b, const loft_arc_shape *s, int k, int i)
{
    return s->tight || b->across > 0 ? 0 : s->bend[k].axis[i];
}

/* |w a| <= A (1 -+ turn x / A), or `turn` and `bow`; that is the curvature as yet. */
static void add_line(scope *s, const loft_budget *b, int axis, loft_real w, loft_real relief, loft_real turn, loft_real bow)
{
    s->most[s->count]    = loft_real_cap(LOFT_ACCEL_MAX, b->accel[axis], w);
    s->turn[0][s->count] = bow < 0 ? turn + bow : turn;
    s->turn[1][s->count] = bow > 0 ? turn + bow : turn;
    s->relief[s->count]  = relief;
    s->axis[s->count++]  = (uint8_t)axis;
}

/* The lines of one end, `ahead` of the start. The far end is no further than where the bend needs all of the acceleration, or 32 times as much
 * where it can be relieved. */
static void set_lines(scope *s, const loft_budget *b, const loft_arc_shape *shape, int end, loft_acc ahead)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_real k = bend_of(b, shape, end, i), w = shape->along[end].axis[i] + loft_acc_round(twice(ahead, k)), size = size_of(w);
        const loft_real with = w < 0 ? -s->skew[i] : s->skew[i], turn = w < 0 ? -k : k, bow = w < 0 ? -s->bow[i] : s->bow[i];

        add_line(s, b, i, with < 0 ? size - with : size, with < 0 ? size : with < size ? size - with : 0, turn, bow);
        if (with > size)
            add_line(s, b, i, with - size, 0, -turn, -bow);
        if (k < 0 || k > 0)
            s->far = smaller(s->far, needed(b->accel[i], size_of(k), loft_prod(LOFT_ACCEL_MAX, size) > loft_wide(b->accel[i]) ? 32 : 1));
    }
}

/* The least of the lines at y, and which it is. */
static loft_acc least_at(const scope *s, loft_unit y, bool fore, int *which)
{
    loft_acc least = loft_wide(LOFT_ACCEL_MAX);

    *which = 0;
    for (int j = 1; j < s->count; j++) {
        const loft_real turn = loft_acc_round(loft_acc_scale(loft_wide(s->turn[fore][j]), y));
        const loft_acc  a = loft_prod(s->most[j], fore ? LOFT_REAL(1) - turn : LOFT_REAL(1) + turn);
        if (a < least) {
            least  = a;
            *which = j;
        }
    }
    return least;
}

static loft_acc slope(const scope *s, int j, bool fore) { return loft_prod(s->most[j], s->turn[fore][j]); }

/* The largest y <= 1 where there is an acceleration: Newton's way from the right, on a concave function. */
static loft_unit tip(const scope *s)
{
    loft_unit y = LOFT_UNIT(1);
    int i, j;

    for (int n = 0; n < 12; n++) {
        const loft_acc spare = least_at(s, y, true, &i) + least_at(s, y, false, &j), fall = slope(s, i, true) - slope(s, j, false);
        if (spare >= 0)
            break;
        const loft_acc both = loft_wide(s->most[i]) + loft_wide(s->most[j]);
        y = both < fall ? loft_unit_ratio(both, fall) : y;
        y -= y / 4096;
    }
    return y;
}

/* The knee, in 256ths of the way to `end`, and the bounds there and at the end. */
static uint8_t set_knee(const scope *s, loft_unit end, bool fore, loft_real bound[2])
{
    int i, j, knee = 128;

    (void)least_at(s, 0, fore, &i);
    bound[1] = loft_acc_round(least_at(s, end, fore, &j));
    const loft_acc fall = fore ? slope(s, j, fore) - slope(s, i, fore) : slope(s, i, fore) - slope(s, j, fore);
    const loft_acc rise = loft_wide(s->most[j]) - loft_wide(s->most[i]);
    if (i != j && fall > 0)
        knee = rise < loft_acc_scale(fall, end) ? (int)loft_acc_int(loft_unit_wide(loft_unit_ratio(rise, loft_acc_scale(fall, end))) * 256) : 256;
    knee = knee < EDGE ? EDGE : knee > 256 - EDGE ? 256 - EDGE : knee;
    bound[0] = loft_acc_round(least_at(s, loft_unit_round(loft_unit_wide(end) / 256 * knee), fore, &i));
    return (uint8_t)knee;
}

/* The most at station k. */
static loft_real speed_cap(const loft_budget *b, const loft_arc_shape *s, int k, loft_real feed)
{
    loft_acc bend[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++) {
        feed = loft_real_cap(feed, b->max_speed[i], size_of(s->along[k].axis[i]));
        bend[i] = loft_wide(s->bend[k].axis[i]);
    }
    if (s->tight || !(b->across > 0))
        return feed;
    const loft_real size = loft_acc_round(loft_acc_hypot(bend, LOFT_AXES));
    const loft_acc  most = size > 0 ? loft_acc_div(loft_wide(b->across), size) : loft_prod(feed, feed);
    return most < loft_prod(feed, feed) ? loft_acc_sqrt(most) : feed;
}

/* The caps at both ends, such that the line between their squares is below that in the middle; 1/64 of the change is for what
 * is no parabola. */
static bool set_caps(loft_plan_piece *p, const loft_budget *b, const loft_arc_shape *shape, loft_real feed)
{
    p->cap  = speed_cap(b, shape, 0, feed);
    p->last = speed_cap(b, shape, 2, feed);
    const loft_real middle = speed_cap(b, shape, 1, feed);
    if (!(p->cap < feed || p->last < feed || middle < feed))
        return true;

    const loft_acc first = loft_prod(p->cap, p->cap), last = loft_prod(p->last, p->last), between = loft_prod(middle, middle);
    const loft_acc change = first < last ? last - first : first - last, bow = loft_acc_mean(first, last) - between;
    const loft_acc off = (bow > 0 ? bow : 0) + change / STEEP;
    p->cap  = loft_acc_sqrt(first - smaller(off, first / 2));
    p->last = loft_acc_sqrt(last - smaller(off, last / 2));
    return bow <= between / STEEP && change <= between / 8;
}

/* The bounds of a piece
 * --------------------- */

static loft_acc knee_of(loft_acc far, unsigned knee) { return far / 256 * (int32_t)knee; }

static loft_real chord_at(const loft_plan_piece *p, loft_acc x, bool fore)
{
    const loft_acc   far = loft_prod(p->far, p->far), knee = knee_of(far, fore ? p->fore_knee : p->back_knee);
    const loft_real *at  = fore ? p->fore : p->back;

    if (!(x < far))
        return at[1];
    if (x < knee)
        return loft_lerp(p->rest, at[0], loft_unit_ratio(x, knee));
    return loft_lerp(at[0], at[1], loft_unit_ratio(x - knee, far - knee));
}

loft_real loft_scope_most(const loft_plan_piece *p, loft_acc x)  { return chord_at(p, x, true); }

/* With the bound g(x) of -a, a concave function, the line x - 2 l g(x) = end: the left side falls first, from 0 or less,
 * and rises then. */
loft_acc loft_scope_brake(const loft_plan_piece *p, loft_acc end)
{
    const loft_acc l = length_of(p), far = loft_prod(p->far, p->far), knee = knee_of(far, p->back_knee);
    const loft_acc at_far = far - twice(l, p->back[1]), at_knee = knee - twice(l, p->back[0]), at_0 = -twice(l, p->rest);

    if (end >= at_far)
        return far;
    if (end >= at_knee)
        return loft_acc_lerp(knee, far, loft_unit_ratio(end - at_knee, at_far - at_knee));
    return loft_acc_scale(knee, loft_unit_ratio(end - at_0, at_knee - at_0));
}


/* Pieces and joints
 * ----------------- */

/* How far the curvature, at most 2^14, goes beyond the line between its ends. */
static loft_real bow_of(const loft_budget *b, const loft_arc_shape *s, int i)
{
    return bend_of(b, s, 1, i) - bend_of(b, s, 0, i) / 2 - bend_of(b, s, 2, i) / 2;
}

static void set_sides(scope *s, const loft_plan_piece *p, const loft_budget *b, const loft_arc_shape *shape)
{
    const loft_real v = p->cap > p->last ? p->cap : p->last;

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_real bow = bow_of(b, shape, i), turn = loft_acc_round(loft_acc_mul(length_of(p), bend_of(b, shape, 2, i) - bend_of(b, shape, 0, i)));
        s->skew[i] = turn / 2 + turn / 8;
        s->bow[i]  = loft_acc_mul(loft_prod(v, v), size_of(bow)) > loft_wide(b->accel[i]) / BOW ? bow : 0;
    }
}

/* Does the curvature's change ask for little between the ends, and the direction not turn much where speed has to change? */
static bool even(const loft_plan_piece *p, const loft_budget *b, const loft_arc_shape *s)
{
    const loft_acc x = loft_prod(p->cap, p->cap);
    bool turns = false;

    for (int i = 0; i < LOFT_AXES; i++) {
        if (loft_acc_mul(length_of(p), b->accel[i]) > x / 128 && loft_acc_mul(x, size_of(bow_of(b, s, i))) > loft_wide(b->accel[i]) / BENT)
            return false;
        turns = turns || size_of(s->along[2].axis[i] - s->along[0].axis[i]) > TURN;
    }
    return p->flows || !(turns || twice(length_of(p), p->rest) > x);
}

/* What line j becomes where the bend has to be relieved. */
static void add_relief(scope *s, const loft_budget *b, int j)
{
    s->turn[0][s->count] = s->turn[0][j];
    s->turn[1][s->count] = s->turn[1][j];
    s->most[s->count++]  = loft_real_cap(LOFT_ACCEL_MAX, b->accel[s->axis[j]], s->relief[j]);
}

/* Chords in the polygon, from which the far end may come nearer. */
static void set_bounds(loft_plan_piece *p, const loft_budget *b, scope *s)
{
    int which;

    p->rest = loft_acc_round(least_at(s, 0, true, &which));
    s->far  = smaller(s->far, loft_prod(p->cap, p->cap) + twice(length_of(p), p->rest));
    const int count = s->count;
    for (int j = 1; j < count; j++) {
        const bool same = !(s->turn[0][j] < s->turn[1][j]);
        for (int fore = same ? 1 : 0; fore < 2; fore++)
            s->turn[fore][j] = loft_acc_quot(loft_acc_mul(s->far, s->turn[fore][j]), loft_wide(b->accel[s->axis[j]]));
        s->turn[0][j] = same ? s->turn[1][j] : s->turn[0][j];
        if (s->relief[j] > 0 && (s->turn[1][j] > LOFT_REAL(1) || s->turn[0][j] < LOFT_REAL(-1)))
            add_relief(s, b, j);
    }
    const loft_unit end = tip(s);
    p->fore_knee = set_knee(s, end, true, p->fore);
    p->back_knee = set_knee(s, end, false, p->back);
    s->far = loft_acc_scale(s->far, end);
    p->far = loft_acc_sqrt(s->far);
    p->cap = p->cap < p->far ? p->cap : p->far;
}

/* A piece that is bent more than its shape can say: half of the acceleration is for its turn. It is shorter than 2^-16 mm. */
static void set_tight_caps(loft_plan_piece *p, const loft_budget *b, const loft_arc_shape *s)
{
    loft_acc x = smaller(loft_prod(p->cap, p->cap), loft_prod(p->last, p->last));

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_real turn = size_of(s->along[2].axis[i] - s->along[0].axis[i]);
        const loft_acc  half = loft_acc_mul(length_of(p), b->accel[i]) / 2;
        x = turn > 0 ? smaller(x, loft_acc_div(half, turn)) : x;
    }
    p->cap  = loft_acc_sqrt(x);
    p->last = p->cap;
}

static void begin(loft_plan_piece *p)
{
    p->stop = p->sure = false;
    p->brake = 0;
}

bool loft_scope_init(loft_plan_piece *p, const loft_budget *b, const loft_arc *arc, const loft_arc_shape *s, loft_real feed)
{
    scope lines = { .most = { LOFT_ACCEL_MAX }, .turn = { { 0 }, { 0 } }, .count = 1, .far = 32 * FASTEST };

    begin(p);
    p->length = loft_unit_round(arc->length);
    const bool steady = set_caps(p, b, s, feed);
    if (s->tight)
        set_tight_caps(p, b, s);
    set_sides(&lines, p, b, s);
    for (int k = 1; k >= -1; k--) {         /* the middle first: it may not be passed faster there */
        set_lines(&lines, b, s, k < 0 ? 2 : k, k < 0 ? length_of(p) : 0);
        lines.count = k > 0 ? 1 : lines.count;
    }
    set_bounds(p, b, &lines);

    const loft_acc x = loft_prod(p->cap, p->cap), more = loft_prod(p->last, p->last) - x;
    p->flows = more <= twice(length_of(p), loft_scope_most(p, x)) && -more <= twice(length_of(p), chord_at(p, x, false));
    return steady && even(p, b, s);
}

/* The spline of the samples spreads a change of acceleration, by a, over beats: the speed at its place is off by 0.23 a h. Where the
 * feed changes there is one at both sides of the slower feed. */
static loft_real feed_cap(const loft_budget *b, loft_vec along, loft_real feed0, loft_real feed1)
{
    const loft_real slow = feed0 < feed1 ? feed0 : feed1;
    loft_real a = LOFT_ACCEL_MAX;

    if (!(feed0 < feed1 || feed1 < feed0))
        return slow;
    for (int i = 0; i < LOFT_AXES; i++)
        a = loft_real_cap(a, b->accel[i], along.axis[i] < 0 ? -along.axis[i] : along.axis[i]);
    const loft_real leak = loft_acc_round(loft_budget_beat(b, a) / 2);
    return leak < slow / 2 ? slow - leak : slow / 2;
}

bool loft_scope_join(loft_plan_piece *p, const loft_budget *b, loft_vec before, loft_vec after, loft_acc spacing, bool corner, loft_real feed0, loft_real feed1)
{
    const loft_acc most = loft_budget_joint(b, before, after, spacing, corner);
    const loft_real cap = feed_cap(b, after, feed0, feed1);
    loft_real rest = LOFT_ACCEL_MAX;

    if (most >= loft_prod(cap, cap) && cap >= feed1)
        return false;
    for (int i = 0; i < LOFT_AXES; i++)
        rest = b->accel[i] < rest ? b->accel[i] : rest;
    begin(p);
    p->length = 0;
    p->cap    = loft_acc_sqrt(most);
    p->stop   = p->cap < loft_acc_round(loft_acc_scale(loft_wide(rest), b->pulse) / 4);
    p->cap    = p->last = p->cap < cap ? p->cap : cap;
    return true;
}
