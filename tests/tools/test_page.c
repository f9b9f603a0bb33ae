/* tests/tools/test_page.c -- a drawing is scaled, turned, placed and repeated exactly, and cut at
 * the edge of its page
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "check.h"
#include "arrange/page.h"
#include "base/spool.h"      /* spool_grow */
#include "tools/drawn.h"

static double random_unit(arb *a)      { return (double)(arb_next(a) >> 11) / 9007199254740992.0; }

static double random_mm(arb *a, double most) { return most * (2 * random_unit(a) - 1); }

/* A path of up to five random cubics. */
static void add_random_path(drawing *d, arb *a, double most)
{
    const unsigned count = 1 + arb_below(a, 5);
    double p[4][2];

    for (unsigned i = 0; i < count; i++) {
        for (int k = 0; k < 8; k++)
            if (i == 0 || k > 1)
                p[k / 2][k % 2] = random_mm(a, most);
        drawing_add(d, p, i == 0, i + 1);
        memcpy(p[0], p[3], sizeof p[0]);
    }
}

/* Read one option. Returns the fault, "" if there is none. */
static const char *read_option(const char *word, page_options *g)
{
    static option_fault f;
    static char text[100];
    char *line[] = { "plot", text, NULL };

    snprintf(text, sizeof text, "%s", word);
    *g = (page_options){ .gap = 0 };
    (void)options_read(page_rows, 2, line, g, &f);
    return f.text;
}

static int apply(const page_options *g, drawing *d)
{
    hear();
    return page_apply(&heard, g, d, "f");
}

static void copy_drawing(drawing *to, const drawing *from)
{
    *to       = *from;
    to->curve = spool_grow(NULL, from->count * sizeof *to->curve);
    memcpy(to->curve, from->curve, from->count * sizeof *to->curve);
    to->room = from->count;
}

static bool same_curves(const drawing *a, const drawing *b)
{
    if (a->count != b->count)
        return false;
    for (size_t i = 0; i < a->count; i++)
        if (memcmp(a->curve[i].p, b->curve[i].p, sizeof a->curve[i].p) != 0 ||
            a->curve[i].path != b->curve[i].path)
            return false;
    return true;
}


// Form
// ----

/* Without an option nothing changes; four quarter turns, and mirroring twice, change nothing on a
 * grid of binary fractions. */
static void turns_and_mirrors_are_exact(arb *a)
{
    drawing d = { .width = 128, .height = 64 }, was;
    page_options none = { .gap = 5 }, quarter = none, across = none, up = none, twice = none;
    double p[4][2];

    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 8; k++)
            p[k / 2][k % 2] = (double)arb_raw(a, 100 << 16) / 65536;
        drawing_add(&d, p, true, 1);
    }
    copy_drawing(&was, &d);
    CHECK(apply(&none, &d) == 0 && same_curves(&d, &was) && d.width == 128);

    CHECK(!*read_option("--rotate=90", &quarter) && !*read_option("--rotate=-540", &twice));
    CHECK(apply(&quarter, &d) == 0 && d.width == 64 && d.height == 128);
    for (size_t i = 0; i < d.count; i++)        /* x, y goes to height - y, x */
        for (int k = 0; k < 4; k++)
            CHECK(d.curve[i].p[k][0] == 64 - was.curve[i].p[k][1] &&
                  d.curve[i].p[k][1] == was.curve[i].p[k][0]);
    CHECK(apply(&quarter, &d) == 0 && apply(&twice, &d) == 0 && same_curves(&d, &was));

    across.mirror = "x";
    up.mirror     = "y";
    CHECK(apply(&across, &d) == 0);
    for (size_t i = 0; i < d.count; i++)
        for (int k = 0; k < 4; k++)
            CHECK(d.curve[i].p[k][0] == 128 - was.curve[i].p[k][0] &&
                  d.curve[i].p[k][1] == was.curve[i].p[k][1]);
    CHECK(apply(&up, &d) == 0 && apply(&twice, &d) == 0 && same_curves(&d, &was));
    CHECK(d.width == 128 && d.height == 64 && caught_lines == 0);
    drawing_free(&was);
    drawing_free(&d);
}

