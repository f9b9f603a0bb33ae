/* host-tools/send/grbl_settings.h -- what a controller of grbl's kind answers to `$$`
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_GRBL_SETTINGS_H
#define LOFT_GRBL_SETTINGS_H

#include "read/machine_file.h"  /* machine_file */

typedef struct {
    char text[8192];            /* lines `$100=250.000`; those beyond are dropped */
    size_t used;
    bool corner_zero;           /* its $I has Z: homed, a corner of the table is 0 */
} grbl_settings;

/* Keep a line of its answer. A number that is needed here and has no meaning is left out, with a
 * warning about what is at `port`. */
void grbl_settings_take(grbl_settings *s, host *h, const char *port, const char *line);

/* A number of it; `otherwise` if it was not told. */
double grbl_settings_number(const grbl_settings *s, int number, double otherwise);

/* The table in work coordinates: `zero` is where their 0,0,0 lies for the machine. Only a machine
 * with soft limits ($20=1) knows it: returns whether it does. */
bool grbl_settings_table(const grbl_settings *s, const double zero[ENGINE_AXES], machine_file *m);

#endif
