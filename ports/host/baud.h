/* ports/host/baud.h -- the speeds of a serial port of this computer
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_BAUD_H
#define LOFT_HOST_BAUD_H

#include <stdbool.h>
#include <stddef.h>
#include <termios.h>

/* The system's constant for a speed; false if it has none. */
static inline bool host_baud(unsigned baud, speed_t *out)
{
    static const struct {
        unsigned baud;
        speed_t speed;
    } speeds[] = { { 9600, B9600 },       { 19200, B19200 },    { 38400, B38400 },
                   { 57600, B57600 },     { 115200, B115200 },  { 230400, B230400 },
                   { 460800, B460800 },   { 500000, B500000 },  { 921600, B921600 },
                   { 1000000, B1000000 }, { 2000000, B2000000 } };
    for (size_t i = 0; i < sizeof speeds / sizeof speeds[0]; i++)
        if (speeds[i].baud == baud) {
            *out = speeds[i].speed;
            return true;
        }
    return false;
}

#endif
