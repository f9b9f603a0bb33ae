/* host-tools/arrange/page.c -- scales, mirrors, turns, places and repeats a drawing
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/host.h"
#include "base/memory.h"
#include "base/source.h"    /* source_name */
#include "engine/curve.h"   /* curves_free */
#include "arrange/areas.h"     /* areas_apply */
#include "arrange/page.h"

#define PAGE_MAX 16000.0    /* mm */

// Options
// -------

/* "210x297", "21x29.7cm", "8.5x11in" */
static bool size_in_numbers(const char *text, double size[2])
{
    static const struct {
        const char *unit;
        double mm;
    } units[] = { { "", 1 }, { "mm", 1 }, { "cm", 10 }, { "in", 25.4 } };
    char *end;

    size[0] = strtod(text, &end);
    if (end == text || *end != 'x')
        return false;
    text    = end + 1;
    size[1] = strtod(text, &end);
    if (end == text)
        return false;
    end += *end == ' ';
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++)
        if (strcmp(end, units[i].unit) == 0) {
            size[0] *= units[i].mm;
            size[1] *= units[i].mm;
            return size[0] > 0 && size[1] > 0 && size[0] <= PAGE_MAX && size[1] <= PAGE_MAX;
        }
    return false;
}

static bool parse_size(const char *text, void *out)
{
    static const struct {
        const char *name;
        double size[2];
    } known[] = { { "A0", { 841, 1189 } },
                  { "A1", { 594, 841 } },
                  { "A2", { 420, 594 } },
                  { "A3", { 297, 420 } },
                  { "A4", { 210, 297 } },
                  { "A5", { 148, 210 } },
                  { "A6", { 105, 148 } },
                  { "Letter", { 8.5 * 25.4, 11 * 25.4 } },
                  { "Legal", { 8.5 * 25.4, 14 * 25.4 } },
                  { "Tabloid", { 11 * 25.4, 17 * 25.4 } } };
    double *size = out;

    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        const size_t length = strlen(known[i].name);
        const char *rest    = text + length;
        if (strncasecmp(text, known[i].name, length) != 0)
            continue;
        const bool lies = strcasecmp(rest, "-landscape") == 0;
        if (*rest != '\0' && !lies)
            return false;
        size[0] = known[i].size[lies];
        size[1] = known[i].size[!lies];
        return true;
    }
    return size_in_numbers(text, size);
}

static bool parse_turn(const char *text, void *out)
{
    page_options *g = out;
    char *end;

    g->upright = strcmp(text, "auto") == 0;
    if (g->upright)
        return true;
    g->degrees = strtod(text, &end);
    return end != text && *end == '\0' && fabs(g->degrees) <= 3600;
}

static bool parse_copies(const char *text, void *out)
{
    page_options *g = out;
    int length = 0;

    return sscanf(text, "%4ux%4u%n", &g->copies[0], &g->copies[1], &length) == 2 &&
           text[length] == '\0' && g->copies[0] >= 1 && g->copies[1] >= 1 && text[0] != '-';
}

