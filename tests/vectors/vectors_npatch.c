/* tests/vectors/vectors_npatch.c -- readers of toric, base point and Zheng-Ball patches
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "vectors/vectors_sheet.h"          /* sheet_of, decimal_real */
#include "polygon/basepoint.h"
#include "polygon/zheng_ball.h"
#include "polygon/toric.h"

#define POINTS 4096

static loft_vec point[POINTS];
static loft_real weight[POINTS], factor[POINTS];

static void read_point(row *r, char *const f[], unsigned place)
{
    for (int i = 0; i < 3; i++)
        point[place].axis[i] = decimal_real(r, f[i]);
}

/* A number that is no coordinate: it does not count among the largest. */
static loft_real aside(row *r, const char *text)
{
    const long double largest = r->largest;
    const loft_real x = decimal_real(r, text);

    r->largest = largest;
    return x;
}


/* Toric patches */

static bool lattice_of(row *r, const char *id, loft_lattice_polygon *l)
{
    const sheet *s = sheet_of(r, "toric_edges");
    loft_whole v[LOFT_SIDES_MAX];
    unsigned n = 0;

    for (unsigned k = 0; k < s->rows; k++)
        if (strcmp(s->field[k][0], id) == 0 && n < LOFT_SIDES_MAX) {
            v[n].at[0] = (int8_t)decimal(r, s->field[k][3]);
            v[n++].at[1] = (int8_t)decimal(r, s->field[k][4]);
        }
    if (loft_lattice_polygon_init(l, v, n) != LOFT_OK)
        row_complain(r, "the lattice polygon %s was refused", id);
    return !r->complaint[0];
}

static void expect_int(row *r, const char *column, int got)
{
    char text[16];

    snprintf(text, sizeof text, "%d", got);
    row_expect_word(r, column, text);
}

static void toric_edges(row *r)
{
    loft_lattice_polygon l;

    if (!lattice_of(r, row_text(r, "case"), &l))
        return;
    const unsigned i = row_count(r, "i", l.sides) - 1;
    if (i >= l.sides)
        return;
    expect_int(r, "ex", l.edge[i].normal.at[0]);
    expect_int(r, "ey", l.edge[i].normal.at[1]);
    expect_int(r, "a", l.edge[i].offset);
    expect_int(r, "m", l.edge[i].length);
}

/* Where (x, y) is among the whole points; their number when it is none of them. */
static unsigned place_in(const loft_lattice_polygon *l, int x, int y)
{
    loft_whole q;
    unsigned place = 0;

    loft_lattice_polygon_first(l, &q);
    do {
        if (q.at[0] == x && q.at[1] == y)
            break;
        place++;
    } while (loft_lattice_polygon_next(l, &q));
    return place;
}

static bool toric_of(row *r, const char *id, loft_lattice_polygon *l, loft_toric *t)
{
    const sheet *s = sheet_of(r, "toric_net");
    unsigned found = 0;

    if (!lattice_of(r, id, l))
        return false;
    r->largest = 0;
    for (unsigned k = 0; k < s->rows; k++) {
        char *const *f = s->field[k];
        if (strcmp(f[0], id) != 0)
            continue;
        const unsigned place = place_in(l, (int)decimal(r, f[1]), (int)decimal(r, f[2]));
        factor[place] = aside(r, f[3]);
        weight[place] = aside(r, f[4]);
        read_point(r, f + 5, place);
        found++;
    }
    if (found != loft_lattice_polygon_count(l))
        row_complain(r, "the net of %s has %u points", id, found);
    else if (loft_toric_init(t, l, point, factor, weight) != LOFT_OK)
        row_complain(r, "the patch %s was refused", id);
    return !r->complaint[0];
}

static unsigned heaviest_sum(const loft_lattice_polygon *l)
{
    unsigned most = 0;
    loft_whole q;

    loft_lattice_polygon_first(l, &q);
    do {
        unsigned sum = 0;
        for (unsigned i = 0; i < l->sides; i++)
            sum += (unsigned)loft_lattice_polygon_height(l, i, q);
        most = sum > most ? sum : most;
    } while (loft_lattice_polygon_next(l, &q));
    return most;
}

static law toric_law(const loft_lattice_polygon *l)
{
    const unsigned n = loft_lattice_polygon_count(l), h = heaviest_sum(l);
    return (law){ .lsb = 0.5L + (n + 2 * h) * 0x1p-28L + 0x1p-16L,
                  .gain = 1,
                  .roundings = n + 128 * h };
}

