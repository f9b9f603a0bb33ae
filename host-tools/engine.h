/* host-tools/engine.h -- the library behind a double interface; engine.c is compiled once per number type
 * SPDX-License-Identifier: MIT
 *
 * All three number types live in one program: names.h keeps their symbols apart.
 */
#ifndef LOFT_ENGINE_H
#define LOFT_ENGINE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define ENGINE_AXES 3

/* A span as it goes on the wire and into pictures: Bezier points in time, raw Q16.16 mm. */
typedef struct {
    int32_t  p[4][ENGINE_AXES];
    uint16_t ticks;
} engine_span;

/* A move of the toolpath: a cubic in mm with its feed in mm/s. */
typedef struct {
    double p[4][ENGINE_AXES];
    double feed;
} engine_move;

typedef struct {
    double max_speed[ENGINE_AXES], max_accel[ENGINE_AXES];      /* mm/s, mm/s^2 */
    double corner, tol;                                         /* mm           */
    unsigned tick_hz;
} engine_limits;

typedef void engine_point_sink(void *context, const double point[ENGINE_AXES]);
typedef void engine_span_sink(void *context, const engine_span *span);

/* Functions return enum loft_status (0 = OK, negative = error). Points in mm. */
typedef struct {
    const char *name;                       /* "q16" "f32" "f64"                    */
    bool fixed;                             /* the step is the same for all sizes   */
    double lsb;                             /* the step of a coordinate of size 1   */
    double reach;                           /* mm: what can be planned lies within +- this */
    int (*eval)(const double p[][ENGINE_AXES], unsigned degree, double t, double out[ENGINE_AXES]);
    int (*walk)(const double p[][ENGINE_AXES], unsigned degree, uint32_t n, engine_point_sink *sink, void *context);
    int (*flatten)(const double p[4][ENGINE_AXES], double tol, engine_point_sink *sink, void *context);
    int (*plan)(const engine_limits *limits, const engine_move moves[], size_t count, engine_span_sink *sink, void *context);
    int32_t (*steps)(double mm, double steps_per_mm);       /* rounded as a machine of this type does it */
} engine;

extern const engine engine_q16, engine_f32, engine_f64;

const engine *engine_find(const char *name);    /* NULL if there is none */
const char   *engine_status(int status);        /* a sentence            */

#endif
