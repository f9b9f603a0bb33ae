/* host-tools/cmd/mill_chip.c -- loft mill --plan chip: patches that the machine cuts by itself
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <string.h>

#include "cmd/keys.h"           /* keys_start, keys_hasty */
#include "base/say.h"
#include "base/source.h"         /* source_name */
#include "base/tool.h"
#include "cmd/mill_chip.h"
#include "cmd/report.h"         /* report_start */
#include "geometry/surface_text.h"
#include "cmd/run.h"            /* run_open */
#include "cmd/run_settings.h"
#include "cmd/run_drawing.h"
#include "host/duration.h"      /* host_duration */

#define COLUMNS 64              /* of a usual machine */

const option mill_chip_rows[] = {
    OPTION_GROUP(mill_chip_options, line, talk_rows),
    { "machine", OPTION_FILE(mill_chip_options, machine), .value = "FILE",
      .help = "of --plan chip: a machine as text, see host-tools/MACHINE.md" },
    { "feed", OPTION_NUMBER(mill_chip_options, feed), .least = 0.016, .most = 1000, .unit = "mm/s",
      .standard = "30", .help = "of --plan chip: on the surface, mm/s, or as 1200mm/min" },
    { "travel", OPTION_NUMBER(mill_chip_options, travel), .least = 0.016, .most = 1000,
      .unit = "mm/s", .standard = "100", .help = "of --plan chip: above it" },
    { "log", OPTION_FILE(mill_chip_options, line.log), .value = "FILE",
      .help = "of --plan chip: write what passes on the line, in words" },
    { "dry-run", OPTION_FLAG(mill_chip_options, dry),
      .help = "of --plan chip: plan for a usual machine, print a summary, move nothing" },
    { 0 }
};

/* A patch, its path, and their job. */
typedef struct {
    lines_patch patch;
    loft_item item[LOFT_PATCH_PARTS];
    drawing d;
    job_work w;
} milling;

static void free_milling(milling *m)
{
    job_work_free(&m->w);
    drawing_free(&m->d);
}

/* The job of a surface, from there. */
static int plan_work(const mill_chip *c, const surface *s, const char *file,
                     const double start[ENGINE_AXES], const engine_limits *machine, milling *m)
{
    job_options as = { .e = c->p.e, .kind = LOFT_CURVES, .limits = *machine, .patch = m->item };

    free_milling(m);
    planning_limit(&c->p, &as.limits);
    int code = patch_make(tool_host(), &m->patch, s, &c->o, start, file);
    if (code != 0)
        return code;
    as.parts = patch_items(&m->patch, m->item);
    patch_path(&m->patch, &c->o, s->line, &m->w.path, &m->d);
    keys_hasty(true);
    code = planning_joints(tool_host(), &c->p, file, &m->d, start, true, &as.limits, &m->w.path,
                           &m->w.of);
    const int status = code == 0 ? job_open(&m->w.j, &m->w.of, &as) : LOFT_OK;
    keys_hasty(false);
    return status == LOFT_OK
               ? code
               : tool_error(EX_DATAERR, "%s:%u: cannot be planned: %s", source_name(file), s->line,
                            engine_status(status, ENGINE_NO_MOTION));
}

static void tell(const milling *m, const surface *s, const char *file)
{
    (void)say(stdout, "%s:%u: %u lines of %u curves, %.3f m on it, %.3f m above, in %zu items\n",
              source_name(file), s->line, m->patch.head.rows + 1u, m->patch.head.columns,
              m->w.path.drawn / 1000, m->w.path.travelled / 1000, m->w.j.count);
}

static int dry_run(mill_chip *c, const surfaces *all, const char *file)
{
    const double start[ENGINE_AXES] = { 0, 0, 0 };
    engine_limits limits            = { .tol = 0 };
    milling m                       = { .d.count = 0 };
    int code                        = 0;
    char time[HOST_DURATION];

    planning_machine(&c->p, &limits);
    c->o.columns = COLUMNS;
    c->o.lines   = engine_lines_q16;
    for (size_t k = 0; k < all->count && code == 0; k++) {
        code = plan_work(c, &all->surface[k], file, start, &limits, &m);
        const int status = code == 0 ? job_finish(tool_host(), &m.w.j) : LOFT_OK;
        if (status != LOFT_OK)
            code = tool_error(EX_DATAERR, "%s:%u: cannot be planned: %s", source_name(file),
                              all->surface[k].line, engine_status(status, ENGINE_NO_MOTION));
        if (code == 0) {
            tell(&m, &all->surface[k], file);
            printf("planned: %s\n", host_duration(time, job_seconds(&m.w.j), 1));
        }
    }
    free_milling(&m);
    return code;
}

