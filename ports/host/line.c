/* ports/host/line.c
 * SPDX-License-Identifier: MIT
 */
#include "host/line.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sysexits.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

static int refuse(const char *what, const char *name)
{
    fprintf(stderr, "loft: %s: %s: %s\n", name, what, strerror(errno));
    return EX_OSERR;
}

/* An older link is replaced, any other file is left alone. */
static int make_link(const char *link, const char *name)
{
    struct stat info;

    if (lstat(link, &info) == 0 && S_ISLNK(info.st_mode))
        unlink(link);
    if (symlink(name, link) != 0) {
        fprintf(stderr, "loft: %s: cannot make this link: %s\n", link, strerror(errno));
        return EX_CANTCREAT;
    }
    return 0;
}

int host_line_open(struct host_line *l, const char *link, double noise)
{
    struct termios t;
    struct timespec now;

    l->link = NULL;
    l->slave = -1;
    l->master = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (l->master < 0 || grantpt(l->master) != 0 || unlockpt(l->master) != 0 ||
        ptsname_r(l->master, l->name, sizeof l->name) != 0)
        return refuse("cannot open a pseudo terminal", "/dev/ptmx");
    l->slave = open(l->name, O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (l->slave < 0 || tcgetattr(l->slave, &t) != 0)
        return refuse("cannot open", l->name);
    cfmakeraw(&t);
    if (tcsetattr(l->slave, TCSANOW, &t) != 0 || fcntl(l->master, F_SETFL, O_NONBLOCK) != 0)
        return refuse("cannot be made raw", l->name);
    if (link) {
        const int code = make_link(link, l->name);
        if (code)
            return code;
        l->link = link;
    }
    clock_gettime(CLOCK_MONOTONIC, &now);
    l->random = (uint64_t)now.tv_nsec;
    l->flip = (uint32_t)(noise * 1e-6 * 4294967295.0);
    return 0;
}

void host_line_close(struct host_line *l)
{
    char target[sizeof l->name];

    if (l->link) {
        const ssize_t length = readlink(l->link, target, sizeof target);
        if (length == (ssize_t)strlen(l->name) && memcmp(target, l->name, (size_t)length) == 0)
            unlink(l->link);            /* not if another machine has taken it over */
    }
    if (l->slave >= 0)
        close(l->slave);
    if (l->master >= 0)
        close(l->master);
}

static uint32_t random_32(struct host_line *l)          /* splitmix64 (Steele, Lea, Flood 2014) */
{
    uint64_t z = (l->random += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (uint32_t)(z >> 32);
}

static uint8_t disturbed(struct host_line *l, uint8_t byte)
{
    for (int bit = 0; l->flip && bit < 8; bit++)
        if (random_32(l) < l->flip)
            byte ^= (uint8_t)(1 << bit);
    return byte;
}

size_t host_line_read(struct host_line *l, uint8_t *byte, size_t max)
{
    const ssize_t count = read(l->master, byte, max);

    for (ssize_t i = 0; i < count; i++)
        byte[i] = disturbed(l, byte[i]);
    return count > 0 ? (size_t)count : 0;
}

size_t host_line_write(struct host_line *l, const uint8_t *byte, size_t count)
{
    uint8_t out[256];

    if (count > sizeof out)
        count = sizeof out;
    for (size_t i = 0; i < count; i++)
        out[i] = disturbed(l, byte[i]);
    const ssize_t written = write(l->master, out, count);
    return written > 0 ? (size_t)written : 0;
}

void host_line_wait(struct host_line *l, bool write, int ms, const sigset_t *during)
{
    struct pollfd fd = { .fd = l->master, .events = (short)(POLLIN | (write ? POLLOUT : 0)) };
    const struct timespec time = { .tv_sec = ms / 1000, .tv_nsec = ms % 1000 * 1000000L };

    ppoll(&fd, 1, ms < 0 ? NULL : &time, during);
}

bool host_line_drained(const struct host_line *l)
{
    int left = 0;
    return ioctl(l->slave, FIONREAD, &left) != 0 || left == 0;
}
