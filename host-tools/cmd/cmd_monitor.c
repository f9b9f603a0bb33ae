/* host-tools/cmd/cmd_monitor.c -- loft monitor: sits between a sender and its machine, and prints
 * the traffic in words
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <string.h>

#include "cmd/commands.h"
#include "host/line.h"  /* host_line: the sender's side */
#include "cmd/keys.h"  /* keys_interrupted */
#include "cmd/run.h"   /* run_line */
#include "send/transport.h"
#include "send/wire_text.h"

typedef struct {
    transport machine;
    struct host_line sender;
    wire_text down, up;
    double began;
} monitor;

static void wait_line(int fd, short events, int most_ms)
{
    struct pollfd p = { .fd = fd, .events = events };

    (void)poll(&p, 1, most_ms);
}

/* Pass bytes to the machine. Returns false if it is gone. */
static bool pass_down(monitor *m, const uint8_t byte[], size_t count)
{
    const double until = tool_clock() + 10;

    for (size_t sent = 0; sent < count;) {
        wait_line(m->machine.out, POLLOUT, 100);
        const long put = m->machine.kind->write(&m->machine, byte + sent, count - sent);
        if (put < 0 || tool_clock() > until)
            return false;
        sent += (size_t)put;
    }
    return true;
}

/* Pass bytes to the sender. If nobody reads them they are dropped, as on a real line. */
static void pass_up(monitor *m, const uint8_t byte[], size_t count)
{
    for (size_t sent = 0, put = 1; sent < count && put > 0; sent += put)
        put = host_line_write(&m->sender, byte + sent, count - sent);
}

static int relay(monitor *m)
{
    uint8_t byte[512];

    while (!keys_interrupted()) {
        wait_line(m->machine.in, POLLIN, 2);
        const long came = m->machine.kind->read(&m->machine, byte, sizeof byte);
        if (came < 0)
            return tool_error(EX_IOERR, "%s: the port has vanished (%s)", m->machine.text,
                              strerror(errno));
        wire_text_push(&m->up, stdout, tool_clock() - m->began, byte, (size_t)came);
        pass_up(m, byte, (size_t)came);
        const size_t count = host_line_read(&m->sender, byte, sizeof byte);
        wire_text_push(&m->down, stdout, tool_clock() - m->began, byte, count);
        if (!pass_down(m, byte, count))
            return tool_error(EX_IOERR, "%s: the port takes no more bytes (%s)", m->machine.text,
                              strerror(errno));
    }
    return 0;
}

static void print_sum(const wire_text *w)
{
    printf("%c %llu bytes, %llu frames, %llu damaged\n", w->arrow, w->bytes, w->frames, w->damaged);
}

typedef struct {
    const char *port, *link;
    unsigned baud;
} monitor_options;

static const option monitor_rows[] = {
    { "port", OPTION_FILE(monitor_options, port), .value = "PORT",
      .help = "the machine: /dev/ttyUSB0, a pty, unix:PATH, tcp:HOST:PORT (`loft ports` lists)" },
    { "baud", OPTION_INTEGER(monitor_options, baud), .least = 300, .most = 4000000, .value = "RATE",
      .standard = "115200", .help = "of a serial port" },
    { "link", OPTION_FILE(monitor_options, link), .value = "PATH",
      .help = "make PATH a symbolic link to the sender's end" },
    OPTION_NO_WORDS("monitor takes no file"),
    OPTION_NEEDS("", "port", "name the machine's port; see `loft monitor --help`"),
    { 0 }
};

static int run_monitor(void *options)
{
    const monitor_options *o = options;
    monitor m                = { .began = tool_clock() };
    int code;

    keys_start(false);
    if ((code = run_line(&m.machine, o->port, o->baud)) != 0)
        return code;
    if ((code = host_line_open(&m.sender, o->link, 0)) == 0) {
        wire_text_init(&m.down, '>');
        wire_text_init(&m.up, '<');
        printf("machine: %s\n", m.sender.name);
        fflush(stdout);
        code = relay(&m);
        print_sum(&m.down);
        print_sum(&m.up);
        host_line_close(&m.sender);
    }
    m.machine.kind->close(&m.machine);
    return code;
}

const command command_monitor = {
    .name = "monitor",
    .arguments = "--port PORT [--link PATH]",
    .summary = "between a sender and its machine: the line in words",
    .detail =
        "Makes a pseudo terminal, prints its name and passes all bytes between it and PORT. Give\n"
        "its name, or PATH, to `loft stream --port`. Prints each frame as a line: seconds, > to\n"
        "the machine or < from it, kind, fields. ^C ends it.\n",
    .options = monitor_rows,
    .size = sizeof(monitor_options),
    .run = run_monitor,
    .talks = true,
};
