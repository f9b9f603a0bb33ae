/* host-tools/send/without_serial.c -- replaces serial ports if loft is built without libserialport;
 * ptys and sockets remain
 * SPDX-License-Identifier: MIT
 */
#include "base/host.h"
#include "send/transport_kind.h"

int transport_open_serial(transport *t, host *h, const char *name, unsigned baud)
{
    (void)t;
    (void)h;
    (void)name;
    (void)baud;
    return TRANSPORT_OTHER;
}

int transport_ports(host *h, void (*each)(void *context, const transport_port *port), void *context)
{
    (void)each;
    (void)context;
    return host_error(h, EX_UNAVAILABLE, "port.no-list", (host_place){ .file = NULL },
                      "name a terminal, unix:PATH or tcp:HOST:PORT",
                      "this loft was built without libserialport, which lists ports");
}
