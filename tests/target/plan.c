/* tests/target/plan.c -- plans the outline of 12 cubics: on an emulated chip, and on the host for
 * comparison
 * SPDX-License-Identifier: MIT
 *
 * The chip reports each span to the emulator (plan_chip.c) by writes to GPIOR0, which cost two
 * cycles each. The host prints the spans, and then a comparison with the path.
 */
#include "motion/plan.h"    /* loft_plan */

#define CURVES 12
#define PIECES 6
#define FEED   50       /* mm/s   */
#define ACCEL  500      /* mm/s^2 */

#if defined(__AVR__)
#  include <avr/interrupt.h>
#  include <avr/io.h>
#  include <avr/pgmspace.h>
#  include <avr/sleep.h>
#  define TOLD(x) (GPIOR0 = (x))
#else
#  include <math.h>
#  include <stdio.h>
#  define PROGMEM
#  define pgm_read_dword(at) (*(at))
#endif

static const int32_t outline[CURVES][4][2] PROGMEM = {
#include "outline12.inc"
};

loft_plan plan;
loft_move moves[2];
loft_plan_piece pieces[PIECES];
loft_span span;

static loft_cubic curve_at(unsigned n)
{
    loft_cubic c = { .p = { { .axis = { 0 } } } };

    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 2 && i < LOFT_AXES; i++)
            c.p[k].axis[i] = (int32_t)pgm_read_dword(&outline[n][k][i]);
    return c;
}

static void set_limits(loft_limits *l)
{
    *l = (loft_limits){ .tol = LOFT_REAL(0.005), .tick_hz = 1000 };
    for (int i = 0; i < LOFT_AXES; i++) {
        l->max_speed[i] = LOFT_REAL(160);
        l->max_accel[i] = LOFT_REAL(ACCEL);
    }
}

/* Plan all spans, one after the other, as for a machine without a queue. */
static void plan_outline(void (*take)(void))
{
    unsigned next = 0;

    for (;;) {
        loft_move m = { .feed = LOFT_REAL(FEED) };
        while (next < CURVES && loft_plan_room(&plan) > 0) {
            m.curve = curve_at(next);
            if (loft_plan_push(&plan, &m) != LOFT_OK)
                return;
            next++;
        }
        if (next == CURVES)
            loft_plan_end(&plan);
        const enum loft_plan_state state = loft_plan_next(&plan, &span);
        if (state == LOFT_PLAN_SPAN)
            take();
        else if (next == CURVES)
            return;
    }
}

#if defined(__AVR__)

static void take(void) { TOLD(1); }

int main(void)
{
    loft_limits l;

    set_limits(&l);
    if (loft_plan_init(&plan, &l, moves, 2, pieces, PIECES) != LOFT_OK)
        TOLD(3);
    TOLD(2);
    plan_outline(take);
    cli();
    sleep_enable();
    sleep_cpu();
    return 0;
}

#else

#define SAMPLES 256

static double line[CURVES * SAMPLES + 1][2], worst;
static uint32_t ticks, spans;

static double bezier(const double p[4], double t)
{
    const double u = 1 - t;
    return u * u * u * p[0] + 3 * u * u * t * p[1] + 3 * u * t * t * p[2] + t * t * t * p[3];
}

/* The outline as chords within 2e-5 mm. Returns its length. */
static double set_line(void)
{
    double length = 0;

    for (unsigned n = 0; n <= CURVES * SAMPLES; n++) {
        const unsigned c = n < CURVES * SAMPLES ? n / SAMPLES : CURVES - 1;
        for (int i = 0; i < 2; i++) {
            double p[4];
            for (int k = 0; k < 4; k++)
                p[k] = outline[c][k][i] / 65536.0;
            line[n][i] = bezier(p, (double)(n - c * SAMPLES) / SAMPLES);
        }
        length += n > 0 ? hypot(line[n][0] - line[n - 1][0], line[n][1] - line[n - 1][1]) : 0;
    }
    return length;
}

static double distance_from_line(double x, double y)
{
    double least = 1e9;

    for (unsigned n = 0; n < CURVES * SAMPLES; n++) {
        const double dx = line[n + 1][0] - line[n][0], dy = line[n + 1][1] - line[n][1];
        const double t = fmin(
            1, fmax(0, ((x - line[n][0]) * dx + (y - line[n][1]) * dy) / (dx * dx + dy * dy)));
        least = fmin(least, hypot(line[n][0] + t * dx - x, line[n][1] + t * dy - y));
    }
    return least;
}

static void take(void)
{
    double at[2];

    spans++;
    ticks += span.ticks;
    printf("%d", (int)span.ticks);
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            printf(" %ld", (long)span.p[k].axis[i]);
    printf("\n");
    for (int n = 1; n <= 4; n++) {
        for (int i = 0; i < 2; i++) {
            double p[4];
            for (int k = 0; k < 4; k++)
                p[k] = span.p[k].axis[i] / 65536.0;
            at[i] = bezier(p, n / 4.0);
        }
        worst = fmax(worst, distance_from_line(at[0], at[1]));
    }
}

int main(void)
{
    const double least = set_line() / FEED + (double)FEED / ACCEL;
    loft_limits l;

    set_limits(&l);
    if (loft_plan_init(&plan, &l, moves, 2, pieces, PIECES) != LOFT_OK)
        return 1;
    plan_outline(take);
    fprintf(stderr, "spans %u\nticks %u\nratio %.4f\ndeviation %.6f\n", (unsigned)spans,
            (unsigned)ticks, ticks / 1000.0 / least, worst);
    return 0;
}

#endif
