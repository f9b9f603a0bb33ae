/* tests/packages/say.c -- printf of %ld, and the start of a program, by semihosting
 * SPDX-License-Identifier: MIT
 */
#include <stdarg.h>

int main(void);
int user_main(void);
int printf(const char *format, ...);

static void ask(long what, const void *with)
{
    register long r0 __asm__("r0") = what;
    register const void *r1 __asm__("r1") = with;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

static void say_number(long value)
{
    char text[12], *c = text + sizeof text;
    unsigned long rest = value < 0 ? 0UL - (unsigned long)value : (unsigned long)value;

    *--c = '\0';
    do
        *--c = (char)('0' + rest % 10);
    while (rest /= 10);
    if (value < 0)
        *--c = '-';
    ask(4, c);
}

int printf(const char *format, ...)
{
    va_list values;

    va_start(values, format);
    for (; *format; format++)
        if (format[0] == '%' && format[1] == 'l') {
            say_number(va_arg(values, long));
            format += 2;
        } else {
            ask(3, format);
        }
    va_end(values);
    return 0;
}

int main(void)
{
    ask(0x18, user_main() == 0 ? (const void *)0x20026 : (const void *)0x20023);
    return 0;
}
