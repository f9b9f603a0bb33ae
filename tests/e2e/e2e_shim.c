/* tests/e2e/e2e_shim.c -- lets libserialport open a pseudo terminal, so that the code path of real
 * serial ports is tested
 * SPDX-License-Identifier: MIT
 *
 * Loaded with LD_PRELOAD. The library looks up a port in /sys/class/tty and queries its modem
 * lines; a pty has neither.
 */
#include <dlfcn.h>
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/types.h>

static const char class[] = "/sys/class/tty/pts/";

static int is_pty(const char *path) { return strncmp(path, class, sizeof class - 1) == 0; }

/* A symbolic link into the devices, as every serial port has. */
static int linked(struct stat *s)
{
    memset(s, 0, sizeof *s);
    s->st_mode = S_IFLNK | 0777;
    return 0;
}

int lstat(const char *path, struct stat *s);
int lstat(const char *path, struct stat *s)
{
    int (*real)(const char *, struct stat *);

    *(void **)&real = dlsym(RTLD_NEXT, "lstat");
    return is_pty(path) ? linked(s) : real(path, s);
}

int __lxstat(int version, const char *path, struct stat *s);
int __lxstat(int version, const char *path, struct stat *s)
{
    int (*real)(int, const char *, struct stat *);

    *(void **)&real = dlsym(RTLD_NEXT, "__lxstat");
    return is_pty(path) ? linked(s) : real(version, path, s);
}

ssize_t readlink(const char *path, char *out, size_t size);
ssize_t readlink(const char *path, char *out, size_t size)
{
    ssize_t (*real)(const char *, char *, size_t);

    *(void **)&real = dlsym(RTLD_NEXT, "readlink");
    return is_pty(path) ? snprintf(out, size, "../../devices/pty") : real(path, out, size);
}

int ioctl(int fd, unsigned long request, ...)
{
    int (*real)(int, unsigned long, ...);
    va_list rest;

    va_start(rest, request);
    void *value = va_arg(rest, void *);
    va_end(rest);
    *(void **)&real = dlsym(RTLD_NEXT, "ioctl");
    const int got = real(fd, request, value);
    if (got == 0 || errno != ENOTTY)
        return got;
    if (request == TIOCMGET)
        *(int *)value = TIOCM_DTR | TIOCM_RTS;
    return request == TIOCMGET || request == TIOCMSET || request == TIOCMBIS || request == TIOCMBIC
               ? 0
               : got;
}
