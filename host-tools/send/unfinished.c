/* host-tools/send/unfinished.c
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/host.h"
#include "engine/engine.h"       /* ENGINE_AXES */
#include "send/unfinished.h"

#define ALL ((1u << ENGINE_AXES) - 1)

typedef struct {
    uint32_t boot, job;
    uint32_t since;             /* the boot id in which some axes were placed, */
    unsigned axes;              /* and those whose place is in doubt yet */
    char file[200];
} record;


// Where it is kept
// ----------------

/* Is it a name that belongs to a device for as long as that is plugged in? Ptys get new ones. */
static bool is_lasting(const char *name)
{
    return strncmp(name, "/dev/", 5) == 0 && strncmp(name, "/dev/pts/", 9) != 0;
}

/* One name for the machine, however it was written. */
static void name_port(const char *port, char key[PATH_MAX])
{
    char folder[PATH_MAX], real[PATH_MAX];
    const char *last = strrchr(port, '/');

    snprintf(key, PATH_MAX, "%s", port);
    if (last == NULL || strncmp(port, "unix:", 5) == 0 || strncmp(port, "tcp:", 4) == 0)
        return;
    snprintf(folder, sizeof folder, "%.*s", last > port ? (int)(last - port) : 1, port);
    if (realpath(port, real) != NULL && is_lasting(real))
        snprintf(key, PATH_MAX, "%s", real);
    else if (realpath(folder, real) != NULL && strlen(real) + strlen(last) < PATH_MAX)
        snprintf(stpcpy(key, real), strlen(last) + 1, "%s", last);
}

/* FNV-1a (Fowler, Noll, Vo), 64 bits: a name for a file. */
static uint64_t hash_of(const char *text)
{
    uint64_t hash = 0xcbf29ce484222325u;

    for (; *text != '\0'; text++)
        hash = (hash ^ (unsigned char)*text) * 0x100000001b3u;
    return hash;
}

/* The folder; it is made where `make`. Returns false, with errno, if there can be none. */
static bool find_folder(const host *h, char folder[PATH_MAX], bool make)
{
    const size_t length = strlen(h->state);

    errno = ENOENT;
    if (length == 0 || length >= PATH_MAX - 32)
        return false;
    strcpy(folder, h->state);
    for (char *at = folder + 1; make && *at != '\0'; at++)
        if (*at == '/') {
            *at = '\0';
            (void)mkdir(folder, 0700);
            *at = '/';
        }
    if (make)
        (void)mkdir(folder, 0700);
    return access(folder, W_OK | X_OK) == 0;
}

/* Standard input names no machine: nothing is kept of it. */
static bool is_kept(const host *h, const char *port)
{
    return h->state != NULL && strcmp(port, "-") != 0;
}

static bool find_file(const host *h, const char *port, bool make, char file[PATH_MAX])
{
    char key[PATH_MAX];

    if (!is_kept(h, port) || !find_folder(h, file, make))
        return false;
    name_port(port, key);
    const size_t used = strlen(file);
    snprintf(file + used, PATH_MAX - used, "/%016" PRIx64, hash_of(key));
    return true;
}


// What is kept
// ------------

/* A line `key = value` in hexadecimal, nothing behind it. */
static void take_number(const char *line, const char *key, uint32_t *out)
{
    const size_t size = strlen(key);
    char *end;

    if (strncmp(line, key, size) != 0)
        return;
    const unsigned long value = strtoul(line + size, &end, 16);
    if (end > line + size && *end == '\n' && value <= UINT32_MAX)
        *out = (uint32_t)value;
}

/* Returns false if there is none. One that is damaged has no boot id, job 0 and all axes. */
static bool read_record(const host *h, const char *port, record *r)
{
    char file[PATH_MAX], line[256];
    uint32_t axes = 0;

    *r = (record){ .axes = ALL };
    FILE *in = find_file(h, port, false, file) ? fopen(file, "r") : NULL;
    if (in == NULL)
        return false;
    while (fgets(line, sizeof line, in) != NULL) {
        take_number(line, "boot = ", &r->boot);
        take_number(line, "job = ", &r->job);
        take_number(line, "since = ", &r->since);
        take_number(line, "axes = ", &axes);
        if (strncmp(line, "file = ", 7) == 0)
            snprintf(r->file, sizeof r->file, "%.*s", (int)strcspn(line + 7, "\n"), line + 7);
    }
    fclose(in);
    if (axes >= 1 && axes <= ALL)
        r->axes = axes;
    return true;
}

