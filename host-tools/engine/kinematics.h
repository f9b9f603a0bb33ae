/* host-tools/engine/kinematics.h -- kinematics of a machine: where its motors are for a place of
 * the tool, and how both move
 * SPDX-License-Identifier: MIT
 *
 * The maps are those of lib/kinematics/kinematics.h in double. Motors count from where the tool is
 * at `center` and z = 0.
 */
#ifndef LOFT_KINEMATICS_H
#define LOFT_KINEMATICS_H

#include "engine/engine.h"         /* engine_kinematics, ENGINE_AXES */

/* Lengths in mm, of the tool. What belongs to another kind is not looked at. */
typedef struct {
    enum engine_kinematics kind;
    bool   hbot;                            /* CoreXY by another name */
    double center[ENGINE_AXES];             /* polar: of the pole, delta: of the middle between the
                                             * towers */
    double arm_length, delta_radius;        /* delta: an arm; from the middle to a carriage, less
                                             * the tool's joint */
    double tower_angle[ENGINE_AXES];        /* delta: degrees, from x towards y */
    double turn, inside;                    /* polar: units of the angle's axis; how near the pole
                                             * may be */
    double geometry[ENGINE_GEOMETRY], zero[ENGINE_AXES];    /* made of these by kinematics_ready */
} kinematics;

/* Place, velocity and acceleration. */
typedef struct {
    double x[ENGINE_AXES], v[ENGINE_AXES], a[ENGINE_AXES];
} kinematics_moving;

/* Cartesian, with usual numbers where there are such for the others. */
kinematics kinematics_usual(void);

/* Make ready what was given. */
void kinematics_ready(kinematics *k);

/* "cartesian", "corexy", "hbot", "polar" or "delta"; and which one a word is. False: none of
 * them. */
const char *kinematics_name(const kinematics *k);
bool kinematics_find(kinematics *k, const char *name, size_t length);

/* The names of the motors, "xyz" or "abc". */
const char *kinematics_axes(const kinematics *k);

/* Can the tool not be there? Then `why` says it: "20.0 mm from the pole .." */
bool kinematics_beyond(const kinematics *k, const double tool[ENGINE_AXES], char why[160]);

/* The motors for a place within reach. An angle is the one nearest to that of `near`. */
void kinematics_motors(const kinematics *k, const double tool[ENGINE_AXES],
                       const double near[ENGINE_AXES], double out[ENGINE_AXES]);

/* The tool for motors; false if they cannot be so. */
bool kinematics_tool(const kinematics *k, const double motors[ENGINE_AXES],
                     double out[ENGINE_AXES]);

/* How fast the motors are when the tool at a place within reach moves by v. */
void kinematics_slope(const kinematics *k, const double tool[ENGINE_AXES],
                      const double v[ENGINE_AXES], double out[ENGINE_AXES]);

/* How the tool moves when motors move so; false if they cannot be so. */
bool kinematics_move(const kinematics *k, const kinematics_moving *motors, kinematics_moving *tool);

/* Units in which the motors are planned: what each is multiplied with so that lengths come as near
 * to those of the tool as they can, or to one multiple of them. `farthest` is how far the path
 * leads from the center. None is below 1. */
void kinematics_scale(const kinematics *k, double farthest, double scale[ENGINE_AXES]);

/* The least length, in these units, of a mm of the tool at a place within reach, in any
 * direction. */
double kinematics_least(const kinematics *k, const double tool[ENGINE_AXES],
                        const double scale[ENGINE_AXES]);

/* Lines `# key = value` for a record; "" for a Cartesian machine. */
#define KINEMATICS_TEXT 512
void kinematics_text(const kinematics *k, char out[KINEMATICS_TEXT]);

#endif
