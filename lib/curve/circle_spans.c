/* lib/curve/circle_spans.c -- arcs cut into Bezier spans
 * SPDX-License-Identifier: MIT
 *
 * A span of angle h has its inner points on the tangents at its ends. Their distance, in slopes, is
 *
 *     cubic            4/3 tan(h/4)                                 the middle lies on the circle
 *     conic            tan(h/2)                        w = cos(h/2)
 *     rational cubic   2 sin(h/2) / (1 + 2 cos(h/2))   w = (1 + 2 cos(h/2)) / 3, the conic elevated
 *
 * Error. The cubic deviates from the circle by r 2/27 sin^6(h/4) / cos^2(h/4) <= 1.8143e-5 r h^6
 * for h <= pi/2. An ellipse is an affine image of the unit circle, which moves nothing by more than
 * its larger radius. The angle of the cubic at t differs from t h by up to 2.01e-3 h^3. Drift is
 * linear in t, so a helix is off by 2.01e-3 h^2 of the drift of one span; for the conics the factor
 * is 8.55e-3 h^2. The weight of a conic, at least 181, is rounded by g / 2, where g is the distance
 * of numbers at 256. That moves the curve by r sin^2(h/2) / cos(h/2) / 4 of it, less than r h^2 g /
 * 4096.
 */
#include "curve/circle.h"

#define SPANS_MAX ((uint32_t)1 << 20)
#define OUTER_WEIGHT LOFT_REAL(256)

typedef struct {
    loft_acc axis[LOFT_AXES];
} wide_point;

/* The fraction j/n of x. */
static loft_acc part_of_sweep(loft_acc x, uint32_t j, uint32_t n)
{
    return loft_acc_lerp_at(0, x, j, n);
}

static loft_circle_place place_at(const loft_circle *c, uint32_t j, uint32_t n)
{
    const loft_fine a = loft_fine_angle(part_of_sweep(c->sweep, j, n)), cosine = loft_fine_cos(a),
                    sine = loft_fine_sin(a);
    const uint8_t plane[2] = { c->plane.first, c->plane.second };
    loft_circle_place at;

    for (int i = 0; i < LOFT_AXES; i++)
        at.p[i] = loft_to_acc(c->from.axis[i]) + part_of_sweep(c->drift[i], j, n);
    for (int i = 0; i < 2; i++) {
        at.p[plane[i]] = c->centre[i] + loft_fine_scale(c->u[i], cosine) +
                         loft_fine_scale(c->v[i], sine) + part_of_sweep(c->drift[plane[i]], j, n);
        at.slope[i] = loft_fine_scale(c->v[i], cosine) - loft_fine_scale(c->u[i], sine);
    }
    for (int i = 0; i < LOFT_AXES && (j == 0 || j == n); i++)
        at.p[i] = loft_to_acc(j ? c->to.axis[i] : c->from.axis[i]);
    return at;
}

/* The inner point next to the end `at`, ahead of it (sign 1) or behind it (-1). */
static wide_point inner_point(const loft_circle_spans *s, const loft_circle_place *at, int sign)
{
    const loft_circle *c = s->circle;
    wide_point q;

    for (int i = 0; i < LOFT_AXES; i++)
        q.axis[i] = at->p[i] +
                    sign * loft_fine_scale(loft_acc_ratio(c->drift[i], (int32_t)s->n), s->share);
    q.axis[c->plane.first]  += sign * loft_fine_scale(at->slope[0], s->arm);
    q.axis[c->plane.second] += sign * loft_fine_scale(at->slope[1], s->arm);
    return q;
}

static bool point_valid(const loft_acc p[])
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (!loft_acc_valid(p[i]))
            return false;
    return true;
}

static loft_vec round_point(const loft_acc p[])
{
    loft_vec v;

    for (int i = 0; i < LOFT_AXES; i++)
        v.axis[i] = loft_acc_round(p[i]);
    return v;
}


/* The number of spans */

/* An upper bound of the error of n spans, without the rounding of the points. */
static loft_acc spans_error(const loft_circle *c, enum loft_circle_kind kind, uint32_t n)
{
    const loft_unit h = loft_unit_from(loft_acc_round(loft_acc_ratio(c->sweep, (int32_t)n)) +
                                       LOFT_REAL_LSB);
    const loft_acc drift = loft_acc_ratio(loft_acc_hypot(c->drift, LOFT_AXES), (int32_t)n);
    loft_acc off, lag = loft_acc_scale(drift, kind == LOFT_CIRCLE_CUBIC ? LOFT_UNIT(0.0021)
                                                                        : LOFT_UNIT(0.0086));

    if (kind == LOFT_CIRCLE_CUBIC) {
        off = loft_acc_scale(c->radius, LOFT_UNIT(0.0000182));
        for (int k = 0; k < 4; k++)
            off = loft_acc_scale(off, h);
    } else {
        off = loft_acc_ratio(
            loft_acc_mul(c->radius, loft_acc_round(loft_real_ulp(loft_to_acc(OUTER_WEIGHT)))),
            4096);
    }
    return loft_acc_scale(loft_acc_scale(off + lag, h), h);
}

/* The smallest number of spans of at most a quarter turn (plus 2^-16 of one) with an error within
 * `budget`; 0 if there is none. */
