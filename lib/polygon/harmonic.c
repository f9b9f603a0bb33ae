/* lib/polygon/harmonic.c
 * SPDX-License-Identifier: MIT
 *
 * Every term is the real part of an analytic function f(z), z = x + i y, or of -i f. Its
 * derivatives are
 *
 *     Re f' by x    -Im f' by y    Re f'' by x twice    -Im f'' by x and y    -Re f'' by y twice
 *
 * At a corner v with a = pi / angle and l = ln((z - v) / reach) turned so that the edge that leaves
 * is real,
 *
 *     w = e^(a l)     (w^k)' = k a w^k / (z - v)     (w^k)'' = k a (k a - 1) w^k / (z - v)^2
 *
 * Where the corner is nearly straight, w and zeta = e^l are nearly the same, and the solution needs
 * their difference. The first term is then, instead of w,
 *
 *     f = (w - zeta) / (a - 1) = zeta l (e^x - 1) / x, x = (a - 1) l
 *     f' = (a f + zeta) / (z - v)     f'' = a w / (z - v)^2
 *
 * which is zeta l where the corner is straight. A pole p of the root s = e^(l / 2) has, with
 * q = size / (s - p) and g = s' / (s - p) = s / (s - p) / (2 (z - v)),
 *
 *     f = q     f' = -q g     f'' = q g (2 g + 1 / (2 (z - v)))
 */
#include "polygon/harmonic.h"
#include "num/explog.h"  /* loft_sci_log, loft_sci_exp */

typedef struct {
    loft_sci re, im;
} number;

static unsigned next(unsigned i, unsigned sides) { return i + 1 < sides ? i + 1 : 0; }

static number times(number a, number b)
{
    number r;

    r.re = loft_sci_sub(loft_sci_mul(a.re, b.re), loft_sci_mul(a.im, b.im));
    r.im = loft_sci_add(loft_sci_mul(a.re, b.im), loft_sci_mul(a.im, b.re));
    return r;
}

static number scaled(number a, loft_sci c)
{
    a.re = loft_sci_mul(a.re, c);
    a.im = loft_sci_mul(a.im, c);
    return a;
}

static loft_sci square_of(number a)
{
    return loft_sci_add(loft_sci_mul(a.re, a.re), loft_sci_mul(a.im, a.im));
}

static number inverse(number a)
{
    a.im = loft_sci_neg(a.im);
    return scaled(a, loft_sci_div(loft_sci_one(), square_of(a)));
}

/* The coefficients that come next, and what they make so far: values only, or jets. */
typedef struct {
    const loft_acc *coefficient;
    unsigned sides;
    loft_sci *phi;
    loft_jet *jet;
} sums;

/* Re f, with f[0..2] the function and its derivatives. */
static void add_term(sums *s, const number f[3])
{
    for (unsigned i = 0; i < s->sides; i++) {
        const loft_sci c = loft_sci_of(*s->coefficient++);
        if (s->phi) {
            loft_sci_add_product(&s->phi[i], c, f[0].re);
            continue;
        }
        const loft_sci minus = loft_sci_neg(c);
        loft_sci_add_product(&s->jet[i].f, c, f[0].re);
        loft_sci_add_product(&s->jet[i].x, c, f[1].re);
        loft_sci_add_product(&s->jet[i].y, minus, f[1].im);
        loft_sci_add_product(&s->jet[i].xx, c, f[2].re);
        loft_sci_add_product(&s->jet[i].xy, minus, f[2].im);
        loft_sci_add_product(&s->jet[i].yy, minus, f[2].re);
    }
}

/* Im f. */
static void add_imaginary(sums *s, const number f[3])
{
    number turned[3];

    for (int k = 0; k < (s->jet ? 3 : 1); k++) {
        turned[k].re = f[k].im;
        turned[k].im = loft_sci_neg(f[k].re);
    }
    add_term(s, turned);
}


// Corners
// -------