/* Scale, mirror and turn, against the formula; the lower left corner of the box stays. */
static void forms_follow_their_formula(arb *a)
{
    static const char *const mirrors[] = { NULL, "x", "y" };
    drawing d = { 0 }, was;
    page_options g = { .degrees = random_mm(a, 400), .mirror = mirrors[arb_below(a, 3)] };
    double box[2][2], corner[2] = { HUGE_VAL, HUGE_VAL };

    g.scale.count    = arb_below(a, 3);
    g.scale.value[0] = 0.1 + random_unit(a);
    g.scale.value[1] = 0.1 + random_unit(a);
    add_random_path(&d, a, 100);
    copy_drawing(&was, &d);
    CHECK(drawing_box(&was, box) && apply(&g, &d) == 0);

    const double turn = g.degrees * acos(-1) / 180, c = cos(turn), s = sin(turn);
    const double fx = (g.scale.count ? g.scale.value[0] : 1) *
                      (g.mirror && *g.mirror == 'x' ? -1 : 1),
                 fy = (g.scale.count ? g.scale.value[g.scale.count - 1] : 1) *
                      (g.mirror && *g.mirror == 'y' ? -1 : 1);
    for (int k = 0; k < 4; k++) {
        const double x = fx * box[k & 1][0], y = fy * box[k >> 1][1];
        corner[0] = fmin(corner[0], c * x - s * y);
        corner[1] = fmin(corner[1], s * x + c * y);
    }
    for (size_t i = 0; i < d.count; i++)
        for (int k = 0; k < 4; k++) {
            const double x = fx * was.curve[i].p[k][0], y = fy * was.curve[i].p[k][1];
            CHECK_NEAR(d.curve[i].p[k][0], c * x - s * y + box[0][0] - corner[0], 1e-11);
            CHECK_NEAR(d.curve[i].p[k][1], s * x + c * y + box[0][1] - corner[1], 1e-11);
            CHECK(k > 0 || i == 0 || memcmp(d.curve[i].p[0], d.curve[i - 1].p[3], 16) == 0);
        }
    drawing_free(&was);
    drawing_free(&d);
}


// Place
// -----

/* The copies are as large as the room allows, in its middle, the gap between them. */
static void fitting_fills_the_room(arb *a)
{
    drawing d = { 0 };
    page_options g = { .fit = true, .margin = 10 * random_unit(a), .gap = 3 * random_unit(a) };
    const bool repeated = arb_below(a, 2) == 1, turned = arb_below(a, 3) == 0;
    double box[2][2], one[2][2], before[2][2];

    g.size[0]   = 100 + 200 * random_unit(a);
    g.size[1]   = 100 + 200 * random_unit(a);
    g.upright   = turned;
    g.copies[0] = repeated ? 1 + arb_below(a, 5) : 0;
    g.copies[1] = repeated ? 1 + arb_below(a, 5) : 0;
    add_random_path(&d, a, 1 + 200 * random_unit(a));
    CHECK(drawing_box(&d, before));
    const size_t count = d.count;
    CHECK(apply(&g, &d) == 0 && d.width == g.size[0] && d.height == g.size[1]);

    const size_t copies = repeated ? g.copies[0] * g.copies[1] : 1;
    CHECK(d.count == copies * count && drawing_box(&d, box));
    double least = HUGE_VAL;
    for (int i = 0; i < 2; i++) {
        const double left = box[0][i] - g.margin, right = g.size[i] - g.margin - box[1][i];
        CHECK_NEAR(left, right, 1e-9);
        CHECK(left > -1e-9);
        least = fmin(least, left);
    }
    CHECK_NEAR(least, 0, 1e-9);

    d.count = count;                /* the first copy keeps its form */
    CHECK(drawing_box(&d, one));
    const double wide = one[1][0] - one[0][0], high = one[1][1] - one[0][1],
                 was_wide = before[1][0] - before[0][0], was_high = before[1][1] - before[0][1];
    CHECK(fabs(wide * was_high - high * was_wide) < 1e-6 ||
          (turned && fabs(wide * was_wide - high * was_high) < 1e-6));
    const double across = repeated ? g.copies[0] : 1, up = repeated ? g.copies[1] : 1;
    CHECK_NEAR(box[1][0] - box[0][0], across * wide + (across - 1) * g.gap, 1e-9);
    CHECK_NEAR(box[1][1] - box[0][1], up * high + (up - 1) * g.gap, 1e-9);
    if (turned) {                   /* the other way round it would be smaller, or as large */
        const double room[2] = { g.size[0] - 2 * g.margin, g.size[1] - 2 * g.margin };
        const double other = fmin((room[0] - (across - 1) * g.gap) / (across * high),
                                  (room[1] - (up - 1) * g.gap) / (up * wide));
        CHECK(other <= 1 + 1e-9);
    }
    drawing_free(&d);
}

