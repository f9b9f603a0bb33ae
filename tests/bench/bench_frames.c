/* tests/bench/bench_frames.c -- counts damaged frames that are accepted as good ones
 * SPDX-License-Identifier: MIT
 * usage: bench_frames CLASS COUNT [SEED] ; CLASS is bits, bytes, lost, doubled, inserted, or
 * `every`: for COUNT frames, all errors of one and two bits, each byte lost and doubled, and all
 * bytes inserted at all places
 *
 * Frames have 128 bytes on the line and random content, which is new for every eighth frame. Each
 * is damaged at random and pushed into loft_frame_push byte by byte. Prints `CLASS frames N
 * accepted N`: accepted frames came out as good but differ from what was sent.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "wire/frame.h"

#define SIZE 128
#define USES 8          /* of each frame */

static uint64_t state;

static uint32_t random_32(void)         /* splitmix64 (Steele, Lea, Flood 2014) */
{
    uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (uint32_t)(z >> 32);
}

static uint32_t below(uint32_t n)       { return (uint32_t)((uint64_t)random_32() * n >> 32); }

static size_t make(uint8_t wire[LOFT_FRAME_MAX], uint8_t content[SIZE])
{
    const size_t count = SIZE - LOFT_FRAME_EXTRA;

    for (size_t i = 0; i < count; i++)
        wire[1 + i] = content[i] = (uint8_t)random_32();
    return loft_frame_encode(wire, count);
}

/* Returns the length of the damaged frame; `wire` has room for one more byte. The delimiter at the
 * end may be damaged as well. */
static size_t damage(const char *class, uint8_t *wire, size_t size)
{
    const uint32_t at = below((uint32_t)size);

    switch (class[0]) {
    case 'b':                                           /* bits: 3 to 10; bytes: 2 to 16 in a row */
        if (class[1] == 'i')
            for (uint32_t n = 3 + below(8); n; n--)
                wire[below((uint32_t)size)] ^= (uint8_t)(1u << below(8));
        else
            for (uint32_t n = 2 + below(15), k = at; n && k < size; n--, k++)
                wire[k] = (uint8_t)random_32();
        return size;
    case 'l': memmove(wire + at, wire + at + 1, size - at - 1); return size - 1;
    case 'd': memmove(wire + at + 1, wire + at, size - at); return size + 1;
    default:
        memmove(wire + at + 1, wire + at, size - at);
        wire[at] = (uint8_t)random_32();
        return size + 1;
    }
}

static loft_frame frame;
static uint8_t good[LOFT_FRAME_MAX], wire[LOFT_FRAME_MAX + 1], content[SIZE];
static size_t length;
static uint64_t frames, accepted;

/* Is the content of `wire` accepted as a frame that was not sent? */
static void try(size_t size)
{
    frames++;
    for (size_t i = 0; i <= size; i++)
        if (loft_frame_push(&frame, i < size ? wire[i] : 0) == LOFT_OK &&
            (frame.count != SIZE - LOFT_FRAME_EXTRA ||
             memcmp(frame.byte, content, frame.count) != 0))
            accepted++;
}

static void flip(size_t bit)    { wire[bit / 8] ^= (uint8_t)(1u << bit % 8); }

/* Try everywhere: one and two bits flipped; a byte lost, doubled, and each value inserted. */
static void try_every(void)
{
    memcpy(wire, good, length);
    for (size_t a = 0; a < 8 * length; a++) {
        flip(a);
        try(length);
        for (size_t b = 0; b < a; b++) {
            flip(b);
            try(length);
            flip(b);
        }
        flip(a);
    }
    for (size_t at = 0; at <= length; at++)
        for (int byte = -2; byte < 256; byte++) {
            memcpy(wire, good, at);
            if (byte == -2 && at < length) {
                memcpy(wire + at, good + at + 1, length - at - 1);
                try(length - 1);
            } else if (byte >= 0 || at < length) {
                wire[at] = byte < 0 ? good[at] : (uint8_t)byte;
                memcpy(wire + at + 1, good + at, length - at);
                try(length + 1);
            }
        }
}

int main(int argc, char **argv)
{
    const uint64_t count = argc > 2 ? strtoull(argv[2], NULL, 10) : 0;
    const bool every = argc > 1 && strcmp(argv[1], "every") == 0;

    if (count == 0) {
        fprintf(stderr,
                "usage: bench_frames bits|bytes|lost|doubled|inserted|every COUNT [SEED]\n");
        return 64;
    }
    state = argc > 3 ? strtoull(argv[3], NULL, 10) : 1;
    loft_frame_init(&frame);
    if (loft_frame_push(&frame, 0) == LOFT_OK)
        return 1;
    for (uint64_t n = 0; n < count; n++) {
        if (every || n % USES == 0)
            length = make(good, content);
        if (every) {
            try_every();
        } else {
            memcpy(wire, good, length);
            try(damage(argv[1], wire, length));
        }
    }
    printf("%s frames %llu accepted %llu\n", argv[1], (unsigned long long)frames,
           (unsigned long long)accepted);
    return accepted != 0;
}