/* x within -pi..pi of `near`, in whole turns. */
static int32_t turns_to(loft_acc x, loft_acc near)
{
    const loft_acc half = loft_fine_to_acc(LOFT_FINE_PI);
    int32_t turns = 0;

    for (; x + half < near; turns++)
        x += 2 * half;
    for (; x - half > near; turns--)
        x -= 2 * half;
    return turns;
}

/* The angle of the offset from a corner, as one sees it who comes from there inside: on the way
 * from p to the corner
 * the angle stays the same, up to the edge where the way leaves the polygon, and along the boundary
 * it was followed by init.
 * Without such an edge it is within 0..angle. */
static loft_acc angle_near(const loft_harmonic *h, unsigned at, loft_spot p)
{
    const loft_domain *d = h->domain;
    const loft_harmonic_corner *c = &h->corner[at];
    const loft_real *q = p.at, *v = d->v[at].at;
    loft_acc near = c->half;
    loft_sci first = loft_sci_from_int(2);

    if (d->convex)
        return near;
    for (unsigned e = next(at, d->sides), f = next(e, d->sides); f != at;
         e = f, f = next(f, d->sides)) {
        const loft_real *a = d->v[e].at, *b = d->v[f].at;
        const loft_sci here = loft_sci_cross(a, b, a, q), there = loft_sci_cross(a, b, a, v);
        if (loft_sci_sign(here) * loft_sci_sign(there) > 0 ||
            !(loft_sci_sign(here) || loft_sci_sign(there)) ||
            loft_sci_sign(loft_sci_cross(q, v, q, a)) * loft_sci_sign(loft_sci_cross(q, v, q, b)) >
                0)
            continue;
        const loft_sci way = loft_sci_div(here, loft_sci_sub(here, there));
        if (loft_sci_less(way, first)) {
            first = way;
            near = c->turn[e];
        }
    }
    return near;
}

static loft_fine direction(const loft_spot *from, const loft_spot *to)
{
    return loft_fine_atan2(loft_to_acc(to->at[1]) - loft_to_acc(from->at[1]),
                           loft_to_acc(to->at[0]) - loft_to_acc(from->at[0]));
}

static number offset(const loft_spot *from, const loft_spot *to)
{
    number r;

    r.re = loft_sci_sub(loft_sci_from_real(to->at[0]), loft_sci_from_real(from->at[0]));
    r.im = loft_sci_sub(loft_sci_from_real(to->at[1]), loft_sci_from_real(from->at[1]));
    return r;
}

static loft_sci half_of(loft_sci x) { return loft_sci_mul(x, loft_sci_from_unit(LOFT_UNIT(0.5))); }

/* e^x: whole turns are taken off the angle first. */
static number exponential(number x)
{
    const loft_sci turn = loft_sci_from_fine(LOFT_FINE_PI), size = loft_sci_exp(x.re);
    loft_acc turns = 0;
    number r;

    if (!loft_sci_to_acc(half_of(loft_sci_div(x.im, turn)), &turns))
        turns = 0;
    const loft_fine angle = loft_sci_to_fine(
        loft_sci_sub(x.im, loft_sci_mul(turn, loft_sci_from_int(2 * loft_acc_int(turns)))));
    r.re = loft_sci_mul(size, loft_sci_from_fine(loft_fine_cos(angle)));
    r.im = loft_sci_mul(size, loft_sci_from_fine(loft_fine_sin(angle)));
    return r;
}

/* (e^x - 1) l / x: from |x| = 1/2 downward by the series, of which the next term is below 2^-62. */
static number quotient(number x, number l, loft_sci less)
{
    const loft_sci one = loft_sci_one();
    number sum = { one, loft_sci_zero() };

    if (loft_sci_less(loft_sci_from_unit(LOFT_UNIT(0.25)), square_of(x))) {
        sum = exponential(x);
        sum.re = loft_sci_sub(sum.re, one);
        return scaled(sum, loft_sci_div(one, less));
    }
    for (int k = 15; k > 1; k--) {
        sum = scaled(times(x, sum), loft_sci_div(one, loft_sci_from_int(k)));
        sum.re = loft_sci_add(sum.re, one);
    }
    return times(l, sum);
}

