/* host-tools/cmd/cmd_ports.c -- loft ports: the serial ports of this computer
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include "base/say.h"
#include "send/talk.h"           /* talk_open */
#include "send/transport.h"      /* transport_ports */
#include "base/tool.h"

static const char *state_words(const loft_ack *a)
{
    return a->state == LOFT_STATE_HELD    ? "in a job, held: `loft stream --resume`, or --abort"
           : loft_state_busy(a->state)    ? "in a job"
           : a->state == LOFT_STATE_FAULT ? "has a fault: restart it"
                                          : "idle";
}

/* Print one line about the machine at a port, on standard error if nothing answers. */
static int ask_port(const char *name, unsigned baud)
{
    char closed[256];
    talk t;
    const int code = talk_open(&t, name, baud, 2.5, NULL);

    if (code != 0)
        return code;
    (void)say(stdout, "%s", name);
    printf("\tloft, %u axes, %u ticks/s, %u slots, queue of %u spans or %u points",
           t.sender.machine.axes, t.sender.machine.tick_hz, t.sender.machine.slots,
           t.sender.machine.queue, t.sender.machine.points);
    for (int i = 0; i < LOFT_AXES; i++)
        printf("%s%g", i ? " " : "\tsteps/mm ", t.sender.axis[i].steps_per_mm / 65536.0);
    printf("\t%s", state_words(&t.sender.ack));
    if (t.sender.ack.flags & LOFT_FLAG_LOST)
        printf("\tits position is in doubt: `loft home`, or `loft zero`");
    if (t.sender.closed & LOFT_INPUT_ENDING)
        printf("\tclosed: %s", talk_inputs(t.sender.closed, closed));
    putchar('\n');
    talk_close(&t);
    return 0;
}

typedef struct {
    bool who;
    unsigned baud, count;
} asking;

static void put_row(const transport_port *port)
{
    (void)say(stdout, "%s", port->name);
    (void)say((putchar('\t'), stdout), "%s", port->description);
    if (port->usb[0])
        (void)say((putchar('\t'), stdout), "usb %s", port->usb);
    putchar('\n');
}

static void print_port(void *context, const transport_port *port)
{
    asking *a = context;

    a->count++;
    if (a->who)
        (void)ask_port(port->name, a->baud);
    else
        put_row(port);
}

static int run_ports(const tool_command *self, int argc, char **argv)
{
    asking a = { .who = false, .baud = 115200 };
    const tool_option options[] = {
        TOOL_SWITCH("ask", &a.who,
                    "ask at each port, or at the ports that are named, who answers: moves nothing"),
        TOOL_COUNT("baud", "RATE", &a.baud, 300, 4000000, "to ask with (115200)"), TOOL_OPTIONS_END
    };
    int first;
    int code = tool_options(self, options, argc, argv, &first);

    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    if (first < argc) {
        int worst = 0;
        for (int i = first; i < argc; i++) {
            const int failed = ask_port(argv[i], a.baud);
            worst = failed != 0 ? failed : worst;
        }
        return worst;
    }
    code = transport_ports(print_port, &a);
    if (code == 0 && a.count == 0)
        (void)tool_error(
            EX_OK,
            "no serial ports: plug the machine in, or name a pty, unix:PATH or tcp:HOST:PORT");
    return code;
}

const tool_command command_ports = {
    "ports", "[--ask] [PORT ..]", "the serial ports of this computer, and who answers there",
    "Prints name and description, and for USB the identity, separated by tabs. Pseudo terminals "
    "and sockets are not\n"
    "listed, but can be named, here and to --port. Asks the ports that are named, or all with "
    "--ask: the machine's axes,\n"
    "ticks, slots, queue and gearing. Opening the port resets some boards.\n",
    run_ports
};
