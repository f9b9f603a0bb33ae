/* tests/support/fuzz.h -- what every program for libFuzzer begins with
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_FUZZ_H
#define LOFT_TESTS_FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#define MUST(condition)                                                                            \
    do {                                                                                           \
        if (!(condition))                                                                          \
            abort();                                                                               \
    } while (0)

#endif
