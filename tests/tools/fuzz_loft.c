/* tests/tools/fuzz_loft.c -- feeds arbitrary bytes to the readers of .loft and CSV
 * SPDX-License-Identifier: MIT
 *
 * For libFuzzer (make fuzz-loft). For any bytes, the readers of curves, surfaces and CSV end with
 * what they have read, in finite numbers, or with EX_DATAERR and one line that is not a warning.
 */
#include <math.h>

#include "engine/curve.h"
#include "engine/surface.h"
#include "tools/fuzz_reader.h"
#include "read/drawing.h"
#include "geometry/surface_text.h"
#include "geometry/curve_text.h"
#include "read/csv.h"
#include "read/drawing_curves.h"

static void check_curves(const char *text)
{
    curves all = { 0 };

    const int code = curves_read_text(&counted, &all, "fuzz.loft", text);
    MUST(code == (refusals ? EX_DATAERR : 0) && refusals <= 1);
    curves_free(&all);
}

static void check_surfaces(const char *text)
{
    surfaces all = { 0 };

    const int code = surfaces_read_text(&counted, &all, "fuzz.loft", text);
    MUST(code == (refusals ? EX_DATAERR : 0) && refusals <= 1);
    surfaces_free(&all);
}

static void check_drawing(const char *text, size_t size, bool csv)
{
    drawing d = { 0 };

    const int code = csv ? drawing_read_csv(&counted, &d, "fuzz.csv", text, size)
                         : drawing_read_curves(&counted, &d, "fuzz.loft", text);
    MUST(code == (refusals ? EX_DATAERR : 0) && refusals <= 1);
    for (size_t i = 0; code == 0 && i < d.count; i++)
        for (int k = 0; k < 4; k++)
            MUST(isfinite(d.curve[i].p[k][0]) && isfinite(d.curve[i].p[k][1]) &&
                 isfinite(d.curve[i].z[k]));
    drawing_free(&d);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *text = text_of(data, size);

    check_curves(text);
    refusals = 0;
    check_surfaces(text);
    refusals = 0;
    check_drawing(text, size, false);
    refusals = 0;
    check_drawing(text, size, true);
    free(text);
    return 0;
}
