/* host-tools/base/describe.h -- a command described from its table of options: help, man page,
 * completions of shells
 * SPDX-License-Identifier: MIT
 *
 * `loft COMMAND --help` is for readers. `--help=man` gives the man page of a command or of loft;
 * `loft --help=bash`, `=zsh` and `=fish` give completions of all commands. `make install` puts them
 * in their places.
 *
 * A value that is one of some words has them in the table as its name: "q16|f32|f64". FILE, PATH
 * and PORT are completed as files, DIR as folders.
 */
#ifndef LOFT_DESCRIBE_H
#define LOFT_DESCRIBE_H

#include "base/tool.h"

/* Print the command in a form: NULL or "" (help), "man", "bash", "zsh", "fish". Gives EX_OK, or
 * EX_USAGE for a form that there is not, which it names. */
int describe_command(const char *form, const tool_command *self, const tool_option options[]);

/* Print what is about all commands in one of these forms; `each` describes one of them. */
int describe_all(const char *form, const tool_command *const commands[], size_t count);

#endif
