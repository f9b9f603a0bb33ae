/* lib/surface/net_ray.h -- where a ray meets a patch or a triangle
 * SPDX-License-Identifier: MIT
 *
 *     loft_ray_hit hit[8];
 *     unsigned     count;
 *     const loft_net net = loft_net_from_tensor(&s);
 *     if (loft_net_ray(net, from, direction, hit, 8, &count) == LOFT_OK && count > 0)
 *         use(hit[0].u, hit[0].v);                    // the first place that it meets
 */
#ifndef LOFT_SURFACE_NET_RAY_H
#define LOFT_SURFACE_NET_RAY_H

#include "surface/net.h"    /* loft_net */

LOFT_BEGIN_C

#define LOFT_NET_RAY_PARTS ((uint32_t)1 << 15)

typedef struct {
    loft_acc  t;                /* the place on the ray, in units of the direction */
    loft_unit u, v;             /* the place on the patch */
    bool      edge;             /* within 2^-30 of the border: the ray may pass it by that much */
    bool      touch;            /* not decided: here the ray touches the patch or its silhouette, or
                                 * the patch is folded or collapsed. Within about 2^-16 of u and v
                                 * there are none, one or more hits */
} loft_ray_hit;

/* Find all places where from + t direction, t >= 0, meets the patch, sorted by t: out[room].
 * LOFT_SINGULAR: at least one is a touch. LOFT_MORE: there are more than `room`, or more than
 * LOFT_NET_RAY_PARTS parts were examined, as where the ray runs within the patch; out[] then
 * holds those found.
 *
 *   range   three axes and a direction that is not 0, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if a
 *           number is not valid or a t does not fit. *count is 0 after an error
 *   error   every place where the ray crosses is a hit, and once, or lies in a touch; no other
 *           place is one, except within 2^-30 beyond the border and within 2^-40 of the patch's
 *           size behind `from`, where t is 0
 *           t, u, v: 2^-42 over the sine of the angle, of the size of the patch in their
 *           units, and q16: 2^-25   f32: 2^-25
 *   cost    some 5 to 100 parts per hit, each twice loft_sci_net_sub; not for small chips
 *   stack   Cortex-M4 22,476   Cortex-M0+ 22,416   ATmega328P 15,549
 *   see     Nishita, Sederberg and Kakimoto, Ray tracing trimmed rational surface patches (1990);
 *           Kearfott, Rigorous Global Search, ch. 1: roots that are unique
 */
enum loft_status loft_net_ray(loft_net s, loft_vec from, loft_vec direction, loft_ray_hit out[],
                              unsigned room, unsigned *count) LOFT_CHECKED;

LOFT_END_C

#endif
