/* host-tools/base/describe.h -- a command described from its table of options: help, man page,
 * completions of shells
 * SPDX-License-Identifier: MIT
 *
 * `loft COMMAND --help` is for readers. `--help=man` gives the man page of a command or of loft;
 * `loft --help=bash`, `=zsh` and `=fish` give completions of all commands. `make install` installs
 * them.
 *
 * If a value is one of several words, the table lists them as its name: "q16|f32|f64". FILE, PATH
 * and PORT are completed as files, DIR as folders.
 */
#ifndef LOFT_DESCRIBE_H
#define LOFT_DESCRIBE_H

#include "base/tool.h"

/* Print the command in a form: NULL or "" (help), "man", "bash", "zsh", "fish". Returns EX_OK, or
 * EX_USAGE after printing that the form is unknown. */
int describe_command(const char *form, const tool_command *self, const tool_option options[]);

/* Print what concerns all commands, in one of these forms. */
int describe_all(const char *form, const tool_command *const commands[], size_t count);

#endif
