/* tests/tools/test_curve.c -- the text format of curves: what it accepts, what it refuses and on
 * which line; drawings from it
 * SPDX-License-Identifier: MIT
 */
#include "tools/drawn.h"
#include "engine/engine.h"
#include "engine/curve.h"
#include "geometry/curve_text.h"
#include "read/drawing_curves.h"

static int read_text(curves *all, const char *text)
{
    hear();
    *all = (curves){ 0 };
    return curves_read_text(&heard, all, "f.loft", text);
}

/* CHECK that the text is refused on that line, with those words, in one line. */
static void check_refused(const char *text, const char *words, int line)
{
    curves all;
    const int code = read_text(&all, text);

    if (code != EX_DATAERR || caught_lines != 1 || strncmp(caught, words, strlen(words)) != 0 ||
        strchr(caught, '\n') != NULL) {
        printf("line %d: code %d, %u lines: %s\n  wanted: %s\n", line, code, caught_lines, caught,
               words);
        check_bad = true;
    }
    curves_free(&all);
}
#define REFUSES_TEXT(text, words) check_refused(text, words, __LINE__)

static void every_kind_is_read(arb *a)
{
    static const char text[] = "\xEF\xBB\xBF# all kinds\r\n\r\n"
                               "bezier 3\n0 0\n1,2\n  3\t4 # a comment\n5;6\n" /* line 3 */
                               "bezier\n0 0 1\n1 -.5e1 2\n"
                               "line\n0 0\n1 0\n1 1\n"
                               "rational 2\n1 0\n1 1 : 0.5\n0 1 2 : 3\n"
                               "parabola\n0 0 : 0\n1 1 : 0.25\n2 0 : 2\n"
                               "hermite3\n0 0 : 1 2\n\n1 1 : 3 4 5\n"
                               "hermite5\n0 0 : 1 2 : 3 4\n1 1 : 5 6 : 7 8\n"
                               "cardinal 0.5\n0 0\n1 0\n2 0\n3 0\n"
                               "cardinal\n0 0\n1 0\n2 0\n3 0\n4 0\n"
                               "natural\n0 0\n1 0\n"
                               "natural chord\n0 0\n1 0\n2 0\n"
                               "bspline 2\n0 0\n1 0\n2 0\n3 0\n"
                               "nurbs 1\nknots 0 0 1\nknots 3 3 # more\n0 0\n1 0 : 2\n2 0\n"
                               "arc right 2\n5 6\n15 6\n15 16\n"
                               "spline closed chord\n0 0\n1 0\n2 1\n"
                               "spline clamped\n0 0 : 1 2\n1 0\n2 0 : 3 4 5\n"
                               "spline not-a-knot uniform\n0 0\n1 0\n"
                               "spline through\n0 0\n1 0\n2 0\n3 0\n"
                               "spline slope\n0 0\n1 0\n2 0\n3 0\n4 0\n"
                               "tcb\n0 0\n1 0 : 0.5 -1 2\n2 0\n3 0\n"
                               "catmull\n0 0\n1 0\n2 0\n3 0\n"
                               "catmull 1\n0 0\n1 0\n2 0\n3 0";
    static const struct {
        enum curve_kind kind;
        unsigned degree, count, pieces;
        double from, to;
    } want[] = { { CURVE_BEZIER, 3, 4, 1, 0, 1 },   { CURVE_BEZIER, 1, 2, 1, 0, 1 },
                 { CURVE_LINE, 1, 3, 2, 0, 2 },     { CURVE_RATIONAL, 2, 3, 1, 0, 1 },
                 { CURVE_PARABOLA, 2, 3, 1, 0, 2 }, { CURVE_HERMITE3, 3, 2, 1, 0, 1 },
                 { CURVE_HERMITE5, 5, 2, 1, 0, 1 }, { CURVE_CARDINAL, 3, 4, 1, 0, 1 },
                 { CURVE_CARDINAL, 3, 5, 2, 0, 2 }, { CURVE_NATURAL, 3, 2, 1, 0, 1 },
                 { CURVE_CHORD, 3, 3, 2, 0, 2 },    { CURVE_BSPLINE, 2, 4, 2, 0, 2 },
                 { CURVE_NURBS, 1, 3, 2, 0, 3 },    { CURVE_ARC, 3, 3, 1, 0, 1 },
                 { CURVE_SPLINE, 3, 3, 3, 0, 3 },   { CURVE_SPLINE, 3, 3, 2, 0, 2 },
                 { CURVE_SPLINE, 3, 2, 1, 0, 1 },   { CURVE_SPLINE, 3, 4, 1, 0, 1 },
                 { CURVE_SPLINE, 3, 5, 2, 0, 2 },   { CURVE_TCB, 3, 4, 1, 0, 1 },
                 { CURVE_CATMULL, 3, 4, 1, 0, 1 },  { CURVE_CATMULL, 3, 4, 1, 0, 1 } };
    const size_t count = sizeof want / sizeof want[0];
    curves all;
    (void)a;
    CHECK(read_text(&all, text) == 0 && caught_lines == 0 && all.count == count && all.solid);
    for (size_t i = 0; i < all.count && i < count; i++) {
        const curve *c = &all.curve[i];
        if (c->kind != want[i].kind || c->degree != want[i].degree || c->count != want[i].count ||
            curve_pieces(c) != want[i].pieces) {
            printf("curve %zu: %s, degree %u, %u points, %u pieces\n", i, curve_name(c->kind),
                   c->degree, c->count, curve_pieces(c));
            check_bad = true;
        }
        CHECK_NEAR(curve_from(c), want[i].from, 0);
        CHECK_NEAR(curve_to(c), want[i].to, 0);
    }
    if (all.count == count) {
        CHECK(all.curve[0].line == 3 && all.curve[1].line == 8 && all.curve[13].line == 59);
        CHECK_NEAR(all.curve[0].point[3].p[1], 6, 0);
        CHECK_NEAR(all.curve[1].point[1].p[1], -5, 0);
        CHECK_NEAR(all.curve[3].point[0].w, 1, 0);
        CHECK_NEAR(all.curve[3].point[2].w, 3, 0);
        CHECK_NEAR(all.curve[4].point[1].w, 0.25, 0);
        CHECK_NEAR(all.curve[5].point[1].d[0][2], 5, 0);
        CHECK_NEAR(all.curve[6].point[1].d[1][1], 8, 0);
        CHECK_NEAR(all.curve[7].tension, 0.5, 0);
        CHECK_NEAR(all.curve[11].knot[3], 1, 0);        /* 0 0 0 1 2 2 2 */
        CHECK_NEAR(all.curve[11].knot[6], 2, 0);
        CHECK_NEAR(all.curve[12].point[1].w, 2, 0);
        CHECK(all.curve[13].turns == -2);
        CHECK(all.curve[14].chord && curve_is_closed(&all.curve[14]));
        CHECK_NEAR(all.curve[15].point[2].d[0][2], 5, 0);
        CHECK_NEAR(all.curve[15].point[1].d[0][0], 0, 0);
        CHECK(curve_hides_ends(&all.curve[17]) && curve_hides_ends(&all.curve[18]));
        CHECK_NEAR(all.curve[19].point[1].d[0][2], 2, 0);
        CHECK_NEAR(all.curve[20].tension, 0.5, 0);
        CHECK_NEAR(all.curve[21].tension, 1, 0);
    }
    curves_free(&all);
}

