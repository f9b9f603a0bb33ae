/* host-tools/cmd_ports.c -- loft ports: the serial ports of this computer
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include <libserialport.h>

#include "tool.h"

static const char *or_none(const char *text)
{
    return text ? text : "";
}

static void print_port(struct sp_port *port)
{
    int vendor, product;

    printf("%s\t%s", sp_get_port_name(port), or_none(sp_get_port_description(port)));
    if (sp_get_port_transport(port) == SP_TRANSPORT_USB && sp_get_port_usb_vid_pid(port, &vendor, &product) == SP_OK)
        printf("\tusb %04x:%04x %s", (unsigned)vendor, (unsigned)product, or_none(sp_get_port_usb_serial(port)));
    putchar('\n');
}

static int run(const tool_command *self, int argc, char **argv)
{
    const tool_option options[] = { TOOL_OPTIONS_END };
    struct sp_port **list = NULL;
    int first;
    const int code = tool_options(self, options, argc, argv, &first);

    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    if (sp_list_ports(&list) != SP_OK)
        list = NULL;            /* a system without /sys/class/tty has no ports */
    if (list == NULL || list[0] == NULL)
        (void)tool_error(EX_OK, "no serial ports: plug the machine in, or name a pty, unix:PATH or tcp:HOST:PORT");
    for (size_t i = 0; list && list[i]; i++)
        print_port(list[i]);
    if (list)
        sp_free_port_list(list);
    return EX_OK;
}

const tool_command command_ports = {
    "ports", "", "the serial ports of this computer",
    "Prints name and description, and for USB the identity, separated by tabs. Pseudo terminals and sockets are not\n"
    "listed, but can be named to --port all the same.\n",
    run
};
