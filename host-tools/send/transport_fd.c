/* host-tools/send/transport_fd.c -- ptys and other terminals, sockets, standard input and output
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <termios.h>
#include <unistd.h>

#include "host/baud.h"      /* host_baud */

#include "base/host.h"
#include "send/transport_kind.h"

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

int transport_open_unix(transport *t, host *h, const char *name)
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

/* From now on the program prints to standard error: standard output is the line. It stays blocking,
 * since its flags are shared with other programs; poll keeps us from waiting. */
int transport_open_standard(transport *t, host *h)
{
    const int in = dup(STDIN_FILENO), out = dup(STDOUT_FILENO);

    if (in < 0 || out < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
        return transport_refused(h, "standard input and output", errno);
    return transport_take(t, in, out, "standard input and output");
}
