/* host-tools/base/create.c
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/create.h"
#include "base/tool.h"

int create_refused(const char *name, int why)
{
    return tool_error(
        EX_CANTCREAT,
        "%s: cannot be written: %s: name a place in a folder that exists and is yours", name,
        strerror(why));
}

int create_check(const char *name)
{
    char folder[4096];

    if (name == NULL || strcmp(name, "-") == 0)
        return 0;
    if (access(name, F_OK) == 0)
        return access(name, W_OK) == 0 ? 0 : create_refused(name, errno);
    size_t length = strlen(name);
    while (length > 1 && name[length - 1] == '/')       /* a folder that is to be made */
        length--;
    while (length > 0 && name[length - 1] != '/')
        length--;
    if (length >= sizeof folder)
        return create_refused(name, ENAMETOOLONG);
    snprintf(folder, sizeof folder, "%.*s", (int)length, length > 0 ? name : "");
    return access(length > 0 ? folder : ".", W_OK | X_OK) == 0 ? 0 : create_refused(name, errno);
}
