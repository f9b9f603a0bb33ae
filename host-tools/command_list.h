/* host-tools/command_list.h -- the commands of loft, and so all their options, as data
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_COMMAND_LIST_H
#define LOFT_COMMAND_LIST_H

#include "cmd/command.h"

extern const command *const commands[];         /* in the order of `loft --help` */
extern const size_t commands_count;

#endif
