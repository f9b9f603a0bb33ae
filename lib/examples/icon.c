/* lib/examples/icon.c -- draw an icon that stays in flash, by short lines
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include "loft.h"

/* icon.h, as `loft export icon.svg -o icon.h` writes it: a face of a clock */
static const int16_t icon_words[28] LOFT_FLASH = {
    0,    4096, 12288, 2,     4096,  20480, 20480, 20480, 20480, 12288, 20480, 4096,  4096,  4096,
    4096, 12288, 0,    12288, 12288, -1,    12288, 17408, 0,     12288, 12288, -1,    16384, 12288,
};
static const loft_drawing icon = { icon_words, 28, 10 };

static long pixel(loft_real mm) { return (long)loft_steps_of(mm, LOFT_REAL(4)); }   /* 4 a mm */

int main(void)
{
    loft_drawing_walk walk;
    loft_cubic curve;
    loft_flatten lines;
    loft_vec to;
    bool lifted;

    if (loft_drawing_begin(&walk, &icon) != LOFT_OK)
        return 1;
    while (loft_drawing_next(&walk, &curve, &lifted)) {
        if (lifted)
            printf("move to %ld %ld\n", pixel(curve.p[0].axis[0]), pixel(curve.p[0].axis[1]));
        if (loft_flatten_init(&lines, &curve, LOFT_REAL(0.5)) != LOFT_OK)
            return 1;
        while (loft_flatten_next(&lines, &to))          /* here: draw a line */
            printf("line to %ld %ld\n", pixel(to.axis[0]), pixel(to.axis[1]));
    }
    return 0;
}

/* prints
 *
 *     move to 16 48
 *     line to 23 64
 *     line to 46 72
 *     line to 71 66
 *     line to 80 50
 *     line to 80 48
 *     line to 73 32
 *     line to 50 24
 *     line to 25 30
 *     line to 16 46
 *     line to 16 48
 *     move to 48 48
 *     line to 48 68
 *     move to 48 48
 *     line to 64 48
 */
