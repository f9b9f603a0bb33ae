/* tests/target/hosts.c -- the tests in one program, for Linux on another processor
 * SPDX-License-Identifier: MIT
 *
 * Tests are compiled for libc/, as for chips. Linux does what libc/ asks of a debugger.
 */
#include "units.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "semihost.h"

uint32_t semihost(uint32_t operation, const void *argument)
{
    if (operation == 4)
        return write(STDOUT_FILENO, argument, strlen(argument)) < 0;
    _exit((int)((const uint32_t *)argument)[1]);
}

int main(int count, char *name[])
{
    int bad = 0;

    for (const struct unit *u = units; u->name; u++) {
        if (count < 2)
            printf("%s\n", u->name);
        for (int k = 1; k < count; k++)
            if (strcmp(name[k], u->name) == 0)
                bad |= u->run();
    }
    return bad;
}