static void nearly_straight(number l, number w, number by, loft_sci a, number f[3])
{
    const loft_sci less = loft_sci_sub(a, loft_sci_one());
    const number zeta = exponential(l);

    f[0] = times(zeta, quotient(scaled(l, less), l, less));
    f[1] = scaled(f[0], a);
    f[1].re = loft_sci_add(f[1].re, zeta.re);
    f[1].im = loft_sci_add(f[1].im, zeta.im);
    f[1] = times(f[1], by);
    f[2] = scaled(times(times(w, by), by), a);
}

static number distance_inverse(number z, const loft_harmonic_pole *pole)
{
    z.re = loft_sci_sub(z.re, loft_sci_of(pole->at[0]));
    z.im = loft_sci_sub(z.im, loft_sci_of(pole->at[1]));
    return inverse(z);
}

/* `by` is 1 / (z - v). */
static void add_corner_pole(const loft_harmonic_pole *pole, number root, number by, sums *s)
{
    const loft_sci half = loft_sci_from_unit(LOFT_UNIT(0.5));
    const number share = distance_inverse(root, pole);
    number f[3], g, slope;

    f[0] = scaled(share, loft_sci_of(pole->size));
    if (s->jet) {
        by = scaled(by, half);
        g = times(times(root, share), by);
        slope = scaled(g, loft_sci_from_int(2));
        slope.re = loft_sci_add(slope.re, by.re);
        slope.im = loft_sci_add(slope.im, by.im);
        f[1] = times(f[0], g);
        f[2] = times(f[1], slope);
        f[1] = scaled(f[1], loft_sci_from_int(-1));
    }
    add_term(s, f);
    add_imaginary(s, f);
}

static void add_corner(const loft_harmonic *h, unsigned at, const loft_harmonic_pole *pole,
                       loft_spot p, sums *s)
{
    const loft_harmonic_corner *c = &h->corner[at];
    const number d = offset(&h->domain->v[at], &p);
    const loft_fine angle = direction(&h->domain->v[at], &p) - c->start;
    const int32_t turns = turns_to(loft_fine_to_acc(angle), angle_near(h, at, p));
    number l, f[3], w, power, root, by = { loft_sci_zero(), loft_sci_zero() };

    l.re = loft_sci_sub(half_of(loft_sci_log(square_of(d))), c->log_reach);
    l.im = loft_sci_add(loft_sci_from_fine(angle), loft_sci_mul(loft_sci_from_fine(LOFT_FINE_PI),
                                                                loft_sci_from_int(2 * turns)));
    w = power = exponential(scaled(l, c->power));
    if (s->jet)
        by = inverse(d);

    for (int k = 1; k <= h->table->powers[at]; k++, power = times(power, w)) {
        const loft_sci exponent = loft_sci_mul(c->power, loft_sci_from_int(k)),
                       less = loft_sci_sub(exponent, loft_sci_one());
        if (k == 1 && h->table->straight >> at & 1) {
            nearly_straight(l, w, by, c->power, f);
        } else {
            f[0] = power;
            f[1] = s->jet ? scaled(times(power, by), exponent) : by;
            f[2] = s->jet ? scaled(times(f[1], by), less) : by;
        }
        add_imaginary(s, f);
    }
    if (h->table->corner_poles[at] == 0)
        return;
    root = exponential(scaled(l, loft_sci_from_unit(LOFT_UNIT(0.5))));
    for (unsigned k = h->table->corner_poles[at]; k-- > 0;)
        add_corner_pole(pole++, root, by, s);
}


// Poles, polynomial
// -----------------

