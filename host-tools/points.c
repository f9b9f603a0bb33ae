/* host-tools/points.c -- curves as text
 * SPDX-License-Identifier: MIT
 */
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drawing.h"        /* drawing_read, for SVG */
#include "points.h"
#include "tool.h"

/* A curve that grows point by point. */
typedef struct {
    points *all;
    const char *file;
    points_curve now;
    unsigned count;         /* points of `now`     */
} reading;

static int end_curve(reading *r)
{
    points *all = r->all;

    if (r->count == 0)
        return 0;
    r->now.degree = r->count - 1;
    r->count      = 0;
    r->now.fresh  = true;
    if (all->count > 0) {
        const points_curve *before = &all->curve[all->count - 1];
        r->now.fresh = memcmp(before->p[before->degree], r->now.p[0], sizeof r->now.p[0]) != 0;
    }
    all->curve = tool_grow(all->curve, (all->count + 1) * sizeof *all->curve);
    all->curve[all->count++] = r->now;
    return 0;
}

static int add_point(reading *r, const double at[], unsigned axes, unsigned line)
{
    if (r->count == POINTS_MAX)
        return tool_error(EX_DATAERR, "%s:%u: more than %d control points: end the curve with an empty line", r->file, line, POINTS_MAX);
    if (r->count == 0)
        r->now.line = line;
    for (unsigned i = 0; i < ENGINE_AXES; i++)
        r->now.p[r->count][i] = i < axes ? at[i] + 0.0 : 0;
    if (axes > 2)
        r->all->solid = true;
    r->count++;
    return 0;
}

/* The numbers of a line, at most eight; -1 if something else stands there. */
static int numbers_of(const char *text, double out[8])
{
    int count = 0;

    for (;;) {
        while (*text != '\0' && (isspace((unsigned char)*text) || *text == ',' || *text == ';'))
            text++;
        if (*text == '\0' || *text == '#')
            return count;
        char *end;
        if (count == 8)
            return -1;
        out[count] = strtod(text, &end);
        if (end == text || !isfinite(out[count]))
            return -1;
        count++;
        text = end;
    }
}

static int add_line(reading *r, const char *text, unsigned line)
{
    double number[8];
    const int count = numbers_of(text, number);
    int code = 0;

    switch (count) {
    case 0:
        return text[strspn(text, " \t\r\n")] == '#' ? 0 : end_curve(r);
    case 2: case 3:
        return add_point(r, number, (unsigned)count, line);
    case 8:
        code = end_curve(r);
        for (unsigned k = 0; k < 4 && code == 0; k++)
            code = add_point(r, number + 2 * k, 2, line);
        return code ? code : end_curve(r);
    default:
        return tool_error(EX_DATAERR, "%s:%u: not a control point: give lines `x y` or `x y z`, or eight numbers for a cubic", r->file, line);
    }
}

static int read_lines(reading *r, FILE *f)
{
    char *text  = NULL;
    size_t room = 0;
    int code    = 0;

    for (unsigned line = 1; code == 0 && getline(&text, &room, f) >= 0; line++)
        code = add_line(r, text, line);
    free(text);
    if (code == 0 && ferror(f))
        code = tool_error(EX_IOERR, "%s: %s: read again", r->file, strerror(errno));
    return code ? code : end_curve(r);
}

/* "0,0 1,2 3,0": the points of one curve, spaces between points, commas within. */
static int read_text(reading *r, const char *text)
{
    char point[128];
    int code = 0;

    for (const char *at = text + strspn(text, " "); *at != '\0' && code == 0; at += strspn(at, " ")) {
        const size_t length = strcspn(at, " ");
        if (length >= sizeof point)
            return tool_error(EX_USAGE, "--points %s: give points as \"x,y x,y ..\"", text);
        memcpy(point, at, length);
        point[length] = '\0';
        code = add_line(r, point, 1);
        at += length;
    }
    return code ? code : end_curve(r);
}

static int read_drawing(reading *r)
{
    drawing d = { 0 };
    int code  = drawing_read(&d, r->file);

    for (size_t i = 0; i < d.count && code == 0; i++) {
        for (unsigned k = 0; k < 4; k++)
            (void)add_point(r, d.curve[i].p[k], 2, d.curve[i].line);
        code = end_curve(r);
    }
    drawing_free(&d);
    return code;
}

static int read_file(reading *r)
{
    const bool standard = strcmp(r->file, "-") == 0;
    FILE *f = standard ? stdin : fopen(r->file, "r");
    int c;

    if (f == NULL)
        return tool_error(EX_NOINPUT, "%s: %s: name a file that can be read, or - for standard input", r->file, strerror(errno));
    do
        c = getc(f);
    while (c != EOF && isspace(c) && c != '\n');
    ungetc(c, f);
    const int code = c == '<' ? read_drawing(r) : read_lines(r, f);
    if (!standard)
        fclose(f);
    return code;
}

int points_read(points *all, const char *file, const char *text)
{
    reading r = { .all = all, .file = text ? "--points" : file };
    const int code = text ? read_text(&r, text) : read_file(&r);

    if (code == 0 && all->count == 0)
        return tool_error(EX_DATAERR, "%s: no curve in it: give control points, one per line", r.file);
    return code;
}

void points_free(points *all)
{
    free(all->curve);
    *all = (points){ 0 };
}

static void print_number(const engine *e, double x)
{
    const double near = (e->fixed ? e->lsb : e->lsb * fabs(x)) / 4;
    char text[32];

    for (int digits = 5; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, x);
        if (fabs(strtod(text, NULL) - x) <= near)
            break;
    }
    fputs(text, stdout);
}

void points_print(void *context, const double point[ENGINE_AXES])
{
    const points_printing *p = context;

    for (int i = 0; i < (p->solid ? ENGINE_AXES : 2); i++) {
        if (i > 0)
            putchar(' ');
        print_number(p->e, point[i]);
    }
    putchar('\n');
}

int points_print_start(points_printing *p, const points *all, size_t i)
{
    const points_curve *c = &all->curve[i];
    double start[ENGINE_AXES];

    if (!c->fresh)
        return 0;
    const int status = p->e->eval((const double (*)[ENGINE_AXES])c->p, 0, 0, start);
    if (status != 0)
        return status;
    if (i > 0)
        putchar('\n');
    points_print(p, start);
    return 0;
}
