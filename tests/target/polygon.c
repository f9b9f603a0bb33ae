/* tests/target/polygon.c -- what a point of a patch with n sides costs on a Cortex-M, in
 * instructions, and its check sum
 * SPDX-License-Identifier: MIT
 *
 * With microbit.c and netduino.ld on an emulated chip, where the debugger gives the letters, or
 * alone here. Prints lines: a name, instructions of a point (here 0), a sum over all points, to be
 * equal bit for bit in q16. tests/bench/bench_polygon.sh runs it.
 */
#include "polygon/basepoint.h"      /* loft_basepoint       */
#include "polygon/gb.h"             /* loft_gb              */
#include "polygon/harmonic.h"       /* loft_harmonic        */
#include "polygon/meanvalue.h"      /* loft_meanvalue_eval  */
#include "polygon/zheng_ball.h"           /* loft_ring            */
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
#define TERMS  37           /* 4 powers at each of 5 corners, a polynomial of degree 8 */

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
static loft_ring ring;
static loft_gb gb;
static uint32_t state, sum, begin, cost;

static uint32_t some(void)
{
    state = state * 1664525u + 1013904223u;
    return state >> 8;
}

static void add(loft_real x) { sum = (sum ^ (uint32_t)x) * 16777619u; }

static void add_vec(const loft_vec *v)
{
    for (int i = 0; i < LOFT_AXES; i++)
        add(v->axis[i]);
}

static void add_all(const loft_sci phi[], unsigned n)
{
    for (unsigned i = 0; i < n; i++) {
        loft_acc x = 0;
        if (loft_sci_to_acc(phi[i], &x))
            add((loft_real)(x / 65536));
    }
}

/* The line of what was measured since the last one. */
static void say(const char *name)
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

/* Between them is what is measured, less what measuring takes. */
static void from_here(void) { begin = meter_now(); }
static void to_here(void)
{
    const uint32_t now = meter_now(), a = meter_now(), b = meter_now();
    cost += now - begin - (b - a);
}

static loft_spot inside(void)
{
    loft_spot s;

    for (int i = 0; i < 2; i++)
        s.at[i] = (loft_real)(some() & 0xffff) - 32768;
    return s;
}

static bool prepare(void)
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
            p[k].axis[i] = (loft_real)(some() % 13107200) - 6553600;
    }
    for (int k = 0; k < TERMS * 5; k++)
        coefficient[k] = (loft_acc)some() * 64 - 536870912;
    return loft_domain_init(&domain, pentagon, 5) == LOFT_OK &&
           loft_lattice_polygon_init(&lattice, hexagon, 6) == LOFT_OK &&
           loft_harmonic_init(&harmonic, &domain, &table) == LOFT_OK &&
           loft_toric_init(&toric, &lattice, p, NULL, w) == LOFT_OK &&
           loft_basepoint_init(&basepoint, p, w, 5, cut) == LOFT_OK;
}


// Coordinates
// -----------

static void coordinates(const char *name,
                        enum loft_status (*eval)(const loft_domain *, loft_spot, loft_sci[]))
{
    for (int n = 0; n < ROUNDS; n++) {
        const loft_spot s = inside();
        loft_sci phi[5];
        from_here();
        const enum loft_status status = eval(&domain, s, phi);
        to_here();
        if (status == LOFT_OK)
            add_all(phi, 5);
    }
    say(name);
}

static enum loft_status harmonic_eval(const loft_domain *d, loft_spot s, loft_sci phi[])
{
    (void)d;
    return loft_harmonic_eval(&harmonic, s, phi);
}


// Patches, from coordinates or parameters
// ---------------------------------------

static void spatches(const char *name, unsigned depth)
{
    if (loft_spatch_init(&spatch, p, NULL, 5, depth) != LOFT_OK)
        return;
    for (int n = 0; n < ROUNDS; n++) {
        loft_sci phi[5];
        loft_vec v = { { 0 } };
        if (loft_wachspress_eval(&domain, inside(), phi) != LOFT_OK)
            continue;
        from_here();
        const enum loft_status status = loft_spatch_eval(&spatch, phi, &v);
        to_here();
        add((loft_real)status);
        add_vec(&v);
    }
    say(name);
}

