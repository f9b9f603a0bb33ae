/* tests/tools/fuzz_svg.c -- feeds arbitrary bytes to the SVG reader
 * SPDX-License-Identifier: MIT
 *
 * For libFuzzer (make fuzz-svg). For any bytes, the reader ends with a drawing within its limits,
 * or with EX_DATAERR and one line that is not a warning.
 */
#include <math.h>

#include "tools/fuzz_reader.h"
#include "read/drawing.h"
#include "svg/svg_file.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *text = text_of(data, size);
    drawing d = { .text = size % 3 ? "outline" : "line",
                  .areas = size % 2,
                  .only = size % 7 ? NULL : "red,none" };

    const int code = drawing_read_svg(&counted, &d, "fuzz.svg", text, size);
    MUST(code == (refusals ? EX_DATAERR : 0) && refusals <= 1);
    for (size_t i = 0; code == 0 && i < d.count; i++)
        for (int k = 0; k < 4; k++)
            MUST(isfinite(d.curve[i].p[k][0]) && isfinite(d.curve[i].p[k][1]));
    drawing_free(&d);
    free(text);
    return 0;
}