static void drawings_go_where_they_are_told(arb *a)
{
    drawing d = { .width = 300, .height = 200 };
    page_options g = { .gap = 5 }, middle = { .centre = true };
    double box[2][2], was[2][2];

    add_random_path(&d, a, 100);
    CHECK(drawing_box(&d, was));
    g.at = (option_list){ { random_mm(a, 100), random_mm(a, 100) }, 2 };
    CHECK(apply(&g, &d) == 0 && drawing_box(&d, box));
    for (int i = 0; i < 2; i++) {
        CHECK_NEAR(box[0][i], g.at.value[i], 1e-9);
        CHECK_NEAR(box[1][i] - box[0][i], was[1][i] - was[0][i], 1e-9);
    }
    CHECK(apply(&middle, &d) == 0 && drawing_box(&d, box));
    CHECK_NEAR(box[0][0] + box[1][0], 300, 1e-9);
    CHECK_NEAR(box[0][1] + box[1][1], 200, 1e-9);
    drawing_free(&d);
}

static void words_give_box_and_page(arb *a)
{
    drawing d = { 0 };
    double p[4][2] = { { 10, 20 }, { 20, 20 }, { 30, 20 }, { 40, 60 } };
    char words[160];
    (void)a;
    drawing_add(&d, p, true, 1);
    CHECK(strcmp(page_words(&d, words), "30.000 x 40.000 mm at 10.000,20.000") == 0);
    d.width  = 210;
    d.height = 50;
    CHECK(strcmp(page_words(&d, words), "30.000 x 40.000 mm at 10.000,20.000 on a page of 210 x 50 "
                                        "mm, 10.000 mm beyond it") == 0);
    drawing_free(&d);
}


// Cutting
// -------

static double box_distance(const double box[2][2], const double p[2])   /* below 0: inside */
{
    return fmax(fmax(box[0][0] - p[0], p[0] - box[1][0]), fmax(box[0][1] - p[1], p[1] - box[1][1]));
}

/* The distance of a point from the samples of a drawing. */
static double drawing_distance(const drawing *d, const double p[2])
{
    double least = HUGE_VAL;

    for (size_t i = 0; i < d->count; i++)
        for (int k = 0; k <= 200; k++) {
            double at[2];
            drawing_eval(&d->curve[i], k / 200.0, at);
            least = fmin(least, hypot(at[0] - p[0], at[1] - p[1]));
        }
    return least;
}

static bool is_on_edge(const double box[2][2], const double p[2])
{
    return p[0] == box[0][0] || p[0] == box[1][0] || p[1] == box[0][1] || p[1] == box[1][1];
}

/* All pieces are inside, all that is inside is in the pieces, and paths end on the edge or where
 * they ended before. */
