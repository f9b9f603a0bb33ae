/* tests/tools/test_plot.c -- pictures: they are written, and ink is where the curves are
 * SPDX-License-Identifier: MIT
 */
#include <unistd.h>

#include "support/kept_fonts.h"
#include "tools/drawn.h"
#include "draw/plot.h"

static char folder[] = "/tmp/loft-plot-XXXXXX";

/* A page of 100 mm with one curve that fills it, and a machine that drew it 0.25 mm too high and
 * then travelled. */
static const drawing_curve arch = { { { 10, 10 }, { 40, 100 }, { 60, 0 }, { 90, 90 } }, 0, 1 };
static record_pulse pulse[301];

static void machine(record *r)
{
    *r = (record){ .pulse = pulse,
                   .machine = machine_usual(),
                   .count = 301,
                   .slot_hz = 1000,
                   .steps_per_mm = { 100, 100, 100 },
                   .pen_down = 1 };
    for (int i = 0; i <= 300; i++) {
        drawing_eval(&arch, fmin(i / 299.0, 1), pulse[i].at);
        pulse[i].slot = (uint64_t)i;
        pulse[i].at[1] += 0.25;
        pulse[i].at[2] = 0;
    }
    pulse[300] = (record_pulse){ 300, { 0, 0, 2 } };
}

