/* ports/nrf51/layout.h -- words of a stream: half the value of all pins; steps are bits 0..2
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_NRF51_LAYOUT_H
#define LOFT_NRF51_LAYOUT_H

#include <stdint.h>

/* step: P0.03 P0.02 P0.01; direction: P0.18 P0.20 P0.16 */
#define STREAM_STEP(i) (2 - (i))
#define STREAM_DIR(i)  ((i) == 0 ? 17 : (i) == 1 ? 19 : 15)
static inline uint32_t stream_dir(uint8_t dir)
{
    return (uint32_t)(dir & 1) << STREAM_DIR(0) | (uint32_t)(dir >> 1 & 1) << STREAM_DIR(1) |
           (uint32_t)(dir >> 2 & 1) << STREAM_DIR(2);
}

#endif