static void cutting_keeps_what_is_inside(arb *a)
{
    const double box[2][2] = { { -40 * random_unit(a), -40 * random_unit(a) },
                               { 40 * random_unit(a), 40 * random_unit(a) } };
    drawing d = { 0 }, cut = { 0 };

    add_random_path(&d, a, 80);
    if (arb_below(a, 3) == 0)               /* a control point on a corner, or ends on an edge */
        memcpy(d.curve[0].p[0], box[arb_below(a, 2)], sizeof d.curve[0].p[0]);
    CHECK(page_crop(&heard, &cut, &d, box, "f") == 0);
    for (size_t i = 0; i < cut.count; i++) {
        const drawing_curve *c = &cut.curve[i];
        for (int k = 0; k <= 300; k++) {
            double at[2];
            drawing_eval(c, k / 300.0, at);
            CHECK(box_distance(box, at) <= PAGE_CUT);
        }
        const bool begins = i == 0 || c[-1].path != c->path,
                   ends   = i + 1 == cut.count || c[1].path != c->path;
        CHECK(begins || memcmp(c->p[0], c[-1].p[3], sizeof c->p[0]) == 0);
        CHECK(!begins || is_on_edge(box, c->p[0]) || memcmp(c->p[0], d.curve[0].p[0], 16) == 0);
        CHECK(!ends || is_on_edge(box, c->p[3]) ||
              memcmp(c->p[3], d.curve[d.count - 1].p[3], 16) == 0);
    }
    double seen = 0, kept = drawing_length(&cut);
    for (size_t i = 0; i < d.count; i++)
        for (int k = 0; k < 1000; k++) {
            double at[2], slope[2];
            drawing_eval(&d.curve[i], (k + 0.5) / 1000, at);
            drawing_deriv(&d.curve[i], (k + 0.5) / 1000, slope);
            if (box_distance(box, at) < 0)
                seen += hypot(slope[0], slope[1]) / 1000;
            if (k % 50 == 0 && box_distance(box, at) < -PAGE_CUT)
                CHECK(drawing_distance(&cut, at) < 1.5);
        }
    CHECK_NEAR(kept, seen, 0.002 * drawing_length(&d) + 0.5);
    drawing_free(&cut);
    drawing_free(&d);
}

/* A curve that touches the edge from within is not cut, a line along the edge is kept, one beyond
 * it is dropped; a line through both sides is cut to what is between. */
static void edges_belong_to_the_page(arb *a)
{
    static const double box[2][2] = { { 0, 0 }, { 100, 50 } };
    double arch[4][2] = { { 10, 10 }, { 20, 190.0 / 3 }, { 40, 190.0 / 3 }, { 50, 10 } };
    double along[4][2] = { { -30, 50 }, { 20, 50 }, { 70, 50 }, { 120, 50 } };
    double beyond[4][2] = { { 0, 50.01 }, { 20, 50.01 }, { 40, 50.01 }, { 60, 50.01 } };
    double through[4][2] = { { -50, -25 }, { 0, 0 }, { 50, 25 }, { 100, 50 } };
    drawing d = { 0 }, cut = { 0 };
    (void)a;
    drawing_add(&d, arch, true, 1);         /* its top: 10 + 0.75 * 160 / 3 = 50 */
    drawing_add(&d, along, true, 2);
    drawing_add(&d, beyond, true, 3);
    drawing_add(&d, through, true, 4);
    CHECK(page_crop(&heard, &cut, &d, box, "f") == 0 && cut.count == 3);
    if (cut.count == 3) {
        CHECK(memcmp(cut.curve[0].p, arch, sizeof arch) == 0);
        CHECK(cut.curve[1].line == 2 && cut.curve[2].line == 4);
        CHECK_NEAR(cut.curve[1].p[0][0], 0, 1e-9);
        CHECK_NEAR(cut.curve[1].p[3][0], 100, 1e-9);
        CHECK_NEAR(cut.curve[2].p[0][0], 0, 1e-6);
        CHECK_NEAR(cut.curve[2].p[0][1], 0, 1e-6);
        CHECK(cut.curve[2].p[3][0] == 100);
    }
    drawing_free(&cut);
    drawing_free(&d);
}


