/* tests/tools/test_readers.c -- each kind of file takes its own samples, and no other kind does
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <string.h>

#include "gcode/gcode_draw.h"
#include "read/drawing_curves.h"
#include "read/foreign.h"
#include "read/number_lines.h"
#include "readers.h"
#include "svg/svg_file.h"
#include "tools/drawn.h"    /* caught */

#define OWN 4
static const reader *const own[OWN] = { &reader_svg, &reader_loft, &reader_gcode, &reader_numbers };

/* What a file holds, and which kind takes it; `refused`: its name in the message. */
static const struct {
    const char *file, *text;
    const reader *row;
    const char *refused;
} samples[] = {
    { "a.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>", &reader_svg, NULL },
    { "a", "\xEF\xBB\xBF <?xml version=\"1.0\"?><svg/>", &reader_svg, NULL },
    { "a.nc", "<svg/>", &reader_svg, NULL },
    { "a.loft", "0 0\n1 1\n", &reader_loft, NULL },
    { "a", "# x\nbezier 3\n", &reader_loft, NULL },
    { "a.nc", "natural\n0 0\n", &reader_loft, NULL },
    { "a.loft", "G1 X1\n", &reader_loft, NULL },
    { "a.NGC", "(nothing)\n", &reader_gcode, NULL },
    { "a.txt", "; x\nG21\nG1 X1\n", &reader_gcode, NULL },
    { "a.csv", "%\nN10 G1\n", &reader_gcode, NULL },
    { "a.csv", "0,0,1,1,2,2,3,3\n", &reader_numbers, NULL },
    { "a", "x0,y0,x1\n", &reader_numbers, NULL },
    { "a.nc", "%PDF-1.4\n", NULL, "PDF" },
    { "a.loft", "%!PS-Adobe\n", NULL, "PostScript" },
    { "a.png", "\x89PNG\r\n", NULL, "a PNG picture" },
    { "a.dxf", "999\nx\n  0\nSECTION\n", NULL, "DXF" },
    { "a.plt", "IN;SP1;PU0,0;\n", NULL, "HP-GL" },
    { "a.gbr", "G04 x*\n%FSLAX24Y24*%\n", NULL, "Gerber" },
    { "a.nc", "M48\nMETRIC,TZ\nT1C0.8\n%\n", NULL, "Excellon" },
    { "a.stl", "solid x\nfacet normal 0 0 1\n", NULL, "STL" },
    { "a.gz", "BZh9", NULL, "compressed with bzip2" },
};

/* All rows, as the program lists them. */
static const reader *row_of(const char *file, const char *text, int *best)
{
    const reader *rows[OWN + FOREIGN_KINDS];

    *best = 0;
    for (size_t i = 0; i < OWN + FOREIGN_KINDS; i++) {
        rows[i] = i < OWN ? own[i] : &foreign_readers[i - OWN];
        const int score = rows[i]->probe(rows[i], file, text, strlen(text));
        *best = score > *best ? score : *best;
    }
    return reader_of(&heard, rows, OWN + FOREIGN_KINDS, file, text, strlen(text));
}

static void each_kind_takes_its_own_samples(arb *a)
{
    (void)a;
    for (size_t i = 0; i < sizeof samples / sizeof *samples; i++) {
        int best;
        const reader *r = row_of(samples[i].file, samples[i].text, &best);
        CHECK(r != NULL && caught_lines == 0);
        if (r == NULL)
            continue;
        if (samples[i].row != NULL)
            CHECK(r == samples[i].row && r->read != NULL);
        else
            CHECK(r->read == NULL && r->remedy != NULL &&
                  strncmp(r->name, samples[i].refused, strlen(samples[i].refused)) == 0);
        for (size_t k = 0; k < FOREIGN_KINDS; k++)
            CHECK(r == &foreign_readers[k] ||
                  foreign_readers[k].probe(&foreign_readers[k], samples[i].file, samples[i].text,
                                           strlen(samples[i].text)) < best);
    }
}

static int speaks(const reader *r, const char *file, const char *text, size_t size)
{
    (void)r, (void)file, (void)text, (void)size;
    return READER_WORD;
}

/* Which of two kinds stands first in the list decides nothing. */
static void a_tie_is_an_error_that_names_both(arb *a)
{
    static const reader one = { .name = "one kind", .probe = speaks },
                        two = { .name = "another kind", .probe = speaks };
    const reader *const rows[] = { &reader_numbers, &one, &two }, *const turned[] = { &two, &one };

    (void)a;
    caught_lines = 0;
    CHECK(reader_of(&heard, rows, 2, "x", "", 0) == &one);
    CHECK(reader_of(&heard, rows, 3, "x", "", 0) == NULL && caught_lines == 1);
    CHECK(strstr(caught, "one kind") != NULL && strstr(caught, "another kind") != NULL);
    CHECK(reader_of(&heard, turned, 2, "x", "", 0) == NULL);
    CHECK(strstr(caught, "one kind") != NULL && strstr(caught, "another kind") != NULL);
    CHECK(reader_of(&heard, rows, 0, "x", "", 0) == NULL);
}

int main(void)
{
    PROPERTY(each_kind_takes_its_own_samples, 1);
    PROPERTY(a_tie_is_an_error_that_names_both, 1);
    return check_failures();
}
