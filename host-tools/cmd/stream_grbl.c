/* host-tools/cmd/stream_grbl.c
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <string.h>

#include "base/say.h"
#include "base/spool.h"         /* spool_passed */
#include "base/tool.h"
#include "cmd/waits.h"         /* waits_due */
#include "cmd/keys.h"          /* keys_next */
#include "cmd/report.h"        /* report_show */
#include "cmd/run.h"           /* run_until, run_controller */
#include "cmd/stream_grbl.h"
#include "plan/table.h"         /* table_check */
#include "cmd/run_drawing.h"    /* run_change, run_teller */
#include "send/gcode_write.h"         /* gcode_make */
#include "send/grbl.h"          /* grbl_begin */

typedef struct {
    grbl *g;
    waits waiting;
    bool closed;                /* the report has ended */
} lines_shown;

static int step_shown(void *context, double now, task_wants *w)
{
    lines_shown *x = context;
    const task t   = grbl_task(x->g);
    const int code = t.step(t.context, now, w);
    send_facts f;
    char words[160];

    if (code == TASK_GOES && !grbl_over(x->g)) {
        const int key = report_key(keys_next());
        if (key != 0)
            task_wake(w, now);
        grbl_key(x->g, key);
        grbl_facts(x->g, &f, words);
        report_show(&f, words);
        if (waits_due(&x->waiting, w->awaits, now))
            report_line("waiting: %s", x->waiting.what);
    } else if (!x->closed) {
        report_end();
        x->closed = true;
    }
    w->awaits[0] = '\0';
    return code;
}

/* Send the lines and wait for the end. Returns an exit code, after one line. */
static int run_lines(grbl *g, const gcode *lines, const report_job *told)
{
    lines_shown x = { .g = g };

    report_begin(told);
    const send_teller to = run_teller();
    grbl_begin(g, lines, told->path, &to);
    return run_until((task){ step_shown, &x, grbl_task(g).stop });
}

/* The G-code of a part, sent from where the controller is, or printed in a dry run. */
static int draw_part(const stream_options *o, const plan_parts *all, size_t k, grbl *g,
                     double start[ENGINE_AXES])
{
    const tools_part *p   = &all->part[k];
    toolpath_options how  = parts_way(&o->p, all, k);
    const gcode_options as = { .tol = (o->p.tol - o->p.smoothed) / 2,
                               .curves = o->g5 ? GCODE_G5 : GCODE_ARCS,
                               .rapids = p->d.program };
    int code = 0;
    toolpath path;
    gcode lines;

    how.laser = false;                  /* its controller sees to that ($32) */
    memcpy(how.start, g ? grbl_place(g) : start, sizeof how.start);
    toolpath_make(&path, &p->smooth, &how);
    gcode_make(&lines, &path, &as);
    if (path.count == 0)
        code = tool_error(EX_DATAERR,
                          "%s: nothing to draw in it: give a drawing with visible outlines",
                          all->file);
    else
        code = table_check(tool_host(), &o->p.machine, all->file, &p->smooth, &path, o->p.tol);
    if (code == 0 && g != NULL && p->tool != NULL)
        code = run_change(p->tool, o->asks);
    if (code == 0 && g != NULL)
        code = run_lines(g, &lines,
                         &(report_job){ all->file, o->line.port, p->tool ? p->tool->name : NULL,
                                        &path, o->p.tol, 0 });
    if (code == 0 && g == NULL && p->tool != NULL)
        (void)say(stdout, "(tool %s)\n", p->tool->name);
    if (code == 0 && g == NULL && p->tool != NULL && *p->tool->pause)
        puts("M0");
    for (size_t i = 0; code == 0 && g == NULL && i < lines.count; spool_passed(i++))
        puts(gcode_text(&lines, i));
    if (path.count > 0)
        memcpy(start, path.move[path.count - 1].p[3], sizeof how.start);
    gcode_free(&lines);
    toolpath_free(&path);
    return code;
}

int stream_grbl(stream_options *o, const plan_parts *all)
{
    grbl *g = NULL;
    double start[ENGINE_AXES] = { 0, 0, 0 };
    int code = o->dry ? 0 : run_controller(&g, &o->line);

    if (g != NULL && o->p.file == NULL)
        (void)grbl_table(g, &o->p.machine);
    for (size_t k = all->first; k < all->count && code == 0; k++)
        code = draw_part(o, all, k, g, start);
    if (g != NULL)
        grbl_close(g);
    return code;
}
