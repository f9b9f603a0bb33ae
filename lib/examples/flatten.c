/* lib/examples/flatten.c -- flatten a curve into the lines of a small display
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include "loft.h"

enum { WIDTH = 44, HEIGHT = 12 };
static char screen[HEIGHT][WIDTH + 1];

#define XY(x, y) { { LOFT_REAL(x), LOFT_REAL(y), 0 } }
#define PIXEL(a)   loft_steps_of(a, LOFT_REAL(1))

static void line_to(loft_vec from, loft_vec to)
{
    for (int k = 0; k <= 32; k++) {             /* your display has its own */
        const loft_vec at = loft_vec_lerp(from, to, loft_unit_of((uint32_t)k, 32));
        screen[PIXEL(at.axis[1])][PIXEL(at.axis[0])] = '#';
    }
}

int main(void)
{
    const loft_cubic curve = { { XY(2, 10), XY(80, 10), XY(-36, 1), XY(41, 1) } };
    loft_vec pen = curve.p[0], next;
    unsigned lines = 0;
    loft_flatten chords;

    for (int i = 0; i < HEIGHT; i++)
        for (int j = 0; j < WIDTH; j++)
            screen[i][j] = '.';
    if (loft_flatten_init(&chords, &curve, LOFT_REAL(0.25)) != LOFT_OK)    /* 1/4 of a pixel */
        return 1;
    for (; loft_flatten_next(&chords, &next); pen = next, lines++)
        line_to(pen, next);
    for (int i = 0; i < HEIGHT; i++)
        puts(screen[i]);
    printf("%u lines\n", lines);
    return 0;
}

/* prints
 *
 *     ............................................
 *     ...................#######################..
 *     .............#######........................
 *     .............###............................
 *     ...............####.........................
 *     ...................####.....................
 *     .......................###..................
 *     ..........................####..............
 *     .............................##.............
 *     ....................###########.............
 *     ..###################.......................
 *     ............................................
 *     7 lines
 */
