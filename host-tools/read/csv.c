/* host-tools/read/csv.c -- reads curves as numbers: x0,y0,x1,y1,x2,y2,x3,y3 in mm, one cubic per
 * line
 * SPDX-License-Identifier: MIT
 *
 * `#` starts a comment; a first line of names is skipped. A curve that starts where the one before
 * ends continues its path. Commas, semicolons, tabs and blanks separate numbers.
 */
#include <ctype.h>
#include <string.h>

#include "base/host.h"
#include "read/csv.h"
#include "base/scan.h"       /* scan_numbers */
#include "base/source.h"     /* source_part */

static const char *skip(const char *s) { return s + strspn(s, ",; \t\r"); }

#define A_CURVE "a curve is x0,y0,x1,y1,x2,y2,x3,y3 in mm"

static int refuse(host *h, const char *file, unsigned line, int count, const char *rest)
{
    const host_place at = { file, line };
    const size_t length = strcspn(rest, ",; \t\r\n");
    const bool over     = *rest == '\0' || *rest == '\n' || *rest == '#';
    double more;

    if (count == 8 && scan_number(&rest, &more))
        return host_error(h, EX_DATAERR, "csv.more-numbers", at, A_CURVE,
                          "more than eight numbers");
    if ((count == 2 || count == 3) && over)
        return host_error(h, EX_DATAERR, "csv.points", at,
                          A_CURVE "; rows of points become a polyline by a line `line` before "
                                  "them, in LOFT.md",
                          "%d numbers", count);
    if (over)
        return host_error(h, EX_DATAERR, "csv.fewer-numbers", at, A_CURVE, "%d numbers", count);
    if (line == 1 && count == 0)
        return host_error(h, EX_DATAERR, "file.unknown", (host_place){ file, 0 }, NULL,
                          "is not a drawing: neither SVG nor CSV with x0,y0,x1,y1,x2,y2,x3,y3 "
                          "in mm");
    return host_error(h, EX_DATAERR, "csv.not-a-number", at, A_CURVE, "\"%.*s\" is not a number",
                      length > 20 ? 20 : (int)length, rest);
}

/* A line of names such as x0,y0,x1..: letters first, and a comma or blank somewhere. */
static bool is_header(const char *s)
{
    const size_t length = strcspn(s, "\n");

    return (isalpha((unsigned char)*s) || *s == '"') && strcspn(s, ",;\t") < length;
}

/* Read lines; *line is the number of the next one, and `first`: it may be names. */
static int read_lines(host *h, drawing *d, const char *file, const char *text, unsigned *at,
                      bool *first)
{
    unsigned line = *at;

    for (const char *s = text; *s != '\0'; line++) {
        const char *rest = skip(s);
        if (*rest != '#' && *rest != '\n' && *rest != '\0') {
            double v[8];
            if (!(*first && is_header(rest))) {
                const int count = scan_numbers(&rest, v, 8);
                if (count != 8 || (*rest != '\n' && *rest != '\0' && *rest != '#'))
                    return refuse(h, file, line, count, rest);
                double p[4][2];
                memcpy(p, v, sizeof p);
                int code = drawing_join(h, d, file, line, p);
                if (code == 0)
                    code = drawing_offer(d);
                if (code != 0)
                    return code;
            }
            *first = false;
        }
        s += strcspn(s, "\n");
        s += *s == '\n';
    }
    *at = line;
    return 0;
}

int drawing_csv_parts(host *h, drawing *d, const char *file, source *s)
{
    bool first    = true;
    unsigned line = 1;
    int code      = 0;

    for (size_t n = 0; code == 0 && s->size > 0; n++) {
        const bool mark = n == 0 && strncmp(s->text, "\xEF\xBB\xBF", 3) == 0;
        code = read_lines(h, d, file, s->text + (mark ? 3 : 0), &line, &first);
        if (code == 0)
            code = source_part(s);
    }
    return code;
}

int drawing_read_csv(host *h, drawing *d, const char *file, const char *text, size_t size)
{
    source s = source_text(text, size);

    return drawing_csv_parts(h, d, file, &s);
}
