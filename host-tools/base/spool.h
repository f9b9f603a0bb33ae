/* host-tools/base/spool.h -- arrays that may grow larger than memory
 * SPDX-License-Identifier: MIT
 *
 * A long array lives in a file without a name, in TMPDIR or /var/tmp. It is read and written as any
 * other; its pages may leave memory where a program has passed them. A short one is in memory, and
 * so is a long one if there is no room for a file.
 */
#ifndef LOFT_HOST_SPOOL_H
#define LOFT_HOST_SPOOL_H

#include <stddef.h>

/* As memory_grow: NULL begins an array. Only the functions of this page may free it or let it grow.
 */
void *spool_grow(void *spool, size_t bytes);
void  spool_free(void *spool);

/* Pages of long arrays leave memory until they are used again. */
void spool_rest(void);

/* Call it for each element that a loop passes. */
static inline void spool_passed(size_t n)
{
    if (n % 4096 == 4095)
        spool_rest();
}

#endif