static void what_is_wrong_is_said_with_its_line(arb *a)
{
    (void)a;
    REFUSES_TEXT("1 2\n", "f.loft:1: a point of no curve: begin with a kind");
    REFUSES_TEXT("# ok\n\nbezier 3\n0 0\nsnake\n", "f.loft:3: bezier with 1 point: give 4");
    REFUSES_TEXT("bezier 1\n0 0\n1 1\n\nsnake 3\n",
                 "f.loft:5: `snake` is not a kind of curve: give bezier");
    REFUSES_TEXT("bezier 1\n0 0\n1 1\n2 2\n", "f.loft:1: bezier with 3 points: give 2");
    REFUSES_TEXT("bezier\n", "f.loft:1: bezier with 0 points: give at least 1");
    REFUSES_TEXT("bezier 10\n",                                "f.loft:1: not a degree");
    REFUSES_TEXT("bezier 2.5\n",                               "f.loft:1: not a degree");
    REFUSES_TEXT("bezier 3 4\n",                               "f.loft:1: not a degree");
    REFUSES_TEXT("bezier three\n",                             "f.loft:1: not a degree");
    REFUSES_TEXT("bezier -1\n",                                "f.loft:1: not a degree");
    REFUSES_TEXT("rational 0\n", "f.loft:1: not a degree: give a whole number from 1 to 9");
    REFUSES_TEXT("bezier 1\n0 0\n1\n",                         "f.loft:3: not a point: `x y`");
    REFUSES_TEXT("bezier 1\n0 0\n1 2 3 4\n",                   "f.loft:3: not a point");
    REFUSES_TEXT("bezier 1\n0 0\n1 nan\n",                     "f.loft:3: not a point");
    REFUSES_TEXT("bezier 1\n0 0\n1 1e999\n",                   "f.loft:3: not a point");
    REFUSES_TEXT("bezier 1\n0 0\n1 0x10\n",                    "f.loft:3: not a point");
    REFUSES_TEXT("bezier 1\n0 0\n1 1 : 2\n",                   "f.loft:3: not a point");
    REFUSES_TEXT("bezier 1\n0 0\n: 1\n",                       "f.loft:3: not a point");
    REFUSES_TEXT("line\n0 0\n", "f.loft:1: line with 1 point: give at least 2");
    REFUSES_TEXT("line 3\n0 0\n1 1\n",                         "f.loft:1: more after the kind");
    REFUSES_TEXT("rational\n0 0\n1 1 : 0\n", "f.loft:3: not a point: `x y : weight`");
    REFUSES_TEXT("rational\n0 0\n1 1 : -1\n",                  "f.loft:3: not a point");
    REFUSES_TEXT("rational\n0 0 : 256.1\n",                    "f.loft:2: not a point");
    REFUSES_TEXT("nurbs 1\n0 0 : 0.0039\n",                    "f.loft:2: not a point");
    REFUSES_TEXT("rational\n0 0\n1 1 :\n",                     "f.loft:3: not a point");
    REFUSES_TEXT("parabola\n0 0 : 0\n1 1\n",                   "f.loft:3: not a point: `x y : t`");
    REFUSES_TEXT("parabola\n0 0 : 0\n1 1 : 1\n", "f.loft:1: parabola with 2 points: give 3");
    REFUSES_TEXT("\nparabola\n0 0 : 0\n1 1 : 1\n2 2 : 1\n",
                 "f.loft:2: parameters that do not ascend");
    REFUSES_TEXT("hermite3\n0 0\n", "f.loft:2: not a point: `x y : dx dy`");
    REFUSES_TEXT("hermite3\n0 0 : 1 1 : 2 2\n",                "f.loft:2: not a point");
    REFUSES_TEXT("hermite5\n0 0 : 1 1\n",                      "f.loft:2: not a point");
    REFUSES_TEXT("cardinal x\n",                               "f.loft:1: not a tension");
    REFUSES_TEXT("cardinal\n0 0\n1 1\n2 2\n", "f.loft:1: cardinal with 3 points: give at least 4");
    REFUSES_TEXT("natural cubic\n",                            "f.loft:1: not a spacing of knots");
    REFUSES_TEXT("spline\n", "f.loft:1: not the ends of a spline: give closed, clamped");
    REFUSES_TEXT("spline through chord\n", "f.loft:1: not a spacing of knots: give none");
    REFUSES_TEXT("spline closed cord\n", "f.loft:1: not a spacing of knots: give uniform");
    REFUSES_TEXT("spline closed\n0 0\n1 1\n", "f.loft:1: spline with 2 points: give at least 3");
    REFUSES_TEXT("spline slope\n0 0\n1 1\n2 0\n", "f.loft:1: spline with 3 points: give at least");
    REFUSES_TEXT("spline clamped\n0 0 : 1 1\n1 1\n", "f.loft:1: a clamped spline without a slope");
    REFUSES_TEXT("spline closed\n0 0\n1 1 : 1 0\n2 0\n", "f.loft:1: a slope at a point that");
    REFUSES_TEXT("tcb\n0 0 : 1 1\n", "f.loft:2: not a point: `x y` or `x y : tension");
    REFUSES_TEXT("tcb\n0 0 : 0 0 2.1\n", "f.loft:2: not a point");
    REFUSES_TEXT("catmull 1.5\n", "f.loft:1: not a power of the chords: give 0 to 1");
    REFUSES_TEXT("natural chords\n",                           "f.loft:1: not a spacing of knots");
    REFUSES_TEXT("bspline\n",                                  "f.loft:1: no degree");
    REFUSES_TEXT("bspline 3\n0 0\n1 1\n2 2\n",
                 "f.loft:1: degree 3 with 3 points: give more points");
    REFUSES_TEXT("bspline 1\nknots 0 0 1\n0 0\n1 1\n",
                 "f.loft:1: 3 knots for 2 points of degree 1");
    REFUSES_TEXT("bspline 1\nknots 0 2 1 1\n0 0\n1 1\n",       "f.loft:2: knots that descend");
    REFUSES_TEXT("bspline 1\nknots 0 0\nknots 1 x\n0 0\n1 1\n", "f.loft:3: not a knot");
    REFUSES_TEXT("bspline 2\nknots 0 0 1 1 2 2\n0 0\n1 1\n2 2\n",
                 "f.loft:1: knots that leave no curve");
    REFUSES_TEXT("bezier 1\nknots 0 1\n",                      "f.loft:2: knots of no B-spline");
    REFUSES_TEXT("knots 0 1\n",                                "f.loft:1: knots of no B-spline");
    REFUSES_TEXT("bspline 1\nknots 0 1 1 1 2\n0 0\n1 1\n2 2\n", "f.loft:1: too many equal knots");
    REFUSES_TEXT("arc\n",                                      "f.loft:1: not an arc");
    REFUSES_TEXT("arc leftish\n",                              "f.loft:1: not an arc");
    REFUSES_TEXT("arc left 1.5\n",                             "f.loft:1: not an arc");
    REFUSES_TEXT("arc right -1\n",                             "f.loft:1: not an arc");
    REFUSES_TEXT("arc left\n0 0\n1 1\n", "f.loft:1: arc with 2 points: give 3");
    REFUSES_TEXT("arc left\n0 0\n1 0\n3 0\n",
                 "f.loft:1: an arc whose ends are 1 and 2 mm from its centre");
    REFUSES_TEXT("arc left\n1 0\n1 0\n1 0\n", "f.loft:1: an arc whose ends are 0 and 0 mm");
    REFUSES_TEXT("\x01\n",                                     "f.loft:1: a point of no curve");
}