const option page_rows[] = {
    OPTION_HEADING("what of a drawing"),
    { "layer", OPTION_TEXT(page_options, layers), .value = "NAME,..",
      .help = "of SVG: draw only these layers of Inkscape, by name or first number (all)" },
    { "only", OPTION_TEXT(page_options, only), .value = "COLOUR,..",
      .help = "of SVG: draw only these colours, of strokes or else of fills, as red,#00f (all)" },
    { "text", OPTION_TEXT(page_options, text), .value = "HOW",
      .help = "of SVG: outline, line or line:FONT: letters of single lines, as line:rowmans; none "
              "(outline)" },
    OPTION_HEADING("place on the page"),
    { "page", OPTION_PARSED(page_options, size), .value = "SIZE", .parse = parse_size,
      .remedy = "give A0 to A6, Letter, Legal or Tabloid, with -landscape or without, or "
                "WIDTHxHEIGHT in mm, cm or in",
      .help = "the page: A4, A4-landscape, Letter .., 210x297 mm, 8.5x11in (the file's)" },
    { "margin", OPTION_NUMBER(page_options, margin), .least = 0, .most = 8000, .unit = "mm",
      .standard = "0", .help = "of the page that --fit and --crop leave free" },
    { "scale", OPTION_LIST(page_options, scale), .least = 1e-6, .most = 1e6, .value = "F[,FY]",
      .counts = "1|2", .remedy = "give one, or one for x and one for y",
      .help = "times as large; FY: along y" },
    { "mirror", OPTION_TEXT(page_options, mirror), .choices = "x|y",
      .help = "x: left becomes right; y: top becomes bottom" },
    { "rotate", OPTION_IS_PARSED, 0, .value = "DEG", .unit = "deg", .parse = parse_turn,
      .remedy = "give degrees from -3600 to 3600, or auto",
      .help = "counterclockwise; auto: by 90 if the page has more room for it then" },
    { "fit", OPTION_FLAG(page_options, fit),
      .help = "as large as the page allows, and in its middle" },
    { "centre", OPTION_FLAG(page_options, centre), .help = "in the middle of the page" },
    { "at", OPTION_LIST(page_options, at), .least = -16000, .most = 16000, .value = "X,Y",
      .counts = "2", .help = "the lower left corner of what is drawn, mm from that of the page" },
    { "copies", OPTION_IS_PARSED, 0, .value = "NXxNY", .parse = parse_copies,
      .remedy = "give how many side by side and in how many rows, as 3x2",
      .help = "NX side by side, in NY rows" },
    { "gap", OPTION_NUMBER(page_options, gap), .least = 0, .most = 8000, .unit = "mm",
      .standard = "5", .help = "between copies" },
    { "crop", OPTION_FLAG(page_options, crop),
      .help = "draw only what is on the page, without its margin" },
    OPTION_HEADING("areas and strokes"),
    OPTION_GROUP(page_options, fill, fill_rows),
    { "stroke", OPTION_TEXT(page_options, stroke), .value = "HOW", .choices = "line|outline",
      .standard = "line",
      .help = "of SVG: line: along its middle, outline: around all that it covers" },
    OPTION_EXCLUDES("at", "fit|centre", "both say where the drawing lies"),
    { 0 }
};


// Moving
// ------

/* out = m in + to */
typedef struct {
    double m[2][2], to[2];
} affine;

static void apply_to_point(const affine *a, double p[2])
{
    const double x = p[0], y = p[1];

    for (int i = 0; i < 2; i++)
        p[i] = a->m[i][0] * x + a->m[i][1] * y + a->to[i];
}

/* Where a place counts from where the machine stands, only its distance from there changes. */
static void apply_affine(const affine *a, drawing *d)
{
    for (size_t i = 0; i < d->count; i++)
        for (int k = 0; k < 4; k++) {
            const unsigned char *loose = d->curve[i].loose;
            affine part                = *a;
            for (int j = 0; j < 2; j++)
                part.to[j] *= 1 - ((3 - k) * (loose[0] >> j & 1) + k * (loose[1] >> j & 1)) / 3.0;
            apply_to_point(&part, d->curve[i].p[k]);
        }
}

/* The box of what is drawn at known places. */
static bool known_box(const drawing *d, double box[2][2])
{
    bool some = false;

    for (size_t i = 0; i < d->count; i++) {
        const drawing one = { .curve = &d->curve[i], .count = 1 };
        double of[2][2];
        if (((d->curve[i].loose[0] | d->curve[i].loose[1]) & 3) != 0)
            continue;
        (void)drawing_box(&one, of);
        for (int k = 0; k < 2; k++) {
            box[0][k] = some ? fmin(box[0][k], of[0][k]) : of[0][k];
            box[1][k] = some ? fmax(box[1][k], of[1][k]) : of[1][k];
        }
        some = true;
    }
    return some || drawing_box(d, box);
}

