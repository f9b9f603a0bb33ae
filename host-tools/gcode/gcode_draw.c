/* host-tools/gcode/gcode_draw.c -- a G-code program as a drawing in space
 * SPDX-License-Identifier: MIT
 *
 * Straight motions, G5 and G5.1 are exact cubics. Arcs and NURBS are cubics within DRAWING_TOL.
 */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "engine/curve.h"
#include "engine/engine.h"  /* engine_f64: NURBS */
#include "engine/piece.h"
#include "base/host.h"
#include "base/source.h"    /* source_part */
#include "read/drawing.h"
#include "gcode/gcode.h"
#include "gcode/gcode_draw.h"
#include "read/machine_tools.h"

#define LINES_LOOKED 200    /* of the beginning, for what kind of file it is */

typedef struct {
    host *host;
    drawing *d;
    const char *file;
    const gcode_event *e;
    bool blends;                /* not all feeds are in G61 or G61.1 */
    unsigned tool;              /* of the table, from 1; 0: none */
    char say[80];               /* the last message since a motion */
    int code;
} pen;

/* A cubic in coordinates of the program. */
static void draw(void *context, double p[4][3])
{
    pen *out = context;
    const gcode_event *e = out->e;
    double mm[4][3];

    for (int k = 0; k < 4; k++) {
        gcode_place(e->frame, p[k], mm[k]);
        out->d->clear = fmax(out->d->clear, mm[k][2]);
    }
    if (e->line < out->d->from_line)
        return;
    const size_t before = out->d->count;
    const double feed = e->kind == GCODE_RAPID && !(e->feed > 0) ? DRAWING_RAPID : e->feed;
    if (out->code == 0)
        out->code = drawing_join_space(out->host, out->d, out->file, e->line, mm, feed);
    if (out->d->count > before && out->d->events > 0 && before > 0 &&
        out->d->event[out->d->events - 1].before == out->d->taken + before)
        out->d->curve[before].path = out->d->curve[before - 1].path + 1;
    out->say[0] = '\0';
    /* no way in numbers may be one on the machine */
    if (out->code == 0 && out->d->count == before && e->loose[0] != e->loose[1])
        drawing_add_space(out->d, mm, feed, false, e->line);
    /* only a line may lead from a loose place to a known one; others start where the numbers say */
    const bool line = e->kind == GCODE_RAPID || e->kind == GCODE_LINE;
    if (out->d->count > before && (line || e->loose[0] == e->loose[1]))
        memcpy(out->d->curve[before].loose, e->loose, sizeof e->loose);
    for (size_t i = before; i < out->d->count; i++)
        out->d->curve[i].tool = out->tool;
    if (out->code == 0)
        out->code = drawing_offer(out->d);
}

static void draw_cubic(pen *out, const gcode_event *e)
{
    double p[4][3];

    for (int i = 0; i < 3; i++) {
        p[0][i] = e->from[i];
        p[3][i] = e->to[i];
        switch (e->kind) {
        case GCODE_CUBIC:
            p[1][i] = e->inner[0][i];
            p[2][i] = e->inner[1][i];
            break;
        case GCODE_QUADRATIC:
            p[1][i] = e->from[i] + (e->inner[0][i] - e->from[i]) * 2 / 3;
            p[2][i] = e->to[i] + (e->inner[0][i] - e->to[i]) * 2 / 3;
            break;
        default:
            p[1][i] = e->from[i] + (e->to[i] - e->from[i]) / 3;
            p[2][i] = e->to[i] - (e->to[i] - e->from[i]) / 3;
        }
    }
    draw(out, p);
}

static int draw_arc(void *context, double p[4][3])
{
    pen *out = context;

    draw(out, p);
    return out->code;
}