/* A vertex of the polygon is a corner of the patch: its control point. */
static void toric_net(row *r)
{
    loft_lattice_polygon l;
    loft_toric t;
    loft_vec v = { { 0 } };
    loft_spot at;

    if (!toric_of(r, row_text(r, "case"), &l, &t))
        return;
    const int x = (int)decimal(r, row_text(r, "lx")), y = (int)decimal(r, row_text(r, "ly"));
    at.at[0] = loft_real_from_int(x);
    at.at[1] = loft_real_from_int(y);
    for (unsigned i = 0; i < l.sides; i++)
        if (l.edge[i].from.at[0] == x && l.edge[i].from.at[1] == y)
            expect_point(r, loft_toric_eval(&t, at, &v), v,
                         (law){ .lsb = 0, .gain = 1, .roundings = 2 });
}

/* Of a point on an edge: the rational Bezier curve there gives it as well. Its weights are off by
 * `off` of the smallest, which moves a point by twice that of the largest coordinate on either
 * side; its parameter by `step`, times a slope of at most m R times their distance. */
static void expect_edge(row *r, const loft_toric *t, loft_spot at)
{
    const long double off = BY_NUM(0x1p-17L, 0x1p-24L, 0x1p-51L),
                      step = BY_NUM(0x1p-25L, 0x1p-24L, 0x1p-40L);
    loft_weighted w[LOFT_DEGREE_MAX + 1];
    long double least = 256, most = 0;
    loft_rational curve;
    loft_unit u = 0;
    unsigned i = 0;

    while (i < t->lattice->sides && loft_toric_parameter(t, i, at, &u) != LOFT_OK)
        i++;
    if (i == t->lattice->sides) {
        row_complain(r, "no parameter on any edge");
        return;
    }
    const unsigned m = t->lattice->edge[i].length;
    if (m > LOFT_DEGREE_MAX || loft_toric_edge(t, i, w) == LOFT_ERR_RANGE)
        return;
    for (unsigned k = 0; k <= m; k++) {
        least = fminl(least, exact_of(w[k].w));
        most = fmaxl(most, exact_of(w[k].w));
    }
    if (loft_rational_init(&curve, w, m) != LOFT_OK)
        row_complain(r, "no curve along edge %u", i);
    const long double moved = 4 * off / BY_NUM(least, 1, 1) + 2 * step * m * most / least;
    expect_point(r, LOFT_OK, loft_rational_eval(&curve, u),
                 (law){ .lsb = 0.501L + moved * r->largest * 65536,
                        .gain = 1,
                        .roundings = 64 + moved * 0x1p53L });
}

static void toric_eval(row *r)
{
    loft_lattice_polygon l;
    loft_toric t;
    loft_vec v = { { 0 } };
    loft_spot at;

    if (!toric_of(r, row_text(r, "case"), &l, &t))
        return;
    at.at[0] = aside(r, row_text(r, "x"));
    at.at[1] = aside(r, row_text(r, "y"));
    expect_point(r, loft_toric_eval(&t, at, &v), v, toric_law(&l));
    if (row_is(r, "type", "edge") || row_is(r, "type", "vertex"))
        expect_edge(r, &t, at);
}


/* Base points */

static bool basepoint_of(row *r, const char *id, loft_basepoint *b)
{
    const sheet *s = sheet_of(r, "basepoint_net");
    uint8_t cut[3] = { 0 };
    unsigned degree = 0;

    r->largest = 0;
    for (unsigned k = 0; k < s->rows; k++) {
        char *const *f = s->field[k];
        if (strcmp(f[0], id) != 0)
            continue;
        degree = (unsigned)decimal(r, f[1]);
        const uint8_t l[3] = { (uint8_t)decimal(r, f[5]), (uint8_t)decimal(r, f[6]),
                               (uint8_t)decimal(r, f[7]) };
        if (l[0] + l[1] + l[2] != (int)degree || degree > LOFT_DEGREE_MAX) {
            row_complain(r, "an index of %s does not sum to %u", id, degree);
            return false;
        }
        for (int i = 0; i < 3; i++)
            cut[i] = (uint8_t)decimal(r, f[2 + i]);
        const unsigned rank = loft_multiindex_rank(l, 3);
        weight[rank] = aside(r, f[8]);
        read_point(r, f + 9, rank);
    }
    if (loft_basepoint_init(b, point, weight, degree, cut) != LOFT_OK)
        row_complain(r, "the patch %s was refused", id);
    return !r->complaint[0];
}

static law basepoint_law(const loft_basepoint *b)
{
    return (law) { .lsb = 0.5L + 0x1p-10L, .gain = 1, .roundings = 8 * b->degree + 60 };
}

