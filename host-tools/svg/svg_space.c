/* host-tools/svg/svg_space.c -- transforms, lengths with units, viewBox and preserveAspectRatio
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>
#include <strings.h>

#include "base/scan.h"       /* scan_number, scan_comma, scan_word */
#include "svg/svg.h"

#define DEGREE 0.017453292519943295769

const svg_matrix svg_identity = { 1, 0, 0, 1, 0, 0 };

svg_matrix svg_multiply(svg_matrix m, svg_matrix n)
{
    return (svg_matrix){ m.a * n.a + m.c * n.b,       m.b * n.a + m.d * n.b,
                         m.a * n.c + m.c * n.d,       m.b * n.c + m.d * n.d,
                         m.a * n.e + m.c * n.f + m.e, m.b * n.e + m.d * n.f + m.f };
}

/* The larger singular value: (|u| + |v|) / 2, where u and v are the rotating and the mirroring
 * parts. */
double svg_stretch(svg_matrix m)
{
    return (hypot(m.a + m.d, m.b - m.c) + hypot(m.a - m.d, m.b + m.c)) / 2;
}


// Transforms
// ----------

static svg_matrix rotation_of(double degrees)
{
    /* quarter turns are exact: drawings are full of them */
    const double quarters = degrees / 90;
    if (isfinite(quarters) && quarters == floor(quarters)) {
        static const double sine[4] = { 0, 1, 0, -1 };
        const int q = (int)(quarters - 4 * floor(quarters / 4));
        return (svg_matrix){ sine[(q + 1) % 4], sine[q], -sine[q], sine[(q + 1) % 4], 0, 0 };
    }
    const double c = cos(degrees * DEGREE), s = sin(degrees * DEGREE);
    return (svg_matrix){ c, s, -s, c, 0, 0 };
}

/* The matrix of one function. Returns false if no function has that name and number of
 * arguments. */
static bool transform_of(const char *name, int length, bool css, const double v[6], int count,
                         svg_matrix *out)
{
    static const char *const names[] = { "matrix",     "translate",  "scale",  "rotate",
                                         "skewX",      "skewY",      "skew",   "translateX",
                                         "translateY", "scaleX",     "scaleY", "rotateZ" };
    const int known                  = css ? 12 : 6;
    int which                        = 0;

    while (which < known && !(strlen(names[which]) == (size_t)length &&
                              strncasecmp(names[which], name, (size_t)length) == 0))
        which++;
    switch (which < known ? 10 * which + count : -1) {
    case  6: *out = (svg_matrix){ v[0], v[1], v[2], v[3], v[4], v[5] };       return true;
    case 11: *out = (svg_matrix){ 1, 0, 0, 1, v[0], 0 };                      return true;
    case 12: *out = (svg_matrix){ 1, 0, 0, 1, v[0], v[1] };                   return true;
    case 21: *out = (svg_matrix){ v[0], 0, 0, v[0], 0, 0 };                   return true;
    case 22: *out = (svg_matrix){ v[0], 0, 0, v[1], 0, 0 };                   return true;
    case 31: *out = rotation_of(v[0]);                                             return true;
    case 33:
        *out = svg_multiply(svg_multiply((svg_matrix){ 1, 0, 0, 1, v[1], v[2] }, rotation_of(v[0])),
                            (svg_matrix){ 1, 0, 0, 1, -v[1], -v[2] });
        return true;
    case 41: *out = (svg_matrix){ 1, 0, tan(v[0] * DEGREE), 1, 0, 0 };        return true;
    case 51: *out = (svg_matrix){ 1, tan(v[0] * DEGREE), 0, 1, 0, 0 };        return true;
    case 61: *out = (svg_matrix){ 1, 0, tan(v[0] * DEGREE), 1, 0, 0 };        return true;
    case 62: *out = (svg_matrix){ 1, tan(v[1] * DEGREE), tan(v[0] * DEGREE), 1, 0, 0 }; return true;
    case 71: *out = (svg_matrix){ 1, 0, 0, 1, v[0], 0 };                      return true;
    case 81: *out = (svg_matrix){ 1, 0, 0, 1, 0, v[0] };                      return true;
    case 91: *out = (svg_matrix){ v[0], 0, 0, 1, 0, 0 };                      return true;
    case 101: *out = (svg_matrix){ 1, 0, 0, v[0], 0, 0 };                     return true;
    case 111: *out = rotation_of(v[0]);                                            return true;
    default: return false;
    }
}

