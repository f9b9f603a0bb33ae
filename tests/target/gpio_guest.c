/* tests/target/gpio_guest.c -- what a shell cannot do in the guest of gpio.sh; linked statically
 * SPDX-License-Identifier: MIT
 *
 *     put NAME < FILE             send it to the host after a line `=== NAME`, through QEMU's
 *                                 debug port
 *     changes < TRACE             of the tracepoint gpio_value: a line `us line value` for each
 *                                 output that changes
 *     pull FILE VALUE US ..       write values into a simulated line's pull, each followed by a
 *                                 pause; tell when: `us VALUE`
 *     exit CODE                   end QEMU with 2 * CODE + 1
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/io.h>
#include <time.h>

#define DEBUG_PORT 0xe9
#define EXIT_PORT  0xf4
#define LINES      4096

static int put(const char *name)
{
    int c, last = '\n';

    if (ioperm(DEBUG_PORT, 1, 1) != 0)
        return 1;
    for (const char *p = "=== "; *p; p++)
        outb((unsigned char)*p, DEBUG_PORT);
    for (const char *p = name; *p; p++)
        outb((unsigned char)*p, DEBUG_PORT);
    outb('\n', DEBUG_PORT);
    for (; (c = getchar()) != EOF; last = c)
        outb((unsigned char)c, DEBUG_PORT);
    if (last != '\n')
        outb('\n', DEBUG_PORT);
    return 0;
}

/* `loft-97 [000] ..... 13.413831: gpio_value: 1016 set 1` */
static int changes(void)
{
    static signed char is[LINES];
    char text[256];

    memset(is, -1, sizeof is);
    while (fgets(text, sizeof text, stdin)) {
        char *event = strstr(text, ": gpio_value: ");
        unsigned line, value, s, us;
        if (!event || sscanf(event, ": gpio_value: %u set %u", &line, &value) != 2 ||
            line >= LINES || is[line] == (signed char)value)
            continue;
        *event = 0;
        if (sscanf(strrchr(text, ' ') + 1, "%u.%u", &s, &us) != 2)
            return 1;
        is[line] = (signed char)value;
        printf("%llu %u %u\n", s * 1000000ull + us, line, value);
    }
    return 0;
}

static int pull(int argc, char **argv)
{
    for (int i = 1; i + 1 < argc; i += 2) {
        const long us = atol(argv[i + 1]);
        const struct timespec pause = { us / 1000000, us % 1000000 * 1000 };
        struct timespec now;
        FILE *file = fopen(argv[0], "w");
        if (!file || fprintf(file, "pull-%s\n", argv[i]) < 0 || fclose(file) != 0)
            return 1;
        clock_gettime(CLOCK_MONOTONIC, &now);
        printf("%llu %s\n",
               (unsigned long long)now.tv_sec * 1000000 + (unsigned long long)now.tv_nsec / 1000,
               argv[i]);
        nanosleep(&pause, NULL);
    }
    return 0;
}

int main(int argc, char **argv)
{
    const char *what = argc > 1 ? argv[1] : "";

    if (strcmp(what, "put") == 0 && argc == 3)
        return put(argv[2]);
    if (strcmp(what, "changes") == 0)
        return changes();
    if (strcmp(what, "pull") == 0 && argc > 4)
        return pull(argc - 2, argv + 2);
    if (strcmp(what, "exit") == 0 && argc == 3 && ioperm(EXIT_PORT, 4, 1) == 0)
        outl((unsigned)atoi(argv[2]), EXIT_PORT);
    return 1;
}
