/* ports/host/memory.c
 * SPDX-License-Identifier: MIT
 */
#include "host/memory.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sysexits.h>
#include <unistd.h>

static uint8_t memory[2 * HOST_MEMORY_ROOM];
static int file = -1;

int host_memory_open(const char *name)
{
    memset(memory, 0xFF, sizeof memory);
    if (!name)
        return 0;
    file = open(name, O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (file >= 0 && read(file, memory, sizeof memory) >= 0)
        return 0;
    fprintf(stderr, "loft: %s: %s: name a file that can be written, for the settings\n", name,
            strerror(errno));
    return EX_CANTCREAT;
}

void host_memory_close(void)
{
    if (file >= 0)
        close(file);
    file = -1;
}

uint8_t host_memory_get(uint16_t at) { return memory[at]; }

void host_memory_put(uint16_t at, uint8_t byte)
{
    memory[at] = byte;
    if (file >= 0 && pwrite(file, &byte, 1, at) != 1)
        fprintf(stderr, "loft: the settings cannot be kept: %s: is the disk full?\n",
                strerror(errno));
}
