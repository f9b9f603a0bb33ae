/* host-tools/serve/preview.c
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/memory.h"
#include "base/say.h"
#include "base/tool.h"          /* tool_clock */
#include "plan/missing.h"
#include "serve/preview.h"

#define PORTION 0.1             /* s of planning between two looks */
#define TEXT_MOST ((size_t)1 << 28)     /* bytes of a line */

/* What the other process plans. */
typedef struct {
    FILE *out;
    host host;
    planning p;
    const char *file;
    double start[ENGINE_AXES];
    job_options as;
    plan_parts parts;
    job_work w;
    uint64_t ticks;             /* of the parts before, and of this one up to `item` */
    char *moves;                /* the text of all */
    FILE *into;
    size_t items, curves;
    double drawn, travelled;
} planned;


// In the other process
// --------------------

static void put_message(void *context, const host_message *m)
{
    planned *k = context;

    fputs("{\"kind\":\"message\",\"message\":", k->out);
    host_put_json(k->out, m);
    fputs("}\n", k->out);
}

static double clock_of(void *context)
{
    (void)context;
    return tool_clock();
}

/* Nobody reads any more: it ends. */
static bool put_progress(void *context, const host_progress *p)
{
    planned *k = context;

    if (p->doing == NULL)
        return true;
    fputs("{\"kind\":\"progress\",\"doing\":", k->out);
    say_quoted(k->out, p->doing);
    fprintf(k->out, ",\"part\":%.3f}\n", p->total > 0 ? fmin(p->done / p->total, 1) : 0);
    return fflush(k->out) == 0;
}

/* 4 digits after the point are 0.1 um, and zeros at the end are no news. */
static void put_number(FILE *out, double x)
{
    char text[40];
    size_t size = (size_t)snprintf(text, sizeof text, "%.4f", x);

    while (text[size - 1] == '0')
        size--;
    size -= text[size - 1] == '.';
    text[size] = '\0';
    fputs(strcmp(text, "-0") == 0 ? "0" : text, out);
}

/* A move that ends at this time: it begins where the one before ended. */
static void put_move(planned *k, size_t n, double seconds)
{
    const engine_move *m = &k->w.path.move[n];
    const size_t curve   = k->w.path.curve[n];
    const bool flat      = m->p[1][2] == m->p[0][2] && m->p[2][2] == m->p[0][2] &&
                      m->p[3][2] == m->p[0][2];

    fprintf(k->into, "%s[%ld,", ftell(k->into) > 0 ? "," : "",
            curve == TOOLPATH_TRAVEL ? -1L : (long)(k->curves + curve));
    put_number(k->into, seconds);
    for (int i = 1; i < 4; i++)
        for (int a = 0; a < (flat ? 2 : 3); a++) {
            putc(',', k->into);
            put_number(k->into, m->p[i][a]);
        }
    putc(']', k->into);
}

/* Plan the job to its end, and put each move with the time when it is over. */
static int plan_on(planned *k)
{
    job *j    = &k->w.j;
    size_t n  = 0, item = 0;
    int status = LOFT_OK;

    for (;;) {
        const host_progress p = { "planning", job_part(j), 1, false };
        for (loft_item at; item < job_ready(j); k->ticks += loft_item_lasts(&at)) {
            job_source(j, (uint32_t)item++, &at);
            for (; n < k->w.path.count && n < job_moves(j, item - 1); n++)
                put_move(k, n, (double)k->ticks / j->tick_hz);
        }
        if (status != LOFT_OK || j->whole)
            break;
        status = host_goes_on(&k->host, &p) ? job_plan(j, item, PORTION) : JOB_STOPPED;
    }
    for (; status == LOFT_OK && n < k->w.path.count; n++)
        put_move(k, n, (double)k->ticks / j->tick_hz);
    host_has_done(&k->host);
    k->items += j->count;
    return status == LOFT_OK ? 0 : job_refuse(&k->host, j, k->file, status, "");
}

/* Where the motors are then. */
static void begin_there(planned *k)
{
    for (int i = 0; i < ENGINE_AXES; i++)
        k->start[i] = k->w.j.last[i] / 65536.0;
}

static void put_part(planned *k, size_t n, double seconds)
{
    const machine_tool *tool = k->parts.part[n].tool;

    fprintf(k->out, "%s{\"tool\":", n > 0 ? "," : "");
    say_quoted(k->out, tool ? tool->name : "");
    fputs(",\"pause\":", k->out);
    say_quoted(k->out, tool ? tool->pause : "");
    fprintf(k->out, ",\"until\":%.3f}", seconds);
}

