/* ports/linux-gpio/powers.c
 * SPDX-License-Identifier: MIT
 *
 * Documentation/driver-api/pwm.rst of the kernel: a channel is a folder with the files period,
 * duty_cycle (ns) and enable. The kernel refuses a duty above the period, so 0 is written first.
 */
#include "linux-gpio/powers.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sysexits.h>
#include <unistd.h>

static int open_file(const char *folder, const char *name)
{
    char path[300];

    snprintf(path, sizeof path, "%s/%s", folder, name);
    return open(path, O_WRONLY | O_CLOEXEC);
}

static bool put_number(int fd, int64_t number)
{
    char text[24];
    const int size = snprintf(text, sizeof text, "%lld\n", (long long)number);

    return write(fd, text, (size_t)size) == size;
}

static bool write_file(const char *folder, const char *name, int64_t number)
{
    const int fd = open_file(folder, name);
    const bool good = fd >= 0 && put_number(fd, number);
    const int error = errno;

    if (fd >= 0)
        close(fd);
    errno = error;
    return good;
}

int powers_open(struct powers *p, const struct settings *s)
{
    *p = (struct powers){ .duty = -1, .relay = s->output[LINE_RELAY].key[0] != 0 };
    if (!s->pwm[0])
        return 0;
    p->period_ns = 1000000000 / s->pwm_hz;
    p->duty = open_file(s->pwm, "duty_cycle");
    if (p->duty >= 0 && put_number(p->duty, 0) && write_file(s->pwm, "period", p->period_ns) &&
        write_file(s->pwm, "enable", 1))
        return 0;
    fprintf(stderr,
            "loft-gpio: pwm = %s: %s: give the folder of a channel that is exported, and write to "
            "it as root\n",
            s->pwm, strerror(errno));
    return EX_NOPERM;
}

int powers_count(const struct settings *s)
{
    return s->output[LINE_COOLANT].key[0] ? 2 : s->pwm[0] || s->output[LINE_RELAY].key[0] ? 1 : 0;
}

bool powers_can(const struct powers *p, int output, bool moving)
{
    return output == 2 || p->duty >= 0 || (p->relay && !moving);
}

bool powers_set(struct powers *p, struct lines *lines, int output, uint16_t level)
{
    const uint32_t line = output == 2 ? LINE_COOLANT : p->relay ? LINE_RELAY : LINE_SPINDLE;
    bool good = true;

    if (output == 1 && p->duty >= 0)
        good = put_number(p->duty, (p->period_ns * level + UINT16_MAX / 2) / UINT16_MAX);
    return lines_set(lines, 1u << line, level ? UINT32_MAX : 0) && good;
}

void powers_close(struct powers *p)
{
    if (p->duty >= 0) {
        (void)put_number(p->duty, 0);
        close(p->duty);
    }
    p->duty = -1;
}
