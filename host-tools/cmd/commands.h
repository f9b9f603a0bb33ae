/* host-tools/cmd/commands.h -- the subcommands of `loft`, each in its file cmd_<name>.c
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_COMMANDS_H
#define LOFT_COMMANDS_H

#include "cmd/command.h"

extern const command command_compare, command_contour, command_decide, command_eval, command_export,
    command_fit, command_flatten, command_go, command_harmonic, command_home, command_jog,
    command_make, command_measure, command_mill, command_monitor, command_park, command_pen,
    command_plan, command_plot, command_ports, command_probe, command_sample, command_set,
    command_serve, command_settings, command_simulate, command_stream, command_surface,
    command_unlock, command_zero;

#endif
