/* tests/vectors/vectors_woven.c -- readers of surfaces from several curves: frames, networks,
 * grids, holes
 * SPDX-License-Identifier: MIT
 */
#include "vectors/vectors_points.h"         /* expect_vecs, as_given; row, answer, law */
#include "curve/moving_frame.h"
#include "polygon/hole.h"
#include "surface/tensor/ferguson.h"
#include "surface/tensor/gordon.h"
#include "surface/tensor/gregory.h"

#define PLACES 16
#define ORDER  (LOFT_DEGREE_MAX + 1)

static void moving_frame(row *r)
{
    const unsigned k = row_count(r, "k", PLACES - 1);
    loft_vec at[PLACES], tangent[PLACES], up, point, place = { { 0 } };
    loft_moving_frame f;

    row_points(r, "P_q16", k + 1, 3, at);
    row_points(r, "T_q16", k + 1, 3, tangent);
    row_points(r, "up_q16", 1, 3, &up);
    row_points(r, "point_q16", 1, 3, &point);
    if (!as_given(r))
        return;
    enum loft_status status = loft_moving_frame_start(&f, at[0], tangent[0], up);
    for (unsigned i = 1; i <= k && status == LOFT_OK; i++)
        status = loft_moving_frame_move(&f, at[i], tangent[i]);
    if (status == LOFT_OK)
        status = loft_moving_frame_point(&f, point, &place);
    /* f32, f64: 13 frames of 2^-46 each, times a point of 64 */
    expect_vecs(r, "place", status, &place, 1, 3, (law){ .lsb = 0.501L, .roundings = 64 });
}

static void ferguson_grid(row *r)
{
    static loft_vec p[36];
    const unsigned rows = row_count(r, "rows", 6), columns = row_count(r, "columns", 6),
                   i = row_count(r, "i", 5), j = row_count(r, "j", 5);
    const enum loft_twist twist = row_is(r, "twist", "zero")    ? LOFT_TWIST_ZERO
                                  : row_is(r, "twist", "adini") ? LOFT_TWIST_ADINI
                                                                : LOFT_TWIST_BESSEL;
    loft_bicubic b = { { { { { 0 } } } } };

    row_points(r, "p_q16", rows * columns, 3, p);
    const enum loft_status status = loft_bicubic_from_grid(p, rows, columns, i, j, twist, &b);
    if (as_given(r))
        expect_vecs(r, "at", status, &b.at[0][0], 16, 3, (law){ .lsb = 0.5L, .roundings = 16 });
}

static void gregory(row *r)
{
    static const struct {
        const char *column;
        unsigned j, k, grow;
    } slope[6] = { { "S", 0, 0, 1 },    { "Su", 1, 0, 12 },  { "Sv", 0, 1, 12 },
                   { "Suu", 2, 0, 90 }, { "Suv", 1, 1, 90 }, { "Svv", 0, 2, 90 } };
    const loft_unit u = row_unit(r, "u_q16"), v = row_unit(r, "v_q16");
    loft_vec p[LOFT_GREGORY_POINTS], out = { { 0 } };
    loft_gregory g;

    row_points(r, "p_q16", LOFT_GREGORY_POINTS, 3, p);
    if (!as_given(r))
        return;
    if (loft_gregory_init(&g, p) != LOFT_OK) {
        row_complain(r, "the patch was refused");
        return;
    }
    for (int o = 0; o < 6; o++) {
        const enum loft_status status = loft_gregory_deriv(&g, slope[o].j, slope[o].k, u, v, &out);
        expect_vecs(
            r, slope[o].column, status, &out, 1, 3,
            (law){ .lsb = 0.5L + slope[o].grow * 0x1p-20L, .roundings = 32 * slope[o].grow });
    }
}

/* `count` Bezier curves of one degree, one after the other. */
static void row_sides(row *r, const char *column, unsigned count, unsigned degree, loft_vec p[],
                      loft_bezier b[], loft_side side[])
{
    row_points(r, column, count * (degree + 1), 3, p);
    for (unsigned k = 0; k < count; k++) {
        if (loft_bezier_init(&b[k], p + k * (degree + 1), degree) != LOFT_OK)
            row_complain(r, "column %s: a curve was refused", column);
        side[k] = loft_side_from_bezier(&b[k]);
    }
}

