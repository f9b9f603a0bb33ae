/* host-tools/send/facts.c
 * SPDX-License-Identifier: MIT
 */
#include <stdarg.h>
#include <stdio.h>

#include "send/facts.h"

void send_tell(const send_teller *to, enum send_line what, const char *format, ...)
{
    char line[512];
    va_list values;

    if (to->tell == NULL)
        return;
    va_start(values, format);
    vsnprintf(line, sizeof line, format, values);
    va_end(values);
    to->tell(to->context, what, line);
}
