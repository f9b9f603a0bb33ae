/* host-tools/base/create.c
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/create.h"
#include "base/host.h"

static bool is_followed(const char *name) { return strncmp(name, "/dev/", 5) == 0; }

static bool is_stream(const struct stat *of)
{
    return S_ISCHR(of->st_mode) || S_ISFIFO(of->st_mode);
}

/* What a link leads to, if it is no file: that is not emptied. */
static int open_device(const char *name)
{
    const int fd = open(name, O_WRONLY | O_CLOEXEC);
    struct stat info;

    if (fd >= 0 && fstat(fd, &info) == 0 && is_stream(&info))
        return fd;
    if (fd >= 0)
        close(fd);
    errno = ELOOP;
    return -1;
}

FILE *create_file(const char *name)
{
    const int follow = is_followed(name) ? 0 : O_NOFOLLOW;
    int fd           = open(name, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | follow, 0666);

    if (fd < 0 && errno == ELOOP)
        fd = open_device(name);
    FILE *file = fd >= 0 ? fdopen(fd, "w") : NULL;
    if (fd >= 0 && file == NULL)
        close(fd);
    return file;
}

int create_refused(host *h, const char *name, int why)
{
    const host_place at = { name, 0 };

    if (why == ELOOP)
        return host_error(h, EX_CANTCREAT, "file.symbolic-link", at,
                          "name the file that it points to, or remove the link",
                          "is a symbolic link, and no file is written through one");
    return host_error(h, EX_CANTCREAT, "file.not-written", at,
                      "name a place in a folder that exists and is yours", "cannot be written: %s",
                      strerror(why));
}

int create_check(host *h, const char *name)
{
    char folder[4096];
    struct stat info;

    if (name == NULL || strcmp(name, "-") == 0)
        return 0;
    if (!is_followed(name) && lstat(name, &info) == 0 && S_ISLNK(info.st_mode) &&
        !(stat(name, &info) == 0 && is_stream(&info)))
        return create_refused(h, name, ELOOP);
    if (access(name, F_OK) == 0)
        return access(name, W_OK) == 0 ? 0 : create_refused(h, name, errno);
    size_t length = strlen(name);
    while (length > 1 && name[length - 1] == '/')       /* a folder that is to be made */
        length--;
    while (length > 0 && name[length - 1] != '/')
        length--;
    if (length >= sizeof folder)
        return create_refused(h, name, ENAMETOOLONG);
    snprintf(folder, sizeof folder, "%.*s", (int)length, length > 0 ? name : "");
    return access(length > 0 ? folder : ".", W_OK | X_OK) == 0 ? 0 : create_refused(h, name, errno);
}
