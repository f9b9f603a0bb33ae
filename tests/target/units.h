/* tests/target/units.h -- the tests of a program; the list is generated
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TARGET_UNITS_H
#define LOFT_TARGET_UNITS_H

struct unit {
    const char *name;
    int (*run)(void);
};

extern const struct unit units[];       /* the last one has no name */

#endif