/* Heights and feeds stay with their curves; a cut curve keeps its slope. */
static void heights_stay(arb *a)
{
    static const double box[2][2] = { { 0, 0 }, { 50, 50 } };
    double line[4][3] = { { -30, 20, 0 }, { 0, 20, 1 }, { 30, 20, 2 }, { 60, 20, 3 } };
    drawing d = { 0 }, cut = { 0 };
    page_options g = { .degrees = 30, .scale = { { 2 }, 1 }, .copies = { 2, 1 } };
    (void)a;
    drawing_add_space(&d, line, 12, true, 1);
    CHECK(page_crop(&heard, &cut, &d, box, "f") == 0 && cut.count == 1 && cut.curve[0].feed == 12);
    if (cut.count == 1) {
        CHECK(cut.curve[0].p[0][0] == 0 && cut.curve[0].p[3][0] == 50);
        for (int k = 0; k < 4; k++)
            CHECK_NEAR(cut.curve[0].z[k], (cut.curve[0].p[k][0] + 30) / 30, 1e-6);
    }
    CHECK(apply(&g, &d) == 0 && d.count == 2);
    for (size_t i = 0; i < d.count; i++)
        CHECK(d.curve[i].feed == 12 && d.curve[i].z[1] == 1 && d.curve[i].z[3] == 3);
    drawing_free(&cut);
    drawing_free(&d);
}


/* A program that begins where the machine is: what counts from there is not moved, and has no
 * place in the box; a line from there to a known place is moved at that end only. */
static void programs_begin_where_the_machine_is(arb *a)
{
    double line[4][2] = { { 0, 0 }, { 3, 1 }, { 6, 2 }, { 9, 3 } };
    double known[4][2] = { { 9, 3 }, { 10, 3 }, { 11, 3 }, { 12, 9 } };
    drawing d = { .program = true };
    page_options g = { .at = { { 100, 50 }, 2 }, .scale = { { 2 }, 1 } }, turn = { .degrees = 90 };
    (void)a;
    drawing_add(&d, line, true, 1);
    d.curve[0].loose[0] = 3;
    drawing_add(&d, known, false, 2);
    CHECK(apply(&g, &d) == 0);
    CHECK_NEAR(d.curve[0].p[0][0], 0, 1e-12);
    CHECK_NEAR(d.curve[0].p[0][1], 0, 1e-12);
    for (int k = 0; k < 4; k++) {       /* thirds from there to 100,50, where the known begins */
        CHECK_NEAR(d.curve[0].p[k][0], 100.0 * k / 3, 1e-9);
        CHECK_NEAR(d.curve[0].p[k][1], 50.0 * k / 3, 1e-9);
    }
    CHECK_NEAR(d.curve[1].p[3][0], 106, 1e-9);
    CHECK_NEAR(d.curve[1].p[3][1], 62, 1e-9);
    CHECK(apply(&turn, &d) == 0);
    CHECK_NEAR(d.curve[0].p[0][0], 0, 1e-9);
    d.curve[0].loose[0] = 1;
    CHECK(apply(&turn, &d) == EX_DATAERR && strstr(caught, "f:1: moves one axis") != NULL);
    drawing_free(&d);
}


// Words
// -----

#define REFUSED(g, page_wide, words)                                                               \
    do {                                                                                           \
        drawing d_ = { .width = page_wide, .height = page_wide };                                  \
        double p_[4][2] = { { 0, 0 }, { 9, 0 }, { 9, 9 }, { 0, 9 } };                              \
        drawing_add(&d_, p_, true, 1);                                                             \
        CHECK(apply(&(g), &d_) != 0 && caught_lines == 1 && strstr(caught, words) != NULL);        \
        drawing_free(&d_);                                                                         \
    } while (0)

/* Between the parts of a program nothing lifts the pen. */
static void program_refuses(const page_options *g)
{
    drawing d      = { .program = true, .width = 300, .height = 300 };
    double p[4][2] = { { 0, 0 }, { 9, 0 }, { 9, 9 }, { 0, 9 } };

    drawing_add(&d, p, true, 1);
    CHECK(apply(g, &d) == EX_USAGE && strstr(caught, "is a program") != NULL);
    drawing_free(&d);
}

