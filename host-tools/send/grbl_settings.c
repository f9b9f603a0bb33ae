/* host-tools/send/grbl_settings.c
 * SPDX-License-Identifier: MIT
 *
 * Homed, the machine stands at -$27 from the high ends, and its table goes from -$130 to 0 (grbl's
 * wiki, "Grbl v1.1 Configuration"). Firmware built with HOMING_FORCE_SET_ORIGIN, a Z in what it
 * answers to $I, has 0 at the end where an axis is homed: bit i of $23 set, that is the low one.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/scan.h"           /* scan_number */
#include "base/host.h"
#include "send/grbl_settings.h"

#define FAR 1e6                  /* mm of travel: more has no meaning */

/* A number, and nothing behind it; grblHAL writes "130=200.000", others blanks. */
static bool value_of(const char *text, double most, double *out)
{
    double value;

    scan_space(&text);
    if (!scan_number(&text, &value) || !(value >= 0 && value <= most))
        return false;
    scan_space(&text);
    *out = value;
    return *text == '\0' || *text == '(';      /* grbl 0.9: a comment follows */
}

/* Those that are needed here, and the most that has a meaning. */
static double most_of(int number)
{
    switch (number) {
    case 13:
    case 20:
    case 23: return 255;
    case 130:
    case 131:
    case 132: return FAR;
    default: return NAN;
    }
}

void grbl_settings_take(grbl_settings *s, host *h, const char *port, const char *line)
{
    const size_t room = sizeof s->text - s->used, size = strlen(line) + 1;
    const char *at    = line + 1;
    double number, value;

    if (scan_number(&at, &number) && *at == '=' && number >= 0 && number < 1000 &&
        !isnan(most_of((int)number)) && !value_of(at + 1, most_of((int)number), &value)) {
        host_warn(h, "grbl.setting", (host_place){ .file = port },
                  HOST_REMEDY("give %.*s= a number", (int)(at - line), line),
                  "the controller says `%s`, which is left out", line);
        return;
    }
    if (size < room)
        s->used += (size_t)snprintf(s->text + s->used, room, "%s\n", line);
}

double grbl_settings_number(const grbl_settings *s, int number, double otherwise)
{
    char key[16], row[64];
    const size_t size = (size_t)snprintf(key, sizeof key, "$%d=", number);
    double value      = otherwise;

    for (const char *line = s->text; *line != '\0'; line = strchr(line, '\n') + 1)
        if (strncmp(line, key, size) == 0) {
            snprintf(row, sizeof row, "%.*s", (int)strcspn(line + size, "\n"), line + size);
            if (value_of(row, most_of(number), &value))
                return value;
        }
    return otherwise;
}

bool grbl_settings_table(const grbl_settings *s, const double zero[ENGINE_AXES], machine_file *m)
{
    const unsigned low = s->corner_zero ? (unsigned)grbl_settings_number(s, 23, 0) : 0;

    if (!(grbl_settings_number(s, 20, 0) > 0))
        return false;
    for (int i = 0; i < ENGINE_AXES; i++) {
        m->travel[i] = grbl_settings_number(s, 130 + i, 0);
        m->min[i]    = (low >> i & 1 ? 0 : -m->travel[i]) - zero[i];
    }
    return true;
}
