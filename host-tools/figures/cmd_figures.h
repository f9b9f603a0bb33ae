/* host-tools/figures/cmd_figures.h -- the subcommands that reproduce the texts
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_CMD_FIGURES_H
#define LOFT_CMD_FIGURES_H

#include "cmd/command.h"

extern const command command_figures, command_study;

#endif
