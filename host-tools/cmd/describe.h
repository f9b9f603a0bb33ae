/* host-tools/cmd/describe.h -- a command described from its table of options: help, man page,
 * completions of shells
 * SPDX-License-Identifier: MIT
 *
 * `loft COMMAND --help` is for readers. `--help=man` gives the man page of a command or of loft;
 * `loft --help=bash`, `=zsh` and `=fish` give completions of all commands. `make install` installs
 * them.
 *
 * Values of a CHOICE are completed as its words, FILE and FOLDER as names of files and folders.
 * JSON says all that a table says, for programs and for a page with controls.
 */
#ifndef LOFT_DESCRIBE_H
#define LOFT_DESCRIBE_H

#include "cmd/command.h"

/* Print the command in a form: NULL (help), "man", "bash", "zsh", "fish", "json". Returns EX_OK, or
 * EX_USAGE after printing that the form is unknown. */
int describe_command(const char *form, const command *self, const option rows[]);

/* Print what concerns all commands, in one of these forms. */
int describe_all(const char *form, const command *const commands[], size_t count);

#endif
