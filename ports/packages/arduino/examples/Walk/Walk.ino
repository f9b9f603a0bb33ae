// ports/packages/arduino/examples/Walk/Walk.ino -- a point on a curve, a thousand times a second
// SPDX-License-Identifier: MIT
// Prints the points of a curve in mm: additions alone, no multiplication, no float.
#include <loft.h>

static const loft_vec points[4] = {
    { { LOFT_REAL(0), LOFT_REAL(0) } },
    { { LOFT_REAL(10), LOFT_REAL(40) } },
    { { LOFT_REAL(30), LOFT_REAL(40) } },
    { { LOFT_REAL(40), LOFT_REAL(0) } },
};
static loft_bezier curve;
static loft_forward walk;

void setup()
{
    Serial.begin(115200);
    if (loft_bezier_init(&curve, points, 3) != LOFT_OK ||
        loft_forward_init(&walk, &curve, 256) != LOFT_OK)
        Serial.println("curve out of range");
}

void loop()
{
    loft_vec at;
    char text[LOFT_TEXT_MAX];
    if (loft_forward_next(&walk, &at)) {
        loft_to_text(at.axis[0], 3, text);
        Serial.print(text);
        Serial.print(' ');
        loft_to_text(at.axis[1], 3, text);
        Serial.println(text);
    }
    delay(1);
}