/* q = size / (z - pole): q' = -q / (z - pole), q'' = -2 q' / (z - pole). */
static void add_pole(const loft_harmonic_pole *pole, loft_spot p, sums *s)
{
    const number z = { loft_sci_from_real(p.at[0]), loft_sci_from_real(p.at[1]) },
                 by = distance_inverse(z, pole);
    number f[3];

    f[0] = scaled(by, loft_sci_of(pole->size));
    f[1] = scaled(times(f[0], by), loft_sci_from_int(-1));
    f[2] = scaled(times(f[1], by), loft_sci_from_int(-2));
    add_term(s, f);
    add_imaginary(s, f);
}

/* t^k, t = (z - middle) / reach. */
static void add_polynomial(const loft_harmonic *h, loft_spot p, sums *s)
{
    const loft_sci zero = loft_sci_zero(), scale = loft_sci_div(loft_sci_one(), h->reach);
    number t, f[3] = { { zero, zero }, { zero, zero }, { zero, zero } };

    t.re = loft_sci_mul(loft_sci_sub(loft_sci_from_real(p.at[0]), h->middle[0]), scale);
    t.im = loft_sci_mul(loft_sci_sub(loft_sci_from_real(p.at[1]), h->middle[1]), scale);
    f[0].re = loft_sci_one();
    add_term(s, f);
    for (int k = 1; k <= h->table->degree; k++) {
        f[2] = scaled(f[1], loft_sci_mul(scale, loft_sci_from_int(k)));
        f[1] = scaled(f[0], loft_sci_mul(scale, loft_sci_from_int(k)));
        f[0] = times(f[0], t);
        add_term(s, f);
        add_imaginary(s, f);
    }
}

static void add_all(const loft_harmonic *h, loft_spot p, sums *s)
{
    const loft_harmonic_table *t = h->table;
    const loft_harmonic_pole *pole = t->pole;

    for (unsigned i = 0; i < t->sides; i++) {
        if (t->powers[i] || t->corner_poles[i])
            add_corner(h, i, pole, p, s);
        if (t->corner_poles[i]) /* there may be no array */
            pole += t->corner_poles[i];
    }
    for (unsigned i = 0; i < t->poles; i++)
        add_pole(pole++, p, s);
    add_polynomial(h, p, s);
}


// Public
// ------

static void prepare_corner(const loft_domain *d, unsigned at, loft_harmonic_corner *c)
{
    const loft_spot *v = d->v, *here = &v[at];
    const unsigned n = d->sides, after = next(at, n), before = at ? at - 1 : n - 1;
    const loft_sci pi = loft_sci_from_fine(LOFT_FINE_PI);
    loft_sci far = loft_sci_zero();
    loft_fine angle;

    c->start = direction(here, &v[after]);
    angle = direction(here, &v[before]) - c->start;
    if (angle < 0)
        angle += 2 * LOFT_FINE_PI;
    c->half = loft_fine_to_acc(angle / 2);
    c->power = loft_sci_div(pi, loft_sci_from_fine(angle));
    for (unsigned i = 0; i < d->sides; i++) {
        const loft_sci square = square_of(offset(here, &v[i]));
        far = loft_sci_less(far, square) ? square : far;
    }
    c->log_reach = half_of(loft_sci_log(far));

    c->turn[at] = c->turn[after] = 0;
    for (unsigned e = after, f = next(e, d->sides); f != at; e = f, f = next(f, d->sides)) {
        const loft_acc step = loft_fine_to_acc(direction(here, &v[f]) - direction(here, &v[e]));
        c->turn[f] = c->turn[e] + step + 2 * turns_to(step, 0) * loft_fine_to_acc(LOFT_FINE_PI);
    }
}

