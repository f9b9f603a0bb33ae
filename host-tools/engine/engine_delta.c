/* host-tools/engine/engine_delta.c -- kinematics of linear deltas: three towers, carriages, arms
 * SPDX-License-Identifier: MIT
 *
 * Compiled once per number type. `geometry` is the arm, then x and y of each tower.
 */
#include <stdio.h>
#include <string.h>

#include "kinematics/kinematics.h"  /* loft_delta */

#include "engine/engine_num.h"      /* real_of, vec_of, point_of */
#include "engine/machine_kinematics.h"

#define FLAT  0.99          /* the largest reach of an arm, of its length: 8 degrees up */
#define APART 30            /* degrees between towers, at least */

static void delta_prepare(kinematics *k)
{
    k->geometry[0] = k->arm_length;
    for (int i = 0; i < ENGINE_AXES; i++) {
        k->geometry[1 + 2 * i] = k->delta_radius * cos(k->tower_angle[i] * KINEMATICS_PI / 180);
        k->geometry[2 + 2 * i] = k->delta_radius * sin(k->tower_angle[i] * KINEMATICS_PI / 180);
    }
}

static bool delta_faulty(const kinematics *k, kinematics_fault *why)
{
    if (!(k->arm_length > 0 && k->delta_radius > 0)) {
        why->key = NULL;
        return snprintf(why->text, sizeof why->text,
                        "kinematics = delta needs %s as well: give it in mm",
                        k->arm_length > 0 ? "delta_radius" : "arm_length") > 0;
    }
    why->key = "delta_radius";
    if (k->delta_radius > FLAT * k->arm_length)
        return snprintf(why->text, sizeof why->text,
                        "arms of %g mm do not reach the middle from %g mm: give a delta_radius of "
                        "at most %g times arm_length",
                        k->arm_length, k->delta_radius, FLAT) > 0;
    why->key = "tower_angle";
    for (int i = 0; i < ENGINE_AXES; i++)
        if (fabs(remainder(k->tower_angle[i] - k->tower_angle[(i + 1) % ENGINE_AXES], 360)) < APART)
            return snprintf(why->text, sizeof why->text,
                            "two towers at %g and %g degrees: give them angles %d degrees apart, "
                            "as 210, 330 and 90",
                            k->tower_angle[i], k->tower_angle[(i + 1) % ENGINE_AXES], APART) > 0;
    return false;
}

static bool delta_beyond(const kinematics *k, const double at[ENGINE_AXES], char why[160])
{
    for (int i = 0; i < ENGINE_AXES; i++) {
        const double far = hypot(at[0] - k->geometry[1 + 2 * i], at[1] - k->geometry[2 + 2 * i]),
                     most = FLAT * k->arm_length;
        if (far > most)
            return snprintf(why, 160,
                            "%.4g mm from the tower of motor %c, and its arm reaches %.4g: move it "
                            "towards the center, or see `center`",
                            far, "abc"[i], most) > 0;
    }
    return false;
}

static bool library_delta(const kinematics *k, loft_delta *out)
{
    for (int i = 0; i < 6; i++)
        if (!real_of(k->geometry[1 + i], &out->tower[i / 2][i % 2]))
            return false;
    return real_of(k->geometry[0], &out->arm);
}

static void delta_motors(const kinematics *k, const double at[ENGINE_AXES],
                         const double near[ENGINE_AXES], double out[ENGINE_AXES])
{
    loft_delta delta;
    loft_vec v;

    (void)near;
    if (vec_of(at, &v) && library_delta(k, &delta))
        point_of(loft_delta_motors(&delta, v), out);
}

static bool delta_tool(const kinematics *k, const double motors[ENGINE_AXES],
                       double at[ENGINE_AXES])
{
    loft_delta delta;
    loft_vec v;

    if (!vec_of(motors, &v) || !library_delta(k, &delta) || !loft_delta_tool(&delta, v, &v))
        return false;
    point_of(v, at);
    return true;
}


// Motion
// ------

/* An arm, from its carriage to the tool. */
static void arm_of(const kinematics *k, int i, const double at[ENGINE_AXES],
                   double out[ENGINE_AXES])
{
    out[0] = at[0] - k->geometry[1 + 2 * i];
    out[1] = at[1] - k->geometry[2 + 2 * i];
    out[2] = -sqrt(fmax(k->arm_length * k->arm_length - out[0] * out[0] - out[1] * out[1], 0));
}

static double dot_product(const double a[ENGINE_AXES], const double b[ENGINE_AXES])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The length of an arm P is constant, so P (v - v_carriage) = 0. */
static void delta_slope(const kinematics *k, const double at[ENGINE_AXES],
                        const double v[ENGINE_AXES], double out[ENGINE_AXES])
{
    for (int i = 0; i < ENGINE_AXES; i++) {
        double arm[ENGINE_AXES];
        arm_of(k, i, at, arm);
        out[i] = dot_product(arm, v) / arm[2];
    }
}

/* Solve row x = right by Cramer's rule. */
static void solve_rows(double row[ENGINE_AXES][ENGINE_AXES], const double right[ENGINE_AXES],
                       double out[ENGINE_AXES])
{
    double turned[ENGINE_AXES][ENGINE_AXES], det = 0;

    for (int i = 0; i < ENGINE_AXES; i++) {
        const double *a = row[(i + 1) % 3], *b = row[(i + 2) % 3];
        turned[i][0] = a[1] * b[2] - a[2] * b[1];
        turned[i][1] = a[2] * b[0] - a[0] * b[2];
        turned[i][2] = a[0] * b[1] - a[1] * b[0];
    }
    det = dot_product(row[0], turned[0]);
    for (int j = 0; j < ENGINE_AXES; j++)
        out[j] = (turned[0][j] * right[0] + turned[1][j] * right[1] + turned[2][j] * right[2]) /
                 det;
}

/* P (v - v_c) = 0, and differentiated: P (a - a_c) + (v - v_c)^2 = 0. */
static void delta_move(const kinematics *k, const double at[ENGINE_AXES],
                       const kinematics_moving *m, kinematics_moving *t)
{
    double arm[ENGINE_AXES][ENGINE_AXES], right[ENGINE_AXES];

    for (int i = 0; i < ENGINE_AXES; i++) {
        arm_of(k, i, at, arm[i]);
        right[i] = arm[i][2] * m->v[i];
    }
    solve_rows(arm, right, t->v);
    for (int i = 0; i < ENGINE_AXES; i++) {
        const double by[ENGINE_AXES] = { t->v[0], t->v[1], t->v[2] - m->v[i] };
        right[i] = arm[i][2] * m->a[i] - dot_product(by, by);
    }
    solve_rows(arm, right, t->a);
}

static size_t delta_text(const kinematics *k, char *out, size_t size)
{
    size_t used = (size_t)snprintf(out, size, "# arm_length = %.17g\n# delta_radius = %.17g\n",
                                   k->arm_length, k->delta_radius);

    for (int i = 0; i < ENGINE_AXES; i++)
        used += (size_t)snprintf(out + used, size - used, "# %c.tower_angle = %.17g\n", "abc"[i],
                                 k->tower_angle[i]);
    return used;
}

const kinematics_kind ENGINE_OF(kinematics_delta) = { .name    = "delta",
                                                      .axes    = "abc",
                                                      .prepare = delta_prepare,
                                                      .faulty  = delta_faulty,
                                                      .beyond  = delta_beyond,
                                                      .motors  = delta_motors,
                                                      .tool    = delta_tool,
                                                      .slope   = delta_slope,
                                                      .move    = delta_move,
                                                      .text    = delta_text };
