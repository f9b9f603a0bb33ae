/* tests/tools/fuzz_reader.h -- what programs that feed a reader have in common
 * SPDX-License-Identifier: MIT
 *
 * Bytes become a text that ends with 0. Lines that are not warnings are counted, not printed.
 */
#ifndef LOFT_TESTS_FUZZ_READER_H
#define LOFT_TESTS_FUZZ_READER_H

#include <string.h>

#include "base/host.h"
#include "base/tool.h"
#include "support/fuzz.h"

static unsigned refusals;

static void count_refusal(void *context, const host_message *m)
{
    (void)context;
    refusals += m->code != EX_OK;
}

static host counted = { .message = count_refusal };

static void no_memory(size_t bytes) { MUST(bytes == 0); }

__attribute__((constructor)) static void begin(void)
{
    memory_is_out(no_memory);
    tool_use(&counted);
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
