/* tests/support/fuzz_main.c -- feeds files to a program for libFuzzer, without libFuzzer
 * SPDX-License-Identifier: MIT
 *
 * PROGRAM FILE..: what fuzzers have found is read again (make test-corpus). The name of each file
 * is printed before it is read: where a promise is broken, that line is the last one.
 */
#include <stdio.h>
#include <string.h>

#include "support/fuzz.h"
#include "support/kept_fonts.h"

static uint8_t bytes[1 << 20];

int main(int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        FILE *f = fopen(argv[i], "rb");
        MUST(f != NULL);
        const size_t size = fread(bytes, 1, sizeof bytes, f);
        MUST(fclose(f) == 0);
        puts(argv[i]);
        fflush(stdout);
        uint8_t *exact = malloc(size ? size : 1);   /* a read beyond its end is seen */
        MUST(exact != NULL);
        memcpy(exact, bytes, size);
        (void)LLVMFuzzerTestOneInput(exact, size);
        free(exact);
    }
    printf("%d passed, 0 failed\n", argc - 1);
    return argc < 2;
}
