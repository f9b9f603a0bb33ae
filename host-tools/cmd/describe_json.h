/* host-tools/cmd/describe_json.h -- tables of options as JSON: all that they say
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_DESCRIBE_JSON_H
#define LOFT_DESCRIBE_JSON_H

#include "cmd/command.h"

/* Print the options and rules of a command as an object. */
void describe_json(const command *self, const option rows[]);

#endif