/* Only x or only y counts from there: such a place cannot be turned. */
static int check_turn(host *h, const drawing *d, const char *file)
{
    for (size_t i = 0; i < d->count; i++)
        for (int k = 0; k < 2; k++)
            if ((d->curve[i].loose[k] & 1) != (d->curve[i].loose[k] >> 1 & 1))
                return host_error(
                    h, EX_DATAERR, "page.turn-one-axis", (host_place){ file, d->curve[i].line },
                    "let the program go to X and Y first",
                    "moves one axis from where the machine is, so it cannot be turned");
    return 0;
}

/* Cosine and sine; turns by multiples of 90 degrees are exact. */
static void turn_of(double degrees, double *cosine, double *sine)
{
    static const double quarter[4][2] = { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };
    const double turns = degrees / 90, within = turns - 4 * floor(turns / 4);

    if (within == floor(within)) {
        *cosine = quarter[(int)within % 4][0];
        *sine   = quarter[(int)within % 4][1];
    } else {
        *cosine = cos(degrees * (3.14159265358979323846 / 180));
        *sine   = sin(degrees * (3.14159265358979323846 / 180));
    }
}

/* Scale, mirror and turn about the origin. */
static affine form_of(const page_options *g, double degrees)
{
    const double sx = g->scale.count > 0 ? g->scale.value[0] : 1,
                 sy = g->scale.count > 1 ? g->scale.value[1] : sx;
    const double x = g->mirror && *g->mirror == 'x' ? -sx : sx,
                 y = g->mirror && *g->mirror == 'y' ? -sy : sy;
    double c, s;

    turn_of(degrees, &c, &s);
    return (affine){ { { c * x, -s * y }, { s * x, c * y } }, { 0, 0 } };
}

/* The box of a box after a form. */
static void form_box(const affine *a, const double box[2][2], double out[2][2])
{
    for (int k = 0; k < 4; k++) {
        double p[2] = { box[k & 1][0], box[k >> 1][1] };
        apply_to_point(a, p);
        for (int i = 0; i < 2; i++) {
            out[0][i] = k == 0 ? p[i] : fmin(out[0][i], p[i]);
            out[1][i] = k == 0 ? p[i] : fmax(out[1][i], p[i]);
        }
    }
}

/* The sheet is the page of the file, or the box of the drawing if it gives none. Its lower left
 * corner stays where it is. */
static void change_form(const page_options *g, drawing *d, double degrees)
{
    const bool paged   = d->width > 0 && d->height > 0;
    double sheet[2][2] = { { 0, 0 }, { d->width, d->height } }, after[2][2];
    affine a = form_of(g, degrees);

    if (!paged)
        (void)known_box(d, sheet);
    form_box(&a, (const double (*)[2])sheet, after);
    for (int i = 0; i < 2; i++)
        a.to[i] = sheet[0][i] - after[0][i];
    apply_affine(&a, d);
    if (paged) {
        d->width  = after[1][0] - after[0][0];
        d->height = after[1][1] - after[0][1];
    }
}


// Placing
// -------

static unsigned copies_of(const page_options *g, int axis)
{
    return g->copies[axis] ? g->copies[axis] : 1;
}

/* How much larger the copies of a box may be within `room`. */
static double fit_factor(const page_options *g, const double box[2][2], const double room[2])
{
    double factor = HUGE_VAL;

    for (int i = 0; i < 2; i++) {
        const double size = box[1][i] - box[0][i], n = copies_of(g, i);
        if (size > 0)
            factor = fmin(factor, (room[i] - (n - 1) * g->gap) / (n * size));
    }
    return factor;
}

/* Would it fit better after a quarter turn? */
static bool fits_turned(const page_options *g, const drawing *d, const double room[2])
{
    drawing copy = *d;
    double box[2][2], factor[2];

    copy.curve = memory_grow(NULL, d->count * sizeof *copy.curve);
    for (int turned = 0; turned < 2; turned++) {
        memcpy(copy.curve, d->curve, d->count * sizeof *copy.curve);
        change_form(g, &copy, 90.0 * turned);
        (void)known_box(&copy, box);
        factor[turned] = fit_factor(g, (const double (*)[2])box, room);
    }
    free(copy.curve);
    return factor[1] > factor[0];
}

