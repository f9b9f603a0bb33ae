/* lib/wire/curve_code.h -- a curve of a job as bytes: a cubic and its feed, for machines that plan
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_WIRE_CURVE_CODE_H
#define LOFT_WIRE_CURVE_CODE_H

#include "wire/codec.h"     /* loft_item, loft_predictor */

LOFT_BEGIN_C

/* Bytes that one curve takes at the most. */
#define LOFT_CURVE_BYTES (4 + 15 * LOFT_AXES)

/* Write a curve that begins where the predictor is; gives the number of bytes.
 *
 *   shape   a line whose inner points are at its thirds, to the nearest 2^-16 mm, takes one
 *           residual per axis that moves
 *   range   any coordinates; a feed of at least 1
 *   error   none
 */
uint8_t loft_curve_encode(uint8_t byte[LOFT_CURVE_BYTES], const loft_predictor *p,
                          const loft_item *item);

/* Read a curve that loft_curve_size has found good; gives what lies behind it. */
const uint8_t *loft_curve_decode(const uint8_t *byte, const loft_predictor *p, loft_item *item);

/* The length of the curve at byte[0], 0 if there is no good one. */
uint8_t loft_curve_size(const uint8_t *byte, uint8_t left);

LOFT_END_C

#endif
