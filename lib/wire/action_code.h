/* lib/wire/action_code.h -- an action between spans in bytes: a pause, or the level of an output
 * SPDX-License-Identifier: MIT
 *
 * In a row of spans an item of 0 ticks is an action. It takes one tick, in which the machine moves
 * straight to p[2]; from then on the output has its new level. Like any item it has a number, so it
 * is executed exactly once, in its place.
 */
#ifndef LOFT_WIRE_ACTION_CODE_H
#define LOFT_WIRE_ACTION_CODE_H

#include "wire/codec.h"     /* loft_item, loft_predictor */

LOFT_BEGIN_C

typedef struct {
    uint8_t  output;            /* 1 .. LOFT_OUTPUTS_MOST; 0: a pause, the machine holds after it */
    bool     moving;            /* only while time runs: in a hold and without data it is off */
    uint16_t level;             /* 65535: full */
    uint16_t feed;              /* mm/min at which the output has this level; at another speed it is
                                 * in proportion. 0: the level does not depend on the speed */
} loft_action;

#define LOFT_OUTPUTS_MOST 15u

/* The largest size of an action in bytes. */
#define LOFT_ACTION_BYTES (1 + 1 + 5 + 5 * LOFT_AXES)

/* The item of an action at `place`, raw Q16.16 mm: where the machine goes in its tick.
 *
 *   range   output <= LOFT_OUTPUTS_MOST
 *   error   none */
void loft_action_item(loft_item *item, const loft_action *action, const int32_t place[LOFT_AXES]);

/* The action of an item of 0 ticks. */
loft_action loft_item_action(const volatile loft_item *item);

/* Encode the action of an item after the state `p`; returns the number of bytes. */
uint8_t loft_action_encode(uint8_t *byte, const loft_predictor *p, const loft_item *item);

/* Decode it; returns the end of the bytes, which loft_action_size has checked. */
const uint8_t *loft_action_decode(const uint8_t *byte, loft_predictor *p, loft_item *item);

/* The length of the action at byte[0]; 0 if it is not valid. */
uint8_t loft_action_size(const uint8_t *byte, uint8_t left);

LOFT_END_C

#endif
