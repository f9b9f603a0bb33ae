/* host-tools/base/create.h -- files that cannot be made: told in one line, and before long work
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_CREATE_H
#define LOFT_CREATE_H

/* Tell that a file could not be made, and why: an `errno`. Returns EX_CANTCREAT. */
int create_refused(const char *name, int why);

/* Can a file or folder be made there? Changes nothing; NULL and "-" can. Returns 0, or an exit code
 * after printing one line. */
int create_check(const char *name);

#endif
