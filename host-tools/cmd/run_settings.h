/* host-tools/cmd/run_settings.h -- the calls of send/settings.h, each run until it is over
 * SPDX-License-Identifier: MIT
 *
 * Each returns 0, or an exit code after printing one line.
 */
#ifndef LOFT_RUN_SETTINGS_H
#define LOFT_RUN_SETTINGS_H

#include "send/settings.h"

int run_settings_read(settings *s, talk *t);
int run_settings_write(settings *s, talk *t, double wait);
int run_settings_reset(settings *s, talk *t, double wait);
int run_settings_adopt(machine_file *m, talk *t);

#endif