static void gordon(row *r)
{
    static loft_vec by_u[5 * ORDER], by_v[5 * ORDER];
    const unsigned rows = row_count(r, "rows", 5), columns = row_count(r, "columns", 5),
                   m = row_count(r, "m", LOFT_DEGREE_MAX), n = row_count(r, "n", LOFT_DEGREE_MAX);
    const loft_unit u = row_unit(r, "u_q16"), v = row_unit(r, "v_q16");
    loft_bezier along_u[5], along_v[5];
    loft_side side_u[5], side_v[5];
    loft_gordon_point memory[25];
    loft_unit at_u[5], at_v[5];
    loft_real place[5];
    loft_vec out = { { 0 } };
    loft_gordon g;

    row_sides(r, "U_q16", columns, m, by_u, along_u, side_u);
    row_sides(r, "V_q16", rows, n, by_v, along_v, side_v);
    const long double largest = r->largest;
    row_reals(r, "up_q16", rows, place);
    for (unsigned k = 0; k < rows; k++)
        at_u[k] = loft_unit_from(place[k]);
    row_reals(r, "vp_q16", columns, place);
    for (unsigned k = 0; k < columns; k++)
        at_v[k] = loft_unit_from(place[k]);
    r->largest = largest;
    if (!as_given(r))
        return;
    if (loft_gordon_init(&g, side_u, at_v, columns, side_v, at_u, rows, LOFT_REAL(0.001), memory) !=
        LOFT_OK) {
        row_complain(r, "the network was refused");
        return;
    }
    /* L is below 24 where steps differ by 1:7 */
    expect_vecs(r, "S", loft_gordon_eval(&g, u, v, &out), &out, 1, 3,
                (law){ .lsb = 0.501L + 24 * 4 * 0x1p-17L, .roundings = 64 * 24 });
}

static void hole_net(row *r)
{
    static loft_vec edge[LOFT_SIDES_MAX * ORDER], across[LOFT_SIDES_MAX * ORDER], net[201];
    const unsigned n = row_count(r, "n", LOFT_SIDES_MAX), d = row_count(r, "d", LOFT_DEGREE_MAX),
                   m = row_count(r, "m", LOFT_DEGREE_MAX);
    loft_hole_side side[LOFT_SIDES_MAX];
    loft_vec split[LOFT_SIDES_MAX];
    loft_acc gap;

    row_points(r, "E_q16", n * (m + 1), 3, edge);
    row_points(r, "N_q16", n * (m + 1), 3, across);
    for (unsigned i = 0; i < n; i++)
        if (loft_bezier_init(&side[i].edge, edge + i * (m + 1), m) != LOFT_OK ||
            loft_bezier_init(&side[i].across, across + i * (m + 1), m) != LOFT_OK) {
            row_complain(r, "a side was refused");
            return;
        }
    const enum loft_status status = loft_gb_from_hole(side, n, d, net, split, &gap);
    if (!as_given(r))
        return;
    /* row 4 errs by 3 LSB, V0, a mean of such points, by 1/2 more */
    const long double ulps = BY_NUM(0, 0x1p31L, 0x1p10L);       /* f32: 4 ulp, as hole.h states */
    const law l = { .lsb = 3.6L, .roundings = ulps };
    expect_vecs(r, "net", status, net, loft_gb_count(n, d), 3, l);
    expect_vecs(r, "split", status, split, n, 3, (law){ .lsb = 1.001L, .roundings = ulps });
}

const vector_system vectors_woven[] = {
    { "moving_frame", "k,P_q16,T_q16,up_q16,point_q16,place", moving_frame, "1/2 + 2^-16" },
    { "ferguson_grid", "rows,columns,p_q16,i,j,twist,at", ferguson_grid, "1/2" },
    { "gregory", "p_q16,u_q16,v_q16,S,Su,Sv,Suu,Suv,Svv", gregory, "1/2 + f 2^-20" },
    { "gordon", "rows,columns,m,n,U_q16,V_q16,up_q16,vp_q16,u_q16,v_q16,S", gordon,
      "1/2 + L 2^-15" },
    { "hole_net", "n,d,m,E_q16,N_q16,net,split", hole_net, "row 1: 1; row k: k / 2 + 1" },
    { 0 }
};
