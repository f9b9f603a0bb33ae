/* tests/vectors/vectors_sheet.c
 * SPDX-License-Identifier: MIT
 */
#define _GNU_SOURCE                 /* getline, strsep, strdup */

#include <stdlib.h>
#include <string.h>

#include "vectors/vectors_sheet.h"

static sheet kept[12];

static void fill(sheet *s, FILE *file)
{
    char *line = NULL;
    size_t size = 0;

    while (getline(&line, &size, file) >= 0) {
        line[strcspn(line, "\r\n")] = '\0';
        if (*line == '#' || !*line)
            continue;
        if ((s->rows & (s->rows - 1)) == 0)
            s->field = realloc(s->field, (s->rows ? 2 * s->rows : 1) * sizeof *s->field);
        if (!s->field)
            abort();
        char *rest = strdup(line);      /* kept until the end */
        for (unsigned k = 0; k < SHEET_COLUMNS; k++)
            s->field[s->rows][k] = rest ? strsep(&rest, ",") : NULL;
        s->rows++;
    }
    free(line);
}

const sheet *sheet_of(row *r, const char *name)
{
    unsigned k = 0;
    char path[4096];

    while (kept[k].name[0] && strcmp(kept[k].name, name) != 0)
        k++;
    if (kept[k].name[0])
        return &kept[k];
    snprintf(kept[k].name, sizeof kept[k].name, "%s", name);
    snprintf(path, sizeof path, "%s/%s.csv", r->folder, name);
    FILE *file = fopen(path, "r");
    if (file) {
        fill(&kept[k], file);
        fclose(file);
    }
    if (!kept[k].rows)
        row_complain(r, "%s has no rows", path);
    return &kept[k];
}

long double decimal(row *r, const char *text)
{
    char *end = NULL;
    const long double v = text ? strtold(text, &end) : 0;

    if (!text || end == text || *end || !isfinite(v))
        row_complain(r, "no number at '%.20s'", text ? text : "");
    return v;
}

loft_real decimal_real(row *r, const char *text)
{
    const long double v = decimal(r, text);
    const bool fits = fabsl(v) < BY_NUM(32768, FLT_MAX, DBL_MAX) ||
                      BY_NUM(v == -32768, false, false);
    const loft_real x = (loft_real)BY_NUM(fits ? llroundl(v * 65536) : 0, v, v);

    if (!fits)
        row_complain(r, "%s is no coordinate", text);

    r->largest = fmaxl(r->largest, fabsl(v));
    r->inexact = fmaxl(r->inexact, fabsl(v - exact_of(x)));
    return x;
}

loft_unit decimal_unit(row *r, const char *text)
{
    const long double v = decimal(r, text);
    const loft_unit t = (loft_unit)BY_NUM(llroundl(v * 16777216), v, v);

    r->inexact = fmaxl(r->inexact, fabsl(v - exact_unit(t)));
    return t;
}

unsigned wholes(const char *text, int out[], unsigned most)
{
    unsigned count = 0;
    char *end;

    for (; text && *text && count < most; text = end, count++) {
        out[count] = (int)strtol(text, &end, 10);
        if (end == text)
            break;
    }
    return count;
}

void expect_wide(row *r, const char *column, loft_acc x, law l)
{
    answer *a = answer_new();

    answer_wide(a, x);
    row_expect(r, column, a, l);
}

void expect_point(row *r, enum loft_status status, loft_vec v, law l)
{
    static const char *const name[3] = { "X", "Y", "Z" };

    for (int i = 0; i < 3; i++) {
        answer *a = answer_new();
        answer_status(r, a, status);
        answer_real(a, v.axis[i]);
        row_expect(r, name[i], a, l);
    }
}
