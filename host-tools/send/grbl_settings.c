/* host-tools/send/grbl_settings.c
 * SPDX-License-Identifier: MIT
 *
 * Homed, the machine stands at -$27 from the high ends, and its table goes from -$130 to 0 (grbl's
 * wiki, "Grbl v1.1 Configuration"). Firmware built with HOMING_FORCE_SET_ORIGIN, a Z in what it
 * answers to $I, has 0 at the end where an axis is homed: bit i of $23 set, that is the low one.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "send/grbl_settings.h"

void grbl_settings_take(grbl_settings *s, const char *line)
{
    const size_t room = sizeof s->text - s->used, size = strlen(line) + 1;

    if (size < room)
        s->used += (size_t)snprintf(s->text + s->used, room, "%s\n", line);
}

double grbl_settings_number(const grbl_settings *s, int number, double otherwise)
{
    char key[16];
    const size_t size = (size_t)snprintf(key, sizeof key, "$%d=", number);

    for (const char *line = s->text; *line != '\0'; line = strchr(line, '\n') + 1)
        if (strncmp(line, key, size) == 0)
            return atof(line + size);
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
