/* host-tools/engine/kinematics.c -- kinematics of a machine
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "engine/kinematics.h"

/* of an arm: its largest sideways reach, 8 degrees above horizontal */
#define FLAT   0.99
#define POLE   1e-6         /* mm: closer than this is the pole */
#define PI     3.14159265358979323846

static const struct {
    const char *name;
    enum engine_kinematics kind;
} names[] = { { "cartesian", ENGINE_CARTESIAN },
              { "corexy", ENGINE_COREXY },
              { "hbot", ENGINE_COREXY },
              { "polar", ENGINE_POLAR },
              { "delta", ENGINE_DELTA } };

kinematics kinematics_usual(void)
{
    kinematics k = { .turn = 360, .inside = 1, .tower_angle = { 210, 330, 90 } };

    kinematics_ready(&k);
    return k;
}

void kinematics_ready(kinematics *k)
{
    const double origin[ENGINE_AXES] = { 0, 0, 0 };

    memset(k->geometry, 0, sizeof k->geometry);
    memset(k->zero, 0, sizeof k->zero);
    if (k->kind == ENGINE_POLAR)
        k->geometry[0] = k->turn;
    if (k->kind != ENGINE_DELTA)
        return;
    k->geometry[0] = k->arm_length;
    for (int i = 0; i < ENGINE_AXES; i++) {
        k->geometry[1 + 2 * i] = k->delta_radius * cos(k->tower_angle[i] * PI / 180);
        k->geometry[2 + 2 * i] = k->delta_radius * sin(k->tower_angle[i] * PI / 180);
    }
    (void)engine_f64.maps->motors(k->kind, k->geometry, origin, k->zero);
}

const char *kinematics_name(const kinematics *k)
{
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        if (names[i].kind == k->kind && !k->hbot)
            return names[i].name;
    return "hbot";
}

bool kinematics_find(kinematics *k, const char *name, size_t length)
{
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        if (strlen(names[i].name) == length && strncmp(names[i].name, name, length) == 0) {
            k->kind = names[i].kind;
            k->hbot = strcmp(names[i].name, "hbot") == 0;
            return true;
        }
    return false;
}

const char *kinematics_axes(const kinematics *k)
{
    return k->kind == ENGINE_CARTESIAN ? "xyz" : "abc";
}


// Places
// ------

static void offset_from_center(const kinematics *k, const double tool[ENGINE_AXES],
                               double out[ENGINE_AXES])
{
    for (int i = 0; i < ENGINE_AXES; i++)
        out[i] = tool[i] - k->center[i];
}

