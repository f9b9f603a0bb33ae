/* host-tools/read/gcode_draw.c -- a G-code program as a drawing in space
 * SPDX-License-Identifier: MIT
 *
 * Straight motions, G5 and G5.1 are exact cubics. Arcs and NURBS are cubics within DRAWING_TOL.
 */
#include <ctype.h>
#include <math.h>
#include <string.h>
#include <strings.h>

#include "engine/curve.h"
#include "engine/engine.h"  /* engine_f64: arcs and NURBS */
#include "engine/piece.h"
#include "base/tool.h"      /* tool_error, sysexits */
#include "read/drawing.h"
#include "read/gcode.h"

#define LINES_LOOKED 200    /* of the beginning, for what kind of file it is */

typedef struct {
    drawing *d;
    const char *file;
    const gcode_event *e;
    unsigned waits, wait_line, stops, stop_line;
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
        out->code = drawing_join_space(out->d, out->file, e->line, mm, feed);
    /* no way in numbers may be one on the machine */
    if (out->code == 0 && out->d->count == before && e->loose[0] != e->loose[1])
        drawing_add_space(out->d, mm, feed, false, e->line);
    /* only a line may lead from a loose place to a known one; others start where the numbers say */
    const bool line = e->kind == GCODE_RAPID || e->kind == GCODE_LINE;
    if (out->d->count > before && (line || e->loose[0] == e->loose[1]))
        memcpy(out->d->curve[before].loose, e->loose, sizeof e->loose);
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

/* Waits and stops are counted: motion alone is drawn. */
static void count_pause(unsigned *count, unsigned *line, const gcode_event *e)
{
    *line = *count > 0 ? *line : e->line;
    ++*count;
}

static int take(void *context, const gcode_event *e)
{
    pen *out   = context;
    int status = 0;

    out->e = e;
    switch (e->kind) {
    case GCODE_WAIT: count_pause(&out->waits, &out->wait_line, e); break;
    case GCODE_STOP: count_pause(&out->stops, &out->stop_line, e); break;
    case GCODE_SAY:  break;
    case GCODE_ARC:
        status = engine_f64.arc(e->from, e->to, e->plane, e->centre, e->turns,
                                DRAWING_TOL / e->frame->unit, draw, out);
        break;
    case GCODE_NURBS: status = draw_nurbs(out, e); break;
    default: draw_cubic(out, e);
    }
    if (status != 0 && out->code == 0)
        out->code = tool_error(EX_DATAERR, "%s:%u: %s: %s", out->file, e->line,
                               e->kind == GCODE_ARC ? "arc" : "NURBS", engine_status(status));
    return out->code;
}

static void tell_pauses(const pen *out)
{
    if (out->waits > 0)
        (void)tool_error(EX_OK, "%s:%u: G4 (%u times): the machine does not wait there", out->file,
                         out->wait_line, out->waits);
    if (out->stops > 0)
        (void)tool_error(EX_OK, "%s:%u: M0, M1 or M6 (%u times): the machine does not stop there",
                         out->file, out->stop_line, out->stops);
}

int drawing_read_gcode(drawing *d, const char *file, const char *text, size_t size)
{
    pen out  = { .d = d, .file = file };
    const bool printer = d->dialect == GCODE_ANY && gcode_is_printer(text);
    gcode_program *g   = gcode_open(file, printer ? GCODE_MARLIN : (enum gcode_dialect)d->dialect,
                                  take, &out);
    d->clear       = -HUGE_VAL;
    const int code = gcode_read(g, text, size);

    gcode_close(g);
    d->program = true;
    if (code == 0)
        tell_pauses(&out);
    return code;
}


// Recognition
// -----------

/* Call `is` for the first lines, without what is not code. */
static bool some_line(const char *text, bool (*is)(const char *line))
{
    for (int line = 0; line < LINES_LOOKED && *text != '\0'; line++) {
        text += strspn(text, " \t\r");
        if (is(text))
            return true;
        text += strcspn(text, "\n");
        text += *text == '\n';
    }
    return false;
}

/* A letter and a number, as G21, N10 or M3. */
static bool begins_with_code(const char *line)
{
    return *line != '\0' && strchr("GMNgmn", *line) != NULL &&
           isdigit((unsigned char)line[1 + strspn(line + 1, " ")]);
}

/* Codes of heaters and extruders. */
static bool is_of_printer(const char *line)
{
    static const char *const codes[] = { "M104", "M109", "M140", "M190", "M82", "M83", ";FLAVOR" };

    for (size_t i = 0; i < sizeof codes / sizeof codes[0]; i++) {
        const size_t n = strlen(codes[i]);
        if (strncmp(line, codes[i], n) == 0 && !isdigit((unsigned char)line[n]))
            return true;
    }
    return false;
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

bool gcode_is_text(const char *file, const char *text)
{
    return named(file, text) || some_line(text, begins_with_code);
}

bool gcode_is_printer(const char *text) { return some_line(text, is_of_printer); }
