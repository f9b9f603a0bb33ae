/* host-tools/engine/machine_kinematics.h -- kinematics of a machine: the positions of the
 * motors for a place of the tool, and their motion
 * SPDX-License-Identifier: MIT
 *
 * A kind of kinematics is a file engine_<kind>.c with one row, and its place in the table of
 * machine_kinematics.c. The maps are those of lib/kinematics/kinematics.h in double. Motors are at
 * 0 when the tool is at `center` and z = 0.
 */
#ifndef LOFT_MACHINE_KINEMATICS_H
#define LOFT_MACHINE_KINEMATICS_H

#include "engine/engine.h"         /* ENGINE_AXES */

#define KINEMATICS_GEOMETRY 7

struct kinematics_kind;

/* Lengths of the tool in mm. Fields of other kinds of kinematics are ignored. */
typedef struct {
    const struct kinematics_kind *kind;     /* never NULL: kinematics_usual */
    double center[ENGINE_AXES];             /* polar: of the pole, delta: of the middle between the
                                             * towers */
    double arm_length, delta_radius;        /* delta: the length of an arm; from the middle to a
                                             * carriage, minus the tool's joint */
    double tower_angle[ENGINE_AXES];        /* delta: degrees, from x towards y */
    double turn, inside;                    /* polar: units of the angle's axis per turn; the
                                             * smallest distance from the pole */
    double geometry[KINEMATICS_GEOMETRY], zero[ENGINE_AXES];    /* computed by kinematics_ready */
} kinematics;

/* Position, velocity and acceleration. */
typedef struct {
    double x[ENGINE_AXES], v[ENGINE_AXES], a[ENGINE_AXES];
} kinematics_moving;

/* What is wrong with a geometry, and the remedy; the key at fault, NULL: one that is missing. */
typedef struct {
    const char *key;
    char text[160];
} kinematics_fault;

/* A kind of kinematics. `at` is a place of the tool seen from `center`. Functions that are NULL:
 * nothing to prepare, to refuse or to print; motors that move as the tool; lengths of the tool. */
typedef struct kinematics_kind {
    const char *name, *axes;    /* "polar"; the names of the motors */
    bool direct;        /* the motors are the axes of the tool */
    bool linear;        /* a matrix maps tool to motors: cubics remain cubics; the switches are
                         * those of the axes. Otherwise they are those of the motors */
    bool paired;        /* the first two motors both move x and y */
    bool lifts;         /* z has a motor of its own. Otherwise each motor moves x, y and z, and
                         * all are homed together */
    bool pole;          /* motor 1 turns around a pole: `turn`, `inside` */
    /* Compute `geometry`; `zero` follows from it. */
    void (*prepare)(kinematics *k);
    /* True if this geometry is impossible. */
    bool (*faulty)(const kinematics *k, kinematics_fault *why);
    /* As kinematics_beyond. */
    bool (*beyond)(const kinematics *k, const double at[ENGINE_AXES], char why[160]);
    /* The motors, before `zero` is subtracted, and back. */
    void (*motors)(const kinematics *k, const double at[ENGINE_AXES],
                   const double near[ENGINE_AXES], double out[ENGINE_AXES]);
    bool (*tool)(const kinematics *k, const double motors[ENGINE_AXES], double at[ENGINE_AXES]);
    /* As kinematics_slope. */
    void (*slope)(const kinematics *k, const double at[ENGINE_AXES], const double v[ENGINE_AXES],
                  double out[ENGINE_AXES]);
    /* Velocity and acceleration of the tool in *tool, which is a copy of *motors but for x. */
    void (*move)(const kinematics *k, const double at[ENGINE_AXES], const kinematics_moving *motors,
                 kinematics_moving *tool);
    /* As kinematics_scale, from factors of 1. */
    void (*scale)(const kinematics *k, double farthest, double scale[ENGINE_AXES]);
    /* The keys of this kind for kinematics_text; returns how many characters. */
    size_t (*text)(const kinematics *k, char *out, size_t size);
} kinematics_kind;

extern const kinematics_kind kinematics_cartesian;

/* Each is compiled once per number type; the table takes those of f64. */
extern const kinematics_kind kinematics_corexy_q16, kinematics_corexy_f32, kinematics_corexy_f64;
extern const kinematics_kind kinematics_hbot_q16, kinematics_hbot_f32, kinematics_hbot_f64;
extern const kinematics_kind kinematics_polar_q16, kinematics_polar_f32, kinematics_polar_f64;
extern const kinematics_kind kinematics_delta_q16, kinematics_delta_f32, kinematics_delta_f64;

#define KINEMATICS_PI 3.14159265358979323846

/* Cartesian; other kinds have typical numbers where such exist. */
kinematics kinematics_usual(void);

/* Compute the derived fields. */
void kinematics_ready(kinematics *k);

/* True if the geometry is impossible; then `why` says what is wrong, and the remedy. */
bool kinematics_faulty(const kinematics *k, kinematics_fault *why);

/* The name of the kind; and the reverse. Returns false for an unknown word. */
const char *kinematics_name(const kinematics *k);
bool kinematics_find(kinematics *k, const char *name, size_t length);

/* All names: "cartesian, corexy, .. or polar". */
#define KINEMATICS_NAMES 80
void kinematics_names(char out[KINEMATICS_NAMES]);

/* The names of the motors, "xyz" or "abc". */
const char *kinematics_axes(const kinematics *k);

/* True if the place is out of reach; then `why` says why: "20.0 mm from the pole .." */
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
