/* tests/gcode/fuzz_gcode.c -- feeds arbitrary bytes to the reader of G-code
 * SPDX-License-Identifier: MIT
 *
 * For libFuzzer (make fuzz-gcode). For any bytes, the reader ends with a drawing of connected
 * curves within its limits, or with EX_DATAERR and one line that is not a warning. The first byte
 * chooses the dialect.
 */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/tool.h"
#include "read/drawing.h"
#include "read/gcode.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#define MUST(condition)                                                                            \
    do {                                                                                           \
        if (!(condition))                                                                          \
            abort();                                                                               \
    } while (0)

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

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *text = tool_grow(NULL, size + 1);
    drawing d  = { .dialect = size > 0 && data[0] % 2 ? GCODE_MARLIN : GCODE_LINUXCNC };

    memcpy(text, data, size);
    text[size] = '\0';
    refusals = 0;
    const int code = drawing_read_gcode(&d, "fuzz.nc", text, size);
    MUST(code == (refusals ? EX_DATAERR : 0) && refusals <= 1);
    for (size_t i = 0; code == 0 && i < d.count; i++)
        for (int k = 0; k < 4; k++)
            MUST(fabs(d.curve[i].p[k][0]) <= DRAWING_LIMIT &&
                 fabs(d.curve[i].p[k][1]) <= DRAWING_LIMIT &&
                 fabs(d.curve[i].z[k]) <= DRAWING_LIMIT);
    drawing_free(&d);
    free(text);
    return 0;
}
