/* tests/tools/test_export.c -- round trips: a drawing, written in each form and read again, is the
 * same within the error that the form states
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "draw/export.h"
#include "plan/toolpath.h"
#include "send/gcode_write.h"
#include "tools/drawn.h"
#include "svg/svg_file.h"
#include "gcode/gcode.h"
#include "gcode/gcode_draw.h"
#include "read/csv.h"
#include "read/drawing_curves.h"

#define DIGITS 0.0002       /* mm: four decimals of ends and centres */

static double random_unit(arb *a)      { return (double)(arb_next(a) >> 11) / 9007199254740992.0; }

/* Paths of lines, of gentle and of wild curves, flat or in space. */
static void make_drawing(drawing *d, arb *a, bool space)
{
    double p[4][3] = { { 0 } };

    *d = (drawing){ .width = 100, .height = 80 };
    for (int n = 0; n < 12; n++) {
        const bool fresh = n == 0 || arb_below(a, 4) == 0;
        const int kind   = (int)arb_below(a, 3);
        for (int i = 0; i < 3; i++) {
            const double size = i == 2 ? (space ? 5 : 0) : 60;
            p[0][i] = fresh ? size * random_unit(a) : p[3][i];
            p[3][i] = p[0][i] + size / 3 * (random_unit(a) - 0.5);
            for (int k = 1; k < 3; k++)
                p[k][i] = p[0][i] + k * (p[3][i] - p[0][i]) / 3 +
                          (kind == 0 ? 0 : size / (kind == 1 ? 30 : 3)) * (random_unit(a) - 0.5);
        }
        CHECK(drawing_join_space(&heard, d, "d", 1, p, 0) == 0);
    }
}

static void space_of(const drawing_curve *c, double t, double out[3])
{
    const double s = 1 - t;

    drawing_eval(c, t, out);
    out[2] = s * s * s * c->z[0] + 3 * s * s * t * c->z[1] + 3 * s * t * t * c->z[2] +
             t * t * t * c->z[3];
}

static double to_segment(const double p[3], const double a[3], const double b[3])
{
    double dot = 0, square = 0, sum = 0;

    for (int i = 0; i < 3; i++) {
        dot    += (p[i] - a[i]) * (b[i] - a[i]);
        square += (b[i] - a[i]) * (b[i] - a[i]);
    }
    const double u = square > 0 ? fmin(fmax(dot / square, 0), 1) : 0;
    for (int i = 0; i < 3; i++)
        sum += pow(p[i] - a[i] - u * (b[i] - a[i]), 2);
    return sqrt(sum);
}

#define FINE 400            /* chords of a curve; so short that their own error is below 1e-4 */

/* The largest distance of places of `d` from the drawn curves of `from`. */
static double farthest(const drawing *d, const drawing *from)
{
    double worst = 0;

    for (size_t i = 0; i < d->count; i++)
        for (int k = 0; k <= 12 && !(d->curve[i].feed < 0); k++) {
            double p[3], a[3], b[3], least = HUGE_VAL;
            space_of(&d->curve[i], k / 12.0, p);
            for (size_t j = 0; j < from->count; j++) {
                if (from->curve[j].feed < 0)
                    continue;
                space_of(&from->curve[j], 0, a);
                for (int n = 1; n <= FINE; n++) {
                    space_of(&from->curve[j], (double)n / FINE, b);
                    least = fmin(least, to_segment(p, a, b));
                    memcpy(a, b, sizeof a);
                }
            }
            worst = fmax(worst, least);
        }
    return worst;
}

/* Write as G-code and read it again. */
static void through_gcode(drawing *out, const drawing *d, const gcode_options *how, size_t *arcs)
{
    const toolpath_options o = { .feed = 10, .travel = 50, .rapid = 1000, .lift = 1 };
    char *text = tool_grow(NULL, 4000000);
    toolpath path;
    gcode g;

    toolpath_make(&path, d, &o);
    gcode_make(&g, &path, how);
    text[0] = '\0';
    for (size_t i = 0, used = 0; i < g.count; i++) {
        *arcs += i > 0 && strchr("235", gcode_text(&g, i)[1]) != NULL;
        used += (size_t)sprintf(text + used, "%s\n", gcode_text(&g, i));
    }
    *out = (drawing){ 0 };
    CHECK(drawing_read_gcode(&heard, out, "part.nc", text, strlen(text)) == 0);
    gcode_free(&g);
    toolpath_free(&path);
    free(text);
}

