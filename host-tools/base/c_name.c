/* host-tools/base/c_name.c
 * SPDX-License-Identifier: MIT
 */
#include "base/c_name.h"

#include <ctype.h>
#include <string.h>

void c_name_of(const char *file, char name[64])
{
    const char *stem = strrchr(file, '/') ? strrchr(file, '/') + 1 : file;
    size_t length = 0;

    if (isdigit((unsigned char)stem[0]))
        name[length++] = '_';
    for (; *stem && *stem != '.' && length < 63; stem++)
        name[length++] = isalnum((unsigned char)*stem) ? *stem : '_';
    name[length] = '\0';
}
