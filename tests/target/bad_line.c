/* tests/target/bad_line.c -- a bad line in front of a machine's socket: bytes are lost, doubled,
 * changed and inserted, and the cable is unplugged
 * SPDX-License-Identifier: MIT
 * usage: bad_line SOCKET MACHINE BAUD SEED BYTES OUTAGES OUTAGE_MS
 *
 * Serves the Unix socket SOCKET, one client after the other, and passes bytes to and from the Unix
 * socket MACHINE, at BAUD. Of a million bytes, BYTES have a flipped bit, and as many are dropped,
 * doubled, or preceded by another one. A third of that are bursts, and earlier frames are repeated.
 * In a million milliseconds the cable is unplugged OUTAGES times, for up to OUTAGE_MS. Runs until
 * it is killed; then prints how many bytes arrived differently, and how often the cable was
 * unplugged.
 */
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <time.h>
#include <unistd.h>

#include "support/line.h"               /* line, line_faults: the faults of bytes */

static volatile sig_atomic_t stop_wanted;

static void want_stop(int number)
{
    (void)number;
    stop_wanted = 1;
}

static uint32_t byte_us;            /* the duration of a byte */

static uint64_t now_us(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (uint64_t)t.tv_sec * 1000000 + (uint64_t)t.tv_nsec / 1000;
}

static int die(const char *what)
{
    perror(what);
    exit(71);
}

static struct sockaddr_un address_of(const char *path)
{
    struct sockaddr_un address = { .sun_family = AF_UNIX };

    snprintf(address.sun_path, sizeof address.sun_path, "%s", path);
    return address;
}

static int served(const char *path)
{
    const struct sockaddr_un address = address_of(path);
    const int server = socket(AF_UNIX, SOCK_STREAM, 0);

    unlink(path);
    if (server < 0 || bind(server, (const struct sockaddr *)&address, sizeof address) != 0 ||
        listen(server, 1) != 0)
        die(path);
    return server;
}

static int connected(const char *path)
{
    const struct sockaddr_un address = address_of(path);
    const int fd = socket(AF_UNIX, SOCK_STREAM, 0);

    for (int tries = 0; connect(fd, (const struct sockaddr *)&address, sizeof address) != 0;
         tries++) {
        if (tries == 500)
            die(path);
        usleep(20000);
    }
    return fd;
}

/* Send one byte into the line. Returns true if it will come out unchanged. */
static bool send_byte(line *l, arb *a, const line_faults *f, uint8_t byte, uint64_t now)
{
    const uint32_t before = l->in;

    l->clock = (l->clock > now ? l->clock : now) + byte_us;
    if (l->out_size < sizeof l->out_frame)
        l->out_frame[l->out_size++] = byte;
    if (byte == 0) {
        line_remember(l);
        l->out_size = 0;
    }
    line_send(l, a, f, byte, (uint32_t)(l->clock / 1000));
    return l->in == before + 1 && l->byte[before % LINE_ROOM] == byte;
}

/* Send the bytes of `from` into the line. Returns the number of damaged bytes, or -1 if `from` is
 * gone. */
static int take(int from, line *l, arb *a, const line_faults *f, uint64_t now)
{
    uint8_t bytes[512];
    const ssize_t got = read(from, bytes, sizeof bytes);
    int damaged = 0;

    if (got <= 0)
        return -1;
    for (ssize_t k = 0; k < got; k++)
        damaged += !send_byte(l, a, f, bytes[k], now);
    return damaged;
}

/* Deliver what has arrived. Never waits: an emulator that writes does not read. */
static void give(int to, line *l, uint32_t now)
{
    for (; l->out != l->in && (int32_t)(now - l->due[l->out % LINE_ROOM]) >= 0; l->out++)
        if (to >= 0 && send(to, &l->byte[l->out % LINE_ROOM], 1, MSG_DONTWAIT) != 1)
            return;
}

int main(int argc, char **argv)
{
    static line up, down;               /* to the machine, and from it */
    unsigned long damaged = 0, outages = 0, bytes;

    if (argc != 8) {
        fprintf(stderr, "usage: bad_line SOCKET MACHINE BAUD SEED BYTES OUTAGES OUTAGE_MS\n");
        return 64;
    }
    bytes = strtoul(argv[5], NULL, 10);
    byte_us = 10000000 / (uint32_t)strtoul(argv[3], NULL, 10);
    arb a = arb_start(strtoull(argv[4], NULL, 10));
    const line_faults f = { .flip = (uint32_t)bytes,
                            .drop = (uint32_t)bytes,
                            .twice = (uint32_t)bytes,
                            .insert = (uint32_t)bytes,
                            .burst = (uint32_t)bytes / 3,
                            .outage = (uint32_t)strtoul(argv[6], NULL, 10),
                            .outage_ms = (uint32_t)strtoul(argv[7], NULL, 10),
                            .replay = (uint32_t)bytes };
    signal(SIGTERM, want_stop);
    signal(SIGPIPE, SIG_IGN);
    const int server = served(argv[1]), machine = connected(argv[2]);
    int client = -1;
    for (uint32_t past = (uint32_t)(now_us() / 1000); !stop_wanted;) {
        struct pollfd p[2] = { { .fd = client >= 0 ? client : server, .events = POLLIN },
                               { .fd = machine, .events = POLLIN } };
        poll(p, 2, 1);
        const uint64_t us = now_us();
        const uint32_t now = (uint32_t)(us / 1000);
        for (; past != now; past++) {           /* the cable has both directions */
            const bool was = up.dead;
            line_trouble(&up, &a, &f, past);
            outages += up.dead && !was;
            down.dead = up.dead;
        }
        if (p[1].revents) {
            const int n = take(machine, &down, &a, &f, us);
            if (n < 0)
                break;
            damaged += (unsigned long)n;
        }
        if (p[0].revents && client < 0) {
            client = accept(server, NULL, NULL);
        } else if (p[0].revents) {
            const int n = take(client, &up, &a, &f, us);
            damaged += n > 0 ? (unsigned long)n : 0;
            if (n < 0) {
                close(client);
                client = -1;
            }
        }
        give(machine, &up, now);
        give(client, &down, now);
    }
    printf("damaged %lu outages %lu\n", damaged, outages);
    return 0;
}