static void gcode_comes_back(arb *a)
{
    gcode_options how = { .tol = 0.001 + 0.01 * random_unit(a),
                          .curves = (enum gcode_curves)arb_below(a, 3),
                          .rapids = true };
    const bool space  = arb_below(a, 2);
    drawing d, back;
    size_t arcs = 0;

    make_drawing(&d, a, space);
    through_gcode(&back, &d, &how, &arcs);
    CHECK((arcs > 0) == (how.curves != GCODE_CHORDS));
    CHECK(back.program && back.curve[1].feed < 0);
    const double off = farthest(&d, &back), left = farthest(&back, &d);
    if (off > how.tol + DIGITS || left > how.tol + DIGITS) {
        printf("curves %d, tol %g: %g missed, %g left\n", (int)how.curves, how.tol, off, left);
        check_bad = true;
    }
    drawing_free(&back);
    drawing_free(&d);
}

/* A helix is few arcs. */
static void helices_stay_helices(arb *a)
{
    const gcode_options how = { .tol = 0.002, .rapids = true };
    drawing d, back;
    size_t arcs = 0;

    (void)a;
    d = (drawing){ 0 };
    CHECK(drawing_read_gcode(&heard, &d, "h.nc", "G0 X20\nG3 I-20 Z6 P3 F600\n", 27) == 0);
    through_gcode(&back, &d, &how, &arcs);
    CHECK(arcs > 2 && arcs <= 2 * d.count);
    CHECK_NEAR(fmax(farthest(&d, &back), farthest(&back, &d)), 0, how.tol + DIGITS);
    drawing_free(&back);
    drawing_free(&d);
}

static char *write_form(export_form *form, const drawing *d, int want)
{
    const export_options o = { .host = &heard, .d = d, .name = "d", .tol = 0.01 };
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);

    CHECK(out != NULL && form(&o, out) == want);
    fclose(out);
    return text;
}

static bool same_curves(const drawing *a, const drawing *b)
{
    if (a->count != b->count)
        return false;
    for (size_t i = 0; i < a->count; i++)
        for (int k = 0; k < 4; k++)
            if (fabs(a->curve[i].p[k][0] - b->curve[i].p[k][0]) > 2e-6 ||
                fabs(a->curve[i].p[k][1] - b->curve[i].p[k][1]) > 2e-6 ||
                fabs(a->curve[i].z[k] - b->curve[i].z[k]) > 2e-6 ||
                a->curve[i].path != b->curve[i].path)
                return false;
    return true;
}

/* Layers keep their names, whatever these are, and what is in no layer stays there. */
static void layers_come_back(arb *a)
{
    static const char text[] =
        "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' viewBox='0 0 100 100'"
        " xmlns:i='http://www.inkscape.org/namespaces/inkscape'>"
        "<path d='M1 1h1'/><g i:groupmode='layer' i:label='1 &quot;a&lt;b&gt;&amp;&#228;&quot;'>"
        "<path d='M2 2h1'/><g i:groupmode='layer' i:label='inner'><path d='M3 3h1'/></g>"
        "<path d='M4 4h1'/></g><path d='M5 5h1'/></svg>";
    static const unsigned numbers[2][5] = { { 0, 1, 2, 1, 0 }, { 0, 1, 2, 3, 0 } };
    drawing_names names = { 0 }, again = { 0 };
    drawing d = { .named = &names }, back = { .named = &again };
    char *out;

    (void)a;
    CHECK(drawing_read_svg(&heard, &d, "d.svg", text, strlen(text)) == 0 && d.count == 5);
    CHECK(names.count == 2 && strcmp(names.name[0], "1 \"a<b>&\xc3\xa4\"") == 0);
    const export_options o = { .host = &heard, .d = &d, .name = "d", .layers = &names };
    size_t size;
    FILE *f = open_memstream(&out, &size);
    CHECK(f != NULL && export_svg(&o, f) == 0);
    fclose(f);
    CHECK(drawing_read_svg(&heard, &back, "e.svg", out, size) == 0 && same_curves(&d, &back));
    CHECK(again.count == 3 && strcmp(again.name[0], names.name[0]) == 0 &&
          strcmp(again.name[1], "inner") == 0 && strcmp(again.name[2], names.name[0]) == 0);
    for (int i = 0; i < 5; i++)
        CHECK(d.curve[i].layer == numbers[0][i] && back.curve[i].layer == numbers[1][i]);
    free(out);
    drawing_free(&back);
    drawing_free(&d);
    drawing_names_free(&names);
    drawing_names_free(&again);
}