static void a_file_is_known_by_its_first_word(arb *a)
{
    (void)a;
    CHECK(curves_is_text("-", "bezier 3\n") &&
          curves_is_text("-", "# x\n\n  \t# y\nnatural chord"));
    CHECK(curves_is_text("any.loft", "nonsense") && !curves_is_text("loft", "nonsense"));
    CHECK(!curves_is_text("f", "x0,y0,x1\n") && !curves_is_text("f", "0 0\nbezier 3\n") &&
          !curves_is_text("f", "beziers\n") && !curves_is_text("f", ""));
}

/* For any bytes: an error code and one line, or curves that keep the promises of the format. */
static void any_text_is_read_or_refused(arb *a)
{
    static const char *const words[] = { "bezier 2\n",
                                         "line\n",
                                         "rational\n",
                                         "parabola\n",
                                         "hermite3\n",
                                         "hermite5\n",
                                         "cardinal 1\n",
                                         "natural chord\n",
                                         "spline closed\n",
                                         "spline clamped chord\n",
                                         "tcb\n",
                                         "catmull\n",
                                         "bspline 1\n",
                                         "nurbs 2\n",
                                         "arc left\n",
                                         "knots 0 1 2 3\n",
                                         "knots 0 0\n",
                                         "0 0\n",
                                         "1 2 : 3\n",
                                         "1 2 : 3 4\n",
                                         "1 2 3 : 4 5 6 : 7 8 9\n",
                                         "# c\n",
                                         "\n",
                                         "x",
                                         ":",
                                         "-",
                                         "1e",
                                         "\t",
                                         "9 9\n",
                                         "5 5\n",
                                         "1 1\n",
                                         "2 0 : 5\n" };
    char text[400] = "";
    curves all;

    for (unsigned n = 1 + arb_below(a, 12); n > 0; n--)
        strcat(text, words[arb_below(a, sizeof words / sizeof words[0])]);
    const int code = read_text(&all, text);
    CHECK(code == 0
              ? caught_lines == 0
              : code == EX_DATAERR && caught_lines == 1 && strncmp(caught, "f.loft:", 7) == 0);
    for (size_t i = 0; code == 0 && i < all.count; i++) {
        const curve *c = &all.curve[i];
        CHECK(c->degree <= CURVE_DEGREE_MAX && c->count >= 1 && curve_pieces(c) >= 1 &&
              curve_from(c) < curve_to(c));
        long double local;
        const unsigned piece = curve_locate(c, (long double)curve_to(c), &local);
        CHECK(piece == curve_pieces(c) - 1);
        CHECK_NEAR((double)local, 1, 0);
    }
    curves_free(&all);
}

