/* tests/packages/arduino/bare/arm/cores/bare/main.cpp -- 300 turns of the loop; prints by
 * semihosting
 * SPDX-License-Identifier: MIT
 */
#include "Arduino.h"

bare_serial Serial;

static void ask(long what, const void *with)
{
    register long r0 __asm__("r0") = what;
    register const void *r1 __asm__("r1") = with;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

void bare_serial::print(const char *text) { ask(4, text); }
void bare_serial::print(char c)
{
    const char text[] = { c, '\0' };
    print(text);
}
void bare_serial::print(long value)
{
    char text[12], *c = text + sizeof text;
    unsigned long rest = value < 0 ? 0UL - (unsigned long)value : (unsigned long)value;

    *--c = '\0';
    do *--c = (char)('0' + rest % 10); while (rest /= 10);
    if (value < 0)
        *--c = '-';
    print(c);
}

void analogWrite(uint8_t pin, int value)
{
    Serial.print((long)pin);
    Serial.print(':');
    Serial.println((long)value);
}

int main()
{
    setup();
    for (int i = 0; i < 300; i++)
        loop();
    ask(0x18, reinterpret_cast<const void *>(0x20026));
    return 0;
}