static void gbs(const char *name, unsigned degree)
{
    if (loft_gb_init(&gb, p, 5, degree) != LOFT_OK)
        return;
    for (int n = 0; n < ROUNDS; n++) {
        loft_sci phi[5];
        loft_vec v = { { 0 } };
        if (loft_wachspress_eval(&domain, inside(), phi) != LOFT_OK)
            continue;
        from_here();
        const enum loft_status status = loft_gb_eval(&gb, phi, &v);
        to_here();
        add((loft_real)status);
        add_vec(&v);
    }
    say(name);
}

/* Coordinates with derivatives, derivatives of the patch, curvatures: all of it. */
static void bends(void)
{
    for (int n = 0; n < ROUNDS; n++) {
        const loft_spot s = inside();
        loft_jet phi[5];
        loft_differential at;
        loft_curvatures k = { 0, 0, 0, 0 };
        from_here();
        enum loft_status status = loft_wachspress_jet(&domain, s, phi);
        if (status == LOFT_OK)
            status = loft_gb_differential(&gb, phi, &at);
        if (status == LOFT_OK)
            status = loft_differential_curvatures(&at, &k);
        to_here();
        add((loft_real)status);
        add((loft_real)(k.gauss & 0xffffffff));
        add((loft_real)(k.mean & 0xffffffff));
    }
    say("gb_5_sides_degree_3_curvatures");
}

static void torics(void)
{
    for (int n = 0; n < ROUNDS; n++) {
        const loft_spot s = { { LOFT_REAL(1) + (loft_real)(some() & 0xffff),
                                LOFT_REAL(1) + (loft_real)(some() & 0xffff) } };
        loft_vec v = { { 0 } };
        from_here();
        const enum loft_status status = loft_toric_eval(&toric, s, &v);
        to_here();
        add((loft_real)status);
        add_vec(&v);
    }
    say("toric_6_sides_14_points");
}

static void basepoints(void)
{
    for (int n = 0; n < ROUNDS; n++) {
        const loft_unit a = (loft_unit)(some() & 0x7fffff), b = (loft_unit)(some() & 0x7fffff);
        loft_vec v = { { 0 } };
        from_here();
        const enum loft_status status = loft_basepoint_eval(&basepoint, a, b, &v);
        to_here();
        add((loft_real)status);
        add_vec(&v);
    }
    say("basepoint_5_sides_degree_5");
}

static void rings(const char *name, unsigned sides, unsigned degree)
{
    if (loft_zheng_ball_init(&ring, p, sides, degree) != LOFT_OK)
        return;
    for (int n = 0; n < ROUNDS; n++) {
        const loft_unit a = (loft_unit)(some() & 0x7fffff), b = (loft_unit)(some() & 0x7fffff);
        loft_sci u[LOFT_ZHENG_BALL_SIDES];
        loft_vec v = { { 0 } };
        from_here();
        enum loft_status status = loft_zheng_ball_params(sides, a, b, u);
        if (status == LOFT_OK)
            status = loft_zheng_ball_eval(&ring, u, &v);
        to_here();
        add((loft_real)status);
        add_vec(&v);
    }
    say(name);
}

int main(void)
{
    meter_start();
    state = 1;
    sum = 2166136261u;
    if (!prepare())
        return 1;
    coordinates("wachspress_5_sides", loft_wachspress_eval);
    coordinates("mean_value_5_sides", loft_meanvalue_eval);
    coordinates("harmonic_5_sides_37_terms", harmonic_eval);
    spatches("spatch_5_sides_depth_2", 2);
    spatches("spatch_5_sides_depth_3", 3);
    gbs("gb_5_sides_degree_5", 5);
    gbs("gb_5_sides_degree_3", 3);
    bends();
    torics();
    basepoints();
    rings("ring_3_sides_degree_3", 3, 3);
    rings("ring_5_sides_degree_3", 5, 3);
    rings("ring_6_sides_degree_4", 6, 4);
    return 0;
}