/* `head` and n points of a saw: point i is (i / 100, i mod 3). */
static char *saw_text(const char *head, unsigned n)
{
    char *text = malloc(32 + 24 * (size_t)n), *at = text + sprintf(text, "%s\n", head);

    for (unsigned i = 0; i < n; i++)
        at += sprintf(at, "%g %u\n", i / 100.0, i % 3);
    return text;
}

static void a_curve_may_have_many_points(arb *a)
{
    static const struct {
        const char *head;
        unsigned least;
    } kinds[] = { { "line", 1 }, { "natural", 1 }, { "cardinal", 3 } };
    const unsigned n = 66000 + arb_below(a, 50), far = 65600 + arb_below(a, 200);
    double at[ENGINE_AXES];

    for (unsigned k = 0; k < 3; k++) {
        engine_curve *held = NULL;
        curves all;
        char *text = saw_text(kinds[k].head, n);
        CHECK(read_text(&all, text) == 0 && all.count == 1 && all.curve[0].count == n &&
              curve_pieces(&all.curve[0]) == n - kinds[k].least);
        CHECK(engine_f64.curve->open(&all.curve[0], &held) == 0);
        if (held != NULL && engine_f64.curve->eval(held, far - (k == 2), at) == 0) {
            CHECK_NEAR(at[0], far / 100.0, 1e-9);
            CHECK_NEAR(at[1], far % 3, 1e-9);
            engine_f64.curve->close(held);
        } else {
            CHECK(false);
        }
        free(text);
        curves_free(&all);
    }
    char *text = saw_text("bspline 3", 32001);
    REFUSES_TEXT(text, "f.loft:32002: more than 32000 points");
    free(text);
}


