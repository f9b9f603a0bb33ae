/* host-tools/read/foreign.h -- files of other programs that loft cannot read: rows that refuse
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_FOREIGN_H
#define LOFT_FOREIGN_H

#include "read/reader.h"        /* reader */

#define FOREIGN_KINDS 21
extern const reader foreign_readers[FOREIGN_KINDS];

#endif
