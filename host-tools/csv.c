/* host-tools/csv.c -- reads curves as numbers: x0,y0,x1,y1,x2,y2,x3,y3 in mm, one cubic per line
 * SPDX-License-Identifier: MIT
 *
 * `#` starts a comment; a first line of names is passed over. A curve that starts where the one before ends goes on
 * with its path. Commas, semicolons, tabs and blanks separate.
 */
#include <ctype.h>
#include <math.h>
#include <string.h>

#include "drawing.h"
#include "scan.h"       /* scan_number */
#include "tool.h"       /* tool_error, sysexits */

#define SAME 1e-6       /* mm; ends that are nearer count as one point */

static const char *skip(const char *s)
{
    return s + strspn(s, ",; \t\r");
}

/* The numbers of one line: 8, or how many were readable. `*end` is where it stopped. */
static int numbers(const char *s, double out[8], const char **end)
{
    int count = 0;

    for (s = skip(s); count < 8 && scan_number(&s, &out[count]); s = skip(s))
        count++;
    *end = s;
    return count;
}

static int refuse(const char *file, unsigned line, int count, const char *rest)
{
    double more;

    if (count == 8 && scan_number(&rest, &more))
        return tool_error(EX_DATAERR, "%s:%u: more than eight numbers: a curve is x0,y0,x1,y1,x2,y2,x3,y3 in mm", file, line);
    if (*rest == '\0' || *rest == '\n' || *rest == '#')
        return tool_error(EX_DATAERR, "%s:%u: %d numbers: a curve is x0,y0,x1,y1,x2,y2,x3,y3 in mm", file, line, count);
    if (line == 1 && count == 0)
        return tool_error(EX_DATAERR, "%s: is no drawing: neither SVG nor CSV with x0,y0,x1,y1,x2,y2,x3,y3 in mm", file);
    return tool_error(EX_DATAERR, "%s:%u: \"%.*s\" is no number: a curve is x0,y0,x1,y1,x2,y2,x3,y3 in mm", file, line,
                      (int)strcspn(rest, ",; \t\r\n") > 20 ? 20 : (int)strcspn(rest, ",; \t\r\n"), rest);
}

/* A line of names such as x0,y0,x1..: letters first, and a comma or blank somewhere. */
static bool is_header(const char *s)
{
    const size_t length = strcspn(s, "\n");

    return (isalpha((unsigned char)*s) || *s == '"') && strcspn(s, ",;\t") < length;
}

static int add(drawing *d, const char *file, unsigned line, const double v[8])
{
    double p[4][2];

    memcpy(p, v, sizeof p);
    for (int i = 0; i < 8; i++)
        if (!(fabs(v[i]) <= DRAWING_LIMIT))
            return tool_error(EX_DATAERR, "%s:%u: %g mm is beyond +-%g mm: check the units", file, line, v[i], DRAWING_LIMIT);
    if (d->count >= DRAWING_CURVES_MAX)
        return tool_error(EX_DATAERR, "%s:%u: more than %u curves: split the drawing", file, line, DRAWING_CURVES_MAX);

    const double *end = d->count ? d->curve[d->count - 1].p[3] : NULL;
    const bool goes_on = end && hypot(end[0] - p[0][0], end[1] - p[0][1]) <= SAME;
    if (goes_on)
        memcpy(p[0], end, sizeof p[0]);
    for (int i = 1; i < 4; i++)
        if (hypot(p[i][0] - p[0][0], p[i][1] - p[0][1]) > SAME) {
            drawing_add(d, p, !goes_on, line);
            break;                      /* a curve without length draws nothing */
        }
    return 0;
}

int drawing_read_csv(drawing *d, const char *file, const char *text, size_t size)
{
    bool first = true;
    unsigned line = 1;

    if (strncmp(text, "\xEF\xBB\xBF", 3) == 0)
        text += 3;
    (void)size;
    for (const char *s = text; *s != '\0'; line++) {
        const char *rest = skip(s);
        if (*rest != '#' && *rest != '\n' && *rest != '\0') {
            double v[8];
            if (!(first && is_header(rest))) {
                const int count = numbers(s, v, &rest);
                if (count != 8 || (*rest != '\n' && *rest != '\0' && *rest != '#'))
                    return refuse(file, line, count, rest);
                const int code = add(d, file, line, v);
                if (code != 0)
                    return code;
            }
            first = false;
        }
        s += strcspn(s, "\n");
        s += *s == '\n';
    }
    return 0;
}