static void place_box(const page_options *g, drawing *d, const double room[2])
{
    double box[2][2];
    affine a = { { { 1, 0 }, { 0, 1 } }, { 0, 0 } };

    (void)known_box(d, box);
    const double factor = g->fit ? fit_factor(g, (const double (*)[2])box, room) : 1;
    a.m[0][0] = a.m[1][1] = factor;
    for (int i = 0; i < 2; i++) {
        const double size = factor * (box[1][i] - box[0][i]), n = copies_of(g, i),
                     all  = n * size + (n - 1) * g->gap, low = factor * box[0][i];
        if (g->at.count == 2)
            a.to[i] = g->at.value[i] - low;
        else if (g->fit || g->centre)
            a.to[i] = g->margin + (room[i] - all) / 2 - low;
    }
    apply_affine(&a, d);
}

static int make_copies(host *h, const page_options *g, drawing *d, const char *file)
{
    const unsigned across = copies_of(g, 0), up = copies_of(g, 1);
    const size_t count = d->count;
    double box[2][2];

    if ((double)count * across * up > DRAWING_CURVES_MAX)
        return host_error(h, EX_DATAERR, "page.copies-too-many", (host_place){ file, 0 },
                          "give fewer copies", "--copies %ux%u: more than %u curves", across, up,
                          DRAWING_CURVES_MAX);
    (void)known_box(d, box);
    for (unsigned k = 1; k < across * up; k++)
        for (size_t i = 0; i < count; i++) {
            drawing_curve c = d->curve[i];
            for (int j = 0; j < 4; j++) {
                c.p[j][0] += k % across * (box[1][0] - box[0][0] + g->gap);
                c.p[j][1] += k / across * (box[1][1] - box[0][1] + g->gap);
            }
            drawing_add_like(d, &c, i == 0 || c.path != d->curve[i - 1].path);
        }
    return 0;
}


// All of it
// ---------

static bool changes_form(const page_options *g)
{
    return g->scale.count > 0 || g->mirror != NULL || g->degrees < 0 || g->degrees > 0 ||
           g->upright;
}

static bool is_asked(const page_options *g)
{
    return changes_form(g) || g->size[0] > 0 || g->at.count > 0 || g->fit || g->centre || g->crop ||
           g->copies[0] > 0;
}

/* The part of the page within its margin. */
static int find_room(host *h, const page_options *g, const double size[2], const char *file,
                     double room[2])
{
    for (int i = 0; i < 2; i++) {
        room[i] = size[i] - 2 * g->margin;
        if (!(size[i] > 0))
            return host_error(h, EX_USAGE, "page.unknown", (host_place){ file, 0 },
                              "say which, as --page A4 or --page 210x297", "gives no page");
        if (!(room[i] > 0))
            return host_error(h, EX_USAGE, "page.margin-too-wide", (host_place){ NULL, 0 },
                              "give less", "--margin %g: leaves nothing of a page of %g x %g mm",
                              g->margin, size[0], size[1]);
        if (!(room[i] - (copies_of(g, i) - 1) * g->gap > 0))
            return host_error(h, EX_USAGE, "page.gap-too-wide", (host_place){ NULL, 0 },
                              "give less --gap",
                              "--copies: the gaps of %g mm fill the page of %g x %g mm", g->gap,
                              size[0], size[1]);
    }
    return 0;
}

static int check_reach(host *h, const drawing *d, const char *file)
{
    for (size_t i = 0; i < d->count; i++)
        for (int k = 0; k < 8; k++) {
            const double x = d->curve[i].p[k / 2][k % 2];
            if (!(fabs(x) <= DRAWING_LIMIT))
                return host_error(h, EX_DATAERR, "page.out-of-reach",
                                  (host_place){ file, d->curve[i].line }, "scale it less",
                                  "lies at %g mm now, beyond +-%g mm", x, DRAWING_LIMIT);
        }
    return 0;
}