static const char *path_of(const char *name)
{
    static char path[80];

    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

/* The darkest value of red, green and blue within two pixels of the place in mm; the frame is found
 * by its own margins. */
static int ink_at(cairo_surface_t *picture, double x, double y, double left, double bottom,
                  double scale)
{
    const unsigned char *bytes = cairo_image_surface_get_data(picture);
    const int stride = cairo_image_surface_get_stride(picture), cx = (int)(left + x * scale),
              cy = (int)(bottom - y * scale);
    int least = 255;

    for (int dy = -2; dy <= 2; dy++)
        for (int dx = -2; dx <= 2; dx++)
            for (int k = 0; k < 3; k++) {
                const int v = bytes[(cy + dy) * stride + (cx + dx) * 4 + k];
                least = v < least ? v : least;
            }
    return least;
}

/* A plain plot of a page: the margins are 62 thousandths on the left, 28 on the right, 52 above. */
static void ink_is_on_the_curve(arb *a)
{
    drawing d = { (drawing_curve *)(size_t)&arch, 1, 1, 100, 100, NULL };
    const plot_options o = { .d = &d,
                             .error = PLOT_NO_ERROR,
                             .comb = PLOT_NO_COMB,
                             .size = 1000,
                             .name = "x.svg",
                             .output = path_of("a.png") };
    (void)a;
    CHECK(plot_draw(&heard, &o, NULL) == 0);
    cairo_surface_t *picture = cairo_image_surface_create_from_png(o.output);
    CHECK(cairo_surface_status(picture) == CAIRO_STATUS_SUCCESS &&
          cairo_image_surface_get_width(picture) == 1000);
    const double scale = 9.10, left = 62, bottom = 52 + 910;
    for (int i = 0; i <= 50; i++) {
        double p[2];
        drawing_eval(&arch, i / 50.0, p);
        CHECK(ink_at(picture, p[0], p[1], left, bottom, scale) < 120);
    }
    CHECK(ink_at(picture, 20, 80, left, bottom, scale) == 255 &&
          ink_at(picture, 80, 20, left, bottom, scale) == 255);
    cairo_surface_destroy(picture);
    remove(o.output);
}

/* A rapid of a program is a thin dashed line, and no curve of the drawing. */
static void rapids_are_drawn_apart(arb *a)
{
    static const drawing_curve of[] = {
        { { { 10, 10 }, { 30, 30 }, { 70, 70 }, { 90, 90 } }, 0, 1, .feed = DRAWING_RAPID },
        { { { 90, 90 }, { 90, 70 }, { 90, 30 }, { 90, 10 } }, 0, 2 },
        { { { 90, 10 }, { 70, 10 }, { 30, 10 }, { 10, 10 } }, 0, 3, .feed = DRAWING_RAPID },
    };
    drawing d = { (drawing_curve *)(size_t)of, 3, 3, 100, 100, NULL };
    const plot_options o = { .d = &d,
                             .error = PLOT_NO_ERROR,
                             .comb = PLOT_NO_COMB,
                             .size = 1000,
                             .name = "x.nc",
                             .output = path_of("r.png") };
    const double scale = 9.10, left = 62, bottom = 52 + 910;
    (void)a;
    CHECK(plot_draw(&heard, &o, NULL) == 0);
    cairo_surface_t *picture = cairo_image_surface_create_from_png(o.output);
    for (int i = 2; i <= 98; i++) {
        double p[2];
        drawing_eval(&of[1], i / 100.0, p);
        CHECK(ink_at(picture, p[0], p[1], left, bottom, scale) < 114);
        for (int k = 0; k <= 2; k += 2) {
            drawing_eval(&of[k], i / 100.0, p);
            const int ink = ink_at(picture, p[0], p[1], left, bottom, scale);
            CHECK(ink >= 114 && ink < 255);
        }
    }
    cairo_surface_destroy(picture);
    remove(o.output);
}

/* The comb of an arc of radius 20: teeth of SCALE / 20 mm, outwards; between their ends and the arc
 * there are only thin lines. */
static void a_comb_stands_on_the_outside(arb *a)
{
    static const drawing_curve arc = {
        { { 70, 50 }, { 70, 61.045695 }, { 61.045695, 70 }, { 50, 70 } }, 0, 1
    };
    drawing d = { (drawing_curve *)(size_t)&arc, 1, 1, 100, 100, NULL };
    const plot_options o = { .d = &d,
                             .error = PLOT_NO_ERROR,
                             .comb = 300,
                             .size = 1000,
                             .name = "x.svg",
                             .output = path_of("c.png") };
    (void)a;
    CHECK(plot_draw(&heard, &o, NULL) == 0);
    cairo_surface_t *picture = cairo_image_surface_create_from_png(o.output);
    const double scale = 9.10, left = 62, bottom = 52 + 910;
    for (int i = 1; i < 20; i++) {
        const double x = cos(acos(-1) * i / 40), y = sin(acos(-1) * i / 40);
        /* their ends */
        CHECK(ink_at(picture, 50 + 35 * x, 50 + 35 * y, left, bottom, scale) < 140);
        CHECK(ink_at(picture, 50 + 27 * x, 50 + 27 * y, left, bottom, scale) > 150);
        /* nothing inside */
        CHECK(ink_at(picture, 50 + 15 * x, 50 + 15 * y, left, bottom, scale) == 255);
        CHECK(ink_at(picture, 50 + 40 * x, 50 + 40 * y, left, bottom, scale) == 255);
    }
    cairo_surface_destroy(picture);
    remove(o.output);
}

static void every_format_is_written(arb *a)
{
    static const double errors[] = { PLOT_NO_ERROR, PLOT_AUTO_ERROR, 10 };
    static const struct {
        const char *name, *start;
    } formats[] = { { "b.png", "\x89PNG" }, { "b.PDF", "%PDF-" }, { "b.svg", "<?xml" } };
    drawing d = { (drawing_curve *)(size_t)&arch, 1, 1, 0, 0, NULL };
    record r;
    (void)a;
    machine(&r);
    for (size_t i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            const plot_options o = { .d = &d,
                                     .r = &r,
                                     .control = true,
                                     .error = errors[k],
                                     .size = i == 0 ? 600 : 0,
                                     .name = "x.svg",
                                     .output = path_of(formats[i].name) };
            plot_result found;
            char start[8] = "";
            CHECK(plot_draw(&heard, &o, &found) == 0);
            CHECK(found.worst > 0.1 && found.worst <= 0.2501 && found.drawing_pulses >= 299 &&
                  found.mean <= found.worst);
            FILE *f = fopen(o.output, "rb");
            CHECK(f != NULL && fread(start, 1, 5, f) == 5 &&
                  strncmp(start, formats[i].start, strlen(formats[i].start)) == 0);
            if (f != NULL)
                fclose(f);
            remove(o.output);
        }
}

static void what_cannot_be_written_is_told(arb *a)
{
    drawing d = { (drawing_curve *)(size_t)&arch, 1, 1, 100, 100, NULL };
    plot_options o = { .d = &d,
                       .error = PLOT_NO_ERROR,
                       .comb = PLOT_NO_COMB,
                       .size = 300,
                       .name = "x.svg",
                       .output = "x.gif" };
    (void)a;
    caught[0] = '\0';
    CHECK(plot_draw(&heard, &o, NULL) == EX_USAGE && strstr(caught, ".png, .svg or .pdf") != NULL);
    static const char *const names[] = { "/tmp/loft/no/such/x.png", "/tmp/loft/no/such/x.svg",
                                         "/tmp/loft/no/such/x.pdf" };
    for (int i = 0; i < 3; i++) {
        caught[0] = '\0';
        o.output = names[i];
        CHECK(plot_draw(&heard, &o, NULL) == EX_CANTCREAT &&
              strstr(caught, "cannot be written") != NULL);
    }
}

int main(void)
{
    if (mkdtemp(folder) == NULL)
        return 1;
    PROPERTY(ink_is_on_the_curve, 1);
    PROPERTY(rapids_are_drawn_apart, 1);
    PROPERTY(a_comb_stands_on_the_outside, 1);
    PROPERTY(every_format_is_written, 1);
    PROPERTY(what_cannot_be_written_is_told, 1);
    rmdir(folder);
    return check_failures();
}