/* What a unit of CSS makes of a number: px or degrees. */
static double css_unit(const char **at)
{
    static const struct {
        const char *name;
        double by;
    } known[] = { { "px", 1 },         { "mm", 96 / 25.4 },         { "cm", 96 / 2.54 },
                  { "in", 96 },        { "pt", 96 / 72.0 },         { "pc", 16 },
                  { "deg", 1 },        { "rad", 1 / DEGREE },       { "grad", 0.9 },
                  { "turn", 360 } };

    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
        if (strncasecmp(*at, known[i].name, strlen(known[i].name)) == 0) {
            *at += strlen(known[i].name);
            return known[i].by;
        }
    return 1;
}

/* Read the numbers between parentheses. Returns how many, or -1 for anything else. */
static int read_arguments(const char **at, bool css, double v[6])
{
    int count = 0;

    if (**at != '(')
        return -1;
    ++*at;
    for (scan_space(at); **at != ')'; count++) {
        if (count == 6 || (count > 0 && scan_comma(at) && **at == ')') ||
            !scan_number(at, &v[count]))
            return -1;
        v[count] *= css ? css_unit(at) : 1;
        scan_space(at);
    }
    ++*at;
    return count;
}

static bool is_finite(svg_matrix m)
{
    return isfinite(m.a) && isfinite(m.b) && isfinite(m.c) && isfinite(m.d) && isfinite(m.e) &&
           isfinite(m.f);
}

void svg_transform(const svg_reader *r, const char *text, bool css, svg_matrix *m)
{
    const svg_matrix before = *m;
    const char *at          = text;

    scan_space(&at);
    if (strcmp(at, "none") == 0)
        return;
    while (*at != '\0') {
        const char *name = at;
        const int length = scan_word(at);
        double v[6];
        svg_matrix one;

        at += length;
        scan_space(&at);
        if (length == 0 || !transform_of(name, length, css, v, read_arguments(&at, css, v), &one)) {
            svg_warn(r, SVG_WARN_TRANSFORM,
                     "transform: \"%.40s\" is not one of matrix(6 numbers) translate(1 or 2) "
                     "scale(1 or 2) rotate(1 or 3) skewX(1) skewY(1): nothing is transformed",
                     name);
            *m = before;
            return;
        }
        *m = svg_multiply(*m, one);
        if (!is_finite(*m)) {
            svg_warn(r, SVG_WARN_TRANSFORM,
                     "transform: \"%.40s\" is too large to compute with, what it transforms is "
                     "not drawn: give smaller numbers",
                     name);
            *m = (svg_matrix){ 0, 0, 0, 0, 0, 0 };
            return;
        }
        scan_comma(&at);
    }
}


// Lengths
// -------

static const struct {
    const char *name;
    double px;
} units[] = { { "", 1 },    { "px", 1 },         { "mm", 96 / 25.4 }, { "cm", 96 / 2.54 },
              { "in", 96 }, { "pt", 96 / 72.0 }, { "pc", 16 },        { "q", 96 / 101.6 } };

/* The unit of a length in user units; 0: unknown. Those of fonts follow the font. */
static double unit_of(const svg_space *space, const char *name, size_t length)
{
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++)
        if (strncasecmp(units[i].name, name, length) == 0 && units[i].name[length] == '\0')
            return units[i].px;
    return length == 2 && strncasecmp(name, "em", 2) == 0   ? space->font.size
           : length == 2 && strncasecmp(name, "ex", 2) == 0 ? space->font.size / 2
           : length == 3 && strncasecmp(name, "rem", 3) == 0 ? space->rem
                                                             : 0;
}

bool svg_css_length(const svg_space *space, const char *text, double hundred, double *out)
{
    const char *at = text;
    double x;

    scan_space(&at);
    if (!scan_number(&at, &x))
        return false;
    const size_t length = strcspn(at, " \t\r\n\f");
    const char *after = at + length;
    const double unit   = *at == '%' && length == 1 ? hundred / 100 : unit_of(space, at, length);
    scan_space(&after);
    if (unit == 0 || *after != '\0' || !isfinite(x * unit))
        return false;
    *out = x * unit;
    return true;
}

