/* host-tools/read/number_lines.c -- curves as numbers
 * SPDX-License-Identifier: MIT
 *
 * Plain lines: `x y [z]` is a control point, an empty line ends the curve, `#` starts a comment;
 * commas, semicolons and tabs count as spaces; a line of eight numbers is a whole cubic in the
 * plane.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/host.h"
#include "base/scan.h"       /* scan_numbers */
#include "read/csv.h"        /* drawing_csv_parts */
#include "read/number_lines.h"

/* A curve that grows point by point. */
typedef struct {
    host *host;
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
        return host_error(r->host, EX_DATAERR, "points.too-many", (host_place){ r->file, line },
                          "end the curve with an empty line", "more than %d control points",
                          CURVE_DEGREE_MAX + 1);
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
        return host_error(r->host, EX_DATAERR, "points.not-a-point", (host_place){ r->file, line },
                          "give lines `x y` or `x y z`, or eight numbers for a cubic",
                          "not a control point");
    end_curve(r);
    for (int k = 0; k < 4 && code == 0; k++)
        code = add_point(r, number + 2 * k, 2, line);
    end_curve(r);
    return code;
}

static int read_lines(host *h, curves *all, const char *file, const char *text)
{
    reading r = { .host = h, .all = all, .file = file };
    int code  = 0;

    for (unsigned line = 1; *text != '\0' && code == 0; line++) {
        code = add_line(&r, text, line);
        text += strcspn(text, "\n");
        text += *text == '\n';
    }
    end_curve(&r);
    return code;
}

/* Spaces stand between points, commas between coordinates. */
int curves_of_points(host *h, curves *all, const char *text)
{
    reading r = { .host = h, .all = all, .file = "--points" };
    int code  = 0;

    for (text += strspn(text, " "); *text != '\0' && code == 0; text += strspn(text, " ")) {
        char point[128];
        const size_t length = strcspn(text, " ");
        if (length >= sizeof point)
            return host_error(h, EX_USAGE, "points.option", (host_place){ NULL, 0 },
                              "give points as \"x,y x,y ..\"", "--points %s", text);
        memcpy(point, text, length);
        point[length] = '\0';
        code = add_line(&r, point, 1);
        text += length;
    }
    end_curve(&r);
    return code;
}

int curves_of_drawing(host *h, curves *all, const drawing *d, const char *file)
{
    reading r = { .host = h, .all = all, .file = file };
    int code  = 0;

    for (size_t i = 0; i < d->count && code == 0; i++) {
        const drawing_curve *c = &d->curve[i];
        for (int k = 0; k < 4 && !(c->feed < 0) && code == 0; k++) {
            const double at[3] = { c->p[k][0], c->p[k][1], c->z[k] };
            code = add_point(&r, at, d->program ? 3 : 2, c->line);
        }
        end_curve(&r);
    }
    return code;
}

/* What no other kind takes. */
static int probe_rest(const reader *r, const char *file, const char *text, size_t size)
{
    (void)r, (void)file, (void)text, (void)size;
    return READER_REST;
}

const reader reader_numbers = { .name   = "lines of numbers",
                                .probe  = probe_rest,
                                .read   = drawing_csv_parts,
                                .curves = read_lines,
                                .takes  = READER_PARTS };