static int draw_nurbs(pen *out, const gcode_event *e)
{
    const engine_curves *make = engine_f64.curve;
    curves all = { 0 };
    curve *c   = curves_add(&all, CURVE_NURBS, e->line);
    engine_curve *held;
    piece p;

    c->degree = e->degree;
    for (unsigned i = 0; i < e->count; i++)
        curve_add_point(c, &(curve_point){ .p = { e->points[i][0], e->points[i][1], e->from[2] },
                                           .w = e->points[i][2] });
    for (unsigned i = 0; i < e->count + e->degree + 1; i++)
        curve_add_knot(c, i <= e->degree  ? 0
                          : i <= e->count ? i - e->degree
                                          : e->count - e->degree);
    int status = make->open(c, &held);
    if (status == 0) {
        for (unsigned i = 0; i < make->pieces(held) && status == 0 && out->code == 0; i++) {
            status = make->piece(held, i, &p);
            if (status == 0)
                status = engine_f64.piece->cubics(&p, DRAWING_TOL / e->frame->unit, draw, out);
        }
        make->close(held);
    }
    curves_free(&all);
    return status;
}

/* Before the first line that is run nothing waits, but what turns there turns from then on. */
static void add_event(pen *out, const gcode_event *e)
{
    drawing_event to = { .line = e->line, .way = e->way };

    switch (e->kind) {
    case GCODE_WAIT:
        to.doing  = DRAWING_WAITS;
        to.amount = e->seconds;
        break;
    case GCODE_SPINDLE:
        to.doing  = DRAWING_SPINS;
        to.amount = e->speed;
        break;
    case GCODE_COOLANT: to.doing = DRAWING_COOLS; break;
    default: to.doing = DRAWING_PAUSES; snprintf(to.text, sizeof to.text, "%s", out->say);
    }
    if (e->line < out->d->from_line && e->kind != GCODE_SPINDLE && e->kind != GCODE_COOLANT)
        return;
    if (out->d->events < DRAWING_CURVES_MAX)
        drawing_add_event(out->d, &to);
    else if (out->code == 0)
        out->code = host_error(out->host, EX_DATAERR, "gcode.too-many-events",
                               (host_place){ out->file, e->line }, "split the program",
                               "more than %u waits, stops and switches", DRAWING_CURVES_MAX);
}

static void note_message(pen *out, const gcode_event *e)
{
    size_t length    = e->length;
    const char *text = e->text;

    while (length > 0 && *text == ' ')
        text++, length--;
    length = length < sizeof out->say ? length : sizeof out->say - 1;
    snprintf(out->say, sizeof out->say, "%.*s", (int)length, text);
}

/* What follows is drawn with this tool. One that the machine does not know is a stop. */
static void change_tool(pen *out, const gcode_event *e)
{
    const machine_tools *all = out->d->tools;
    char name[24];

    snprintf(name, sizeof name, "%ld", e->tool);
    const machine_tool *found = all != NULL ? machine_tools_find(all, name) : NULL;
    out->tool = found != NULL ? (unsigned)(found - all->tool) + 1 : 0;
    if (found != NULL)
        return;
    if (out->say[0] == '\0')
        snprintf(out->say, sizeof out->say, "tool %ld", e->tool);
    add_event(out, e);
}

/* One plan has one tolerance: the smallest; and stops everywhere, or nowhere. */
static void note_path(pen *out, const gcode_event *e)
{
    drawing *d = out->d;

    if (e->kind == GCODE_RAPID || e->kind > GCODE_NURBS || e->line < d->from_line)
        return;
    out->blends = out->blends || !e->exact;
    d->exact    = d->exact || e->exact;
    if (e->within > 0 && (!(d->within > 0) || e->within < d->within))
        d->within = e->within;
}

static int take(void *context, const gcode_event *e)
{
    pen *out   = context;
    int status = 0;

    out->e = e;
    note_path(out, e);
    switch (e->kind) {
    case GCODE_WAIT:
    case GCODE_STOP:
    case GCODE_SPINDLE:
    case GCODE_COOLANT: add_event(out, e); break;
    case GCODE_SAY:     note_message(out, e); break;
    case GCODE_TOOL:     change_tool(out, e); break;
    case GCODE_ARC: (void)gcode_arc_cubics(e, DRAWING_TOL / e->frame->unit, draw_arc, out); break;
    case GCODE_NURBS: status = draw_nurbs(out, e); break;
    default: draw_cubic(out, e);
    }
    if (status != 0 && out->code == 0)
        out->code = host_error(out->host, EX_DATAERR, "gcode.nurbs",
                               (host_place){ out->file, e->line }, NULL, "NURBS: %s",
                               engine_status(status, "give L from 2 to 10 and more points than L"));
    return out->code;
}

