/* tests/bench/bench_line.c -- measures how many sampled points per second a serial line of 115200
 * baud carries, clean and noisy
 * SPDX-License-Identifier: MIT
 * usage: bench_line [POINTS]
 *
 * The points are a motion on three axes at 250 steps/mm, sampled 1000 times a second: moves from
 * place to place by a polynomial of degree five in time (speed and acceleration are continuous), at
 * most 100 mm/s. The parts are loft_sender, a line with ten bits per byte in both directions,
 * loft_receiver, and a machine that takes every item at once. Every point that arrives is compared.
 * Prints lines `RATE points_per_second bytes_per_point resent frames`.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "wire/session.h"

#define BYTES_PER_S 11520
#define QUEUE       256
#define MOST        (1u << 20)

static loft_item point[MOST];
static uint32_t points;
static uint64_t state;

static double random_unit(void)         /* splitmix64 (Steele, Lea, Flood 2014) */
{
    uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (double)((z ^ (z >> 31)) >> 11) / 9007199254740992.0;
}

static void make_points(void)
{
    double from[3] = { 0 }, to[3];

    for (uint32_t n = 0; n < points;) {
        double d = 0;
        for (int i = 0; i < 3; i++) {
            to[i] = 100 * random_unit();
            d += (to[i] - from[i]) * (to[i] - from[i]);
        }
        /* the top speed of the polynomial is 1.875 of the mean */
        const double time = 1.875 * sqrt(d) / 100 + 0.05;
        const uint32_t ticks = (uint32_t)(time * 1000) + 1;
        for (uint32_t k = 1; k <= ticks && n < points; k++, n++) {
            const double u = (double)k / ticks, s = u * u * u * (10 - u * (15 - 6 * u));
            for (int i = 0; i < 3; i++)
                point[n].p[2][i] = (int32_t)lround(250 * (from[i] + s * (to[i] - from[i])));
            point[n].ticks = 1;
        }
        memcpy(from, to, sizeof from);
    }
}

static void source(void *context, uint32_t index, loft_item *out)
{
    (void)context;
    *out = point[index];
}

/* One direction: a frame that is being sent, byte by byte. */
struct way {
    uint8_t byte[LOFT_FRAME_MAX];
    size_t size, at;
};

static uint8_t noisy(uint8_t byte, double rate)
{
    if (rate > 0 && random_unit() < 8 * rate)
        byte ^= (uint8_t)(1u << (unsigned)(8 * random_unit()));
    return byte;
}

/* Returns false if a point arrives that differs from the one that was sent. */
static bool measure(double rate)
{
    static loft_sender s;
    static loft_receiver r;
    struct way down = { .size = 0 }, up = { .size = 0 };
    loft_machine_info info = { .boot = 1,
                           .queue = QUEUE,
                           .points = QUEUE,
                           .tick_hz = 1000,
                           .slots = 40,
                           .kinds = 1u << LOFT_SPANS | 1u << LOFT_POINTS };
    loft_snapshot now = { .room = QUEUE };
    loft_job job = { .kind = LOFT_POINTS };
    uint64_t bytes = 0, began = 0;
    uint32_t taken = 0, frames = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        info.axis[i].steps_per_mm = 250 * 65536;
        info.axis[i].max_speed = info.axis[i].max_accel = 1000 * 65536;
    }
    job.id = loft_job_id(&job, points, source, NULL);
    loft_sender_init(&s, 12345, 0);
    if (loft_receiver_init(&r, &info) != LOFT_OK)
        return false;
    for (uint64_t t = 0; s.phase < LOFT_PHASE_DONE; t++) {
        const uint32_t ms = (uint32_t)(t * 1000 / BYTES_PER_S);
        loft_event_data data;
        enum loft_event e;

        if (s.phase == LOFT_PHASE_READY &&
            loft_sender_begin(&s, &job, points, source, NULL) != LOFT_OK)
            return false;
        if (down.at == down.size) {
            down.at = 0;
            down.size = loft_sender_poll(&s, ms, down.byte);
            frames += down.size > 0;
        }
        if (down.at < down.size && ++bytes &&
            loft_receiver_push(&r, noisy(down.byte[down.at++], rate))) {
            while ((e = loft_receiver_next(&r, &now, &data)) != LOFT_EVENT_NONE) {
                if (e == LOFT_EVENT_JOB) {
                    loft_receiver_answer(&r, &data.job, LOFT_REFUSAL_NONE);
                    now.state = LOFT_STATE_RUNNING;
                    began = t;
                } else if (e == LOFT_EVENT_ITEM) {
                    if (taken >= points ||
                        memcmp(&data.item.p[2], &point[taken].p[2], sizeof data.item.p[2]) != 0)
                        return false;
                    now.executed = now.ticks = ++taken;
                    if (taken == points)
                        printf("%-7g %6.0f %.3f", rate,
                               (double)points / ((double)(t - began) / BYTES_PER_S),
                               (double)bytes / points);
                } else if (e == LOFT_EVENT_END) {
                    now.state = LOFT_STATE_DONE;
                } else if (e == LOFT_EVENT_CLOSE) {
                    now.state = LOFT_STATE_IDLE;
                }
            }
        }
        if (up.at == up.size) {
            up.at = 0;
            up.size = loft_receiver_poll(&r, &now, up.byte);
        }
        if (up.at < up.size)
            (void)loft_sender_push(&s, noisy(up.byte[up.at++], rate), ms);
    }
    printf(" %u %u\n", (unsigned)s.resent, (unsigned)frames);
    return s.phase == LOFT_PHASE_DONE && taken == points;
}

int main(int argc, char **argv)
{
    points = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 200000;
    if (points == 0 || points > MOST) {
        fprintf(stderr, "usage: bench_line [POINTS to %u]\n", MOST);
        return 64;
    }
    state = 1;
    make_points();
    return !(measure(0) & measure(1e-5) & measure(1e-4));
}