static int crop_to_page(host *h, const page_options *g, drawing *d, const double size[2],
                        const char *file)
{
    const double box[2][2] = { { g->margin, g->margin },
                               { size[0] - g->margin, size[1] - g->margin } };
    drawing cut = { .width = d->width, .height = d->height };
    const int code = page_crop(h, &cut, d, box, file);

    drawing_free(d);
    *d = cut;
    if (code == 0 && cut.count == 0)
        return host_error(h, EX_DATAERR, "page.crop-empty", (host_place){ file, 0 },
                          "move it there, as with --centre",
                          "--crop: nothing of it is on the page of %g x %g mm", size[0], size[1]);
    return code;
}

static int place(host *h, const page_options *g, drawing *d, const char *file)
{
    const char *name = source_name(file);
    double room[2] = { 0, 0 }, size[2] = { g->size[0], g->size[1] };
    int code = 0;

    if (!is_asked(g))
        return 0;
    if (d->of != NULL)          /* what follows changes cubics, not what they were made of */
        curves_free(d->of);
    free(d->of);
    d->of = NULL;
    if (d->program && (g->crop || g->copies[0] > 0))
        return host_error(h, EX_USAGE, "page.program", (host_place){ name, 0 },
                          g->crop
                              ? "--crop needs a drawing, which lifts the pen between its parts"
                              : "--copies needs a drawing, which lifts the pen between its parts",
                          "is a program, which says every motion");
    const bool own = !(size[0] > 0), needed = g->fit || g->centre || g->crop || g->upright;
    if (own) {
        size[0] = d->width;
        size[1] = d->height;
    }
    if (needed)
        code = find_room(h, g, size, name, room);
    if (code == 0 && (g->upright || g->degrees < 0 || g->degrees > 0))
        code = check_turn(h, d, name);
    if (code == 0 && changes_form(g))
        change_form(g, d, g->upright ? 90.0 * fits_turned(g, d, room) : g->degrees);
    if (own && !g->upright) {   /* the page of the file has changed with the drawing */
        size[0] = d->width;
        size[1] = d->height;
    }
    if (code == 0 && needed)
        code = find_room(h, g, size, name, room);
    if (code == 0 && (g->fit || g->centre || g->at.count == 2))
        place_box(g, d, room);
    if (code == 0)
        code = make_copies(h, g, d, name);
    d->width  = size[0];
    d->height = size[1];
    if (code == 0)
        code = check_reach(h, d, name);
    return code;
}

static bool is_wide(const page_options *g)
{
    return g->stroke != NULL && strcmp(g->stroke, "outline") == 0;
}

bool page_is_asked(const page_options *g)
{
    return is_asked(g) || g->fill.distance > 0 || is_wide(g);
}

int page_apply(host *h, const page_options *g, drawing *d, const char *file)
{
    const bool wide = is_wide(g);
    int code        = areas_apply(h, wide, g->fill.distance > 0, d, file);
    if (code == 0)
        code = place(h, g, d, file);
    if (code == 0)
        code = fill_apply(h, &g->fill, d, file);
    const double size[2] = { d->width, d->height };
    return code == 0 && g->crop ? crop_to_page(h, g, d, size, source_name(file)) : code;
}

/* How far a box is beyond the page, mm. */
static double beyond_page(const double box[2][2], const double size[2])
{
    double most = 0;

    for (int i = 0; i < 2; i++)
        most = fmax(most, fmax(-box[0][i], box[1][i] - size[i]));
    return most;
}

const char *page_words(const drawing *d, char text[160])
{
    const double size[2] = { d->width, d->height };
    double box[2][2];

    text[0] = '\0';
    if (!known_box(d, box))
        return text;
    int used = snprintf(text, 160, "%.3f x %.3f mm at %.3f,%.3f", box[1][0] - box[0][0],
                        box[1][1] - box[0][1], box[0][0], box[0][1]);
    if (size[0] > 0 && size[1] > 0) {
        const double beyond = beyond_page((const double (*)[2])box, size);
        used += snprintf(text + used, (size_t)(160 - used), " on a page of %g x %g mm", size[0],
                         size[1]);
        if (beyond > 0.0005)
            snprintf(text + used, (size_t)(160 - used), ", %.3f mm beyond it", beyond);
    }
    return text;
}
