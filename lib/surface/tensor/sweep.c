/* lib/surface/tensor/sweep.c
 * SPDX-License-Identifier: MIT
 *
 * Station k of n is at k pieces / n of the whole path: a whole number of pieces, and a quotient.
 */
#include "surface/tensor/sweep.h"
#include "curve/moving_frame.h"        /* loft_moving_frame */

#define SWEEP_STATIONS 65535

static enum loft_status station_at(const loft_bezier path[], unsigned pieces, uint32_t k,
                                   uint32_t n, loft_vec *at, loft_vec *tangent)
{
    const uint64_t whole = (uint64_t)k * pieces;
    uint32_t piece = (uint32_t)(whole / n), rest = (uint32_t)(whole % n);

    if (piece == pieces) {
        piece--;
        rest = n;
    }
    const loft_unit t = loft_unit_of(rest, n);
    *at = loft_bezier_eval(&path[piece], t);
    return loft_bezier_deriv(&path[piece], 1, t, tangent);
}

enum loft_status loft_sweep_sections(const loft_bezier path[], unsigned pieces, uint32_t stations,
                                     loft_vec up, const loft_vec section[], unsigned degree,
                                     loft_vec out[])
{
    loft_moving_frame f;
    loft_vec at, tangent;

    if (pieces < 1 || stations < 2 || stations > SWEEP_STATIONS || degree > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    for (uint32_t k = 0; k < stations; k++) {
        enum loft_status status = station_at(path, pieces, k, stations - 1, &at, &tangent);
        if (status == LOFT_OK)
            status = k ? loft_moving_frame_move(&f, at, tangent)
                       : loft_moving_frame_start(&f, at, tangent, up);
        for (unsigned i = 0; i <= degree && status == LOFT_OK; i++)
            status = loft_moving_frame_point(&f, section[i], &out[(size_t)k * (degree + 1) + i]);
        if (status != LOFT_OK)
            return status;
    }
    return LOFT_OK;
}
