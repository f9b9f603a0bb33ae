/* host-tools/send/transport_kind.c
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <sys/file.h>
#include <unistd.h>

#include "send/transport_kind.h"

/* A simulated machine looks whether byte 0 is locked: then its sender is there, maybe slow. */
bool transport_own(host *h, int fd, const char *name)
{
    struct flock first = { .l_type = F_WRLCK, .l_whence = SEEK_SET, .l_len = 1 };

    if (flock(fd, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) {
        (void)fcntl(fd, F_OFD_SETLK, &first);
        return true;
    }
    host_error(h, EX_UNAVAILABLE, "port.owned", (host_place){ .file = name }, "end that one first",
               "another program talks to it");
    return false;
}

int transport_refused(host *h, const char *name, int error)
{
    switch (error) {
    case EACCES:
    case EPERM:
        return host_error(h, EX_NOPERM, "port.no-permission", (host_place){ .file = name },
                          "join its group (often dialout) and log in again", "%s", strerror(error));
    case EBUSY:
        return host_error(h, EX_UNAVAILABLE, "port.owned", (host_place){ .file = name },
                          "end that one first", "another program talks to it");
    case ECONNREFUSED:
        return host_error(h, EX_UNAVAILABLE, "port.no-server", (host_place){ .file = name },
                          "start the machine's server first", "%s", strerror(error));
    default:
        if (error == ENOENT && strncasecmp(name, "COM", 3) == 0 && strpbrk(name, "0123456789"))
            return host_error(
                h, EX_UNAVAILABLE, "port.missing", (host_place){ .file = name },
                "here they are called /dev/ttyUSB0, /dev/ttyACM0: `loft ports` lists them",
                "no such port");
        return host_error(h, EX_UNAVAILABLE, "port.not-opened", (host_place){ .file = name },
                          "see `loft ports` for the ports there are", "%s", strerror(error));
    }
}

static bool later(int error) { return error == EAGAIN || error == EWOULDBLOCK || error == EINTR; }

static long fd_read(transport *t, void *bytes, size_t max)
{
    struct pollfd p = { .fd = t->in, .events = POLLIN };
    const int ready = poll(&p, 1, 0);

    if (ready <= 0)
        return ready == 0 || errno == EINTR ? 0 : -1;
    const ssize_t got = read(t->in, bytes, max);
    if (got > 0)
        return (long)got;
    if (got < 0 && later(errno) && !(p.revents & (POLLHUP | POLLERR)))
        return 0;
    if (got == 0)
        errno = EPIPE;
    return -1;
}

static long fd_write(transport *t, const void *bytes, size_t count)
{
    struct pollfd p = { .fd = t->out, .events = POLLOUT };
    const int ready = poll(&p, 1, 0);

    if (ready <= 0)
        return ready == 0 || errno == EINTR ? 0 : -1;
    const ssize_t put = write(t->out, bytes, count);
    return put >= 0 ? (long)put : later(errno) ? 0 : -1;
}

static void fd_close(transport *t)
{
    close(t->in);
    if (t->out != t->in)
        close(t->out);
}

static const transport_kind kind = { fd_read, fd_write, fd_close };

int transport_take(transport *t, int in, int out, const char *name)
{
    t->kind = &kind;
    t->in   = in;
    t->out  = out;
    snprintf(t->text, sizeof t->text, "%.120s", name);
    return 0;
}
