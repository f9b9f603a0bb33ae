/* tests/target/polygon.c -- the cost of a point of a patch with n sides on a Cortex-M, in
 * instructions, and its check sum
 * SPDX-License-Identifier: MIT
 *
 * Runs with microbit.c and netduino.ld on an emulated chip, where the debugger prints, or by itself
 * on the host. Prints lines: a name, instructions per point (on the host 0), and a sum over all
 * points, which must be equal bit for bit in q16. tests/bench/bench_polygon.sh runs it.
 */
#include "polygon/basepoint.h"      /* loft_basepoint       */
#include "polygon/gb.h"             /* loft_gb              */
#include "polygon/harmonic.h"       /* loft_harmonic        */
#include "polygon/meanvalue.h"      /* loft_meanvalue_eval  */
#include "polygon/zheng_ball.h"     /* loft_zheng_ball      */
#include "polygon/spatch.h"         /* loft_spatch          */
#include "polygon/toric.h"          /* loft_toric           */
#include "polygon/wachspress.h"     /* loft_wachspress_eval */

#include "say.h"                    /* say_number           */

#if defined(__arm__)
#  include "meter.h"
void debugger_put(char c);
int  main(void);
static void put(char c) { debugger_put(c); }
#else
#  include <stdio.h>
static void put(char c)             { putchar(c); }
static void meter_start(void)       {}
static uint32_t meter_now(void)     { return 0; }
#endif

#define ROUNDS 16
#define TERMS  37           /* 4 powers at each of 5 corners, and a polynomial of degree 8 */

static const loft_spot pentagon[5] = { { { LOFT_REAL(0), LOFT_REAL(1) } },
                                       { { LOFT_REAL(-0.951171875), LOFT_REAL(0.30908203125) } },
                                       { { LOFT_REAL(-0.587890625), LOFT_REAL(-0.80908203125) } },
                                       { { LOFT_REAL(0.587890625), LOFT_REAL(-0.80908203125) } },
                                       { { LOFT_REAL(0.951171875), LOFT_REAL(0.30908203125) } } };
static const loft_whole hexagon[6] = { { { 0, 0 } }, { { 2, 0 } }, { { 3, 1 } },
                                       { { 3, 3 } }, { { 1, 3 } }, { { 0, 2 } } };

static loft_vec p[256];
static loft_real w[256];
static loft_acc coefficient[TERMS * 5];
static loft_domain domain;
static loft_lattice_polygon lattice;
static loft_harmonic harmonic;
static loft_spatch spatch;
static loft_toric toric;
static loft_basepoint basepoint;
static loft_zheng_ball zheng_ball;
static loft_gb gb;
static uint32_t state, sum, begin, cost;

static uint32_t random_coordinate(void)
{
    state = state * 1664525u + 1013904223u;
    return state >> 8;
}

static void add_number(loft_real x) { sum = (sum ^ (uint32_t)x) * 16777619u; }

static void add_vec(const loft_vec *v)
{
    for (int i = 0; i < LOFT_AXES; i++)
        add_number(v->axis[i]);
}

static void add_all(const loft_sci phi[], unsigned n)
{
    for (unsigned i = 0; i < n; i++) {
        loft_acc x = 0;
        if (loft_sci_to_acc(phi[i], &x))
            add_number((loft_real)(x / 65536));
    }
}

/* Print the cost and the sum since the last line. */
static void say_cost(const char *name)
{
    say_words(put, name);
    put(' ');
    say_number(put, cost / ROUNDS);
    put(' ');
    say_number(put, sum);
    put('\n');
    sum = 2166136261u;
    cost = 0;
}

/* The code between start_measuring and stop_measuring is measured; their own cost is subtracted. */
static void start_measuring(void) { begin = meter_now(); }
static void stop_measuring(void)
{
    const uint32_t now = meter_now(), a = meter_now(), b = meter_now();
    cost += now - begin - (b - a);
}

static loft_spot inside(void)
{
    loft_spot s;

    for (int i = 0; i < 2; i++)
        s.at[i] = (loft_real)(random_coordinate() & 0xffff) - 32768;
    return s;
}

static bool prepare_domains(void)
{
    static const uint8_t cut[3] = { 1, 0, 2 };
    static const loft_harmonic_table table = { .coefficient = coefficient,
                                               .terms = TERMS,
                                               .sides = 5,
                                               .degree = 8,
                                               .powers = { 4, 4, 4, 4, 4 } };

    for (int k = 0; k < 256; k++) {
        w[k] = LOFT_REAL(1);
        for (int i = 0; i < LOFT_AXES; i++)
            p[k].axis[i] = (loft_real)(random_coordinate() % 13107200) - 6553600;
    }
    for (int k = 0; k < TERMS * 5; k++)
        coefficient[k] = (loft_acc)random_coordinate() * 64 - 536870912;
    return loft_domain_init(&domain, pentagon, 5) == LOFT_OK &&
           loft_lattice_polygon_init(&lattice, hexagon, 6) == LOFT_OK &&
           loft_harmonic_init(&harmonic, &domain, &table) == LOFT_OK &&
           loft_toric_init(&toric, &lattice, p, NULL, w) == LOFT_OK &&
           loft_basepoint_init(&basepoint, p, w, 5, cut) == LOFT_OK;
}


// Coordinates
// -----------