/* A corner that is not cut is its control point, one that is cut is no point. */
static void basepoint_net(row *r)
{
    static const loft_unit corner[3][2] = { { LOFT_UNIT(1), 0 }, { 0, LOFT_UNIT(1) }, { 0, 0 } };
    const char *const name[3] = { "i", "j", "k" };
    loft_basepoint b;
    loft_vec v = { { 0 } };

    if (!basepoint_of(r, row_text(r, "case"), &b))
        return;
    for (int c = 0; c < 3; c++) {
        const enum loft_status status = loft_basepoint_eval(&b, corner[c][0], corner[c][1], &v);
        if ((status == LOFT_SINGULAR) != (b.cut[c] != 0))
            row_complain(r, "corner %d: status %d", c + 1, status);
        else if (!b.cut[c] && row_count(r, name[c], b.degree) == b.degree)
            expect_point(r, status, v, (law) { .lsb = 0, .gain = 1, .roundings = 2 });
    }
}

static void basepoint_eval(row *r)
{
    loft_basepoint b;
    loft_vec v = { { 0 } };

    if (!basepoint_of(r, row_text(r, "case"), &b))
        return;
    const loft_unit one = decimal_unit(r, row_text(r, "phi_1")),
                    two = decimal_unit(r, row_text(r, "phi_2"));
    expect_point(r, loft_basepoint_eval(&b, one, two, &v), v, basepoint_law(&b));
}

static void basepoint_uv(row *r)
{
    loft_basepoint b;
    loft_vec v = { { 0 } };

    if (!basepoint_of(r, row_text(r, "case"), &b))
        return;
    const loft_unit x = decimal_unit(r, row_text(r, "u")), y = decimal_unit(r, row_text(r, "v"));
    expect_point(r, loft_basepoint_uv(&b, x, y, &v), v, basepoint_law(&b));
}

static void basepoint_boundary(row *r)
{
    static const char *const edge[3] = { "phi3=0", "phi1=0", "phi2=0" }, *const corner[3] = {
        "corner1", "corner2", "corner3"
    };
    loft_basepoint b;
    loft_vec v = { { 0 } };

    if (!basepoint_of(r, row_text(r, "case"), &b))
        return;
    const unsigned number = row_count(r, "number", 6) - 1;
    const loft_basepoint_side s = loft_basepoint_side_of(&b, number);
    row_expect_word(r, "side", s.cut ? corner[s.corner] : edge[s.corner]);
    expect_int(r, "degree", s.degree);
    const loft_unit t = decimal_unit(r, row_text(r, "t"));
    expect_point(r, loft_basepoint_boundary(&b, number, t, &v), v, basepoint_law(&b));
}


/* Zheng-Ball patches */

static unsigned ring_place(row *r, const char *text, unsigned n, unsigned d)
{
    int l[LOFT_ZHENG_BALL_SIDES + 1];
    uint8_t own[LOFT_ZHENG_BALL_SIDES];
    const unsigned count = loft_zheng_ball_count(n, d);

    if (wholes(text, l, LOFT_ZHENG_BALL_SIDES + 1) == n)
        for (unsigned k = 0; k < count; k++) {
            unsigned same = 0;
            loft_zheng_ball_index(n, d, k, own);
            for (unsigned i = 0; i < n; i++)
                same += own[i] == l[i];
            if (same == n)
                return k;
        }
    row_complain(r, "no control point %.30s", text);
    return 0;
}

static bool ring_of(row *r, const char *id, loft_zheng_ball *ring)
{
    const sheet *s = sheet_of(r, "zb_net");
    unsigned found = 0, n = 0, d = 0;

    r->largest = 0;
    for (unsigned k = 0; k < s->rows; k++) {
        char *const *f = s->field[k];
        if (strcmp(f[0], id) != 0)
            continue;
        n = (unsigned)decimal(r, f[1]);
        d = (unsigned)decimal(r, f[2]);
        read_point(r, f + 4, ring_place(r, f[3], n, d));
        found++;
    }
    if (!found || found != loft_zheng_ball_count(n, d))
        row_complain(r, "the net of %s has %u points", id, found);
    else if (loft_zheng_ball_init(ring, point, n, d) != LOFT_OK)
        row_complain(r, "the patch %s was refused", id);
    return !r->complaint[0];
}

static bool params_of(row *r, unsigned n, loft_sci u[])
{
    const loft_unit one = decimal_unit(r, row_text(r, "u1")),
                    two = decimal_unit(r, row_text(r, "u2"));
    const enum loft_status status = loft_zheng_ball_params(n, one, two, u);

    if (status != LOFT_OK)
        row_complain(r, "no parameters: status %d", status);
    return status == LOFT_OK;
}

static void zb_net(row *r)
{
    loft_zheng_ball ring;
    ring_of(r, row_text(r, "case"), &ring);
}

