/* host-tools/engine/kinematics.h -- kinematics of a machine: the positions of the motors for a
 * place of the tool, and their motion
 * SPDX-License-Identifier: MIT
 *
 * The maps are those of lib/kinematics/kinematics.h in double. Motors are at 0 when the tool is at
 * `center` and z = 0.
 */
#ifndef LOFT_KINEMATICS_H
#define LOFT_KINEMATICS_H

#include "engine/engine.h"         /* engine_kinematics, ENGINE_AXES */

/* Lengths of the tool in mm. Fields of other kinds of kinematics are ignored. */
typedef struct {
    enum engine_kinematics kind;
    bool   hbot;                            /* CoreXY under another name */
    double center[ENGINE_AXES];             /* polar: of the pole, delta: of the middle between the
                                             * towers */
    double arm_length, delta_radius;        /* delta: the length of an arm; from the middle to a
                                             * carriage, minus the tool's joint */
    double tower_angle[ENGINE_AXES];        /* delta: degrees, from x towards y */
    double turn, inside;                    /* polar: units of the angle's axis per turn; the
                                             * smallest distance from the pole */
    double geometry[ENGINE_GEOMETRY], zero[ENGINE_AXES];    /* computed by kinematics_ready */
} kinematics;

/* Position, velocity and acceleration. */
typedef struct {
    double x[ENGINE_AXES], v[ENGINE_AXES], a[ENGINE_AXES];
} kinematics_moving;

/* Cartesian; other kinds have typical numbers where such exist. */
kinematics kinematics_usual(void);

/* Compute the derived fields. */
void kinematics_ready(kinematics *k);

/* "cartesian", "corexy", "hbot", "polar" or "delta"; and the reverse. Returns false for an unknown
 * word. */
const char *kinematics_name(const kinematics *k);
bool kinematics_find(kinematics *k, const char *name, size_t length);

/* The names of the motors, "xyz" or "abc". */
const char *kinematics_axes(const kinematics *k);

/* Is the place out of reach? Then `why` says why: "20.0 mm from the pole .." */
bool kinematics_beyond(const kinematics *k, const double tool[ENGINE_AXES], char why[160]);

/* The motors for a place within reach. An angle is the one closest to that of `near`. */
void kinematics_motors(const kinematics *k, const double tool[ENGINE_AXES],
                       const double near[ENGINE_AXES], double out[ENGINE_AXES]);

/* The tool for positions of the motors. Returns false if the motors cannot be there. */
bool kinematics_tool(const kinematics *k, const double motors[ENGINE_AXES],
                     double out[ENGINE_AXES]);

/* The speeds of the motors when the tool, at a place within reach, moves with v. */
void kinematics_slope(const kinematics *k, const double tool[ENGINE_AXES],
                      const double v[ENGINE_AXES], double out[ENGINE_AXES]);

/* The motion of the tool for a motion of the motors. Returns false if the motors cannot be
 * there. */
bool kinematics_move(const kinematics *k, const kinematics_moving *motors, kinematics_moving *tool);

/* The units in which the motors are planned: factors per motor that make lengths as close as
 * possible to those of the tool, or to one multiple of them. `farthest` is the largest distance of
 * the path from the center. No factor is below 1. */
void kinematics_scale(const kinematics *k, double farthest, double scale[ENGINE_AXES]);

/* The smallest length, in these units, of 1 mm of the tool in any direction, at a place within
 * reach. */
double kinematics_least(const kinematics *k, const double tool[ENGINE_AXES],
                        const double scale[ENGINE_AXES]);

/* Lines `# key = value` for a record; "" for a Cartesian machine. */
#define KINEMATICS_TEXT 512
void kinematics_text(const kinematics *k, char out[KINEMATICS_TEXT]);

#endif
