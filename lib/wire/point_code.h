/* lib/wire/point_code.h -- points as bytes: the residuals of the prediction, typically -2..2
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_WIRE_POINT_CODE_H
#define LOFT_WIRE_POINT_CODE_H

#include "num/num.h"    /* LOFT_AXES, uint8_t */

LOFT_BEGIN_C

#define LOFT_POINT_GROUPS ((LOFT_AXES + 2) / 3)

/* The largest size of a point in bytes: at all, and with residuals within -32768..32767. */
#define LOFT_POINT_BYTES  (LOFT_POINT_GROUPS + 4 * LOFT_AXES)
#define LOFT_POINT_BYTES2 (LOFT_POINT_GROUPS + 2 * LOFT_AXES)

#define LOFT_POINT_RUN 128u     /* no point begins with a byte of this or more */

/* Write the residuals (two's complement) of a point. Returns the number of bytes.
 *
 *   error   none
 */
uint8_t loft_point_encode(uint8_t byte[LOFT_POINT_BYTES], const uint32_t residual[LOFT_AXES]);

/* Read the residuals of a point that loft_point_size has accepted. Returns the address after it.
 *
 *   cost    additions and shifts only
 */
const uint8_t *loft_point_decode(const uint8_t *byte, uint32_t residual[LOFT_AXES]);

/* The length of the point at byte[0]; 0 if it is cut off or invalid. */
uint8_t loft_point_size(const uint8_t *byte, uint8_t left);

LOFT_END_C

#endif