static uint32_t count_spans(const loft_circle *c, enum loft_circle_kind kind, loft_acc budget)
{
    const loft_acc quarters = loft_fine_scale(
        c->sweep, loft_fine_ratio((loft_acc)LOFT_FINE_1, (loft_acc)(LOFT_FINE_PI / 2)));
    const int32_t whole = loft_acc_int(quarters + loft_to_acc(LOFT_REAL(0.499984741)));
    uint32_t few = whole > 1 ? (uint32_t)whole : 1, many = few;

    while (spans_error(c, kind, many) > budget) {
        few = many + 1;
        many *= 2;
        if (many > SPANS_MAX)
            return 0;
    }
    while (few < many) {
        const uint32_t middle = (few + many) / 2;
        if (spans_error(c, kind, middle) > budget)
            few = middle + 1;
        else
            many = middle;
    }
    return many;
}

/* The largest coordinate of the ends, or the radius. */
static loft_acc largest_coordinate(const loft_circle *c)
{
    loft_acc largest = c->radius;

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc end[2] = { loft_to_acc(c->from.axis[i]), loft_to_acc(c->to.axis[i]) };
        for (int k = 0; k < 2; k++)
            if (end[k] > largest || -end[k] > largest)
                largest = end[k] < 0 ? -end[k] : end[k];
    }
    return largest;
}

static void set_span_shape(loft_circle_spans *s)
{
    const loft_fine h = loft_fine_angle(loft_acc_ratio(s->circle->sweep, (int32_t)s->n));
    const loft_fine sine = loft_fine_sin(h / 2), cosine = loft_fine_cos(h / 2),
                    sum = LOFT_FINE_1 + 2 * cosine;

    s->weight = LOFT_FINE_1;
    s->share = LOFT_FINE_1 / 3;
    if (s->kind == LOFT_CIRCLE_CUBIC) {
        s->arm = loft_fine_ratio((loft_acc)(4 * loft_fine_sin(h / 4)),
                                 (loft_acc)(3 * loft_fine_cos(h / 4)));
    } else if (s->kind == LOFT_CIRCLE_CONIC) {
        s->arm = loft_fine_ratio((loft_acc)sine, (loft_acc)cosine);
        s->weight = cosine;
        s->share = LOFT_FINE_1 / 2;
    } else {
        s->arm = loft_fine_ratio((loft_acc)(2 * sine), (loft_acc)sum);
        s->weight = sum / 3;
        s->share = loft_fine_ratio((loft_acc)cosine, (loft_acc)sum);
    }
}

static bool spans_valid(const loft_circle_spans *s)
{
    loft_circle_place first = place_at(s->circle, 0, s->n);

    for (uint32_t j = 1; j <= s->n; j++) {
        const loft_circle_place last = place_at(s->circle, j, s->n);
        const wide_point q1 = inner_point(s, &first, 1), q2 = inner_point(s, &last, -1);
        if (!point_valid(q1.axis) || !point_valid(q2.axis) || !point_valid(last.p))
            return false;
        first = last;
    }
    return true;
}

enum loft_status loft_circle_spans_init(loft_circle_spans *s, const loft_circle *c,
                                        enum loft_circle_kind kind, loft_real tolerance)
{
    const loft_acc budget = loft_to_acc(tolerance) - 3 * loft_real_ulp(largest_coordinate(c));
    loft_circle_spans made = { .circle = c, .next = 0, .kind = (uint8_t)kind };

    if (!(budget > 0))
        return LOFT_ERR_RANGE;
    made.n = count_spans(c, kind, budget);
    if (made.n == 0)
        return LOFT_ERR_RANGE;
    set_span_shape(&made);
    if (!spans_valid(&made))
        return LOFT_ERR_RANGE;
    made.at = place_at(c, 0, made.n);
    *s = made;
    return LOFT_OK;
}


/* The spans */

/* The two ends and the two inner points of the next span. */
static void next_points(loft_circle_spans *s, loft_vec out[4])
{
    const loft_circle_place last = place_at(s->circle, ++s->next, s->n);
    const wide_point q1 = inner_point(s, &s->at, 1), q2 = inner_point(s, &last, -1);

    out[0] = round_point(s->at.p);
    out[1] = round_point(q1.axis);
    out[2] = round_point(q2.axis);
    out[3] = round_point(last.p);
    s->at = last;
}

bool loft_circle_spans_next(loft_circle_spans *s, loft_cubic *out)
{
    if (s->kind != LOFT_CIRCLE_CUBIC || s->next == s->n)
        return false;
    next_points(s, out->p);
    return true;
}

bool loft_circle_spans_rational(loft_circle_spans *s, loft_weighted out[])
{
    loft_vec p[4];

    if (s->kind == LOFT_CIRCLE_CUBIC || s->next == s->n)
        return false;
    next_points(s, p);
    const loft_real weight = loft_acc_round(256 * loft_fine_to_acc(s->weight));
    const int count_of = s->kind == LOFT_CIRCLE_CONIC ? 3 : 4;
    for (int k = 0; k < count_of; k++) {
        const bool outer = k == 0 || k == count_of - 1;
        out[k].p = k == count_of - 1 ? p[3] : p[k];
        out[k].w = outer ? OUTER_WEIGHT : weight;
    }
    return true;
}
