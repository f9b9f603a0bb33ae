/* host-tools/command_list.c -- the commands, in the order of `loft --help`
 * SPDX-License-Identifier: MIT
 */
#include "cmd/commands.h"
#include "command_list.h"
#include "figures/cmd_figures.h"    /* command_figures, command_study */

const command *const commands[] = {
    &command_stream,   &command_serve,   &command_plan,    &command_simulate, &command_monitor,
    &command_zero,     &command_home,    &command_unlock,  &command_go,       &command_jog,
    &command_probe,    &command_pen,     &command_park,    &command_ports,    &command_eval,
    &command_sample,   &command_fit,     &command_flatten, &command_plot,     &command_measure,
    &command_compare,  &command_surface, &command_contour, &command_study,    &command_harmonic,
    &command_export,   &command_decide,  &command_make,    &command_mill,     &command_set,
    &command_settings, &command_figures
};

const size_t commands_count = sizeof commands / sizeof commands[0];