static void what_cannot_be_is_refused(arb *a)
{
    page_options fit = { .fit = true }, wide = { .centre = true, .margin = 60 },
                 off = { .crop = true, .at = { { 200, 0 }, 2 } }, far = { .scale = { { 1e4 }, 1 } },
                 many = { .copies = { 9999, 9999 } },
                 gaps = { .fit = true, .gap = 60, .copies = { 3, 1 } }, g;
    (void)a;
    REFUSED(fit, 0, "gives no page: say which, as --page A4");
    REFUSED(wide, 100, "--margin 60: leaves nothing");
    CHECK(strstr(read_option("--mirror=z", &g), "--mirror z: give x or y"));
    CHECK(strstr(read_option("--at=1", &g), "--at: 1 number: give X,Y"));
    CHECK(strstr(read_option("--scale=1,2,3", &g), "--scale: 3 numbers: give one"));
    CHECK(strstr(read_option("--stroke=both", &g), "--stroke both: give line or outline"));
    REFUSED(off, 100, "nothing of it is on the page");
    REFUSED(far, 0, "f:1: lies at 90000 mm now");
    REFUSED(many, 100, "give fewer copies");
    program_refuses(&off);
    program_refuses(&many);
    REFUSED(gaps, 100, "the gaps of 60 mm fill the page");
}

static bool sized(const char *text, double width, double height)
{
    page_options g;
    char word[60];

    snprintf(word, sizeof word, "--page=%s", text);
    const char *fault = read_option(word, &g);
    return *fault == '\0' ? fabs(g.size[0] - width) < 1e-9 && fabs(g.size[1] - height) < 1e-9
                          : width <= 0 && strstr(fault, "give A0 to A6") != NULL;
}

static void pages_have_names_and_numbers(arb *a)
{
    static const char *const bad[] = { "",        "A",        "A7",     "A44",  "A4-upright",
                                       "10",      "10x",      "x10",    "0x10", "-1x10",
                                       "10x10ft", "10x10x10", "nanx10", "1e9x5" };
    static const char *const copies[] = { "", "3", "0x1", "1x0", "-1x2", "3x2x", "3x", "ax2" };
    page_options g = { .gap = 0 };
    (void)a;
    CHECK(sized("A4", 210, 297) && sized("a4-landscape", 297, 210) && sized("A0", 841, 1189));
    CHECK(sized("Letter", 215.9, 279.4) && sized("letter-landscape", 279.4, 215.9));
    CHECK(sized("210x297", 210, 297) && sized("21x29.7cm", 210, 297) && sized("10x20 mm", 10, 20));
    CHECK(sized("8.5x11in", 215.9, 279.4));
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
        CHECK(sized(bad[i], -1, -1));
    CHECK(!*read_option("--copies=3x2", &g) && g.copies[0] == 3 && g.copies[1] == 2);
    for (size_t i = 0; i < sizeof copies / sizeof copies[0]; i++) {
        char word[40];
        snprintf(word, sizeof word, "--copies=%s", copies[i]);
        CHECK(strstr(read_option(word, &g), "give how many"));
    }
    CHECK(!*read_option("--rotate=-12.5", &g) && g.degrees == -12.5);
    CHECK(!*read_option("--rotate=auto", &g) && g.upright);
    CHECK(*read_option("--rotate=left", &g) && *read_option("--rotate=nan", &g));
}

int main(void)
{
    PROPERTY(turns_and_mirrors_are_exact, 100);
    PROPERTY(forms_follow_their_formula, 300);
    PROPERTY(fitting_fills_the_room, 300);
    PROPERTY(drawings_go_where_they_are_told, 100);
    PROPERTY(words_give_box_and_page, 1);
    PROPERTY(cutting_keeps_what_is_inside, 400);
    PROPERTY(edges_belong_to_the_page, 1);
    PROPERTY(heights_stay, 1);
    PROPERTY(programs_begin_where_the_machine_is, 1);
    PROPERTY(what_cannot_be_is_refused, 1);
    PROPERTY(pages_have_names_and_numbers, 1);
    return check_failures();
}
