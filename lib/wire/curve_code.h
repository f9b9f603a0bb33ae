/* lib/wire/curve_code.h -- curves as bytes: a cubic and its feed, or two points of a patch, for
 * machines that plan
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_WIRE_CURVE_CODE_H
#define LOFT_WIRE_CURVE_CODE_H

#include "wire/codec.h"     /* loft_item, loft_predictor */

LOFT_BEGIN_C

/* The largest size of a curve in bytes. */
#define LOFT_CURVE_BYTES (4 + 15 * LOFT_AXES)

/* Write a curve that begins at the predictor's position. Returns the number of bytes.
 *
 *   shape   a line with its inner points at the thirds, to the nearest 2^-16 mm, takes one
 *           residual per moving axis
 *   range   any coordinates; a feed of at least 1, or loft_curve_is_part
 *   error   none
 */
uint8_t loft_curve_encode(uint8_t byte[LOFT_CURVE_BYTES], const loft_predictor *p,
                          const loft_item *item);

/* True if it is a part of a patch: without a feed, ending where it begins. */
bool loft_curve_is_part(const loft_predictor *p, const loft_item *item);

/* Read a curve that loft_curve_size has accepted. Returns the address after it. */
const uint8_t *loft_curve_decode(const uint8_t *byte, loft_predictor *p, loft_item *item);

/* The length of the curve at byte[0]; 0 if it is not valid. */
uint8_t loft_curve_size(const uint8_t *byte, uint8_t left);

LOFT_END_C

#endif
