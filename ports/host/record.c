/* ports/host/record.c
 * SPDX-License-Identifier: MIT
 */
#include "host/record.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sysexits.h>

static int report_error(const struct loft_host_options *o)
{
    fprintf(stderr, "loft: %s: cannot write the record: %s: name a file that can be written\n",
            o->record, strerror(errno));
    return EX_CANTCREAT;
}

static void write_header(FILE *file, const struct loft_host_options *o)
{
    static const char name[] = "xyzabc";

    fprintf(file, "# record = pulses; position of each axis in steps after the slot\n");
    fprintf(file, "# slot_hz = %.17g\n", (double)o->tick_hz * o->slots);
    for (int i = 0; i < LOFT_AXES; i++)
        fprintf(file, "# steps_per_mm_%c = %.17g\n", name[i], o->steps_per_mm[i]);
    if (o->note)
        fputs(o->note, file);
    fprintf(file, "slot");
    for (int i = 0; i < LOFT_AXES; i++)
        fprintf(file, ",%c", name[i]);
    fprintf(file, "\n");
}

/* A link is not followed, except those of /dev. */
static FILE *create(const char *name)
{
    const int follow = strncmp(name, "/dev/", 5) == 0 ? 0 : O_NOFOLLOW,
              fd     = open(name, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | follow, 0666);

    return fd >= 0 ? fdopen(fd, "w") : NULL;
}

int host_record_open(struct host_record *r, const struct loft_host_options *o)
{
    memset(r, 0, sizeof *r);
    if (!o->record)
        return 0;
    r->file = strcmp(o->record, "-") == 0 ? stdout : create(o->record);
    if (!r->file)
        return report_error(o);
    write_header(r->file, o);
    return fflush(r->file) == 0 ? 0 : report_error(o);
}

void host_record_job(struct host_record *r, uint32_t id)
{
    if (r->file)
        fprintf(r->file, "# job = %08lx\n", (unsigned long)id);
}

void host_record_slot(struct host_record *r, uint64_t slot, loft_pins pins)
{
    if (pins.step == 0)
        return;
    for (int i = 0; i < LOFT_AXES; i++)
        if (pins.step & (1u << i))
            r->position[i] += pins.dir & (1u << i) ? -1 : 1;
    if (!r->file)
        return;
    fprintf(r->file, "%llu", (unsigned long long)slot);
    for (int i = 0; i < LOFT_AXES; i++)
        fprintf(r->file, ",%d", (int)r->position[i]);
    putc('\n', r->file);
}

void host_record_output(struct host_record *r, uint64_t slot, int output, uint16_t level)
{
    const int k = output - 1;

    r->energy[k] += level;
    if (level == r->level[k])
        return;
    r->level[k] = level;
    if (r->file)
        fprintf(r->file, "# output %d = %u from slot %llu\n", output, level,
                (unsigned long long)slot);
}

int host_record_close(struct host_record *r, const struct loft_host_options *o)
{
    FILE *file = r->file;

    r->file = NULL;
    if (!file)
        return 0;
    const bool bad = ferror(file) != 0;
    if ((file == stdout ? fflush(file) : fclose(file)) != 0 || bad)
        return report_error(o);
    return 0;
}
