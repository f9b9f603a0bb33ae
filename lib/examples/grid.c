/* lib/examples/grid.c -- a surface patch as a grid of points, by additions only
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include "loft/surfaces.h"

#define P(x, y, z) { { LOFT_REAL(x), LOFT_REAL(y), LOFT_REAL(z) } }
static const loft_vec net[4 * 4] = {
    /* a bicubic hill: v runs along a row */
    P(0, 0, 0),    P(0, 10, 0),  P(0, 20, 0),  P(0, 30, 0),   P(10, 0, 0),   P(10, 10, 40),
    P(10, 20, 20), P(10, 30, 0), P(20, 0, 0),  P(20, 10, 20), P(20, 20, 10), P(20, 30, 0),
    P(30, 0, 0), P(30, 10, 0),  P(30, 20, 0),  P(30, 30, 0),
};
static loft_state memory[LOFT_GRID_STATES(3, 3)];

int main(void)
{
    enum { ROWS = 4, COLUMNS = 8 };
    loft_tensor patch;
    loft_grid grid;
    char text[LOFT_TEXT_MAX];
    loft_vec at;

    if (loft_tensor_init(&patch, net, 3, 3) != LOFT_OK ||
        loft_grid_init(&grid, &patch, ROWS, COLUMNS, memory, LOFT_GRID_STATES(3, 3)) != LOFT_OK)
        return 1;
    for (int i = 0; loft_grid_next(&grid, &at); i++) {     /* a real one: vertices of a mesh */
        loft_to_text(at.axis[2], 2, text);
        printf("%6s%s", text, (i + 1) % (COLUMNS + 1) ? "" : "\n");
    }
    return 0;
}

/* prints
 *
 *       0.00  0.00  0.00  0.00  0.00  0.00  0.00  0.00  0.00
 *       0.00  6.06  9.69 11.25 11.07  9.52  6.92  3.63  0.00
 *       0.00  6.92 11.07 12.85 12.66 10.88  7.91  4.15  0.00
 *       0.00  4.33  6.92  8.03  7.91  6.80  4.94  2.60  0.00
 *       0.00  0.00  0.00  0.00  0.00  0.00  0.00  0.00  0.00
 */
