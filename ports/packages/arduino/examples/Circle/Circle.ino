// ports/packages/arduino/examples/Circle/Circle.ino -- two channels of PWM that draw a circle
// SPDX-License-Identifier: MIT
// On an oscilloscope in X-Y mode, behind low-pass filters: pins 9 and 10 as x and y.
#include <loft.h>

static loft_circle circle;
static const uint16_t steps = 400;

void setup()
{
    const loft_vec centre = { { LOFT_REAL(128), LOFT_REAL(128) } };
    const loft_vec start = { { LOFT_REAL(228), LOFT_REAL(128) } };

    Serial.begin(115200);
    pinMode(9, OUTPUT);
    pinMode(10, OUTPUT);
    if (loft_circle_from_centre(&circle, start, start, LOFT_PLANE_XY, centre, 1) != LOFT_OK)
        Serial.println("not a circle");
}

void loop()
{
    static uint16_t i;
    loft_vec at;

    if (loft_circle_eval(&circle, loft_unit_of(i, steps), &at) == LOFT_OK) {
        analogWrite(9, (int)(at.axis[0] >> 16));
        analogWrite(10, (int)(at.axis[1] >> 16));
    }
    i = (i + 1) % steps;
}
