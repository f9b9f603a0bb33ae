/* tests/tools/fuzz_machine.c -- feeds arbitrary bytes to the reader of machine files
 * SPDX-License-Identifier: MIT
 *
 * For libFuzzer (make fuzz-machine). For any bytes, the reader ends with a machine whose numbers
 * are those of a machine, or with EX_DATAERR and one line.
 */
#include <math.h>

#include "tools/fuzz_reader.h"
#include "read/machine_file.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *text     = text_of(data, size);
    machine_file m = machine_usual();

    const int code = machine_text(&counted, &m, "fuzz.txt", text);
    MUST(code == (refusals ? EX_DATAERR : 0) && refusals <= 1);
    for (int i = 0; code == 0 && i < ENGINE_AXES; i++)
        MUST(m.steps_per_mm[i] > 0 && m.max_speed[i] > 0 && m.max_accel[i] > 0 &&
             m.travel[i] >= 0 && fabs(m.min[i]) <= 16383);
    MUST(code != 0 || (m.tol > 0 && m.tick_hz >= 1 && m.queue >= 2));
    for (unsigned i = 0; i < m.tools.count; i++)
        MUST(m.tools.tool[i].name[0] != '\0' && !(m.tools.tool[i].diameter < 0));
    free(text);
    return 0;
}
