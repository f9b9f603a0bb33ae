/* tests/vectors/vectors_motion.c -- the reader of moves of one axis
 * SPDX-License-Identifier: MIT
 */
#include "vectors/vectors.h"

#include "motion/scurve.h"

/* f32 moves by other ways and limits where it cannot hold those of the row. */
static void scurve(row *r)
{
    loft_real from, to;
    loft_scurve_limits limits;
    loft_scurve s;
    char text[64];
    answer *a = answer_new();

    row_reals(r, "from_q16", 1, &from);
    row_reals(r, "to_q16", 1, &to);
    row_reals(r, "speed_q16", 1, &limits.max_speed);
    row_reals(r, "accel_q16", 1, &limits.max_accel);
    limits.max_jerk = row_count(r, "jerk", 10000000);
    limits.tick_hz = (uint16_t)row_count(r, "hz", 50000);
    const uint32_t tick = row_count(r, "tick", 3 * LOFT_SCURVE_TICKS);
    if (r->inexact > 0)
        return;
    if (loft_scurve_init(&s, from, to, &limits) != LOFT_OK) {
        row_complain(r, "the move was refused");
        return;
    }
    snprintf(text, sizeof text, "%lu %lu %lu", (unsigned long)s.part[0].cruise,
             (unsigned long)s.part[0].ramp, (unsigned long)s.part[0].ease);
    row_expect_word(r, "parts", text);
    snprintf(text, sizeof text, "%lu", (unsigned long)s.ticks);
    row_expect_word(r, "ticks", text);
    answer_real(a, loft_scurve_eval(&s, tick));
    row_expect(r, "place", a, (law) { .lsb = 0.5L + 1 / 65536.0L, .roundings = 4 });
}

const vector_system vectors_motion[] = {
    { "scurve", "from_q16,to_q16,speed_q16,accel_q16,jerk,hz,tick,parts,ticks,place", scurve,
      "ticks exact, place 1/2 LSB + 2^-16 LSB" },
    { NULL, NULL, NULL, NULL }
};
