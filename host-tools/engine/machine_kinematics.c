/* host-tools/engine/machine_kinematics.c -- kinematics of a machine: the table of the kinds,
 * and what holds for all of them
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "engine/machine_kinematics.h"

const kinematics_kind kinematics_cartesian = {
    .name = "cartesian", .axes = "xyz", .direct = true, .linear = true, .lifts = true
};

static const kinematics_kind *const kinds[] = { &kinematics_cartesian, &kinematics_corexy_f64,
                                                &kinematics_hbot_f64, &kinematics_delta_f64,
                                                &kinematics_polar_f64 };
#define KINDS (sizeof kinds / sizeof kinds[0])

kinematics kinematics_usual(void)
{
    kinematics k = {
        .kind = &kinematics_cartesian, .turn = 360, .inside = 1, .tower_angle = { 210, 330, 90 }
    };

    kinematics_ready(&k);
    return k;
}

void kinematics_ready(kinematics *k)
{
    const double origin[ENGINE_AXES] = { 0, 0, 0 };

    memset(k->geometry, 0, sizeof k->geometry);
    memset(k->zero, 0, sizeof k->zero);
    if (k->kind->prepare == NULL)
        return;
    k->kind->prepare(k);
    k->kind->motors(k, origin, origin, k->zero);
}

bool kinematics_faulty(const kinematics *k, kinematics_fault *why)
{
    return k->kind->faulty != NULL && k->kind->faulty(k, why);
}

const char *kinematics_name(const kinematics *k) { return k->kind->name; }

bool kinematics_find(kinematics *k, const char *name, size_t length)
{
    for (size_t i = 0; i < KINDS; i++)
        if (strlen(kinds[i]->name) == length && strncmp(kinds[i]->name, name, length) == 0) {
            k->kind = kinds[i];
            return true;
        }
    return false;
}

void kinematics_names(char out[KINEMATICS_NAMES])
{
    size_t used = 0;

    for (size_t i = 0; i < KINDS && used < KINEMATICS_NAMES; i++)
        used += (size_t)snprintf(out + used, KINEMATICS_NAMES - used, "%s%s",
                                 i == 0          ? ""
                                 : i < KINDS - 1 ? ", "
                                                 : " or ",
                                 kinds[i]->name);
}

const char *kinematics_axes(const kinematics *k) { return k->kind->axes; }


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
    return k->kind->beyond != NULL && k->kind->beyond(k, at, why);
}

void kinematics_motors(const kinematics *k, const double tool[ENGINE_AXES],
                       const double near[ENGINE_AXES], double out[ENGINE_AXES])
{
    double at[ENGINE_AXES];

    if (k->kind->direct) {
        memcpy(out, tool, ENGINE_AXES * sizeof *out);
        return;
    }
    offset_from_center(k, tool, at);
    k->kind->motors(k, at, near, out);
    for (int i = 0; i < ENGINE_AXES; i++)
        out[i] -= k->zero[i];
}

bool kinematics_tool(const kinematics *k, const double motors[ENGINE_AXES], double out[ENGINE_AXES])
{
    double at[ENGINE_AXES];

    if (k->kind->direct) {
        memcpy(out, motors, ENGINE_AXES * sizeof *out);
        return true;
    }
    for (int i = 0; i < ENGINE_AXES; i++)
        at[i] = motors[i] + k->zero[i];
    if (!k->kind->tool(k, at, out))
        return false;
    for (int i = 0; i < ENGINE_AXES; i++)
        out[i] += k->center[i];
    return true;
}


// Motion
// ------

void kinematics_slope(const kinematics *k, const double tool[ENGINE_AXES],
                      const double v[ENGINE_AXES], double out[ENGINE_AXES])
{
    double at[ENGINE_AXES];

    offset_from_center(k, tool, at);
    memcpy(out, v, ENGINE_AXES * sizeof *out);
    if (k->kind->slope != NULL)
        k->kind->slope(k, at, v, out);
}

bool kinematics_move(const kinematics *k, const kinematics_moving *m, kinematics_moving *t)
{
    double at[ENGINE_AXES];

    *t = *m;
    if (!kinematics_tool(k, m->x, t->x))
        return false;
    offset_from_center(k, t->x, at);
    if (k->kind->move != NULL)
        k->kind->move(k, at, m, t);
    return true;
}


// Lengths
// -------

void kinematics_scale(const kinematics *k, double farthest, double scale[ENGINE_AXES])
{
    scale[0] = scale[1] = scale[2] = 1;
    if (k->kind->scale != NULL)
        k->kind->scale(k, farthest, scale);
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
    return mean + 2 * size * cos(acos(fmin(fmax(half, -1), 1)) / 3 + 2 * KINEMATICS_PI / 3);
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
            g[i][j] = column[i][0] * column[j][0] + column[i][1] * column[j][1] +
                      column[i][2] * column[j][2];
    return sqrt(fmax(smallest_eigenvalue(g), 0));
}

void kinematics_text(const kinematics *k, char out[KINEMATICS_TEXT])
{
    size_t used = 0;

    out[0] = '\0';
    if (k->kind->direct)
        return;
    used += (size_t)snprintf(out, KINEMATICS_TEXT, "# kinematics = %s\n", kinematics_name(k));
    if (k->kind->text != NULL)
        used += k->kind->text(k, out + used, KINEMATICS_TEXT - used);
    for (int i = 0; !k->kind->linear && i < ENGINE_AXES; i++)
        used += (size_t)snprintf(out + used, KINEMATICS_TEXT - used, "# %c.center = %.17g\n",
                                 "xyz"[i], k->center[i]);
}
