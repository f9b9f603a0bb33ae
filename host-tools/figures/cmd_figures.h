/* host-tools/figures/cmd_figures.h -- the subcommands that reproduce the texts
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_CMD_FIGURES_H
#define LOFT_CMD_FIGURES_H

#include "base/tool.h"      /* tool_command */

extern const tool_command command_figures, command_study;

#endif
