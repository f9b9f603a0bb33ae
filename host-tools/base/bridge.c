/* host-tools/base/bridge.c
 * SPDX-License-Identifier: MIT
 */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/bridge.h"

static host *program;

void tool_use(host *h) { program = h; }

host *tool_host(void) { return program; }

int tool_error(int code, const char *format, ...)
{
    char few[512], *text = few;
    va_list values;

    va_start(values, format);
    const int length = vsnprintf(few, sizeof few, format, values);
    va_end(values);
    if (length >= (int)sizeof few && (text = malloc((size_t)length + 1)) != NULL) {
        va_start(values, format);
        (void)vsnprintf(text, (size_t)length + 1, format, values);
        va_end(values);
    }
    if (code != EX_OK)
        (void)host_error(program, code, "", (host_place){ NULL, 0 }, NULL, "%s",
                         text != NULL ? text : few);
    else
        host_warn(program, "", (host_place){ NULL, 0 }, NULL, "%s", text != NULL ? text : few);
    if (text != few)
        free(text);
    if (code == EX_OK && program->strict)
        exit(EX_DATAERR);
    return code;
}
