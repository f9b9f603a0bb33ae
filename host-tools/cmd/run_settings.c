/* host-tools/cmd/run_settings.c
 * SPDX-License-Identifier: MIT
 */
#include "cmd/run.h"        /* run_until */
#include "cmd/run_settings.h"

int run_settings_read(settings *s, talk *t)
{
    settings_work k;

    settings_read(&k, s, t);
    return run_until(settings_task(&k));
}

int run_settings_write(settings *s, talk *t, double wait)
{
    settings_work k;

    settings_write(&k, s, t, wait);
    return run_until(settings_task(&k));
}

int run_settings_reset(settings *s, talk *t, double wait)
{
    settings_work k;

    settings_reset(&k, s, t, wait);
    return run_until(settings_task(&k));
}

int run_settings_adopt(machine_file *m, talk *t)
{
    settings_work k;

    settings_adopt(&k, m, t);
    return run_until(settings_task(&k));
}
