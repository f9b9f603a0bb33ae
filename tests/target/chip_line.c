/* tests/target/chip_line.c
 * SPDX-License-Identifier: MIT
 */
#include "chip_line.h"

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sysexits.h>
#include <time.h>
#include <unistd.h>

/* of real time without an expected byte: the sender is gone, not only busy */
#define QUIET_MS    10000
#define LEAVE_MS    10000           /* time to read the last answer */

static volatile sig_atomic_t stop_wanted;

static void want_stop(int signal)
{
    (void)signal;
    stop_wanted = 1;
}

bool chip_line_stopped(void) { return stop_wanted; }

static int64_t now_ms(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (int64_t)t.tv_sec * 1000 + t.tv_nsec / 1000000;
}

/* One host. */
static int serve_socket(struct chip_line *l, const char *path)
{
    struct sockaddr_un address = { .sun_family = AF_UNIX };
    const int server = socket(AF_UNIX, SOCK_STREAM, 0);

    snprintf(address.sun_path, sizeof address.sun_path, "%s", path);
    l->line = (struct host_line){ .master = -1, .slave = -1 };
    if (server >= 0 && bind(server, (struct sockaddr *)&address, sizeof address) == 0 &&
        listen(server, 1) == 0)
        l->line.master = accept(server, NULL, NULL);
    close(server);
    if (l->line.master < 0 || fcntl(l->line.master, F_SETFL, O_NONBLOCK) != 0) {
        perror(path);
        return EX_OSERR;
    }
    return 0;
}

int chip_line_open(struct chip_line *l, const char *link, const char *socket)
{
    gate_init(&l->gate);
    signal(SIGTERM, want_stop);
    signal(SIGPIPE, SIG_IGN);
    l->free = socket != NULL;
    if (socket)
        return serve_socket(l, socket);
    const int code = host_line_open(&l->line, link, 0);
    if (code == 0) {
        printf("machine: %s\n", l->line.name);
        fflush(stdout);
    }
    return code;
}

void chip_line_close(struct chip_line *l) { host_line_close(&l->line); }

void chip_line_out(struct chip_line *l, uint8_t byte)
{
    l->out[l->out_head++] = byte;
    gate_machine(&l->gate, byte);
}

static void take_bytes(struct chip_line *l)
{
    uint8_t byte[256];
    const size_t count = host_line_read(&l->line, byte, sizeof byte);

    for (size_t i = 0; i < count; i++) {
        l->put(l->context, byte[i]);
        gate_host(&l->gate, byte[i]);
    }
    l->taken += count;
}

static void give_bytes(struct chip_line *l)
{
    while (l->out_tail != l->out_head) {
        const size_t most = l->out_head > l->out_tail ? (size_t)(l->out_head - l->out_tail)
                                                      : sizeof l->out - l->out_tail;
        const size_t count = host_line_write(&l->line, l->out + l->out_tail, most);
        if (count == 0)
            return;
        l->out_tail = (uint16_t)(l->out_tail + count);
    }
}

/* Let the host speak while it is its turn: during a job until it has sent what it may, otherwise
 * until it sends anything. If it does not send, stop waiting until it may send more. */
static void wait_for_host(struct chip_line *l)
{
    const bool busy = gate_busy(&l->gate);
    const int64_t began = now_ms();
    sigset_t none;

    sigemptyset(&none);
    for (;;) {
        const uint64_t before = l->taken;
        give_bytes(l);
        take_bytes(l);
        if (stop_wanted || (busy ? !gate_owed(&l->gate) : l->taken != before))
            return;
        if (busy && now_ms() - began > QUIET_MS) {
            l->given_up = l->gate.ack.limit;
            l->waits++;
            return;
        }
        host_line_wait(&l->line, l->out_tail != l->out_head, busy ? 20 : -1, &none);
    }
}

void chip_line_turn(struct chip_line *l, bool pending)
{
    give_bytes(l);
    if (!l->free &&
        (gate_busy(&l->gate) ? gate_owed(&l->gate) && l->gate.ack.limit != l->given_up : !pending))
        wait_for_host(l);
    else
        take_bytes(l);
    if (l->free && !gate_busy(&l->gate)) {      /* do not race through idle time */
        sigset_t none;
        sigemptyset(&none);
        host_line_wait(&l->line, false, 1, &none);
    }
}

void chip_line_leave(struct chip_line *l)
{
    for (const int64_t began = now_ms(); now_ms() - began < LEAVE_MS;) {
        give_bytes(l);
        usleep(30000);                  /* a pseudo terminal delays bytes */
        if (l->out_tail == l->out_head && (l->free || host_line_drained(&l->line)))
            break;
    }
}
