/* host-tools/serve/door.c
 * SPDX-License-Identifier: MIT
 */
#include <arpa/inet.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "serve/door.h"

static bool is_address(const char *name)
{
    unsigned char bytes[16];

    return inet_pton(AF_INET, name, bytes) == 1 || inet_pton(AF_INET6, name, bytes) == 1;
}

bool door_is_local(const char *listens)
{
    return strcmp(listens, "localhost") == 0 || strcmp(listens, "::1") == 0 ||
           (strncmp(listens, "127.", 4) == 0 && is_address(listens));
}

/* The name without the port and without brackets. */
static bool take_name(const char *host, char out[256])
{
    const bool six   = *host == '[';
    const size_t end = six ? strcspn(host, "]") : strcspn(host, ":");

    if (end >= 256 || (six && host[end] == '\0'))
        return false;
    const char *behind = host + end + six;
    if (*behind != '\0' &&
        (*behind != ':' || strspn(behind + 1, "0123456789") != strlen(behind + 1)))
        return false;
    snprintf(out, 256, "%.*s", (int)(end - six), host + six);
    return *out != '\0';
}

bool door_host(const char *listens, const char *host)
{
    char name[256], own[128], local[160];

    if (!take_name(host, name))
        return false;
    if (door_is_local(name))
        return true;
    if (door_is_local(listens))
        return false;
    if (is_address(name) || strcasecmp(name, listens) == 0)
        return true;
    if (gethostname(own, sizeof own) != 0)
        return false;
    own[sizeof own - 1] = '\0';
    snprintf(local, sizeof local, "%s.local", own);
    return strcasecmp(name, own) == 0 || strcasecmp(name, local) == 0;
}

bool door_origin(const char *host, const char *origin)
{
    char ours[280];

    snprintf(ours, sizeof ours, "http://%s", host);
    return *origin == '\0' || strcasecmp(origin, ours) == 0;
}