static void curves_come_back(arb *a)
{
    drawing d, back = { 0 };
    char *text;

    make_drawing(&d, a, false);
    text = write_form(export_svg, &d, 0);
    CHECK(drawing_read_svg(&heard, &back, "d.svg", text, strlen(text)) == 0 &&
          same_curves(&d, &back) && fabs(back.width - 100) < 1e-9);
    free(text);
    drawing_free(&back);
    text = write_form(export_csv, &d, 0);
    CHECK(drawing_read_csv(&heard, &back, "d.csv", text, strlen(text)) == 0 &&
          same_curves(&d, &back));
    free(text);
    drawing_free(&back);
    drawing_free(&d);
    make_drawing(&d, a, true);
    text = write_form(export_loft, &d, 0);
    CHECK(drawing_read_curves(&heard, &back, "d.loft", text) == 0 && same_curves(&d, &back));
    free(text);
    drawing_free(&back);
    caught[0] = '\0';
    free(write_form(export_csv, &d, EX_DATAERR));
    CHECK(strstr(caught, "d: has heights") != NULL);
    drawing_free(&d);
}

/* HP-GL: as lines, of its own chords. */
static void read_hpgl(drawing *d, const char *text)
{
    double p[4][3] = { { 0 } }, at[2] = { 0 };
    bool down = false;

    *d = (drawing){ 0 };
    while (*text != '\0') {
        int x, y, used = 0;
        if (strncmp(text, "PU", 2) == 0 || strncmp(text, "PD", 2) == 0)
            down = *++text == 'D';
        if (sscanf(++text, "%d,%d%n", &x, &y, &used) < 2 || used == 0)
            continue;
        for (int i = 0; i < 2; i++)
            for (int k = 0; k < 4; k++)
                p[k][i] = at[i] + k * ((i ? y : x) / 40.0 - at[i]) / 3;
        at[0] = x / 40.0;
        at[1] = y / 40.0;
        if (down)
            (void)drawing_join_space(&heard, d, "d", 1, p, 0);
        text += used;
    }
}

static void hpgl_comes_back(arb *a)
{
    drawing d, back;

    make_drawing(&d, a, false);
    char *text = write_form(export_hpgl, &d, 0);
    CHECK(strncmp(text, "IN;SP1;\nPU", 10) == 0 && strstr(text, ";\nPU0,0;SP0;\n") != NULL);
    read_hpgl(&back, text);
    CHECK(back.count > d.count);
    CHECK_NEAR(farthest(&d, &back), 0, 0.01 + 0.018 + 1e-4);
    CHECK_NEAR(farthest(&back, &d), 0, 0.01 + 0.018 + 1e-4);
    free(text);
    drawing_free(&back);
    drawing_free(&d);
}

int main(void)
{
    PROPERTY(gcode_comes_back, 12);
    PROPERTY(helices_stay_helices, 1);
    PROPERTY(layers_come_back, 1);
    PROPERTY(curves_come_back, 50);
    PROPERTY(hpgl_comes_back, 3);
    return check_failures();
}
