/* host-tools/send/without_serial.c -- replaces serial ports if loft is built without libserialport;
 * ptys and sockets remain
 * SPDX-License-Identifier: MIT
 */
#include "base/tool.h"
#include "send/transport.h"

int transport_open_serial(transport *t, const char *name, unsigned baud)
{
    (void)t;
    (void)name;
    (void)baud;
    return TRANSPORT_OTHER;
}

int transport_ports(void (*each)(void *context, const transport_port *port), void *context)
{
    (void)each;
    (void)context;
    return tool_error(EX_UNAVAILABLE, "this loft was built without libserialport, which lists "
                                      "ports: name a terminal, unix:PATH or tcp:HOST:PORT");
}