enum loft_status loft_harmonic_init(loft_harmonic *h, const loft_domain *domain,
                                    const loft_harmonic_table *table)
{
    const unsigned n = domain->sides;
    unsigned terms = 1u + 2u * table->degree + 2u * table->poles;

    for (unsigned i = 0; i < n; i++)
        terms += table->powers[i] + 2u * table->corner_poles[i];
    if (table->sides != n || table->terms != terms)
        return LOFT_ERR_ARG;

    h->domain = domain;
    h->table = table;
    for (int k = 0; k < 2; k++) {
        h->middle[k] = loft_sci_zero();
        for (unsigned i = 0; i < n; i++)
            h->middle[k] = loft_sci_add(h->middle[k], loft_sci_from_real(domain->v[i].at[k]));
        h->middle[k] = loft_sci_div(h->middle[k], loft_sci_from_int((int32_t)n));
    }
    h->reach = loft_sci_zero();
    for (unsigned i = 0; i < n; i++) {
        number to;
        to.re = loft_sci_sub(loft_sci_from_real(domain->v[i].at[0]), h->middle[0]);
        to.im = loft_sci_sub(loft_sci_from_real(domain->v[i].at[1]), h->middle[1]);
        const loft_sci r = loft_sci_sqrt(square_of(to));
        h->reach = loft_sci_less(h->reach, r) ? r : h->reach;
        prepare_corner(domain, i, &h->corner[i]);
    }
    return LOFT_OK;
}

/* Inside, no coordinate leaves 0..1, nor is 0: what does is nearer there. A 0 would say that the
 * point lies on an edge, and the parameters of far sides would be free. */
static loft_sci within(loft_sci x)
{
    const loft_sci least = loft_sci_from_unit(LOFT_UNIT(0x1p-24));

    if (loft_sci_sign(x) <= 0)
        return loft_sci_mul(least, least);
    return loft_sci_less(loft_sci_one(), x) ? loft_sci_one() : x;
}

enum loft_status loft_harmonic_eval(const loft_harmonic *h, loft_spot p, loft_sci phi[])
{
    loft_sci area[LOFT_SIDES_MAX];
    const unsigned n = h->table->sides;
    sums s = { h->table->coefficient, n, phi, 0 };
    unsigned index = 0;

    if (!loft_spot_valid(p))
        return LOFT_ERR_RANGE;
    const enum loft_place place = loft_domain_place(h->domain, p, area, &index);
    if (place == LOFT_OUTSIDE)
        return LOFT_ERR_RANGE;
    if (place == LOFT_AT_VERTEX)
        loft_domain_vertex(h->domain, index, phi);
    if (place == LOFT_ON_EDGE)
        loft_domain_edge(h->domain, p, index, phi);
    if (place != LOFT_INSIDE)
        return LOFT_OK;

    for (unsigned i = 0; i < n; i++)
        phi[i] = loft_sci_zero();
    add_all(h, p, &s);
    for (unsigned i = 0; i < n; i++)
        phi[i] = within(phi[i]);
    return LOFT_OK;
}

enum loft_status loft_harmonic_jet(const loft_harmonic *h, loft_spot p, loft_jet phi[])
{
    loft_sci area[LOFT_SIDES_MAX];
    const unsigned n = h->table->sides;
    sums s = { h->table->coefficient, n, 0, phi };
    unsigned index = 0;

    if (!loft_spot_valid(p))
        return LOFT_ERR_RANGE;
    const enum loft_place place = loft_domain_place(h->domain, p, area, &index);
    if (place == LOFT_OUTSIDE)
        return LOFT_ERR_RANGE;
    if (place == LOFT_AT_VERTEX)
        return LOFT_SINGULAR;

    for (unsigned i = 0; i < n; i++)
        phi[i] = loft_jet_of(loft_sci_zero());
    add_all(h, p, &s);
    if (place == LOFT_ON_EDGE)
        loft_domain_edge(h->domain, p, index, area);
    for (unsigned i = 0; i < n; i++)
        phi[i].f = place == LOFT_ON_EDGE ? area[i] : within(phi[i].f);
    return LOFT_OK;
}