/* The computer may lose its power with the machine: the file is on the disk when this returns. */
static void write_record(const host *h, const char *port, const record *r)
{
    char file[PATH_MAX], fresh[PATH_MAX + 8], key[PATH_MAX];

    if (!find_file(h, port, true, file))
        return;
    name_port(port, key);
    snprintf(fresh, sizeof fresh, "%s.new", file);
    const int fd = open(fresh, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0600);
    FILE *out    = fd >= 0 ? fdopen(fd, "w") : NULL;
    if (out == NULL)
        return;
    fprintf(out,
            "# a job that began and has not ended on this machine\nport = %s\nboot = %" PRIx32
            "\njob = %" PRIx32 "\nsince = %" PRIx32 "\naxes = %x\nfile = %s\n",
            key, r->boot, r->job, r->since, r->axes, r->file);
    const bool good = fflush(out) == 0 && fsync(fd) == 0;
    if (fclose(out) == 0 && good)
        (void)rename(fresh, file);
}


// Jobs
// ----

/* Another restart: what was placed before it is in doubt again. */
static unsigned doubted(const record *r, const unfinished_machine *m)
{
    return r->since == m->boot ? r->axes : ALL;
}

int unfinished_check(const unfinished_machine *m)
{
    char folder[PATH_MAX], axes[ENGINE_AXES + 2] = "";
    record r;

    if (is_kept(m->host, m->port) && !find_folder(m->host, folder, true)) {
        const unsigned warned = m->host->warnings;
        host_warn(m->host, "job.no-record", (host_place){ .file = NULL }, "set XDG_STATE_HOME",
                  "no record of the job can be kept: %s: if the machine restarts in it, the next "
                  "job does not notice",
                  strerror(errno));
        return host_code(m->host, warned, 0);
    }
    if (!read_record(m->host, m->port, &r))
        return 0;
    if (r.boot == m->boot && r.job != 0) {
        if (!m->busy)
            unfinished_end(m->host, m->port);
        return 0;
    }
    for (int i = 0; i < ENGINE_AXES && doubted(&r, m) != ALL; i++)
        if (doubted(&r, m) >> i & 1)
            snprintf(axes + strlen(axes), 3, "%s%c", axes[0] ? "" : " ", "xyz"[i]);
    return host_error(m->host, EX_UNAVAILABLE, "job.was-cut-off", (host_place){ .file = m->port },
                      HOST_REMEDY("its position may be lost: home it, or `loft zero%s --port %s` "
                                  "at 0,0,0; then run this again",
                                  axes, m->port),
                      "the machine was restarted in a job%s%s", r.file[0] ? ", " : "", r.file);
}

void unfinished_begin(const unfinished_machine *m, uint32_t id, const char *file)
{
    record r = { .boot = m->boot, .job = id, .since = m->boot, .axes = ALL };

    for (size_t n = 0; file[n] != '\0' && n + 1 < sizeof r.file; n++)
        r.file[n] = file[n] == '\n' || file[n] == '\r' ? ' ' : file[n];
    write_record(m->host, m->port, &r);
}

void unfinished_end(const host *h, const char *port)
{
    char file[PATH_MAX];

    if (find_file(h, port, false, file))
        (void)unlink(file);
}

void unfinished_placed(const unfinished_machine *m, unsigned axes)
{
    record r;

    if (!read_record(m->host, m->port, &r) || (r.boot == m->boot && r.job != 0))
        return;
    r.axes  = doubted(&r, m) & ~axes;
    r.since = m->boot;
    if (r.axes == 0)
        unfinished_end(m->host, m->port);
    else
        write_record(m->host, m->port, &r);
}
