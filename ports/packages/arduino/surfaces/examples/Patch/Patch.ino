// ports/packages/arduino/surfaces/examples/Patch/Patch.ino -- heights of a hill, line by line
// SPDX-License-Identifier: MIT
// Prints a grid of heights of a bicubic patch in 1/65536: additions alone after init.
#include <loft.h>
#include <loft_surfaces.h>

#define P(x, y, z) { { LOFT_REAL(x), LOFT_REAL(y), LOFT_REAL(z) } }
static const loft_vec net[4 * 4] = {
    P(0, 0, 0),  P(0, 10, 0),   P(0, 20, 0),   P(0, 30, 0),
    P(10, 0, 0), P(10, 10, 40), P(10, 20, 20), P(10, 30, 0),
    P(20, 0, 0), P(20, 10, 20), P(20, 20, 10), P(20, 30, 0),
    P(30, 0, 0), P(30, 10, 0),  P(30, 20, 0),  P(30, 30, 0),
};
static loft_state memory[LOFT_GRID_STATES(3, 3)];
static loft_tensor patch;
static loft_grid grid;

void setup()
{
    Serial.begin(115200);
    if (loft_tensor_init(&patch, net, 3, 3) != LOFT_OK ||
        loft_grid_init(&grid, &patch, 4, 8, memory, LOFT_GRID_STATES(3, 3)) != LOFT_OK)
        Serial.println("patch out of range");
}

void loop()
{
    loft_vec at;
    if (loft_grid_next(&grid, &at))
        Serial.println(at.axis[2]);
    delay(1);
}