static void measure_coordinates(const char *name, enum loft_status (*eval)(const loft_domain *,
                                                                           loft_spot, loft_sci[]))
{
    for (int n = 0; n < ROUNDS; n++) {
        const loft_spot s = inside();
        loft_sci phi[5];
        start_measuring();
        const enum loft_status status = eval(&domain, s, phi);
        stop_measuring();
        if (status == LOFT_OK)
            add_all(phi, 5);
    }
    say_cost(name);
}

static enum loft_status harmonic_eval(const loft_domain *d, loft_spot s, loft_sci phi[])
{
    (void)d;
    return loft_harmonic_eval(&harmonic, s, phi);
}


// Patches, from coordinates or parameters
// ---------------------------------------

static void measure_spatches(const char *name, unsigned depth)
{
    if (loft_spatch_init(&spatch, p, NULL, 5, depth) != LOFT_OK)
        return;
    for (int n = 0; n < ROUNDS; n++) {
        loft_sci phi[5];
        loft_vec v = { { 0 } };
        if (loft_wachspress_eval(&domain, inside(), phi) != LOFT_OK)
            continue;
        start_measuring();
        const enum loft_status status = loft_spatch_eval(&spatch, phi, &v);
        stop_measuring();
        add_number((loft_real)status);
        add_vec(&v);
    }
    say_cost(name);
}

static void measure_gbs(const char *name, unsigned degree)
{
    if (loft_gb_init(&gb, p, 5, degree) != LOFT_OK)
        return;
    for (int n = 0; n < ROUNDS; n++) {
        loft_sci phi[5];
        loft_vec v = { { 0 } };
        if (loft_wachspress_eval(&domain, inside(), phi) != LOFT_OK)
            continue;
        start_measuring();
        const enum loft_status status = loft_gb_eval(&gb, phi, &v);
        stop_measuring();
        add_number((loft_real)status);
        add_vec(&v);
    }
    say_cost(name);
}

/* Coordinates with derivatives, derivatives of the patch, curvatures: everything. */
static void measure_curvatures(void)
{
    for (int n = 0; n < ROUNDS; n++) {
        const loft_spot s = inside();
        loft_jet phi[5];
        loft_differential at;
        loft_curvatures k = { 0, 0, 0, 0 };
        start_measuring();
        enum loft_status status = loft_wachspress_jet(&domain, s, phi);
        if (status == LOFT_OK)
            status = loft_gb_differential(&gb, phi, &at);
        if (status == LOFT_OK)
            status = loft_differential_curvatures(&at, &k);
        stop_measuring();
        add_number((loft_real)status);
        add_number((loft_real)(k.gauss & 0xffffffff));
        add_number((loft_real)(k.mean & 0xffffffff));
    }
    say_cost("gb_5_sides_degree_3_curvatures");
}

static void measure_torics(void)
{
    for (int n = 0; n < ROUNDS; n++) {
        const loft_spot s = { { LOFT_REAL(1) + (loft_real)(random_coordinate() & 0xffff),
                                LOFT_REAL(1) + (loft_real)(random_coordinate() & 0xffff) } };
        loft_vec v = { { 0 } };
        start_measuring();
        const enum loft_status status = loft_toric_eval(&toric, s, &v);
        stop_measuring();
        add_number((loft_real)status);
        add_vec(&v);
    }
    say_cost("toric_6_sides_14_points");
}

static void measure_basepoints(void)
{
    for (int n = 0; n < ROUNDS; n++) {
        const loft_unit a = (loft_unit)(random_coordinate() & 0x7fffff),
                        b = (loft_unit)(random_coordinate() & 0x7fffff);
        loft_vec v = { { 0 } };
        start_measuring();
        const enum loft_status status = loft_basepoint_eval(&basepoint, a, b, &v);
        stop_measuring();
        add_number((loft_real)status);
        add_vec(&v);
    }
    say_cost("basepoint_5_sides_degree_5");
}

static void measure_zheng_balls(const char *name, unsigned sides, unsigned degree)
{
    if (loft_zheng_ball_init(&zheng_ball, p, sides, degree) != LOFT_OK)
        return;
    for (int n = 0; n < ROUNDS; n++) {
        const loft_unit a = (loft_unit)(random_coordinate() & 0x7fffff),
                        b = (loft_unit)(random_coordinate() & 0x7fffff);
        loft_sci u[LOFT_ZHENG_BALL_SIDES];
        loft_vec v = { { 0 } };
        start_measuring();
        enum loft_status status = loft_zheng_ball_params(sides, a, b, u);
        if (status == LOFT_OK)
            status = loft_zheng_ball_eval(&zheng_ball, u, &v);
        stop_measuring();
        add_number((loft_real)status);
        add_vec(&v);
    }
    say_cost(name);
}

int main(void)
{
    meter_start();
    state = 1;
    sum = 2166136261u;
    if (!prepare_domains())
        return 1;
    measure_coordinates("wachspress_5_sides", loft_wachspress_eval);
    measure_coordinates("mean_value_5_sides", loft_meanvalue_eval);
    measure_coordinates("harmonic_5_sides_37_terms", harmonic_eval);
    measure_spatches("spatch_5_sides_depth_2", 2);
    measure_spatches("spatch_5_sides_depth_3", 3);
    measure_gbs("gb_5_sides_degree_5", 5);
    measure_gbs("gb_5_sides_degree_3", 3);
    measure_curvatures();
    measure_torics();
    measure_basepoints();
    measure_zheng_balls("ring_3_sides_degree_3", 3, 3);
    measure_zheng_balls("ring_5_sides_degree_3", 5, 3);
    measure_zheng_balls("ring_6_sides_degree_4", 6, 4);
    return 0;
}