static void tell_path(const pen *out)
{
    if (out->d->exact && out->blends)
        host_warn(out->host, "gcode.exact-stop-everywhere", (host_place){ out->file, 0 }, NULL,
                  "G61 in a part of it: it stops at corners everywhere");
}

static int drawing_gcode_parts(host *h, drawing *d, const char *file, source *s)
{
    pen out  = { .host = h, .d = d, .file = file };
    const bool printer = d->dialect == GCODE_ANY && gcode_is_printer(s->text);
    gcode_program *g = gcode_open(h, file, printer ? GCODE_MARLIN : (enum gcode_dialect)d->dialect,
                                  take, &out);
    d->clear       = -HUGE_VAL;
    gcode_set_tools(g, d->tools);
    gcode_bound(g, d->most_lines);
    d->program     = true;
    int code       = 0;
    while (code == 0 && s->size > 0 && !gcode_ended(g)) {
        code = gcode_lines(g, s->text, s->size);
        if (code == 0)
            code = source_part(s);
    }
    if (code == 0)
        code = gcode_finish(g);
    gcode_close(g);
    if (code == 0)
        tell_path(&out);
    return code;
}

int drawing_read_gcode(host *h, drawing *d, const char *file, const char *text, size_t size)
{
    source s = source_text(text, size);

    return drawing_gcode_parts(h, d, file, &s);
}


// Recognition
// -----------

/* Call `is` for the first lines, without what is not code. */
static bool some_line(const char *text, bool (*is)(const char *line))
{
    for (int line = 0; line < LINES_LOOKED && *text != '\0'; line += *text != ';') {
        text += strspn(text, " \t\r\n");
        if (is(text))
            return true;
        text += strcspn(text, "\r\n");
        text += strspn(text, "\r\n");
    }
    return false;
}

/* A letter and a number, as G21, N10 or M3. */
static bool begins_with_code(const char *line)
{
    return *line != '\0' && strchr("GMNgmn", *line) != NULL &&
           isdigit((unsigned char)line[1 + strspn(line + 1, " ")]);
}

/* A motion with an extruder: G1 X1 E2. */
static bool extrudes(const char *line)
{
    const size_t end = strcspn(line, "\r\n;(");

    if (!begins_with_code(line) || toupper((unsigned char)*line) != 'G')
        return false;
    for (size_t i = 1; i + 1 < end; i++)
        if (toupper((unsigned char)line[i]) == 'E' && strchr("-.0123456789", line[i + 1]) != NULL)
            return true;
    return false;
}

/* Codes of heaters, extruders, fans and displays; all above M199, which are no controller's. */
static bool is_of_printer(const char *line)
{
    static const int codes[] = { 82, 83, 84, 104, 105, 106, 107, 109, 117, 118, 140, 190 };

    if (strncmp(line, ";FLAVOR", 7) == 0 || extrudes(line))
        return true;
    if (toupper((unsigned char)*line) != 'M' || !begins_with_code(line))
        return false;
    const long m = strtol(line + 1, NULL, 10);
    for (size_t i = 0; i < sizeof codes / sizeof codes[0]; i++)
        if (codes[i] == m)
            return true;
    return m > 199;
}

static bool named(const char *file, const char *text)
{
    static const char *const ends[] = { ".nc", ".ngc", ".gcode", ".tap", ".cnc", ".gc", ".g" };
    const char *dot = strrchr(file, '.');

    for (size_t i = 0; dot != NULL && i < sizeof ends / sizeof ends[0]; i++)
        if (strcasecmp(dot, ends[i]) == 0)
            return true;
    return *text == '%' && strchr(" \r\n", text[1]) != NULL;
}

bool gcode_is_printer(const char *text) { return some_line(text, is_of_printer); }

static int probe_gcode(const reader *r, const char *file, const char *text, size_t size)
{
    (void)r, (void)size;
    return named(file, text)                   ? READER_ENDING
           : some_line(text, begins_with_code) ? READER_LINE
                                               : READER_NOT;
}

const reader reader_gcode = { .name  = "G-code",
                              .probe = probe_gcode,
                              .read  = drawing_gcode_parts,
                              .takes = READER_PARTS | READER_PROGRAM };
