/* host-tools/base/create.h -- files that cannot be made: reported in one line, and before long work
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_CREATE_H
#define LOFT_CREATE_H

#include <stdio.h>

struct host;                /* base/host.h */

/* fopen to write a file that is made or emptied. What a symbolic link points to is not touched:
 * links that somebody put there would lead to any file of the user. Those of /dev are followed, as
 * /dev/stdout, and those to a device of characters or a pipe. NULL, with errno, which is ELOOP for
 * a link. */
FILE *create_file(const char *name);

/* Tell that a file could not be made, and why: an `errno`. Returns EX_CANTCREAT. */
int create_refused(struct host *h, const char *name, int why);

/* Refuse a name where no file or folder can be made, and change nothing; NULL and "-" are good.
 * Returns 0, or an exit code after one message. */
int create_check(struct host *h, const char *name);

#endif
