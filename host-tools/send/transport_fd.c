/* host-tools/send/transport_fd.c -- ptys and other terminals, sockets, standard input and output
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <termios.h>
#include <unistd.h>

#include "host/baud.h"      /* host_baud */

#include "base/host.h"
#include "send/transport.h"

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

/* Raw bytes, no modem lines. The lock is advisory: TIOCEXCL would outlive a killed sender on a
 * pty. */
static int make_raw(host *h, int fd, const char *name, unsigned baud)
{
    struct termios mode;
    speed_t speed;

    if (!host_baud(baud, &speed))
        return host_error(h, EX_USAGE, "port.baud", (host_place){ .file = NULL },
                          "give 9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600 ..",
                          "--baud %u", baud);
    if (tcgetattr(fd, &mode) != 0)
        return transport_refused(h, name, errno);
    cfmakeraw(&mode);
    cfsetispeed(&mode, speed);
    cfsetospeed(&mode, speed);
    mode.c_cflag |= CLOCAL | CREAD;
    mode.c_cflag &= ~(tcflag_t)(HUPCL | CRTSCTS);
    mode.c_cc[VMIN]  = 1;
    mode.c_cc[VTIME] = 0;
    return tcsetattr(fd, TCSANOW, &mode) == 0 ? 0 : transport_refused(h, name, errno);
}

int transport_open_terminal(transport *t, host *h, const char *name, unsigned baud)
{
    const int fd = open(name, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    struct termios mode;
    int code = 0;

    if (fd < 0)
        return transport_refused(h, name, errno);
    if (tcgetattr(fd, &mode) != 0)
        code = host_error(h, EX_UNAVAILABLE, "port.not-serial", (host_place){ .file = name },
                          "see `loft ports`, or name a pty, unix:PATH or tcp:HOST:PORT",
                          "not a serial port");
    else if (!transport_own(h, fd, name))
        code = EX_UNAVAILABLE;
    else
        code = make_raw(h, fd, name, baud);
    if (code != 0) {
        close(fd);
        return code;
    }
    return transport_take(t, fd, fd, name);
}

static int open_unix(transport *t, host *h, const char *name)
{
    struct sockaddr_un address = { .sun_family = AF_UNIX };
    const char *path = name + strlen("unix:");

    if (strlen(path) >= sizeof address.sun_path)
        return host_error(h, EX_USAGE, "port.path-too-long", (host_place){ .file = name },
                          HOST_REMEDY("give at most %zu characters", sizeof address.sun_path - 1),
                          "the path is too long");
    strcpy(address.sun_path, path);
    const int fd = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (fd < 0 || connect(fd, (const struct sockaddr *)&address, sizeof address) != 0) {
        const int error = errno == EAGAIN ? EBUSY : errno;      /* others wait to be let in */
        if (fd >= 0)
            close(fd);
        return transport_refused(h, name, error);
    }
    return transport_take(t, fd, fd, name);
}

int transport_open_socket(transport *t, host *h, const char *name)
{
    return strncmp(name, "unix:", 5) == 0 ? open_unix(t, h, name) : transport_open_tcp(t, h, name);
}

/* From now on the program prints to standard error: standard output is the line. It stays blocking,
 * since its flags are shared with other programs; poll keeps us from waiting. */
int transport_open_standard(transport *t, host *h)
{
    const int in = dup(STDIN_FILENO), out = dup(STDOUT_FILENO);

    if (in < 0 || out < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
        return transport_refused(h, "standard input and output", errno);
    return transport_take(t, in, out, "standard input and output");
}
