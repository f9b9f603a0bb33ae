/* host-tools/cmd/cmd_ports.c -- loft ports: the serial ports of this computer
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include "cmd/commands.h"
#include "base/say.h"
#include "cmd/run.h"            /* run_open */
#include "send/transport.h"      /* transport_ports */

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
    const int code = run_open(&t, &(talk_options){ .port = name, .baud = baud, .wait = 2.5 });

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

typedef struct {
    bool ask;
    unsigned baud;
    option_words ports;
} ports_options;

static const option ports_rows[] = {
    { "ask", OPTION_FLAG(ports_options, ask),
      .help = "ask at each port, or at the ports that are named, who answers: moves nothing" },
    { "baud", OPTION_INTEGER(ports_options, baud), .least = 300, .most = 4000000, .value = "RATE",
      .standard = "115200", .help = "to ask with" },
    { "ports", OPTION_WORDS(ports_options, ports), .most = 1e6, .value = "PORT" },
    { 0 }
};

static int run_ports(void *options)
{
    const ports_options *o = options;
    asking a               = { .who = o->ask, .baud = o->baud };
    int code               = 0;

    for (size_t i = 0; i < o->ports.count; i++) {
        const int failed = ask_port(o->ports.word[i], o->baud);
        code             = failed != 0 ? failed : code;
    }
    if (o->ports.count > 0)
        return code;
    code = transport_ports(tool_host(), print_port, &a);
    if (code == 0 && a.count == 0)
        (void)tool_error(
            EX_OK,
            "no serial ports: plug the machine in, or name a pty, unix:PATH or tcp:HOST:PORT");
    return code;
}

const command command_ports = {
    .name = "ports",
    .arguments = "[--ask] [PORT ..]",
    .summary = "the serial ports of this computer, and who answers there",
    .detail =
        "Prints name and description, and for USB the identity, separated by tabs. Pseudo "
        "terminals "
        "and sockets are not\n"
        "listed, but can be named, here and to --port. Asks the ports that are named, or all with "
        "--ask: the machine's axes,\n"
        "ticks, slots, queue and gearing. Opening the port resets some boards.\n",
    .options = ports_rows,
    .size = sizeof(ports_options),
    .run = run_ports,
    .talks = true,
};