bool kinematics_beyond(const kinematics *k, const double tool[ENGINE_AXES], char why[160])
{
    double at[ENGINE_AXES];

    offset_from_center(k, tool, at);
    const double out = hypot(at[0], at[1]);
    if (k->kind == ENGINE_POLAR && out < k->inside)
        return snprintf(why, 160,
                        "%.3g mm from the pole, where the angle would have to turn too fast: keep "
                        "%g mm away, or lower `inside`",
                        out, k->inside) > 0;
    for (int i = 0; k->kind == ENGINE_DELTA && i < ENGINE_AXES; i++) {
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

void kinematics_motors(const kinematics *k, const double tool[ENGINE_AXES],
                       const double near[ENGINE_AXES], double out[ENGINE_AXES])
{
    double at[ENGINE_AXES];

    if (k->kind == ENGINE_CARTESIAN) {
        memcpy(out, tool, ENGINE_AXES * sizeof *out);
        return;
    }
    offset_from_center(k, tool, at);
    (void)engine_f64.maps->motors(k->kind, k->geometry, at, out);
    for (int i = 0; i < ENGINE_AXES; i++)
        out[i] -= k->zero[i];
    if (k->kind == ENGINE_POLAR)
        out[1] = hypot(at[0], at[1]) < POLE
                     ? near[1]
                     : out[1] + k->turn * round((near[1] - out[1]) / k->turn);
}

bool kinematics_tool(const kinematics *k, const double motors[ENGINE_AXES], double out[ENGINE_AXES])
{
    double at[ENGINE_AXES];

    if (k->kind == ENGINE_CARTESIAN) {
        memcpy(out, motors, ENGINE_AXES * sizeof *out);
        return true;
    }
    for (int i = 0; i < ENGINE_AXES; i++)
        at[i] = motors[i] + k->zero[i];
    if (!engine_f64.maps->tool(k->kind, k->geometry, at, out))
        return false;
    for (int i = 0; i < ENGINE_AXES; i++)
        out[i] += k->center[i];
    return true;
}


// Motion
// ------

/* An arm of a delta, from its carriage to the tool at `tool`. */
static void arm_of(const kinematics *k, int i, const double tool[ENGINE_AXES],
                   double out[ENGINE_AXES])
{
    double at[ENGINE_AXES];

    offset_from_center(k, tool, at);
    out[0] = at[0] - k->geometry[1 + 2 * i];
    out[1] = at[1] - k->geometry[2 + 2 * i];
    out[2] = -sqrt(fmax(k->arm_length * k->arm_length - out[0] * out[0] - out[1] * out[1], 0));
}

static double dot_product(const double a[ENGINE_AXES], const double b[ENGINE_AXES])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Delta: the length of an arm P is constant, so P (v - v_carriage) = 0. Polar: v along and across
 * the radius. */
void kinematics_slope(const kinematics *k, const double tool[ENGINE_AXES],
                      const double v[ENGINE_AXES], double out[ENGINE_AXES])
{
    double at[ENGINE_AXES];

    offset_from_center(k, tool, at);
    memcpy(out, v, ENGINE_AXES * sizeof *out);
    if (k->kind == ENGINE_COREXY) {
        out[0] = v[0] + v[1];
        out[1] = v[0] - v[1];
    } else if (k->kind == ENGINE_POLAR) {
        const double r2 = at[0] * at[0] + at[1] * at[1];
        out[0] = (at[0] * v[0] + at[1] * v[1]) / sqrt(r2);
        out[1] = (at[0] * v[1] - at[1] * v[0]) / r2 * k->turn / (2 * PI);
    } else if (k->kind == ENGINE_DELTA) {
        for (int i = 0; i < ENGINE_AXES; i++) {
            double arm[ENGINE_AXES];
            arm_of(k, i, tool, arm);
            out[i] = dot_product(arm, v) / arm[2];
        }
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
static void move_delta(const kinematics *k, const kinematics_moving *m, kinematics_moving *t)
{
    double arm[ENGINE_AXES][ENGINE_AXES], right[ENGINE_AXES];

    for (int i = 0; i < ENGINE_AXES; i++) {
        arm_of(k, i, t->x, arm[i]);
        right[i] = arm[i][2] * m->v[i];
    }
    solve_rows(arm, right, t->v);
    for (int i = 0; i < ENGINE_AXES; i++) {
        const double by[ENGINE_AXES] = { t->v[0], t->v[1], t->v[2] - m->v[i] };
        right[i] = arm[i][2] * m->a[i] - dot_product(by, by);
    }
    solve_rows(arm, right, t->a);
}

static void move_polar(const kinematics *k, const kinematics_moving *m, kinematics_moving *t)
{
    const double per = 2 * PI / k->turn, r = m->x[0], angle = m->x[1] * per, c = cos(angle),
                 s = sin(angle);
    const double w = m->v[1] * per, dw = m->a[1] * per, along = m->a[0] - r * w * w,
                 across = r * dw + 2 * m->v[0] * w;

    t->v[0] = c * m->v[0] - s * r * w;
    t->v[1] = s * m->v[0] + c * r * w;
    t->a[0] = c * along - s * across;
    t->a[1] = s * along + c * across;
}

bool kinematics_move(const kinematics *k, const kinematics_moving *m, kinematics_moving *t)
{
    *t = *m;
    if (!kinematics_tool(k, m->x, t->x))
        return false;
    if (k->kind == ENGINE_COREXY) {
        for (int i = 0; i < 2; i++) {
            t->v[i] = (m->v[0] + (i ? -1 : 1) * m->v[1]) / 2;
            t->a[i] = (m->a[0] + (i ? -1 : 1) * m->a[1]) / 2;
        }
    } else if (k->kind == ENGINE_POLAR) {
        move_polar(k, m, t);
    } else if (k->kind == ENGINE_DELTA) {
        move_delta(k, m, t);
    }
    return true;
}


// Lengths
// -------

/* CoreXY: distances of the motors are sqrt(2) times those of the tool, so z is scaled alike. Polar:
 * an angle counts as its arc where the path is farthest out; if the unit of the angle is longer,
 * the other motors are scaled up to it. */
void kinematics_scale(const kinematics *k, double farthest, double scale[ENGINE_AXES])
{
    scale[0] = scale[1] = scale[2] = 1;
    if (k->kind == ENGINE_COREXY)
        scale[2] = sqrt(2);
    if (k->kind == ENGINE_POLAR) {
        const double arc = farthest * 2 * PI / k->turn, unit = arc < 1 && arc > 0 ? 1 / arc : 1;
        scale[0] = scale[2] = unit;
        scale[1] = unit * arc > 1 ? unit * arc : 1;
    }
}

/* The smallest eigenvalue of the symmetric g, from its invariants (the trigonometric solution of
 * the cubic). */
static double smallest_eigenvalue(double g[3][3])
{
    const double mean = (g[0][0] + g[1][1] + g[2][2]) / 3,
                 off = g[0][1] * g[0][1] + g[0][2] * g[0][2] + g[1][2] * g[1][2];
    double b[3][3], size = 2 * off;

    for (int i = 0; i < 3; i++)
        size += (g[i][i] - mean) * (g[i][i] - mean);
    size = sqrt(size / 6);
    if (!(size > 1e-12 * mean))
        return mean;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            b[i][j] = (g[i][j] - (i == j ? mean : 0)) / size;
    const double half = (b[0][0] * (b[1][1] * b[2][2] - b[1][2] * b[2][1]) -
                         b[0][1] * (b[1][0] * b[2][2] - b[1][2] * b[2][0]) +
                         b[0][2] * (b[1][0] * b[2][1] - b[1][1] * b[2][0])) /
                        2;
    return mean + 2 * size * cos(acos(fmin(fmax(half, -1), 1)) / 3 + 2 * PI / 3);
}

/* The squared length is v^T g v. */
double kinematics_least(const kinematics *k, const double tool[ENGINE_AXES],
                        const double scale[ENGINE_AXES])
{
    double column[3][3], g[3][3];

    for (int j = 0; j < 3; j++) {
        const double v[3] = { j == 0, j == 1, j == 2 };
        kinematics_slope(k, tool, v, column[j]);
        for (int i = 0; i < 3; i++)
            column[j][i] *= scale[i];
    }
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            g[i][j] = dot_product(column[i], column[j]);
    return sqrt(fmax(smallest_eigenvalue(g), 0));
}

void kinematics_text(const kinematics *k, char out[KINEMATICS_TEXT])
{
    size_t used = 0;

    out[0] = '\0';
    if (k->kind == ENGINE_CARTESIAN)
        return;
    used += (size_t)snprintf(out, KINEMATICS_TEXT, "# kinematics = %s\n", kinematics_name(k));
    if (k->kind == ENGINE_POLAR)
        used += (size_t)snprintf(out + used, KINEMATICS_TEXT - used,
                                 "# turn = %.17g\n# inside = %.17g\n", k->turn, k->inside);
    if (k->kind == ENGINE_DELTA)
        used += (size_t)snprintf(out + used, KINEMATICS_TEXT - used,
                                 "# arm_length = %.17g\n# delta_radius = %.17g\n", k->arm_length,
                                 k->delta_radius);
    for (int i = 0; k->kind == ENGINE_DELTA && i < ENGINE_AXES; i++)
        used += (size_t)snprintf(out + used, KINEMATICS_TEXT - used, "# %c.tower_angle = %.17g\n",
                                 "abc"[i], k -> tower_angle[i]);
    for (int i = 0; k->kind != ENGINE_COREXY && i < ENGINE_AXES; i++)
        used += (size_t)snprintf(out + used, KINEMATICS_TEXT - used, "# %c.center = %.17g\n",
                                 "xyz"[i], k -> center[i]);
}
