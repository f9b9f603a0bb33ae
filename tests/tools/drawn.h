/* tests/tools/drawn.h -- drawings as text
 * SPDX-License-Identifier: MIT
 *
 * A drawing is written back as path data in the user units of a page of 100 mm, y down: M at the
 * start of each path, L for a cubic that is a line, C for the others. So the expectation reads like
 * the source.
 */
#ifndef LOFT_TESTS_DRAWN_H
#define LOFT_TESTS_DRAWN_H

#include <math.h>
#include <string.h>

#include "check.h"      /* CHECK, PROPERTY */
#include "read/drawing.h"
#include "support/heard.h"
#include "svg/svg_file.h"

/* " x" with at most three decimals, without trailing zeros. */
static inline void put_number(char *out, size_t size, double x)
{
    char number[40];

    snprintf(number, sizeof number, "%.3f", fabs(x) < 0.0005 ? 0 : x);
    for (size_t n = strlen(number); n > 0 && (number[n - 1] == '0' || number[n - 1] == '.'); n--) {
        const bool point = number[n - 1] == '.';
        number[n - 1] = '\0';
        if (point)
            break;
    }
    snprintf(out + strlen(out), size - strlen(out), " %s", number);
}

static inline bool is_line(const drawing_curve *c)
{
    for (int k = 1; k < 3; k++)
        for (int i = 0; i < 2; i++)
            if (fabs(c->p[k][i] - (c->p[0][i] + (c->p[3][i] - c->p[0][i]) * k / 3)) > 1e-9)
                return false;
    return true;
}

static inline void put_drawing(char *out, size_t size, const drawing *d, double page)
{
    out[0] = '\0';
    for (size_t i = 0; i < d->count; i++) {
        const drawing_curve *c = &d->curve[i];
        const bool line = is_line(c);
        if (i == 0 || c->path != d->curve[i - 1].path) {
            snprintf(out + strlen(out), size - strlen(out), "%sM", i ? " " : "");
            put_number(out, size, c->p[0][0]);
            put_number(out, size, page - c->p[0][1]);
        }
        snprintf(out + strlen(out), size - strlen(out), line ? " L" : " C");
        for (int k = line ? 3 : 1; k < 4; k++) {
            put_number(out, size, c->p[k][0]);
            put_number(out, size, page - c->p[k][1]);
        }
    }
}

static inline int read_svg(drawing *d, const char *text)
{
    hear();
    *d = (drawing){ 0 };
    return drawing_read_svg(&heard, d, "test.svg", text, strlen(text));
}

/* Read a whole document; CHECK that it draws `wanted` on a page of `page` mm. */
#define DRAWS_ON(page, text, wanted) check_draws(text, page, wanted, __FILE__, __LINE__)

/* The same inside an <svg> of 100 mm and 100 units. */
#define DRAWS(inner, wanted) DRAWS_ON(100, PAGE(inner), wanted)
#define PAGE(inner)                                                                                \
    "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "      \
    "width=\"100mm\" height=\"100mm\" viewBox=\"0 0 100 100\">" inner "</svg>"
#define DRAWS_PATH(data, wanted) DRAWS("<path d=\"" data "\"/>", wanted)

static inline void check_draws(const char *text, double page, const char *wanted, const char *file,
                               int line)
{
    char got[8192];
    drawing d;
    const int code = read_svg(&d, text);

    put_drawing(got, sizeof got, &d, page);
    if (code != 0 || strcmp(got, wanted) != 0) {
        printf("%s:%d: code %d %s\n  source %s\n  drawn  %s\n  wanted %s\n", file, line, code,
               caught, text, got, wanted);
        check_bad = true;
    }
    drawing_free(&d);
}

/* CHECK that the document is refused with EX_DATAERR and one line that contains `words`. */
#define REFUSES(inner, words) check_refuses(PAGE(inner), words, __FILE__, __LINE__)
#define REFUSES_PATH(data, words) REFUSES("<path d=\"" data "\"/>", words)

static inline void check_refuses(const char *text, const char *words, const char *file, int line)
{
    drawing d;
    const int code = read_svg(&d, text);

    if (code != EX_DATAERR || caught_lines != 1 || strchr(caught, '\n') != NULL ||
        strstr(caught, words) == NULL) {
        printf("%s:%d: code %d, %u lines: %s\n  wanted: %s\n", file, line, code, caught_lines,
               caught, words);
        check_bad = true;
    }
    drawing_free(&d);
}

#endif
