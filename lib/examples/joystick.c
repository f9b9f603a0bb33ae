/* lib/examples/joystick.c -- a response curve: y at x, that rises everywhere
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include "loft.h"

/* little around the middle, all at the end; symmetric */
static const loft_real stick[] = { LOFT_REAL(-512), LOFT_REAL(-384), LOFT_REAL(-32),
                                   LOFT_REAL(32),   LOFT_REAL(384),  LOFT_REAL(512) };
static const loft_real speed[] = { LOFT_REAL(-100), LOFT_REAL(-40), LOFT_REAL(0),
                                   LOFT_REAL(0),    LOFT_REAL(40),  LOFT_REAL(100) };
static loft_acc slope[6];

int main(void)
{
    loft_monotone response;

    if (loft_monotone_init(&response, stick, speed, 6, slope) != LOFT_OK)
        return 1;
    for (int32_t at = -512; at <= 512; at += 128)       /* here: what the converter reads */
        printf(
            "%4ld: %ld %%\n", (long)at,
            (long)loft_acc_int(loft_to_acc(loft_monotone_eval(&response, loft_real_from_int(at)))));
    return 0;
}

/* prints
 *
 *     -512: -100 %
 *     -384: -40 %
 *     -256: -13 %
 *     -128: -2 %
 *        0: 0 %
 *      128: 2 %
 *      256: 13 %
 *      384: 40 %
 *      512: 100 %
 */
