/* lib/wire/rto.h -- the retransmission timeout: how long to wait for an answer
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_WIRE_RTO_H
#define LOFT_WIRE_RTO_H

#include "num/num.h"        /* the integer types */

LOFT_BEGIN_C

#define LOFT_RTO_FIRST  200     /* ms */
#define LOFT_RTO_MIN   25
#define LOFT_RTO_MAX  1000

typedef struct {
    uint32_t ms;            /* the time to wait, LOFT_RTO_MIN .. LOFT_RTO_MAX             */
    uint32_t rtt8, var4;    /* smoothed round trip and its deviation, times 8 and 4; ms      */
} loft_rto;

/* No measurement yet: LOFT_RTO_FIRST. */
void loft_rto_init(loft_rto *r);

/* A round trip took `m` ms (0 counts as 1): smooth it. The timeout itself changes with
 * loft_rto_reset.
 *
 *   range   m to 2^28
 *   see     V. Jacobson, Congestion avoidance and control, 1988: srtt += (m - srtt) / 8, var += (|m
 *           - srtt| - var) / 4
 */
void loft_rto_take(loft_rto *r, uint32_t m);

/* Set the timeout from the measured round trips. Without any it does not change. */
void loft_rto_reset(loft_rto *r);

/* No answer came in time: double the timeout. */
void loft_rto_back_off(loft_rto *r);

/* The smoothed round trip in ms; 0 before the first measurement. */
uint32_t loft_rto_trip(const loft_rto *r);

LOFT_END_C

#endif