static void expect_params(row *r, const loft_sci u[], unsigned first, unsigned n)
{
    r->largest = 1;
    for (unsigned i = first; i < n; i++) {
        char column[16];
        loft_acc x = 0;
        snprintf(column, sizeof column, "u%u", i + 1);
        if (!loft_sci_to_acc(u[i], &x))
            row_complain(r, "%s does not fit", column);
        expect_wide(r, column, x, (law) { .lsb = 0x1p-16L, .gain = 16, .roundings = 1024 });
    }
}

static void zb_params(row *r)
{
    const unsigned n = row_count(r, "n", LOFT_ZHENG_BALL_SIDES);
    loft_sci u[LOFT_ZHENG_BALL_SIDES];

    if (params_of(r, n, u))
        expect_params(r, u, 2, n);
}

static void zb_lift3(row *r)
{
    loft_sci u[3];

    if (loft_zheng_ball_lift(decimal_unit(r, row_text(r, "b1")), decimal_unit(r, row_text(r, "b2")),
                             u) != LOFT_OK)
        row_complain(r, "the lift was refused");
    else
        expect_params(r, u, 0, 3);
}

static void zb_basis(row *r)
{
    static loft_sci b[POINTS];
    const unsigned n = row_count(r, "n", LOFT_ZHENG_BALL_SIDES),
                   d = row_count(r, "d", LOFT_DEGREE_MAX);
    loft_sci u[LOFT_ZHENG_BALL_SIDES];
    loft_acc x = 0;

    const unsigned place = ring_place(r, row_text(r, "lambda"), n, d);
    if (r->complaint[0] || !params_of(r, n, u))
        return;
    loft_zheng_ball_weights(n, d, u, b);
    if (!loft_sci_to_acc(b[place], &x))
        row_complain(r, "the weight does not fit");
    r->largest = 1;
    expect_wide(r, "B", x, (law) { .lsb = 0x1p-16L, .gain = 64, .roundings = 4096 });
}

static void zb_eval(row *r)
{
    loft_zheng_ball ring;
    loft_sci u[LOFT_ZHENG_BALL_SIDES];
    loft_vec v = { { 0 } };

    if (!ring_of(r, row_text(r, "case"), &ring) || !params_of(r, ring.sides, u))
        return;
    expect_point(r, loft_zheng_ball_eval(&ring, u, &v), v,
                 (law){ .lsb = 0.5L + 0x1p-10L, .gain = 64, .roundings = 4096 });
}

const vector_system vectors_npatch[] = {
    { "toric_edges", "case,n,i,vx,vy,ex,ey,a,m", toric_edges, "exact" },
    { "toric_net", "case,lx,ly,c,w,X,Y,Z", toric_net,
      "corners: q16 exact; floats 2 ulp of double" },
    { "toric_eval", "case,type,x,y,X,Y,Z", toric_eval,
      "q16 1/2 LSB + (N + 2 H) 2^-28 LSB; floats 1/2 ulp + (N + 128 H) ulp of double; the edges as "
      "curves: and what rounded weights and parameters make of it" },
    { "basepoint_net", "case,d,a,b,c,i,j,k,w,X,Y,Z", basepoint_net,
      "corners and base points: exact" },
    { "basepoint_eval", "case,phi_1,phi_2,X,Y,Z", basepoint_eval,
      "q16 1/2 LSB + 2^-10 LSB; floats 1/2 ulp + (8 d + 60) ulp of double" },
    { "basepoint_boundary", "case,number,side,degree,t,X,Y,Z", basepoint_boundary,
      "q16 1/2 LSB + 2^-10 LSB; floats 1/2 ulp + (8 d + 60) ulp of double" },
    { "basepoint_uv", "case,u,v,X,Y,Z", basepoint_uv,
      "q16 1/2 LSB + 2^-10 LSB; floats 1/2 ulp + (8 d + 60) ulp of double" },
    { "zb_net", "case,n,d,lambda,x,y,z", zb_net, "exact" },
    { "zb_params", "n,u1,u2,u3,u4,u5,u6", zb_params, "q16 2^-32; floats 1024 ulp of double" },
    { "zb_basis", "n,d,u1,u2,lambda,B", zb_basis, "q16 2^-32; floats 4096 ulp of double" },
    { "zb_eval", "case,n,d,u1,u2,X,Y,Z", zb_eval,
      "q16 1/2 LSB + 2^-10 LSB; floats 1/2 ulp + 4096 ulp of double" },
    { "zb_lift3", "b1,b2,u1,u2,u3", zb_lift3, "q16 2^-32; floats 1024 ulp of double" },
    { 0 }
};
