/* host-tools/read/curve_read.c -- reads curves from any file; its content tells the format
 * SPDX-License-Identifier: MIT
 *
 * Plain lines: `x y [z]` is a control point, an empty line ends the curve, `#` starts a comment;
 * commas, semicolons and tabs count as spaces; a line of eight numbers is a whole cubic in the
 * plane.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "engine/curve.h"
#include "read/drawing.h"    /* drawing_read_svg */
#include "read/foreign.h"
#include "gcode/gcode.h"      /* gcode_is_text */
#include "base/scan.h"       /* scan_numbers */
#include "base/source.h"     /* source_read */
#include "base/tool.h"       /* tool_error, sysexits */

/* A curve that grows point by point. */
typedef struct {
    curves *all;
    const char *file;
    curve *now;             /* NULL between curves */
} reading;

static void end_curve(reading *r)
{
    if (r->now != NULL)
        r->now->degree = r->now->count - 1;
    r->now = NULL;
}

static int add_point(reading *r, const double at[], int axes, unsigned line)
{
    curve_point point = { .w = 1 };

    if (r->now == NULL)
        r->now = curves_add(r->all, CURVE_BEZIER, line);
    if (r->now->count > CURVE_DEGREE_MAX)
        return tool_error(EX_DATAERR,
                          "%s:%u: more than %d control points: end the curve with an empty line",
                          r->file, line, CURVE_DEGREE_MAX + 1);
    for (int i = 0; i < axes; i++)
        point.p[i] = at[i] + 0.0;       /* no -0 */
    r->all->solid |= axes > 2;
    curve_add_point(r->now, &point);
    return 0;
}

static bool all_finite(const double number[], int count)
{
    for (int i = 0; i < count; i++)
        if (!isfinite(number[i]))
            return false;
    return true;
}

static int add_line(reading *r, const char *text, unsigned line)
{
    double number[9];
    const int count = scan_numbers(&text, number, 9);
    const bool good = (*text == '\0' || *text == '\n' || *text == '#') && all_finite(number, count);
    int code = 0;

    if (good && count == 0) {
        if (*text != '#')
            end_curve(r);
        return 0;
    }
    if (good && (count == 2 || count == 3))
        return add_point(r, number, count, line);
    if (!good || count != 8)
        return tool_error(
            EX_DATAERR,
            "%s:%u: not a control point: give lines `x y` or `x y z`, or eight numbers for a cubic",
            r->file, line);
    end_curve(r);
    for (int k = 0; k < 4 && code == 0; k++)
        code = add_point(r, number + 2 * k, 2, line);
    end_curve(r);
    return code;
}

static int read_lines(reading *r, const char *text)
{
    int code = 0;

    for (unsigned line = 1; *text != '\0' && code == 0; line++) {
        code = add_line(r, text, line);
        text += strcspn(text, "\n");
        text += *text == '\n';
    }
    end_curve(r);
    return code;
}

/* The points of one curve, "0,0 1,2 3,0": spaces between points, commas between coordinates. */
static int read_points(reading *r, const char *text)
{
    int code = 0;

    for (text += strspn(text, " "); *text != '\0' && code == 0; text += strspn(text, " ")) {
        char point[128];
        const size_t length = strcspn(text, " ");
        if (length >= sizeof point)
            return tool_error(EX_USAGE, "--points %s: give points as \"x,y x,y ..\"", text);
        memcpy(point, text, length);
        point[length] = '\0';
        code = add_line(r, point, 1);
        text += length;
    }
    end_curve(r);
    return code;
}

/* The travels of a program are no curves. */
static int read_drawing(reading *r, const char *text, size_t size, bool svg)
{
    drawing d = { 0 };
    int code  = (svg ? drawing_read_svg : drawing_read_gcode)(&d, r->file, text, size);

    for (size_t i = 0; i < d.count && code == 0; i++) {
        for (int k = 0; k < 4 && !(d.curve[i].feed < 0); k++) {
            const double at[3] = { d.curve[i].p[k][0], d.curve[i].p[k][1], d.curve[i].z[k] };
            (void)add_point(r, at, svg ? 2 : 3, d.curve[i].line);
        }
        end_curve(r);
    }
    drawing_free(&d);
    return code;
}

static int read_file(reading *r, const char *file)
{
    size_t size;
    int code;
    char *text = source_read(file, &size, &code);

    if (text == NULL)
        return code;
    if (source_is_xml(text))
        code = read_drawing(r, text, size, true);
    else if (foreign_refuse(r->file, text, size) != 0)
        code = EX_DATAERR;
    else if (strlen(text) != size)
        code = tool_error(EX_DATAERR, "%s: is not text: give control points, one per line",
                          r->file);
    else if (curves_is_text(file, text))
        code = curves_read_text(r->all, r->file, text);
    else if (gcode_is_text(file, text))
        code = read_drawing(r, text, size, false);
    else
        code = read_lines(r, text);
    free(text);
    return code;
}

int curves_read(curves *all, const char *file, const char *text)
{
    reading r = { .all = all, .file = text ? "--points" : source_name(file) };
    const int code = text ? read_points(&r, text) : read_file(&r, file);

    if (code == 0 && all->count == 0)
        return tool_error(EX_DATAERR, "%s: no curve in it: give control points, one per line",
                          r.file);
    return code;
}
