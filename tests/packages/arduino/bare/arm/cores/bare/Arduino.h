/* tests/packages/arduino/bare/arm/cores/bare/Arduino.h -- what the sketches ask of a core
 * SPDX-License-Identifier: MIT
 */
#ifndef BARE_ARDUINO_H
#define BARE_ARDUINO_H

#include <stdint.h>

#define OUTPUT 1
void setup(void);
void loop(void);
inline void delay(unsigned long) {}
inline void pinMode(uint8_t, uint8_t) {}
void analogWrite(uint8_t pin, int value);

struct bare_serial {
    void begin(unsigned long) {}
    void print(const char *text);
    void print(int value) { print((long)value); }
    void print(long value);
    void print(char c);
    template <typename T> void println(T value)
    {
        print(value);
        print('\n');
    }
};
extern bare_serial Serial;

#endif