/* Refuse what the machine cannot do. */
static int check_machine(mill_chip *c, const talk *t)
{
    const loft_welcome *m = &t->sender.machine;

    if (!c->p.machine.k.kind->direct)
        return tool_error(EX_CONFIG,
                          "%s: the motors of a %s machine are not its axes: leave out --plan chip, "
                          "and stream the path",
                          c->a.line.port, kinematics_name(&c->p.machine.k));
    if (!(m->kinds & 1u << LOFT_CURVES) || m->curves == 0 || m->columns == 0)
        return tool_error(EX_CONFIG,
                          "%s: this machine does not cut patches by itself: leave out --plan chip, "
                          "or build its firmware with LOFT_PORT_PATCHES=1",
                          c->a.line.port);
    c->o.columns = m->columns;
    c->o.lines   = m->num == LOFT_F32   ? engine_lines_f32
                 : m->num == LOFT_F64 ? engine_lines_f64
                                      : engine_lines_q16;
    return 0;
}

/* The machine may be in one of these jobs: the one with its id, planned from the same start. */
static int find_old(const mill_chip *c, const surfaces *all, const char *file, const talk *t,
                    const engine_limits *limits, milling *m, size_t *at)
{
    double start[ENGINE_AXES];
    int code = 0;

    *at = all->count;
    stream_old_start(&t->sender, false, start);
    for (size_t k = 0; k < all->count && t->sender.machine.job != 0 && code == 0; k++) {
        code = plan_work(c, &all->surface[k], file, start, limits, m);
        if (code == 0 && m->w.j.head.id == t->sender.machine.job) {
            *at = k;
            break;
        }
    }
    return code;
}

static int run_job(const mill_chip *c, const surface *s, const char *file, talk *t, milling *m)
{
    const stream_subject about = { .file = file,
                                   .curves = m->w.path.curves,
                                   .drawn = m->w.path.drawn,
                                   .tol = c->p.tol + c->o.tol,
                                   .d = &m->d,
                                   .k = &c->p.machine.k,
                                   .port = c->a.line.port,
                                   .path = &m->w.path };
    const int code             = stream_limits(t, c->p.machine.hard_stop > 0, &m->w.j.head);

    tell(m, s, file);
    return code ? code : run_drawing(t, &m->w.j, &about);
}

static int run_jobs(mill_chip *c, const surfaces *all, const char *file, talk *t)
{
    milling m = { .d.count = 0 };
    engine_limits limits = { .tol = 0 };
    double start[ENGINE_AXES];
    size_t old = all->count;

    stream_machine(&t->sender, &limits);
    int code = find_old(c, all, file, t, &limits, &m, &old);
    for (size_t k = old < all->count ? old : 0; k < all->count && code == 0; k++) {
        const bool first = k == (old < all->count ? old : 0);
        if (!first)
            code = run_again(t, c->a.line.wait);
        if (code == 0 && k != old) {
            stream_new_start(&t->sender, start);
            code = plan_work(c, &all->surface[k], file, start, &limits, &m);
        }
        if (code == 0)
            code = run_job(c, &all->surface[k], file, t, &m);
    }
    free_milling(&m);
    return code;
}

static int connect(mill_chip *c, const surfaces *all, const char *file)
{
    talk t;

    int code = run_open(&t, &c->a.line);
    if (code != 0)
        return code;
    if (c->p.file == NULL)
        code = run_settings_adopt(&c->p.machine, &t);
    if (code == 0)
        code = talk_certain(&t);
    if (code == 0)
        code = check_machine(c, &t);
    if (code == 0)
        code = run_jobs(c, all, file, &t);
    talk_close(&t);
    return code;
}

int mill_chip_run(mill_chip *c, const char *file)
{
    surfaces all = { 0 };

    int code    = planning_usual(tool_host(), &c->p, c->a.machine);
    c->p.feed   = c->o.feed   = c->a.feed;
    c->p.travel = c->o.travel = c->a.travel;
    if (code == 0)
        code = surfaces_read_only(tool_host(), &all, file);
    if (code == 0) {
        keys_start(!c->a.dry && strcmp(file, "-") != 0);
        code = report_start(REPORT_BAR);
    }
    if (code == 0)
        code = c->a.dry ? dry_run(c, &all, file) : connect(c, &all, file);
    surfaces_free(&all);
    return report_exit(code);
}