// Drawings of curves
// ------------------

static int read_drawing(drawing *d, const char *text)
{
    hear();
    *d = (drawing){ 0 };
    return drawing_read_curves(&heard, d, "f.loft", text);
}

static void curves_become_paths(arb *a)
{
    char got[1024];
    drawing d;
    (void)a;
    CHECK(read_drawing(&d, "bezier 3\n0 0\n0 10\n10 10\n10 0\nline\n10 0\n20 0\n20 5\nbezier 2\n0 "
                           "0\n3 3\n6 0\nbezier 0\n6 0\n") == 0);
    put_drawing(got, sizeof got, &d, 0);
    if (strcmp(got, "M 0 0 C 0 -10 10 -10 10 0 L 20 0 L 20 -5 M 0 0 C 2 -2 4 -2 6 0") != 0) {
        printf("drawn %s\n", got);
        check_bad = true;
    }
    CHECK(d.count == 4 && d.curve[1].line == 6 && d.curve[3].line == 10 && d.curve[3].path == 1);
    drawing_free(&d);
    CHECK(read_drawing(&d, "\nline\n0 0\n1 1 2\n") == 0 && d.count == 1 && d.curve[0].z[0] == 0 &&
          d.curve[0].z[3] == 2);
    CHECK_NEAR(drawing_length(&d), sqrt(6), 1e-9);
    CHECK_NEAR(drawing_top(&d), 2, 0);
    drawing_free(&d);
    CHECK(read_drawing(&d, "line\n0 0 1\n5 0 1\nline\n5 0 2\n9 0 2\n") == 0 && d.count == 2 &&
          d.curve[1].path == 1);
    drawing_free(&d);
    CHECK(read_drawing(&d, "line\n0 0\n1 1 17000\n") == EX_DATAERR &&
          strstr(caught, "f.loft:1: 17000 mm is beyond") != NULL && caught_lines == 1);
    drawing_free(&d);
    CHECK(read_drawing(&d, "\n\nline\n0 0\n1 17000\n") == EX_DATAERR &&
          strstr(caught, "f.loft:3: 17000 mm is beyond") != NULL && caught_lines == 1);
    drawing_free(&d);
}

