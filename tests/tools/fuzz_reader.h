/* tests/tools/fuzz_reader.h -- what programs that feed a reader have in common
 * SPDX-License-Identifier: MIT
 *
 * Bytes become a text that ends with 0. Lines that are not warnings are counted, not printed.
 */
#ifndef LOFT_TESTS_FUZZ_READER_H
#define LOFT_TESTS_FUZZ_READER_H

#include <string.h>

#include "base/tool.h"
#include "support/fuzz.h"

static unsigned refusals;

int tool_error(int code, const char *format, ...)
{
    (void)format;
    refusals += code != EX_OK;
    return code;
}

void *tool_grow(void *old, size_t bytes)
{
    void *grown = realloc(old, bytes ? bytes : 1);

    MUST(grown != NULL);
    return grown;
}

static inline char *text_of(const uint8_t *data, size_t size)
{
    char *text = tool_grow(NULL, size + 1);

    memcpy(text, data, size);
    text[size] = '\0';
    refusals = 0;
    return text;
}

#endif
