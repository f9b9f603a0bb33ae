/* lib/examples/gradient.c -- a gradient along a row of LEDs that stays within 0 to 255
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include "loft.h"

#define LEDS 12
static const loft_real stop[] = { LOFT_REAL(0), LOFT_REAL(3), LOFT_REAL(4), LOFT_REAL(11) };
static const loft_real level[3][4] = {
    { LOFT_REAL(255), LOFT_REAL(255), LOFT_REAL(0), LOFT_REAL(0) },     /* red   */
    { LOFT_REAL(0), LOFT_REAL(128), LOFT_REAL(255), LOFT_REAL(0) },     /* green */
    { LOFT_REAL(0), LOFT_REAL(0), LOFT_REAL(10), LOFT_REAL(255) },      /* blue  */
};
static loft_acc slope[3][4];

int main(void)
{
    loft_monotone colour[3];

    for (int k = 0; k < 3; k++)
        if (loft_monotone_init(&colour[k], stop, level[k], 4, slope[k]) != LOFT_OK)
            return 1;
    for (int led = 0; led < LEDS; led++) {
        for (int k = 0; k < 3; k++)
            printf("%4ld", (long)loft_acc_int(loft_to_acc(
                               loft_monotone_eval(&colour[k], loft_real_from_int(led)))));
        printf("\n");
    }
    return 0;
}

/* prints
 *
 *      255   0   0
 *      255  33   0
 *      255  67   0
 *      255 128   0
 *        0 255  10
 *        0 245  36
 *        0 219  67
 *        0 181 103
 *        0 136 141
 *        0  88 180
 *        0  41 218
 *        0   0 255
 */