static void put_plan(planned *k, const drawing *d, const double until[])
{
    double box[2][2] = { { 0, 0 }, { 0, 0 } };

    (void)drawing_box(d, box);
    fprintf(k->out,
            "{\"kind\":\"plan\",\"seconds\":%.3f,\"drawn\":%.3f,\"travelled\":%.3f,\"curves\":%zu,"
            "\"items\":%zu,\"tol\":%.6g,\"box\":[%.4f,%.4f,%.4f,%.4f],\"page\":[%.4f,%.4f],"
            "\"parts\":[",
            (double)k->ticks / k->w.j.tick_hz, k->drawn, k->travelled, k->curves, k->items,
            k->p.tol, box[0][0], box[0][1], box[1][0], box[1][1], d->width, d->height);
    for (size_t n = 0; n < k->parts.count; n++)
        put_part(k, n, until[n]);
    fputs("]}\n", k->out);
}

static int plan_all(planned *k, const drawing *d)
{
    double begins[ENGINE_AXES], *until = memory_grow(NULL, k->parts.count * sizeof *until);
    char *text  = NULL;
    size_t size = 0;
    int code    = 0;

    k->into = open_memstream(&text, &size);
    memcpy(begins, k->start, sizeof begins);
    for (size_t n = 0; n < k->parts.count && code == 0; n++) {
        job_work_free(&k->w);
        code = parts_plan(&k->host, &k->p, &k->parts, n, "-", k->start, false, &k->as, &k->w);
        if (code == 0 && n == 0 && k->w.path.count > 0)
            memcpy(begins, k->w.path.move[0].p[0], sizeof begins);
        if (code == 0)
            code = plan_on(k);
        k->curves += k->w.path.curves;
        k->drawn += k->w.path.drawn;
        k->travelled += k->w.path.travelled;
        until[n] = (double)k->ticks / fmax(k->w.j.tick_hz, 1);
        if (code == 0)
            begin_there(k);
    }
    fclose(k->into);
    if (code == 0) {
        put_plan(k, d, until);
        fprintf(k->out, "{\"kind\":\"moves\",\"start\":[%.4f,%.4f,%.4f],\"moves\":[%s]}\n",
                begins[0], begins[1], begins[2], text);
    }
    free(text);
    free(until);
    return code;
}

static void work(void *given, FILE *out)
{
    planned *k = given;
    drawing d = { 0 }, smooth = { 0 };

    k->out  = out;
    k->host =
        (host){ .message = put_message, .progress = put_progress, .now = clock_of, .context = k };
    int code = planning_read(&k->host, &k->p, &d, &smooth, k->file);
    if (code == 0)
        code = parts_find(&k->host, &k->p, k->file, &d, &smooth, &k->parts);
    if (code == 0) {
        const missing_job asked = { k->file, k->parts.part, k->parts.count, false, false };
        code = missing_tell(&k->host, &asked, &k->as.does);
    }
    planning_limit(&k->p, &k->as.limits);
    if (code == 0)
        code = plan_all(k, &smooth);
    if (code != 0)
        fprintf(out, "{\"kind\":\"failed\",\"code\":%d}\n", code);
    job_work_free(&k->w);
    drawing_free(&smooth);
    drawing_free(&d);
}


// Here
// ----

void preview_end(preview *v)
{
    if (v->child > 0) {
        (void)kill(v->child, SIGKILL);
        (void)waitpid(v->child, NULL, 0);
        close(v->fd);
    }
    free(v->text);
    *v = (preview){ .fd = -1 };
}

bool preview_begin(preview *v, serve_beside *beside, const desk *d, const planning *how,
                   const char *file)
{
    planned *k = memory_grow(NULL, sizeof *k);

    preview_end(v);
    *k = (planned){ .p = *how, .file = file, .w = { .path = { 0 } } };
    desk_given(d, &k->p, k->start, &k->as);
    k->p.levels = true;
    v->child    = beside(work, k, &v->fd);
    free(k);
    if (v->child > 0)
        return true;
    v->child = 0;
    return false;
}

/* Read what is there. Returns false at the end. */
static bool read_more(preview *v)
{
    if (v->at > 0 && v->size > 0) {
        memmove(v->text, v->text + v->at, v->size - v->at);
        v->size -= v->at;
        v->at = 0;
    }
    if (v->size == v->room && v->room < TEXT_MOST) {
        v->room = v->room == 0 ? 65536 : 2 * v->room;
        v->text = memory_grow(v->text, v->room);
    }
    const ssize_t got = read(v->fd, v->text + v->size, v->room - v->size);
    if (got > 0)
        v->size += (size_t)got;
    return got > 0 || (got < 0 && (errno == EAGAIN || errno == EINTR));
}

const char *preview_line(preview *v)
{
    for (;;) {
        char *end = v->size > v->at ? memchr(v->text + v->at, '\n', v->size - v->at) : NULL;
        if (end != NULL) {
            const char *line = v->text + v->at;
            *end  = '\0';
            v->at = (size_t)(end + 1 - v->text);
            return line;
        }
        if (v->child == 0)
            return NULL;
        const size_t had = v->size - v->at;
        if (!read_more(v)) {
            (void)kill(v->child, SIGKILL);
            (void)waitpid(v->child, NULL, 0);
            close(v->fd);
            v->child = 0;
            v->fd    = -1;
        } else if (v->size == had) {
            return NULL;
        }
    }
}
