/* host-tools/send/transport_serial.c -- serial ports through libserialport
 * SPDX-License-Identifier: MIT
 *
 * The library leaves this to us. A read of an unplugged port returns 0, as a timeout does: after
 * each 0, sp_input_waiting tells the two apart. Its blocking read spins: we poll the descriptor.
 * Drivers accept baud rates that they do not support: we read the rate back. It admits a second
 * owner: we lock the port. Closing drops DTR, which resets many boards: we clear HUPCL, so a second
 * run finds the machine where it stands.
 */
#include <errno.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <termios.h>

#include <libserialport.h>

#include "base/host.h"
#include "send/transport_kind.h"

static long serial_read(transport *t, void *bytes, size_t max)
{
    struct pollfd p = { .fd = t->in, .events = POLLIN };

    if (poll(&p, 1, 0) < 0 && errno != EINTR)
        return -1;
    const long got = sp_nonblocking_read(t->port, bytes, max);
    if (got < 0 || (got == 0 && sp_input_waiting(t->port) < 0)) {
        errno = sp_last_error_code();
        return -1;
    }
    return got;
}

static long serial_write(transport *t, const void *bytes, size_t count)
{
    struct pollfd p = { .fd = t->out, .events = POLLOUT };

    if (poll(&p, 1, 0) < 0 && errno != EINTR)
        return -1;
    const long put = sp_nonblocking_write(t->port, bytes, count);
    if (put < 0) {
        errno = sp_last_error_code();
        return errno == EAGAIN || errno == EINTR ? 0 : -1;
    }
    return put;
}

/* No sp_drain: it waits forever on a device that holds the line. */
static void serial_close(transport *t)
{
    sp_close(t->port);
    sp_free_port(t->port);
}

/* 8N1, no flow control, in one call: each separate setter costs a round trip on USB. */
static bool configure(struct sp_port *port, unsigned baud)
{
    struct sp_port_config *c;

    if (sp_new_config(&c) != SP_OK)
        return false;
    const bool good = sp_set_config_baudrate(c, (int)baud) == SP_OK &&
                      sp_set_config_bits(c, 8) == SP_OK &&
                      sp_set_config_parity(c, SP_PARITY_NONE) == SP_OK &&
                      sp_set_config_stopbits(c, 1) == SP_OK &&
                      sp_set_config_flowcontrol(c, SP_FLOWCONTROL_NONE) == SP_OK &&
                      sp_set_config(port, c) == SP_OK;
    sp_free_config(c);
    return good;
}

static int baud_of(struct sp_port *port)
{
    struct sp_port_config *c;
    int baud = 0;

    if (sp_new_config(&c) != SP_OK)
        return 0;
    if (sp_get_config(port, c) != SP_OK || sp_get_config_baudrate(c, &baud) != SP_OK)
        baud = 0;
    sp_free_config(c);
    return baud;
}

/* Keep DTR up after closing, and keep others out. */
static void keep(int fd)
{
    struct termios mode;

    (void)ioctl(fd, TIOCEXCL);
    if (tcgetattr(fd, &mode) == 0) {
        mode.c_cflag &= ~(tcflag_t)HUPCL;
        (void)tcsetattr(fd, TCSANOW, &mode);
    }
}

static int set_up(transport *t, host *h, const char *name, unsigned baud)
{
    struct sp_port *port = t->port;
    int fd;

    if (sp_get_port_handle(port, &fd) != SP_OK)
        return transport_refused(h, name, sp_last_error_code());
    if (!transport_own(h, fd, name))
        return EX_UNAVAILABLE;
    const bool configured = configure(port, baud);
    const int got         = baud_of(port);
    if (!configured || got != (int)baud)
        return host_error(h, EX_UNAVAILABLE, "port.baud-not-taken", (host_place){ .file = name },
                          "give a --baud that it has", "asked for %u baud, the port has %d", baud,
                          got);
    keep(fd);
    static const transport_kind kind = { serial_read, serial_write, serial_close };
    t->kind = &kind;
    t->in   = t->out = fd;
    t->baud = baud;
    snprintf(t->text, sizeof t->text, "%.90s at %u baud", name, baud);
    return 0;
}

int transport_open_serial(transport *t, host *h, const char *name, unsigned baud)
{
    struct sp_port *port;

    if (sp_get_port_by_name(name, &port) != SP_OK)
        return TRANSPORT_OTHER;
    if (sp_open(port, SP_MODE_READ_WRITE) != SP_OK) {
        const int error = sp_last_error_code();
        sp_free_port(port);
        return error == ENOTTY ? TRANSPORT_OTHER : transport_refused(h, name, error);
    }
    t->port = port;
    const int code = set_up(t, h, name, baud);
    if (code != 0)
        serial_close(t);
    return code;
}

static const char *or_none(const char *text) { return text ? text : ""; }

int transport_ports(host *h, void (*each)(void *context, const transport_port *port), void *context)
{
    struct sp_port **list = NULL;

    (void)h;
    if (sp_list_ports(&list) != SP_OK)
        return 0;               /* a system without /sys/class/tty has no ports */
    for (size_t i = 0; list[i]; i++) {
        char usb[120] = "";
        int vendor, product;
        if (sp_get_port_transport(list[i]) == SP_TRANSPORT_USB &&
            sp_get_port_usb_vid_pid(list[i], &vendor, &product) == SP_OK)
            snprintf(usb, sizeof usb, "%04x:%04x %s", (unsigned)vendor, (unsigned)product,
                     or_none(sp_get_port_usb_serial(list[i])));
        const transport_port port = { sp_get_port_name(list[i]),
                                      or_none(sp_get_port_description(list[i])), usb };
        each(context, &port);
    }
    sp_free_port_list(list);
    return 0;
}