/* Without the size of the page, the shape is not known. */
static double percent_of_viewport(const svg_reader *r, const svg_space *space, const char *name,
                                  enum svg_side side, double value)
{
    if (space->width <= 0 || space->height <= 0) {
        svg_lose(r, SVG_WARN_SIZE,
                 "%s: %g%% of a page whose size is not known, such shapes are not drawn: give "
                 "<svg> a viewBox, or width and height",
                 name, value);
        return 0;
    }
    switch (side) {
    case SVG_ACROSS:  return value / 100 * space->width;
    case SVG_ALONG_Y: return value / 100 * space->height;
    default:          return value / 100 * (hypot(space->width, space->height) / sqrt(2));
    }
}

/* One length at *at, on to what follows it. `text` is the whole value, for messages. */
static bool one_length(const svg_reader *r, const svg_space *space, const char *name,
                       const char *text, enum svg_side side, const char **at, double *out)
{
    bool good        = scan_number(at, out), percent = false;
    double unit      = 0;

    if (good) {
        const size_t length = strcspn(*at, ", \t\r\n\f");
        unit    = unit_of(space, *at, length);
        percent = length == 1 && **at == '%';
        *at += length;
        scan_space(at);
    }
    if (good && unit > 0)
        *out *= unit;
    else if (good && percent)
        *out = percent_of_viewport(r, space, name, side, *out);
    else
        good = false;
    if (!good)
        svg_warn(r, SVG_WARN_LENGTH,
                 "%s=\"%.40s\" is not used: give a number with px mm cm in pt pc Q or %%", name,
                 text);
    else if (!isfinite(*out))
        svg_warn(r, SVG_WARN_LENGTH,
                 "%s=\"%.40s\" is not used, it is too large to compute with: give a smaller number",
                 name, text);
    return good && isfinite(*out);
}

double svg_length(const svg_reader *r, const svg_space *space, const char *name, enum svg_side side,
                  double absent)
{
    char *text     = svg_attribute(r->node, name);
    const char *at = text;
    double out     = absent;

    if (text == NULL)
        return absent;
    scan_space(&at);
    bool good = *at != '\0' && strcmp(at, "auto") != 0 &&
                one_length(r, space, name, text, side, &at, &out);
    if (good && *at != '\0') {
        svg_warn(r, SVG_WARN_LENGTH, "%s=\"%.40s\" is not used: give one length", name, text);
        good = false;
    }
    xmlFree(text);
    return good ? out : absent;
}

double svg_size(const svg_reader *r, const svg_space *space, const char *name, enum svg_side side,
                double absent)
{
    const double out = svg_length(r, space, name, side, absent);

    if (out >= 0 || out == absent)
        return out;
    svg_warn(r, SVG_WARN_LENGTH, "%s=%g is not used: a size cannot be negative", name, out);
    return absent;
}

size_t svg_lengths(const svg_reader *r, const svg_space *space, const char *name,
                   enum svg_side side, double out[], size_t room)
{
    char *text     = svg_attribute(r->node, name);
    const char *at = text;
    size_t count   = 0;
    bool good      = true;

    if (text != NULL)
        scan_space(&at);
    while (good && text != NULL && *at != '\0' && count < room) {
        good = one_length(r, space, name, text, side, &at, &out[count]);
        count += good;
        scan_comma(&at);
    }
    xmlFree(text);
    return good ? count : 0;
}

/* One side of an origin: a length, or a word for a part of the viewport, which also says the side.
 */
static bool one_origin(const svg_reader *r, const svg_space *space, const char *text,
                       const char **at, enum svg_side *side, double *out)
{
    static const struct {
        const char *name;
        double part;
        int side;           /* -1: of either */
    } words[] = { { "left", 0, SVG_ACROSS },
                  { "right", 100, SVG_ACROSS },
                  { "center", 50, -1 },
                  { "top", 0, SVG_ALONG_Y },
                  { "bottom", 100, SVG_ALONG_Y } };
    const char *name = "transform-origin";
    const int length = scan_word(*at);

    for (size_t k = 0; length > 0 && k < sizeof words / sizeof words[0]; k++)
        if (strlen(words[k].name) == (size_t)length &&
            strncasecmp(words[k].name, *at, (size_t)length) == 0) {
            *at += length;
            scan_space(at);
            *side = words[k].side < 0 ? *side : (enum svg_side)words[k].side;
            *out  = percent_of_viewport(r, space, name, *side, words[k].part);
            return true;
        }
    return one_length(r, space, name, text, *side, at, out);
}

