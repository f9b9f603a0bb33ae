/* tests/tools/test_spool.c -- arrays that grow larger than memory keep what was written
 * SPDX-License-Identifier: MIT
 */
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>

#include "base/spool.h"
#include "check.h"

#define ARRAYS 5

static uint32_t content(uint32_t array, uint32_t n) { return n * 2654435761u ^ array; }

/* Some arrays grow in turns, some shrink; pages rest at any time. */
static void grow_in_turns(arb *a, uint32_t most)
{
    uint32_t *array[ARRAYS] = { NULL }, count[ARRAYS] = { 0 };

    for (int turn = 0; turn < 40; turn++) {
        const uint32_t k = arb_below(a, ARRAYS), size = 1 + arb_below(a, most);
        array[k]         = spool_grow(array[k], size * sizeof *array[k]);
        for (uint32_t n = count[k]; n < size; n++)
            array[k][n] = content(k, n);
        count[k] = size;
        if (arb_below(a, 2) == 0)
            spool_rest();
        if (arb_below(a, 8) == 0) {
            spool_free(array[k]);
            array[k] = NULL;
            count[k] = 0;
        }
        for (uint32_t i = 0; i < ARRAYS; i++)
            for (uint32_t n = 0; n < count[i]; n++)
                if (array[i][n] != content(i, n))
                    CHECK(!"an element has changed");
    }
    for (uint32_t k = 0; k < ARRAYS; k++)
        spool_free(array[k]);
}

static void arrays_keep_their_elements(arb *a)
{
    grow_in_turns(a, 40);               /* in memory */
    grow_in_turns(a, 150000);           /* some of them longer than that */
}

/* No folder for files: in memory, as long as it lasts. */
static void they_do_so_without_a_folder(arb *a)
{
    CHECK(setenv("TMPDIR", "/nowhere/at/all", 1) == 0);
    grow_in_turns(a, 150000);
    CHECK(unsetenv("TMPDIR") == 0);
}

/* The files grow no further: what is there moves to memory. */
static void they_do_so_when_the_disk_is_full(arb *a)
{
    const struct rlimit full = { 1 << 19, RLIM_INFINITY };
    struct rlimit before;

    CHECK(getrlimit(RLIMIT_FSIZE, &before) == 0);
    CHECK(signal(SIGXFSZ, SIG_IGN) != SIG_ERR);
    CHECK(setrlimit(RLIMIT_FSIZE, &full) == 0);
    grow_in_turns(a, 300000);
    CHECK(setrlimit(RLIMIT_FSIZE, &before) == 0);
}

static long resident_kb(void)
{
    char line[256];
    long kb    = -1;
    FILE *file = fopen("/proc/self/status", "r");

    while (file != NULL && fgets(line, sizeof line, file) != NULL)
        if (sscanf(line, "VmRSS: %ld", &kb) == 1)
            break;
    if (file != NULL)
        (void)fclose(file);
    return kb;
}

/* 64 MB are written and read, and take less than 8 of memory; most of it is a sanitizer's. */
static void long_arrays_take_little_memory(arb *a)
{
    enum { COUNT = 1 << 20 };
    double (*array)[8] = spool_grow(NULL, COUNT * sizeof *array);
    double sum = 0;
    const long before  = resident_kb();
    long most          = before;

    (void)a;
    for (uint32_t n = 0; n < COUNT; spool_passed(n++)) {
        array[n][n % 8] = n;
        most = n % 65536 == 65535 && resident_kb() > most ? resident_kb() : most;
    }
    for (uint32_t n = 0; n < COUNT; spool_passed(n++)) {
        sum += array[n][n % 8];
        most = n % 65536 == 65535 && resident_kb() > most ? resident_kb() : most;
    }
    CHECK(sum == (double)COUNT * (COUNT - 1) / 2);
    CHECK(before > 0 && most - before < 8192);
    spool_free(array);
}

int main(void)
{
    PROPERTY(arrays_keep_their_elements, 10);
    PROPERTY(they_do_so_without_a_folder, 4);
    PROPERTY(they_do_so_when_the_disk_is_full, 4);
    PROPERTY(long_arrays_take_little_memory, 1);
    return check_failures();
}