/* A quarter of a circle with weights: its cubics stay on the circle, and join. */
static void rational_curves_become_cubics(arb *a)
{
    const double r = 0.01 + (double)arb_below(a, 1000);
    char text[200];
    drawing d;

    snprintf(text, sizeof text, "rational 2\n%.17g 0\n%.17g %.17g : %.17g\n0 %.17g\n", r, r, r,
             sqrt(0.5), r);
    CHECK(read_drawing(&d, text) == 0 && d.count >= 1 && d.curve[d.count - 1].path == 0);
    for (size_t i = 0; i < d.count; i++)
        for (int j = 0; j <= 64; j++) {
            double p[2];
            drawing_eval(&d.curve[i], j / 64.0, p);
            CHECK_NEAR(hypot(p[0], p[1]), r, 1e-4);
        }
    drawing_free(&d);
}

/* Of degrees above those of the library, in drawings alone: y over x, and a circle with weights
 * that was raised. */
static void curves_of_high_degree_become_cubics(arb *a)
{
    const unsigned n = 10 + arb_below(a, CURVE_DRAWN_MAX - 9);
    double y[CURVE_DRAWN_MAX + 1],
        w[CURVE_DRAWN_MAX + 1] = { 1, sqrt(0.5), 1 },
                            x[CURVE_DRAWN_MAX + 1][2] = { { 9, 0 },
                                                          { 9 * sqrt(0.5), 9 * sqrt(0.5) },
                                                          { 0, 9 } };
    char text[4096], high[4096];
    size_t used = 0, also = 0;
    drawing d;
    curves all;

    for (unsigned m = 2; m < n; m++)
        for (unsigned k = m + 1; k > 0; k--) {
            const double share = (double)k / (m + 1);
            w[k] = (k > m ? 0 : (1 - share) * w[k]) + share * w[k - 1];
            for (int i = 0; i < 2; i++)
                x[k][i] = (k > m ? 0 : (1 - share) * x[k][i]) + share * x[k - 1][i];
        }
    for (unsigned k = 0; k <= n; k++) {
        y[k] = (double)arb_below(a, 50000) / 1000;
        used += (size_t)snprintf(text + used, sizeof text - used, "%s%u %.17g\n",
                                 k ? "" : "bezier\n", 10 * k, y[k]);
        also += (size_t)snprintf(high + also, sizeof high - also, "%s%.17g %.17g : %.17g\n",
                                 k ? "" : "rational\n", x[k][0] / w[k], x[k][1] / w[k], w[k]);
    }
    CHECK(read_drawing(&d, text) == 0 && d.count >= 1 && d.curve[d.count - 1].path == 0);
    for (size_t i = 0; i < d.count; i++)
        for (int j = 0; j <= 16; j++) {
            double p[2], row[CURVE_DRAWN_MAX + 1];
            drawing_eval(&d.curve[i], j / 16.0, p);
            memcpy(row, y, sizeof row);
            for (unsigned m = n; m > 0; m--)
                for (unsigned k = 0; k < m; k++)
                    row[k] += p[0] / (10 * n) * (row[k + 1] - row[k]);
            CHECK_NEAR(p[1], row[0], 6e-4);             /* slopes are at most 5 */
        }
    drawing_free(&d);
    CHECK(read_drawing(&d, high) == 0 && d.count >= 1);
    for (size_t i = 0; i < d.count; i++)
        for (int j = 0; j <= 16; j++) {
            double p[2];
            drawing_eval(&d.curve[i], j / 16.0, p);
            CHECK_NEAR(hypot(p[0], p[1]), 9, 1e-4);
        }
    drawing_free(&d);
    CHECK(read_text(&all, text) == EX_DATAERR && strstr(caught, "give at most 10") != NULL);
    curves_free(&all);
}

int main(void)
{
    PROPERTY(every_kind_is_read, 1);
    PROPERTY(what_is_wrong_is_said_with_its_line, 1);
    PROPERTY(a_file_is_known_by_its_first_word, 1);
    PROPERTY(any_text_is_read_or_refused, 20000);
    PROPERTY(a_curve_may_have_many_points, 2);
    PROPERTY(curves_become_paths, 1);
    PROPERTY(rational_curves_become_cubics, 50);
    PROPERTY(curves_of_high_degree_become_cubics, 100);
    return check_failures();
}