void svg_origin(const svg_reader *r, const svg_space *space, const char *text, double out[2])
{
    const char *at = text;
    enum svg_side first = SVG_ACROSS, second = SVG_ALONG_Y;
    double one, other = 50;

    scan_space(&at);
    if (!one_origin(r, space, text, &at, &first, &one))
        return;
    second = first == SVG_ALONG_Y ? SVG_ACROSS : SVG_ALONG_Y;
    const enum svg_side asked = second;
    if (*at == '\0')
        other = percent_of_viewport(r, space, "transform-origin", second, other);
    else if (!one_origin(r, space, text, &at, &second, &other))
        return;
    if (second != asked && first == second)     /* "center left": the word for a side leads */
        first = second == SVG_ACROSS ? SVG_ALONG_Y : SVG_ACROSS;
    out[first == SVG_ACROSS ? 0 : 1] = one;
    out[second == SVG_ACROSS ? 0 : 1] = other;
}


// Viewports
// ---------

bool svg_view_box(const svg_reader *r, double box[4])
{
    char *text     = svg_attribute(r->node, "viewBox");
    const char *at = text;
    int count      = 0;

    if (text == NULL)
        return false;
    scan_space(&at);
    const bool none = strcmp(at, "none") == 0;
    while (count < 4 && scan_number(&at, &box[count])) {
        count++;
        scan_comma(&at);
    }
    bool good = count == 4 && *at == '\0' && box[2] >= 0 && box[3] >= 0;
    for (int i = 0; i < 4 && good; i++)
        good = isfinite(box[i]);
    if (!good && !none)
        svg_warn(r, SVG_WARN_VIEW,
                 "viewBox=\"%.60s\" is not used: give four numbers: x y width height, none of the "
                 "sizes negative",
                 text);
    xmlFree(text);
    return good;
}

/* 0, 1/2, 1 for Min, Mid, Max at `text`; -1 for anything else. */
static double read_alignment(const char *text)
{
    return strncmp(text, "Min", 3) == 0   ? 0
           : strncmp(text, "Mid", 3) == 0 ? 0.5
           : strncmp(text, "Max", 3) == 0 ? 1
                                          : -1;
}

static void read_aspect(const svg_reader *r, bool *stretch, bool *slice, double align[2])
{
    char *text = svg_attribute(r->node, "preserveAspectRatio");
    const char *at = text;
    bool good = true;

    *stretch = *slice = false;
    align[0] = align[1] = 0.5;
    if (text == NULL)
        return;
    scan_space(&at);
    if (strncmp(at, "none", 4) == 0) {
        *stretch = true;
        at += 4;
    } else if (*at == 'x' && strlen(at) >= 8 && at[4] == 'Y') {
        align[0] = read_alignment(at + 1);
        align[1] = read_alignment(at + 5);
        at += 8;
        good = align[0] >= 0 && align[1] >= 0;
    } else {
        good = *at == '\0';
    }
    const char *behind = at;
    scan_space(&at);
    *slice = strncmp(at, "slice", 5) == 0;
    at += *slice ? 5 : strncmp(at, "meet", 4) == 0 ? 4 : 0;
    good = good && (at == behind || *behind == '\0' || strchr(" \t\r\n\f", *behind) != NULL);
    scan_space(&at);
    if (!good || *at != '\0') {
        svg_warn(r, SVG_WARN_VIEW,
                 "preserveAspectRatio=\"%.40s\" is not used: give none or xMidYMid and the like, "
                 "with meet or slice",
                 text);
        *stretch = *slice = false;
        align[0] = align[1] = 0.5;
    }
    xmlFree(text);
}

svg_matrix svg_fit(const svg_reader *r, const double box[4], double width, double height)
{
    double sx = width / box[2], sy = height / box[3], align[2];
    bool stretch, slice;

    read_aspect(r, &stretch, &slice, align);
    if (!stretch)
        sx = sy = slice ? fmax(sx, sy) : fmin(sx, sy);
    svg_matrix out = { sx,
                       0,
                       0,
                       sy,
                       (width  - sx * box[2]) * align[0] - sx * box[0],
                       (height - sy * box[3]) * align[1] - sy * box[1] };
    if (stretch) {
        out.e = -sx * box[0];
        out.f = -sy * box[1];
    }
    if (is_finite(out))
        return out;
    svg_warn(r, SVG_WARN_VIEW,
             "a viewBox of %g x %g is too small to fill %g x %g px: nothing of it is drawn", box[2],
             box[3], width, height);
    return (svg_matrix){ 0, 0, 0, 0, 0, 0 };
}
