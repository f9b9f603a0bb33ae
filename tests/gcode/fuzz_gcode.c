/* tests/gcode/fuzz_gcode.c -- feeds arbitrary bytes to the reader of G-code
 * SPDX-License-Identifier: MIT
 *
 * For libFuzzer (make fuzz-gcode). For any bytes, the reader ends with a drawing of connected
 * curves within its limits, or with EX_DATAERR and one line that is not a warning. The first byte
 * chooses the dialect.
 */
#include <math.h>

#include "tools/fuzz_reader.h"
#include "read/drawing.h"
#include "gcode/gcode.h"
#include "gcode/gcode_draw.h"
#include "read/machine_tools.h"

static const machine_tools bench = { .tool = { { .name = "2", .diameter = 6, .length = 5 },
                                               { .name = "3", .diameter = 1 } },
                                     .count = 2 };

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *text = text_of(data, size);
    drawing d  = { .tools = &bench,
                  .most_lines = 2000,
                  .dialect = size > 0 && data[0] % 2 ? GCODE_MARLIN : GCODE_LINUXCNC };

    const int code = drawing_read_gcode(&counted, &d, "fuzz.nc", text, size);
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
