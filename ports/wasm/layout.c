/* ports/wasm/layout.c -- sizes of structures and places of their fields, for callers in JavaScript
 * SPDX-License-Identifier: MIT
 *
 * loft_layout[] ends with a name of NULL. `loft_plan` is a size, `loft_plan.knot` a place in bytes.
 */
#include "loft/surfaces.h"

#define SIZE(type)         { #type, sizeof(type) }
#define FIELD(type, field) { #type "." #field, offsetof(type, field) }

extern const struct layout {
    const char *name;
    uint32_t bytes;
} loft_layout[];

const struct layout loft_layout[] = {
    SIZE(loft_vec),
    SIZE(loft_acc),
    SIZE(loft_bezier),
    SIZE(loft_cubic),
    SIZE(loft_walk),
    SIZE(loft_forward),
    FIELD(loft_forward, axis),
    SIZE(loft_flatten),
    SIZE(loft_shape),
    FIELD(loft_shape, kind),
    FIELD(loft_shape, inflections),
    FIELD(loft_shape, cusps),
    FIELD(loft_shape, loops),
    FIELD(loft_shape, inflection),
    FIELD(loft_shape, cusp),
    FIELD(loft_shape, loop),
    SIZE(loft_limits),
    FIELD(loft_limits, max_speed),
    FIELD(loft_limits, max_accel),
    FIELD(loft_limits, max_jerk),
    FIELD(loft_limits, tol),
    FIELD(loft_limits, corner),
    FIELD(loft_limits, exact),
    FIELD(loft_limits, tick_hz),
    SIZE(loft_move),
    FIELD(loft_move, feed),
    SIZE(loft_knot),
    SIZE(loft_plan),
    SIZE(loft_span),
    FIELD(loft_span, ticks),
    SIZE(loft_tensor),
    SIZE(loft_spot),
    SIZE(loft_domain),
    SIZE(loft_gb),
    SIZE(loft_disk),
    SIZE(loft_surface),
    SIZE(loft_level),
    SIZE(loft_contour),
    { NULL, 0 },
};

/* A function that callers hand over: its place in the table. */
extern loft_coordinates *const loft_wachspress;
loft_coordinates *const loft_wachspress = loft_wachspress_eval;
