/* host-tools/cmd/cmd_ports.c -- loft ports: the serial ports of this computer
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include <libserialport.h>

#include "send/talk.h"           /* talk_open */
#include "base/tool.h"

static const char *or_none(const char *text)
{
    return text ? text : "";
}

static void print_port(struct sp_port *port)
{
    int vendor, product;

    printf("%s\t%s", sp_get_port_name(port), or_none(sp_get_port_description(port)));
    if (sp_get_port_transport(port) == SP_TRANSPORT_USB &&
        sp_get_port_usb_vid_pid(port, &vendor, &product) == SP_OK)
        printf("\tusb %04x:%04x %s", (unsigned)vendor, (unsigned)product,
               or_none(sp_get_port_usb_serial(port)));
    putchar('\n');
}

/* Who answers there: one line, on standard error if nobody does. */
static int ask(const char *name, unsigned baud)
{
    char closed[256];
    talk t;
    const int code = talk_open(&t, name, baud, 2.5, NULL);

    if (code != 0)
        return code;
    printf("%s\tloft, %u axes, %u ticks/s, %u slots, queue of %u spans or %u points", name,
           t.sender.machine.axes, t.sender.machine.tick_hz, t.sender.machine.slots,
           t.sender.machine.queue, t.sender.machine.points);
    for (int i = 0; i < LOFT_AXES; i++)
        printf("%s%g", i ? " " : "\tsteps/mm ", t.sender.axis[i].steps_per_mm / 65536.0);
    printf("\t%s", t.sender.machine.job != 0 ? "in a job" : "idle");
    if (t.sender.closed & LOFT_INPUT_ENDING)
        printf("\tclosed: %s", talk_inputs(t.sender.closed, closed));
    putchar('\n');
    talk_close(&t);
    return 0;
}

static int run(const tool_command *self, int argc, char **argv)
{
    unsigned baud = 115200;
    bool who = false;
    const tool_option options[] = {
        TOOL_SWITCH("ask", &who,
                    "ask at each port, or at the ports that are named, who answers: moves nothing"),
        TOOL_COUNT("baud", "RATE", &baud, 300, 4000000, "to ask with (115200)"), TOOL_OPTIONS_END
    };
    struct sp_port **list = NULL;
    int first;
    const int code = tool_options(self, options, argc, argv, &first);

    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    if (first < argc) {
        int worst = 0;
        for (int i = first; i < argc; i++) {
            const int failed = ask(argv[i], baud);
            worst = failed != 0 ? failed : worst;
        }
        return worst;
    }
    if (sp_list_ports(&list) != SP_OK)
        list = NULL;            /* a system without /sys/class/tty has no ports */
    if (list == NULL || list[0] == NULL)
        (void)tool_error(
            EX_OK,
            "no serial ports: plug the machine in, or name a pty, unix:PATH or tcp:HOST:PORT");
    for (size_t i = 0; list && list[i]; i++)
        if (who)
            (void)ask(sp_get_port_name(list[i]), baud);
        else
            print_port(list[i]);
    if (list)
        sp_free_port_list(list);
    return EX_OK;
}

const tool_command command_ports = {
    "ports", "[--ask] [PORT ..]", "the serial ports of this computer, and who answers there",
    "Prints name and description, and for USB the identity, separated by tabs. Pseudo terminals "
    "and sockets are not\n"
    "listed, but can be named, here and to --port. Asks the ports that are named, or all with "
    "--ask: the machine's axes,\n"
    "ticks, slots, queue and gearing. Opening the port resets some boards.\n",
    run
};
