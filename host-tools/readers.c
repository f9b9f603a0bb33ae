/* host-tools/readers.c -- the kinds of files that are read, and which one a file is
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/source.h"        /* source_open */
#include "gcode/gcode.h"        /* GCODE_ANY */
#include "gcode/gcode_draw.h"   /* reader_gcode */
#include "read/drawing_curves.h"    /* reader_loft */
#include "read/foreign.h"       /* foreign_readers */
#include "read/number_lines.h"        /* reader_numbers */
#include "read/reader.h"
#include "readers.h"
#include "svg/svg_file.h"       /* reader_svg */

static const reader *const readers[] = { &reader_svg, &reader_loft, &reader_gcode,
                                         &reader_numbers };
#define EXPECTED "a drawing is expected, SVG, G-code, CSV or .loft"
#define READERS  (sizeof readers / sizeof *readers)

/* The kind of a file of which the first part is there. NULL after one message: it is not read. */
static const reader *kind_of(host *h, const char *file, const char *text, size_t size,
                             const char *expected)
{
    const reader *rows[READERS + FOREIGN_KINDS];
    const host_place at = { file, 0 };

    memcpy(rows, readers, sizeof readers);
    for (size_t i = 0; i < FOREIGN_KINDS; i++)
        rows[READERS + i] = &foreign_readers[i];
    const reader *r = reader_of(h, rows, READERS + FOREIGN_KINDS, file, text, size);
    if (r == NULL)
        return NULL;
    if (r->read == NULL)
        (void)host_error(h, EX_DATAERR, "file.foreign", at, r->remedy, "is %s", r->name);
    else if (!(r->takes & READER_BYTES) && strlen(text) != size)
        (void)host_error(h, EX_DATAERR, "file.not-text", at, expected, "is not text");
    else
        return r;
    return NULL;
}


// Drawings
// --------

/* Refuse options that were given, and say nothing about a file of this kind. */
static bool other_options(host *h, const drawing *d, const char *file, unsigned takes)
{
    char line[24];
    const struct {
        unsigned of;
        const char *option, *value, *why;
    } given[] = {
        { READER_LAYERS, "layer", d->layers, "only SVG has layers" },
        { READER_LAYERS, "only", d->only, "only SVG has colours" },
        { READER_LAYERS, "text", d->text, "only SVG has text" },
        { READER_PROGRAM, "from-line", d->from_line > 0 ? line : NULL,
          "only G-code has lines that are run" },
        { READER_PROGRAM, "dialect", d->dialect != GCODE_ANY ? "" : NULL,
          "only G-code has dialects" },
    };

    snprintf(line, sizeof line, "%u", d->from_line);
    for (size_t i = 0; i < sizeof given / sizeof *given; i++)
        if (!(takes & given[i].of) && given[i].value != NULL)
            return host_error(h, EX_USAGE, "file.option-of-another-kind", (host_place){ file, 0 },
                              "leave it out", "--%s%s%s: %s", given[i].option,
                              given[i].value[0] ? " " : "", given[i].value, given[i].why) != 0;
    return false;
}

/* The source has given its first part. */
static int read_source(host *h, drawing *d, const char *file, source *s)
{
    const host_place at = { file, 0 };

    if (s->text[strspn(s->text, " \t\r\n")] == '\0' && strlen(s->text) == s->size)
        return host_error(h, EX_DATAERR, "file.empty", at, EXPECTED, "is empty");
    const reader *r = kind_of(h, file, s->text, s->size, EXPECTED);
    if (r == NULL)
        return EX_DATAERR;
    if (other_options(h, d, file, r->takes))
        return EX_USAGE;
    const int code = r->takes & READER_PARTS ? 0 : source_rest(s);
    if (code != 0)
        return code;
    if (s->stream != NULL && s->text[s->size - 1] != '\n')
        return host_error(h, EX_DATAERR, "file.line-too-long", (host_place){ file, 1 }, "split it",
                          "a line of more than 1 MB");
    if (!(r->takes & READER_BYTES) && strlen(s->text) != s->size)
        return host_error(h, EX_DATAERR, "file.not-text", at, EXPECTED, "is not text");
    return r->read(h, d, file, s);
}

int drawing_read(host *h, drawing *d, const char *file)
{
    const unsigned warnings = h->warnings;
    const bool kept = strcmp(file, "-") == 0;       /* it cannot be read again */
    source s;
    int code = kept ? source_whole(h, &s, file) : source_open(h, &s, file);

    if (code == 0)
        code = read_source(h, d, source_name(file), &s);
    source_close(&s);
    if (code == 0 && d->count + d->taken == 0)
        return host_error(h, EX_DATAERR, "drawing.empty", (host_place){ source_name(file), 0 },
                          NULL,
                          "nothing to draw: it holds no visible curve of 0.000001 mm or more");
    return host_code(h, warnings, code);
}


// Curves
// ------

static int curves_of_file(host *h, curves *all, const char *file)
{
    size_t size;
    int code;
    char *text = source_read(h, file, &size, &code);

    if (text == NULL)
        return code;
    const reader *r = kind_of(h, source_name(file), text, size,
                              "give control points, one per line");
    if (r == NULL) {
        code = EX_DATAERR;
    } else if (r->curves != NULL) {
        code = r->curves(h, all, source_name(file), text);
    } else {
        drawing d = { 0 };
        source s  = source_text(text, size);
        code      = r->read(h, &d, source_name(file), &s);
        if (code == 0)
            code = curves_of_drawing(h, all, &d, source_name(file));
        drawing_free(&d);
    }
    free(text);
    return code;
}

int curves_read(host *h, curves *all, const char *file, const char *text)
{
    const unsigned warnings = h->warnings;
    const char *name = text ? "--points" : source_name(file);
    const int code   = text ? curves_of_points(h, all, text) : curves_of_file(h, all, file);

    if (code == 0 && all->count == 0)
        return host_error(h, EX_DATAERR, "points.none", (host_place){ name, 0 },
                          "give control points, one per line", "no curve in it");
    return host_code(h, warnings, code);
}
