/* tests/target/rate.c -- runs a machine at a given rate: some axes move straight, all at the same
 * number of steps per tick
 * SPDX-License-Identifier: MIT
 * usage: rate PORT AXES STEPS_PER_TICK [FILTER[!] [probe]]
 * Prints `ticks elapsed slowed` and the positions reached, and fails if they are not those of the
 * plan. With FILTER, in ms, the limit switch of x guards the job, or the probe, and !: stops it at
 * once: prints `latched` and the place, and fails if that has not ended the job.
 */
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#include "wire/sender.h"

#define RAMP    100         /* ticks from rest to the rate, and back */
#define SPANS   6           /* ramp, four at the rate, ramp              */

static loft_item item[SPANS];
static int32_t end_steps;

static uint32_t now_ms(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (uint32_t)((uint64_t)t.tv_sec * 1000u + (uint64_t)t.tv_nsec / 1000000u);
}

static void source(void *context, uint32_t index, loft_item *out)
{
    (void)context;
    *out = item[index];
}

/* A parabola in time at both ends: with d its length, its control values are 0 0 d/3 d and 0 2d/3 d
 * d. */
static void plan(const loft_sender *s, int axes, double rate)
{
    for (int i = 0; i < axes; i++) {
        const double per_mm = s->axis[i].steps_per_mm / 65536.0, d = rate * RAMP / per_mm * 65536;
        double at = (double)s->axis[i].position / per_mm * 65536;

        end_steps = (int32_t)(at / 65536 * per_mm + rate * RAMP * (SPANS - 1) + 0.5);
        for (int k = 0; k < SPANS; k++) {
            const double length = k == 0 || k == SPANS - 1 ? d / 2 : d;
            item[k].p[0][i] = (int32_t)(at + (k == 0           ? 0
                                              : k == SPANS - 1 ? 2 * length / 3
                                                               : length / 3));
            item[k].p[1][i] = (int32_t)(at + (k == 0           ? length / 3
                                              : k == SPANS - 1 ? length
                                                               : 2 * length / 3));
            item[k].p[2][i] = (int32_t)(at += length);
            item[k].ticks = RAMP;
        }
    }
    for (int i = axes; i < LOFT_AXES; i++)
        for (int k = 0; k < SPANS; k++)
            for (int j = 0; j < 3; j++)
                item[k].p[j][i] = (int32_t)((int64_t)s->axis[i].position * 65536 * 65536 /
                                            s->axis[i].steps_per_mm);
}

static int begin(loft_sender *s, int axes, double rate, const char *filter, uint16_t inputs)
{
    loft_job job = { .kind = LOFT_SPANS };

    if (filter)
        job.guard = (loft_guard){ .inputs = inputs,
                                  .how    = strchr(filter, '!') ? LOFT_GUARD_HARD : 0,
                                  .filter = (uint8_t)atoi(filter) };

    plan(s, axes, rate);
    for (int i = 0; i < LOFT_AXES; i++)
        job.start[i] = (int32_t)((int64_t)s->axis[i].position * 65536 * 65536 /
                                 s->axis[i].steps_per_mm);
    job.id = loft_job_id(&job, SPANS, source, NULL);
    return loft_sender_begin(s, &job, SPANS, source, NULL) == LOFT_OK ? 0 : 1;
}

static int open_port(const char *name)
{
    struct termios mode;
    const int fd = open(name, O_RDWR | O_NOCTTY | O_NONBLOCK);

    if (fd < 0 || tcgetattr(fd, &mode) != 0)
        return -1;
    cfmakeraw(&mode);
    return tcsetattr(fd, TCSANOW, &mode) == 0 ? fd : -1;
}

/* Write all bytes. Returns false if the line is gone, or takes nothing for 15 s. */
static bool give(int fd, const uint8_t *byte, size_t count)
{
    for (size_t sent = 0; sent < count;) {
        struct pollfd p = { .fd = fd, .events = POLLOUT };
        const ssize_t put = write(fd, byte + sent, count - sent);
        if (put < 0 && errno != EAGAIN && errno != EINTR)
            return false;
        if (put <= 0 && poll(&p, 1, 15000) == 0)
            return false;
        sent += put > 0 ? (size_t)put : 0;
    }
    return true;
}

int main(int argc, char **argv)
{
    const bool known = argc >= 4 && argc <= 6;
    const int fd = known ? open_port(argv[1]) : -1, axes = known ? atoi(argv[2]) : 0;
    const uint16_t inputs = argc == 6 ? LOFT_INPUT_PROBE : LOFT_INPUT_ENDS(0);
    static loft_sender s;
    int failed = 0;

    if (fd < 0 || axes < 1 || axes > LOFT_AXES) {
        fprintf(stderr, "usage: rate PORT AXES STEPS_PER_TICK [FILTER [probe]]\n");
        return 64;
    }
    loft_sender_init(&s, now_ms() + (uint32_t)getpid(), now_ms());
    while (s.phase < LOFT_PHASE_DONE && !failed && now_ms() - s.heard < 15000) {
        uint8_t byte[256], wire[LOFT_FRAME_MAX + 1];
        struct pollfd p = { .fd = fd, .events = POLLIN };
        const size_t count = loft_sender_poll(&s, now_ms(), wire);
        if (!give(fd, wire, count)) {
            perror(argv[1]);
            return 1;
        }
        if (count)
            continue;
        poll(&p, 1,
             (int)(loft_sender_wait(&s, now_ms()) < 20 ? loft_sender_wait(&s, now_ms()) : 20));
        const ssize_t got = read(fd, byte, sizeof byte);
        for (ssize_t i = 0; i < got; i++)
            (void)loft_sender_push(&s, byte[i], now_ms());
        if (s.phase == LOFT_PHASE_READY)
            failed = begin(&s, axes, atof(argv[3]), argc >= 5 ? argv[4] : NULL, inputs);
    }
    printf("ticks %u elapsed %u slowed %u position", (unsigned)s.report.ticks,
           (unsigned)s.report.elapsed, (unsigned)s.report.slowed);
    for (int i = 0; i < LOFT_AXES; i++)
        printf(" %d", (int)s.report.position[i]);
    printf(" planned %d\n", (int)end_steps);
    if (argc >= 5) {
        printf("latched %d\n", (int)s.report.latched[0]);
        return s.phase != LOFT_PHASE_ABORTED || s.report.ended_by != inputs;
    }
    for (int i = 0; i < axes; i++)
        failed |= s.report.position[i] != end_steps;
    return failed || s.phase != LOFT_PHASE_DONE;
}
