/* tests/tools/test_svg.c -- what the SVG reader draws, command by command, and what it refuses
 * SPDX-License-Identifier: MIT
 */
#include <time.h>       /* clock: processor time */

#include "tools/drawn.h"
#include "svg/svg_file.h"


// Path data
// ---------

/* Other programs draw the rest; so does this one, and reports once what is missing. */
#define TELLS(inner, wanted, words) check_tells(PAGE(inner), wanted, words, __FILE__, __LINE__)
static void check_tells(const char *text, const char *wanted, const char *words, const char *file,
                        int line)
{
    check_draws(text, 100, wanted, file, line);
    if (caught_lines != (words[0] != '\0') || strstr(caught, words) == NULL) {
        printf("%s:%d: %u lines: %s\n  wanted: %s\n", file, line, caught_lines, caught, words);
        check_bad = true;
    }
}

/* What cannot be read is as if it were not given: the rest is drawn. */
#define LACKS(inner, words) TELLS(inner "<path d='M2 2h1'/>", "M 2 2 L 3 2", words)


static void lines_absolute_and_relative(arb *a)
{
    (void)a;
    DRAWS_PATH("M10 20L30 40 50 60",            "M 10 20 L 30 40 L 50 60");
    DRAWS_PATH("m10 20l20 20 20 20",            "M 10 20 L 30 40 L 50 60");
    DRAWS_PATH("M10 20 30 40 50 60",            "M 10 20 L 30 40 L 50 60");
    DRAWS_PATH("m10 20 20 20 20 20",            "M 10 20 L 30 40 L 50 60");
    DRAWS_PATH("M1 1H5 9V5 7",                  "M 1 1 L 5 1 L 9 1 L 9 5 L 9 7");
    DRAWS_PATH("M1 1h5 9v5 7",                  "M 1 1 L 6 1 L 15 1 L 15 6 L 15 13");
    DRAWS_PATH("M1 1H5M2 2H6",                  "M 1 1 L 5 1 M 2 2 L 6 2");
    DRAWS_PATH("M1 1h5m2 2h6",                  "M 1 1 L 6 1 M 8 3 L 14 3");
}

static void closing_goes_back_to_the_start(arb *a)
{
    (void)a;
    DRAWS_PATH("M1 1H5V5Z",                     "M 1 1 L 5 1 L 5 5 L 1 1");
    DRAWS_PATH("M1 1H5V5zm10 0h2v2z", "M 1 1 L 5 1 L 5 5 L 1 1 M 11 1 L 13 1 L 13 3 L 11 1");
    DRAWS_PATH("M1 1H5V5z h-1",                 "M 1 1 L 5 1 L 5 5 L 1 1 M 1 1 L 0 1");
    DRAWS_PATH("M1 1H5V5L1 1Z",                 "M 1 1 L 5 1 L 5 5 L 1 1");
}

static void cubics_and_their_reflections(arb *a)
{
    (void)a;
    DRAWS_PATH("M1 2C3 4 5 9 7 8",              "M 1 2 C 3 4 5 9 7 8");
    DRAWS_PATH("M1 2c2 2 4 7 6 6",              "M 1 2 C 3 4 5 9 7 8");
    DRAWS_PATH("M1 2C3 4 5 9 7 8 9 8 9 2 1 1",  "M 1 2 C 3 4 5 9 7 8 C 9 8 9 2 1 1");
    DRAWS_PATH("M1 2C3 4 5 9 7 8S9 9 10 2",     "M 1 2 C 3 4 5 9 7 8 C 9 7 9 9 10 2");
    DRAWS_PATH("M1 2C3 4 5 9 7 8s2 1 3-6",      "M 1 2 C 3 4 5 9 7 8 C 9 7 9 9 10 2");
    DRAWS_PATH("M1 2C3 4 5 9 7 8S9 9 10 2 1 3 5 5",
               "M 1 2 C 3 4 5 9 7 8 C 9 7 9 9 10 2 C 11 -5 1 3 5 5");
    DRAWS_PATH("M1 2S3 4 5 9",                  "M 1 2 C 1 2 3 4 5 9");
    DRAWS_PATH("M1 2Q4 5 7 2S9 9 10 2",         "M 1 2 C 3 4 5 4 7 2 C 7 2 9 9 10 2");
    DRAWS_PATH("M1 2C3 4 5 9 7 8L8 8S9 9 10 2", "M 1 2 C 3 4 5 9 7 8 L 8 8 C 8 8 9 9 10 2");
}

static void quadratics_and_their_reflections(arb *a)
{
    (void)a;
    DRAWS_PATH("M1 2Q4 5 7 2",                  "M 1 2 C 3 4 5 4 7 2");
    DRAWS_PATH("M1 2q3 3 6 0",                  "M 1 2 C 3 4 5 4 7 2");
    DRAWS_PATH("M1 2Q4 5 7 2T13 2",             "M 1 2 C 3 4 5 4 7 2 C 9 0 11 0 13 2");
    DRAWS_PATH("M1 2q3 3 6 0t6 0 6 0", "M 1 2 C 3 4 5 4 7 2 C 9 0 11 0 13 2 C 15 4 17 4 19 2");
    DRAWS_PATH("M1 2C3 4 5 9 7 8T10 2",         "M 1 2 C 3 4 5 9 7 8 C 7 8 8 6 10 2");
    DRAWS_PATH("M1 2T10 2",                     "M 1 2 C 1 2 4 2 10 2");
}

static void numbers_without_separators(arb *a)
{
    (void)a;
    DRAWS_PATH("M1.5.5-3e-1+2",                 "M 1.5 0.5 L -0.3 2");
    DRAWS_PATH("M1e1,1.E+1L.5,-.5",             "M 10 10 L 0.5 -0.5");
    DRAWS_PATH("\n M\t1 , 1 \r\n l 2-3 \n",     "M 1 1 L 3 -2");
    DRAWS_PATH("M0 0a5 5 0 0110 0",
               "M 0 0 C 0 -1.786 0.953 -3.437 2.5 -4.33 C 4.047 -5.223 5.953 -5.223 7.5 -4.33"
               " C 9.047 -3.437 10 -1.786 10 0");
    DRAWS_PATH("M0 0a5 5 0 00.1.1 5 5 0 00.1.1",
               "M 0 0 C 0.033 0.034 0.066 0.067 0.1 0.1 C 0.133 0.134 0.166 0.167 0.2 0.2");
}

static void arcs_that_are_lines_or_nothing(arb *a)
{
    (void)a;
    DRAWS_PATH("M1 1A0 5 0 0 1 9 1",            "M 1 1 L 9 1");
    DRAWS_PATH("M1 1A5 0 0 0 1 9 1",            "M 1 1 L 9 1");
    DRAWS_PATH("M1 1A5 5 0 1 1 1 1H2",          "M 1 1 L 2 1");
    DRAWS_PATH("M1 1A1e11 1e11 0 0 1 9 1",      "M 1 1 L 9 1");
}

static void what_has_no_length_is_dropped(arb *a)
{
    (void)a;
    DRAWS_PATH("M1 1zM2 2h0l0 0M3 3H4",         "M 3 3 L 4 3");
    DRAWS_PATH("M1 1h0h2h0h2",                  "M 1 1 L 3 1 L 5 1");
    DRAWS_PATH("M5 5h1M9 9",                    "M 5 5 L 6 5");
    DRAWS("<path/><path d=''/><path d=' none'/><path d='M1 1h1'/>", "M 1 1 L 2 1");
    DRAWS("<g transform='scale(0 1)'><path d='M1 1h1v1'/></g><path d='M1 1h1'/>", "M 1 1 L 2 1");
}

#define DRAWS_UNTIL(data, wanted, words)                                                           \
    do {                                                                                           \
        DRAWS_PATH(data, wanted);                                                                  \
        CHECK(caught_lines == 1 && strstr(caught, words) != NULL);                                 \
    } while (0)

static void path_data_is_drawn_up_to_its_first_error(arb *a)
{
    (void)a;
    DRAWS("\n\n<path d='M1 1H5L2 x'/><path d='M6 6H7'/>", "M 1 1 L 5 1 M 6 6 L 7 6");
    CHECK(
        caught_lines == 1 &&
        strstr(caught, "test.svg:3: path data: \"x\" behind \"M1 1H5L2 \": a number is expected"));
    DRAWS_UNTIL("L1 1",                        "", "M is expected");
    DRAWS_UNTIL("M1 1H5L2",                    "M 1 1 L 5 1", "ends after \"M1 1H5L2\"");
    DRAWS_UNTIL("M1 1L2 2,",                   "M 1 1 L 2 2", "a number is missing");
    DRAWS_UNTIL("M1 1 2 2 G2 2",               "M 1 1 L 2 2", "one of MLHVCSQTAZ");
    DRAWS_UNTIL("M1 1H2A5 5 0 2 0 9 9",        "M 1 1 L 2 1", "a flag");
    DRAWS_UNTIL("M1 1L0 1 0x10 2",             "M 1 1 L 0 1", "\"x10 2\"");
    DRAWS_UNTIL("M1 1H2Lnan 2",                "M 1 1 L 2 1", "\"nan 2\"");
    DRAWS_UNTIL("M1 1H2Linf 2",                "M 1 1 L 2 1", "\"inf 2\"");
}

static void points_that_no_machine_reaches_are_left_out(arb *a)
{
    (void)a;
    LACKS("<path d='M1 1L1e9 2'/>",
          "<path> is not drawn, a point at 3.33333e+08 mm is beyond +-16000");
    LACKS("<path d='M1 1L1e999 2'/>", "beyond +-16000 mm");
    LACKS("<polyline points='1 1 17000 2 1 5'/><rect x='16000' width='1' height='1'/>", "beyond");
    LACKS("<path d='M1 1a1e300 1 0 1 1 5 5'/>", "radius");
    TELLS("<clipPath id='c'><rect x='-1e5' y='-1e5' width='2e5' height='2e5'/></clipPath>"
          "<path clip-path='url(#c)' d='M2 2h1'/>",
          "M 2 2 L 3 2", "");
}


// Basic shapes
// ------------

#define ROUND_3                                                                                    \
    "C 3 0.796 2.684 1.559 2.121 2.121 C 1.559 2.684 0.796 3 0 3 C -0.796 3 -1.559 2.684 -2.121 "  \
    "2.121 C -2.684 1.559 "                                                                        \
    "-3 0.796 -3 0 C -3 -0.796 -2.684 -1.559 -2.121 -2.121 C -1.559 -2.684 -0.796 -3 0 -3 C "      \
    "0.796 -3 1.559 -2.684 2.121 -2.121 "                                                          \
    "C 2.684 -1.559 3 -0.796 3 0"

static void shapes(arb *a)
{
    (void)a;
    DRAWS("<line x1='1' y1='2' x2='3' y2='4'/>",            "M 1 2 L 3 4");
    DRAWS("<line x2='3'/>",                                 "M 0 0 L 3 0");
    DRAWS("<polyline points='1,2 3,4,5 6'/>",               "M 1 2 L 3 4 L 5 6");
    DRAWS("<polygon points='1-2,3-4 5 6'/>",                "M 1 -2 L 3 -4 L 5 6 L 1 -2");
    DRAWS("<rect x='1' y='2' width='3' height='4'/>",       "M 1 2 L 4 2 L 4 6 L 1 6 L 1 2");
    DRAWS("<circle r='3'/>",                                "M 3 0 " ROUND_3);
    DRAWS("<ellipse rx='3' ry='3'/>",                       "M 3 0 " ROUND_3);
    DRAWS("<ellipse rx='3'/>",                              "M 3 0 " ROUND_3);
    DRAWS("<circle r='0'/><rect width='3'/><rect width='0' height='1'/><ellipse rx='3' "
          "ry='0'/><circle/><path d='M1 1h1'/>",
          "M 1 1 L 2 1");
}

/* The corners of <rect>: a missing radius equals the other, and none is more than half a side. */
static void rounded_corners(arb *a)
{
    static const struct {
        const char *radii;
        double rx, ry;
    } all[] = { { "rx='3' ry='2'", 3, 2 },   { "rx='3'", 3, 3 },   { "ry='2'", 2, 2 },
                { "rx='30' ry='2'", 10, 2 }, { "rx='30'", 10, 5 }, { "rx='10%' ry='auto'", 10, 5 },
                { "rx='3' ry='0'", 0, 0 },   { "rx='auto'", 0, 0 } };
    (void)a;
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        char text[300];
        drawing d;
        double box[2][2], along = 0, down = 0;

        snprintf(text, sizeof text, PAGE("<rect x='1' y='2' width='20' height='10' %s/>"),
                 all[i].radii);
        CHECK(read_svg(&d, text) == 0 && drawing_box(&d, box));
        CHECK_NEAR(box[0][0], 1, 1e-9);
        CHECK_NEAR(box[1][0], 21, 1e-9);
        CHECK_NEAR(box[1][1], 98, 1e-9);
        CHECK_NEAR(box[0][1], 88, 1e-9);
        for (size_t k = 0; k < d.count; k++)
            if (is_line(&d.curve[k])) {
                along += fabs(d.curve[k].p[3][0] - d.curve[k].p[0][0]);
                down  += fabs(d.curve[k].p[3][1] - d.curve[k].p[0][1]);
            }
        CHECK_NEAR(along, 2 * (20 - 2 * all[i].rx), 1e-9);
        CHECK_NEAR(down,  2 * (10 - 2 * all[i].ry), 1e-9);
        drawing_free(&d);
    }
}

static void broken_shapes_are_drawn_without_their_faults(arb *a)
{
    (void)a;
    LACKS("<rect width='-1' height='1'/>",    "width=-1 is not used: a size cannot be negative");
    LACKS("<circle r='-1'/>",                 "r=-1 is not used");
    LACKS("\n<rect width='5zz' height='1'/>",
          "test.svg:2: width=\"5zz\" is not used: give a number with px mm");
    LACKS("<rect width='5 5' height='1'/>",   "width=\"5 5\" is not used: give one length");
    LACKS("<rect width='NaN' height='1'/>",   "width=\"NaN\"");
    LACKS("<rect width='10vw' height='1'/>",  "width=\"10vw\"");
    TELLS("<line x1='a' y1='2' x2='3' y2='2'/>", "M 0 2 L 3 2", "x1=\"a\"");
    TELLS("<rect x='1' y='2' width='3' height='4' rx='-2'/>", "M 1 2 L 4 2 L 4 6 L 1 6 L 1 2",
          "rx=-2");
    TELLS("<ellipse rx='3' ry='-2'/>",        "M 3 0 " ROUND_3, "ry=-2");
    DRAWS("<polygon points='1 2 3 4 5'/>",          "M 1 2 L 3 4 L 1 2");
    CHECK(caught_lines == 1 && strstr(caught, "5 numbers: give x and y"));
    DRAWS("<polyline points='1 2 3 4 b'/>",         "M 1 2 L 3 4");
    CHECK(caught_lines == 1 && strstr(caught, "\"b\" behind 4 numbers"));
}


// Transforms and units
// --------------------

#define MOVED(transform, wanted)                                                                   \
    DRAWS("<g transform='" transform "'><path d='M1 2L3 5'/></g>", wanted)

static void every_transform(arb *a)
{
    (void)a;
    MOVED("translate(10,20)",                       "M 11 22 L 13 25");
    MOVED("translate(10)",                          "M 11 2 L 13 5");
    MOVED("scale(2)",                               "M 2 4 L 6 10");
    MOVED("scale(2 -3)",                            "M 2 -6 L 6 -15");
    MOVED("rotate(90)",                             "M -2 1 L -5 3");
    MOVED("rotate(-90)",                            "M 2 -1 L 5 -3");
    MOVED("rotate(450)",                            "M -2 1 L -5 3");
    MOVED("rotate(180,10,10)",                      "M 19 18 L 17 15");
    MOVED("rotate(30)",                             "M -0.134 2.232 L 0.098 5.83");
    MOVED("skewX(45)",                              "M 3 2 L 8 5");
    MOVED("skewY(45)",                              "M 1 3 L 3 8");
    MOVED("matrix(1 2 3 4 5 6)",                    "M 12 16 L 23 32");
    MOVED(" translate(10 20) , scale(2)rotate(90)", "M 6 22 L 0 26");
    MOVED("none",                                   "M 1 2 L 3 5");
    MOVED("",                                       "M 1 2 L 3 5");
    DRAWS("<g transform='translate(10 20)'><g transform='scale(2)'><path transform='rotate(90)' "
          "d='M1 2L3 5'/></g></g>",
          "M 6 22 L 0 26");
    DRAWS("<g style='transform: translate(10px, 20px) rotate(90deg)'><path d='M1 2L3 5'/></g>",
          "M 8 21 L 5 23");
}

static void transforms_are_about_their_origin(arb *a)
{
    (void)a;
    DRAWS("<path transform='rotate(90)' transform-origin='10 10' d='M1 2L3 5'/>", "M 18 1 L 15 3");
    DRAWS("<path style='transform: scale(2); transform-origin: 1px 2px' d='M1 2L3 5'/>",
          "M 1 2 L 5 8");
    DRAWS("<path transform='scale(2)' transform-origin='left bottom' d='M0 100L3 95'/>",
          "M 0 100 L 6 90");
    DRAWS("<path transform='scale(2)' transform-origin='bottom left' d='M0 100L3 95'/>",
          "M 0 100 L 6 90");
    DRAWS("<path transform='scale(2)' transform-origin='center left' d='M0 50L3 55'/>",
          "M 0 50 L 6 60");
    DRAWS("<path transform='scale(2)' transform-origin='center' d='M50 50L55 60'/>",
          "M 50 50 L 60 70");
    DRAWS("<path transform='scale(2)' transform-origin='10%' d='M10 50L15 60'/>",
          "M 10 50 L 20 70");
    DRAWS("<path transform-origin='10 10' d='M1 2L3 5'/>", "M 1 2 L 3 5");
    DRAWS("<path transform='scale(2)' style='transform-box: fill-box' d='M1 2L3 5'/>",
          "M 2 4 L 6 10");
    CHECK(strstr(caught, "transform-box: fill-box is read as view-box") != NULL);
    TELLS("<path transform='scale(2)' transform-origin='3 x' d='M1 2L3 5'/>", "M 2 4 L 6 10",
          "transform-origin=\"3 x\" is not used: give a number");
}

#define MISSES(transform, words)                                                                  \
    TELLS("<g transform='" transform "'><path d='M2 2h1'/></g>", "M 2 2 L 3 2", words)

static void broken_transforms_transform_nothing(arb *a)
{
    (void)a;
    MISSES("translate(9) rotate(10deg)", "\"rotate(10deg)\" is not one of");
    DRAWS("<g style='transform:translateY(2px) rotate(.25turn) scaleX(3)'><path d='M2 0h1'/></g>",
          "M 0 8 L 0 11");
    MISSES("rotat(3)", "transform: \"rotat(3)\" is not one of");
    MISSES("scale(1 2 3)", "is not one of");
    MISSES("scale(1", "is not one of");
    MISSES("scale()", "is not one of");
    MISSES("rotate(1,2)", "is not one of");
    MISSES("scale(2px)", "is not one of");
    MISSES("matrix(1 2 3 4 5)", "is not one of");
}

/* 1e999 is read as infinite, and two large factors become infinite: one line names the
 * transform. */
static void numbers_beyond_arithmetic_do_no_harm(arb *a)
{
    (void)a;
    LACKS("\n<g transform='rotate(1e999)'/>",
          "test.svg:2: transform: \"rotate(1e999)\" is too large");
    LACKS("<g transform='rotate(-1e999)'/>",      "\"rotate(-1e999)\" is too large");
    LACKS("<g transform='rotate(1e999 1 1)'/>",   "is too large");
    LACKS("<g transform='rotate(1 1e999 1)'/>",   "is too large");
    LACKS("<g transform='translate(1e999)'/>",    "is too large");
    LACKS("<g transform='scale(1,1e999)'/>",      "is too large");
    LACKS("<g transform='skewX(1e999)'/>",        "is too large");
    LACKS("<g transform='skewY(-1e999)'/>",       "is too large");
    LACKS("<g transform='matrix(1 0 0 1 0 1e999)'/>", "is too large");
    LACKS("<g style='transform:rotate(1e999deg)'><path d='M1 1h1'/></g>",  "is too large");
    LACKS("<g transform='scale(1e200)'><g transform='translate(3) scale(1e200)'/></g>",
          "transform: \"scale(1e200)\" is too large");
    LACKS("<rect width='1e999' height='1'/>",     "width=\"1e999\" is not used, it is too large");
    LACKS("<line x1='1e308in'/>",                 "x1=\"1e308in\" is not used, it is too large");
    LACKS("<svg viewBox='0 0 1e999 1'/>",         "viewBox=\"0 0 1e999 1\" is not used");
    LACKS("<svg viewBox='0 0 1e-320 1' preserveAspectRatio='none'/>", "too small to fill");
}

#define SIZED(attributes, inner)                                                                   \
    "<svg xmlns='http://www.w3.org/2000/svg' " attributes ">" inner "</svg>"

static void every_unit(arb *a)
{
    (void)a;
    DRAWS_ON(25.4, SIZED("width='96' height='96'", "<line x2='96px'/>"), "M 0 0 L 25.4 0");
    DRAWS_ON(10,      SIZED("width='10mm' height='10mm'",   "<line x2='5mm'/>"),    "M 0 0 L 5 0");
    DRAWS_ON(10,      SIZED("width='1cm' height='1cm'",     "<line x2='.5cm'/>"),   "M 0 0 L 5 0");
    DRAWS_ON(25.4, SIZED("width='1in' height='1in'", "<line x2='1in'/>"), "M 0 0 L 25.4 0");
    DRAWS_ON(25.4, SIZED("width='72pt' height='72pt'", "<line x2='72pt'/>"), "M 0 0 L 25.4 0");
    DRAWS_ON(25.4, SIZED("width='6pc' height='6pc'", "<line x2='6pc'/>"), "M 0 0 L 25.4 0");
    DRAWS_ON(10,      SIZED("width='40Q' height='40Q'",     "<line x2='20Q'/>"),    "M 0 0 L 5 0");
    DRAWS_ON(10,      SIZED("width='10MM' height='10mm'",   "<line x2='50%'/>"),    "M 0 0 L 5 0");
    DRAWS_ON(10, SIZED("width='20mm' height='10mm'", "<line x2='50%' y2='50%'/>"), "M 0 0 L 10 5");
    DRAWS_ON(100,     PAGE("<line x1='5mm' x2='5'/>"),      "M 18.898 0 L 5 0");
}

/* A page without sizes has those of its viewBox in px; a page of unknown size starts at the
 * drawing's corner. */
static void pages_of_unknown_size(arb *a)
{
    (void)a;
    DRAWS_ON(25.4, SIZED("viewBox='0 0 192 96'", "<line x2='96'/>"), "M 0 0 L 25.4 0");
    DRAWS_ON(25.4, SIZED("viewBox='0 0 192 96' width='100%' height='100%'", "<line x2='96'/>"),
             "M 0 0 L 25.4 0");
    DRAWS_ON(10, SIZED("viewBox='0 0 192 96' width='20mm'", "<line x2='96'/>"), "M 0 0 L 10 0");
    DRAWS_ON(10, SIZED("viewBox='0 0 192 96' height='10mm'", "<line x2='96'/>"), "M 0 0 L 10 0");
    DRAWS_ON(10, SIZED("viewBox='-96 -48 192 96' height='10mm'", "<line x2='96'/>"),
             "M 10 5 L 20 5");
    DRAWS_ON(25.4, SIZED("", "<path d='M96 96h96v96'/>"), "M 0 0 L 25.4 0 L 25.4 25.4");
    drawing d;
    CHECK(read_svg(&d, SIZED("", "<rect width='50%' height='1'/><line x2='1'/>")) == 0 &&
          d.count == 1 && strstr(caught, "size is not known") != NULL);
    drawing_free(&d);
    CHECK(read_svg(&d, SIZED("viewBox='0 0 192 96' width='20mm'", "<line x2='96'/>")) == 0);
    CHECK_NEAR(d.width, 20, 1e-12);
    CHECK_NEAR(d.height, 10, 1e-12);
    drawing_free(&d);
}

/* A square of ten units in 40 x 20 mm: it fits twice and leaves 20 mm across, or covers four times
 * and exceeds 20 mm downwards. */
static void every_aspect_ratio(arb *a)
{
    static const char *const names[3] = { "Min", "Mid", "Max" };
    (void)a;
    for (int x = 0; x < 3; x++)
        for (int y = 0; y < 3; y++)
            for (int slice = 0; slice < 2; slice++) {
                char text[300], wanted[80];
                const int ox = slice ? 0 : 10 * x, oy = slice ? -10 * y : 0, s = slice ? 4 : 2;
                snprintf(text, sizeof text,
                         SIZED("width='40mm' height='20mm' viewBox='0 0 10 10' "
                               "preserveAspectRatio='x%sY%s%s'",
                               "<path d='M0 0L5 10'/>"),
                         names[x], names[y],
                         slice ? " slice"
                         : y   ? " meet"
                               : "");
                snprintf(wanted, sizeof wanted, "M %d %d L %d %d", ox, oy, ox + 5 * s, oy + 10 * s);
                DRAWS_ON(20, text, wanted);
            }
    DRAWS_ON(20,
             SIZED("width='40mm' height='20mm' viewBox='5 0 10 10' preserveAspectRatio='none'",
                   "<path d='M5 0L10 10'/>"),
             "M 0 0 L 20 20");
    DRAWS_ON(20, SIZED("width='40mm' height='20mm' viewBox='0,0,10,10'", "<path d='M0 0L5 10'/>"),
             "M 10 0 L 20 20");
    LACKS("<svg viewBox='0 0 1 1' preserveAspectRatio='xMidYmid'/>",
          "preserveAspectRatio=\"xMidYmid\"");
    LACKS("<svg viewBox='0 0 1 1' preserveAspectRatio='xMidYMidmeet'/>", "preserveAspectRatio");
    LACKS("<svg viewBox='0 0 1'/>", "viewBox=\"0 0 1\"");
    LACKS("<svg viewBox='0 0 -1 1'/>", "viewBox");
}

static void viewports_within_the_page(arb *a)
{
    (void)a;
    DRAWS("<svg x='10' y='20'><path d='M1 2h5'/></svg>", "M 11 22 L 16 22");
    DRAWS(
        "<svg x='10' y='20' width='50' height='50' viewBox='0 0 100 100'><path d='M2 2h10'/></svg>",
        "M 11 21 L 16 21");
    DRAWS("<svg width='50' height='20'><line x2='50%' y2='50%'/></svg>", "M 0 0 L 25 10");
    DRAWS("<svg viewBox='0 0 10 10'><line x2='50%' y2='50%'/></svg>", "M 0 0 L 50 50");
    DRAWS("<svg width='0'><path d='M1 2h5'/></svg><path d='M0 0h1'/>", "M 0 0 L 1 0");
    DRAWS("<svg viewBox='0 0 0 5'><path d='M1 2h5'/></svg><path d='M0 0h1'/>", "M 0 0 L 1 0");
    TELLS("<svg width='-5'><path d='M1 2h5'/></svg>", "M 1 2 L 6 2", "cannot be negative");
}


// Structure
// ---------

static void use_draws_again(arb *a)
{
    (void)a;
    DRAWS("<defs><path id='a' d='M1 2h3'/></defs><use href='#a' x='10' y='20'/>",
          "M 11 22 L 14 22");
    DRAWS("<defs><path id='a' d='M1 2h3'/></defs><use xlink:href='#a' transform='scale(2)' x='1'/>",
          "M 4 4 L 10 4");
    DRAWS("<path id='a' d='M1 2h3'/><use href='#a' y='5'/>", "M 1 2 L 4 2 M 1 7 L 4 7");
    DRAWS("<use href='#b'/><defs><g id='b'><use href='#a' x='1'/></g><path id='a' "
          "transform='scale(2)' d='M1 2h3'/></defs>",
          "M 3 4 L 9 4");
    DRAWS("<path id='a' d='M1 1h1'/><path id='a' d='M2 2h1'/><use href='#a' y='5'/>",
          "M 1 1 L 2 1 M 2 2 L 3 2 M 1 6 L 2 6");
    DRAWS(
        "<path id='a' d='M1 1h1'/><path id='b' d='M2 2h1'/><use href='#a' xlink:href='#b' y='5'/>",
        "M 1 1 L 2 1 M 2 2 L 3 2 M 1 6 L 2 6");
}

static void symbols_are_drawn_by_use_alone(arb *a)
{
    (void)a;
    DRAWS("<symbol id='s'><path d='M1 2h3'/></symbol><use href='#s' x='10'/>", "M 11 2 L 14 2");
    DRAWS("<symbol id='s' viewBox='0 0 10 10'><path d='M1 2h3'/></symbol><use href='#s'/>",
          "M 10 20 L 40 20");
    DRAWS("<symbol id='s' viewBox='0 0 10 10'><path d='M1 2h3'/></symbol><use href='#s' x='5' "
          "width='20' height='20'/>",
          "M 7 4 L 13 4");
    DRAWS("<symbol id='s' viewBox='0 0 10 10' width='20' height='20'><path d='M1 "
          "2h3'/></symbol><use href='#s'/>",
          "M 2 4 L 8 4");
    DRAWS("<svg id='s' viewBox='0 0 10 10' width='20' height='20'><path d='M1 2h3'/></svg><use "
          "href='#s' width='40' height='40'/>",
          "M 2 4 L 8 4 M 4 8 L 16 8");
}

static void circular_uses_draw_nothing(arb *a)
{
    (void)a;
    LACKS("<g id='a'><use href='#a'/></g>", "<use> of \"#a\" is not drawn, it uses itself");
    LACKS("<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g>",     "uses itself");
    LACKS("<use id='a' href='#a'/>",                                          "uses itself");
}

/* Ten uses of ten uses of .. : few bytes that would draw for years. */
static void a_flood_of_uses_is_stopped(arb *a)
{
    static char text[4000];
    (void)a;
    strcpy(text, "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1 1'><defs><g id='g0'/>");
    for (int i = 0; i < 12; i++) {
        sprintf(text + strlen(text), "<g id='g%d'>", i + 1);
        for (int k = 0; k < 10; k++)
            sprintf(text + strlen(text), "<use href='#g%d'/>", i);
        strcat(text, "</g>");
    }
    strcat(text, "</defs><use href='#g12'/></svg>");
    check_refuses(text, "counting each use", __FILE__, __LINE__);
}

/* Nested elements, written so or by <use>: the reader's stack is limited. */
static void depth_is_bounded(arb *a)
{
    enum { FILES = 23, GROUPS = 240 };
    static char text[FILES * GROUPS * 8 + 40000];
    char *end = text;
    (void)a;
    end += sprintf(end, "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1 1'><defs>");
    for (int i = 0; i < FILES; i++) {
        end += sprintf(end, "<g id='g%d'>", i);
        for (int k = 0; k < GROUPS; k++)
            end += sprintf(end, "<g>");
        end += sprintf(end, "<use href='#g%d'/>", i + 1);
        for (int k = 0; k <= GROUPS; k++)
            end += sprintf(end, "</g>");
    }
    sprintf(end, "<g id='g%d'/></defs><use href='#g0'/></svg>", FILES);
    check_refuses(text, "<g>: more than 500 nested elements, counting each use", __FILE__,
                  __LINE__);

    end = text + sprintf(text, "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1 1'><path "
                               "id='g0' d='M0 0h1'/><defs>");
    for (int i = 0; i < 600; i++)
        end += sprintf(end, "<use id='g%d' href='#g%d'/>", i + 1, i);
    sprintf(end, "</defs><use href='#g600'/></svg>");
    check_refuses(text, "nested elements, counting each use", __FILE__, __LINE__);
    sprintf(end, "</defs><use href='#g100' x='5'/></svg>");
    DRAWS_ON(25.4 / 96, text, "M 0 0 L 0.265 0 M 1.323 0 L 1.588 0");

    end = text + sprintf(text, "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1 1'>\n");
    for (int k = 0; k < 600; k++)
        end += sprintf(end, "<g>");
    for (int k = 0; k < 600; k++)
        end += sprintf(end, "</g>");
    sprintf(end, "</svg>");
    check_refuses(text, "test.svg:2: more than 500 nested elements: draw with fewer groups",
                  __FILE__, __LINE__);
}

static void switch_draws_the_first_that_applies(arb *a)
{
    (void)a;
    DRAWS("<switch><path d='M1 1h1'/><path d='M2 2h1'/></switch>", "M 1 1 L 2 1");
    DRAWS("<switch><foreignObject requiredExtensions='x'/><g><path d='M1 1h1'/></g><path d='M2 "
          "2h1'/></switch>",
          "M 1 1 L 2 1");
    DRAWS("<switch><path systemLanguage='de' d='M1 1h1'/><path systemLanguage='fr, en-GB' d='M2 "
          "2h1'/></switch>",
          "M 2 2 L 3 2");
}

static void missing_targets_are_told_and_the_rest_is_drawn(arb *a)
{
    (void)a;
    TELLS("<path d='M2 2h1'/>\n<use href='#a'/><use href='#b'/>", "M 2 2 L 3 2",
          "test.svg:2: <use> of \"#a\" is not drawn");
    TELLS("<use href='other.svg#a'/><path d='M2 2h1'/>", "M 2 2 L 3 2",
          "\"other.svg#a\" is not drawn, it is not in this file");
    TELLS("<use/><path d='M2 2h1'/>",                    "M 2 2 L 3 2", "without href");
}

static void what_leaves_a_viewport_is_cut(arb *a)
{
    (void)a;
    TELLS("\n<svg width='5' height='5'><path d='M1 1h9'/></svg>", "M 1 1 L 5 1", "");
    TELLS("<svg width='5' height='5' viewBox='0 0 10 10'><path d='M1 1h9'/></svg>",
          "M 0.5 0.5 L 5 0.5", "");
    TELLS("<svg width='5' height='5' viewBox='0 0 10 10'><path d='M1 -1h1'/></svg>", "", "");
    TELLS("<svg width='5' height='5' style='overflow:visible'><path d='M1 1h9'/></svg>",
          "M 1 1 L 10 1", "");
    TELLS("<svg width='9' height='4'><path d='M1 1C1 5 8 5 8 1'/></svg>", "M 1 1 C 1 5 8 5 8 1",
          "");
    TELLS("<g transform='rotate(90)'><svg width='9' height='4'><path d='M1 1h5'/></svg></g>",
          "M -1 1 L -1 6", "");
    TELLS("<symbol id='s' viewBox='0 0 4 4'><path d='M1 1h5'/></symbol><use href='#s' width='4' "
          "height='4'/>",
          "M 1 1 L 4 1", "");
}

#define P "<path d='M1 1h1'/>"      /* what must not be drawn */
#define Q "<path d='M2 2h1'/>"
#define Q_DRAWN "M 2 2 L 3 2"

static void hidden_elements_are_left_out(arb *a)
{
    (void)a;
    DRAWS("<g display='none'>" P "</g>" Q, Q_DRAWN);
    DRAWS("<g style='fill:red; display : none'>" P "</g>" Q, Q_DRAWN);
    DRAWS("<g display='none'><path display='inline' d='M1 1h1'/></g>" Q, Q_DRAWN);
    DRAWS("<g display='none' style='display:inline'>" Q "</g>", Q_DRAWN);
    DRAWS("<g visibility='hidden'>" P "</g>" Q, Q_DRAWN);
    DRAWS("<g visibility='collapse'>" P "</g>" Q, Q_DRAWN);
    DRAWS("<g visibility='hidden'>" P "<g><path visibility='visible' d='M2 2h1'/></g></g>",
          Q_DRAWN);
    DRAWS("<g style='visibility:hidden'>" P "<path style='visibility:visible' d='M2 2h1'/></g>",
          Q_DRAWN);
    DRAWS("<g visibility='hidden'>" P "<g visibility='inherit'>" P "</g></g>" Q, Q_DRAWN);
    DRAWS("<defs><g id='g'>" P
          "</g></defs><use href='#g' display='none'/><use href='#g' visibility='hidden'/>" Q,
          Q_DRAWN);
    DRAWS("<defs>" P "</defs><clipPath>" P "</clipPath><mask>" P "</mask><pattern>" P
          "</pattern><marker>" P "</marker>"
          "<symbol>" P "</symbol>" Q,
          Q_DRAWN);
    DRAWS("<g xmlns='urn:other'>" P "</g><unknown>" P "</unknown>" Q, Q_DRAWN);
}

/* Programs for icons put an invisible frame around them. */
static void what_is_not_painted_is_left_out(arb *a)
{
    drawing d;
    (void)a;
    DRAWS("<path fill='none' d='M1 1h1'/>" Q, Q_DRAWN);
    DRAWS("<path fill='none' stroke='red' d='M2 2h1'/>", Q_DRAWN);
    DRAWS("<g fill='none'>" P "<path stroke='red' d='M2 2h1'/></g>", Q_DRAWN);
    DRAWS("<g fill='none' stroke='red'><path stroke='none' d='M1 1h1'/><path fill='inherit' d='M2 "
          "2h1'/></g>",
          Q_DRAWN);
    DRAWS("<g fill='none'><path style='stroke:none;fill:#000' d='M2 2h1'/></g>", Q_DRAWN);
    DRAWS("<style>.n{fill:none} .s{stroke:#123}</style><g class='n'>" P
          "<path class='s' d='M2 2h1'/></g>",
          Q_DRAWN);
    CHECK(read_svg(&d, PAGE("\n<rect width='9' height='9' fill='none'/>" Q)) == 0 &&
          caught_lines == 1);
    CHECK(strstr(caught, "test.svg:2: <rect> without fill and stroke is invisible") != NULL);
    drawing_free(&d);
    CHECK(read_svg(&d, PAGE("<g stroke-dasharray='none'>" Q "<g style='stroke-dasharray:1,2'>" Q Q
                            "</g></g>")) == 0 &&
          d.count == 3 && caught_lines == 0);
    drawing_free(&d);
    CHECK(read_svg(&d, PAGE("<style>g path{fill:red}</style>" Q)) == 0 && caught_lines == 0);
    drawing_free(&d);
}

/* As in a browser: elements that are transparent, or have no width, are not visible. */
static void what_is_clear_is_left_out(arb *a)
{
    (void)a;
    DRAWS("<g opacity='0'><path opacity='1' d='M1 1h1'/></g>" Q, Q_DRAWN);
    DRAWS("<g style='opacity:0%'>" P "</g><g opacity='.01'>" Q "</g>", Q_DRAWN);
    DRAWS("<g fill='none' stroke='red'><path stroke-opacity='0' d='M1 1h1'/><path stroke-width='0' "
          "d='M1 1h1'/>" Q "</g>",
          Q_DRAWN);
    DRAWS("<path fill-opacity='0' d='M1 1h1'/>" Q, Q_DRAWN);
    DRAWS("<path fill-opacity='0' stroke='red' d='M2 2h1'/>", Q_DRAWN);
    DRAWS("<path stroke='red' stroke-width='0px' d='M2 2h1'/>", Q_DRAWN);
    DRAWS("<g stroke-width='0' stroke='red' fill='none'>" P
          "<path stroke-width='1' d='M2 2h1'/></g>",
          Q_DRAWN);
    DRAWS("<style>.o{opacity:0} .w{fill:none;stroke:red;stroke-width:0mm}</style><path class='o' "
          "d='M1 1h1'/><path class='w' d='M1 1h1'/>" Q,
          Q_DRAWN);
    DRAWS("<path fill='#f000' d='M1 1h1'/><path fill='#ff000000' d='M1 1h1'/><path fill='#ff0000' "
          "d='M2 2h1'/>",
          Q_DRAWN);
    DRAWS("<path fill='rgba(1,2,3,0)' d='M1 1h1'/><path fill='rgb(1 2 3 / 0%)' d='M1 1h1'/><path "
          "fill='rgb(1,2,0)' d='M2 2h1'/>",
          Q_DRAWN);
    TELLS("<path marker-end='none' d='M2 2h1'/>", Q_DRAWN, "");
    TELLS("<path marker-mid='url(#m)' marker-start='url(#m)' d='M2 2h1'/>", Q_DRAWN, "");
}

/* What paints nothing is not painted: gradients without colours, what is no paint, and the paint of
 * a marker outside of one. */
static void paint_may_be_none(arb *a)
{
    (void)a;
    DRAWS("<linearGradient id='g'/><path fill='url(#g)' d='M1 1h1'/>" Q, Q_DRAWN);
    DRAWS("<linearGradient id='g' href='#h'/><radialGradient id='h'><stop/></radialGradient>"
          "<path fill='url(#g)' d='M2 2h1'/>",
          Q_DRAWN);
    DRAWS("<linearGradient id='g' href='#h'/><linearGradient id='h' href='#g'/>"
          "<path fill='url(#g) red' d='M1 1h1'/>" Q,
          Q_DRAWN);
    DRAWS("<path fill='url(#g)' d='M1 1h1'/>" Q, Q_DRAWN);
    DRAWS("<path fill='url(#g) none' d='M1 1h1'/><path fill='url(#g) #123' d='M2 2h1'/>", Q_DRAWN);
    DRAWS("<path id='g' fill='url(#g)' d='M1 1h1'/><path fill='url(#g) #123' d='M2 2h1'/>",
          Q_DRAWN);
    DRAWS("<path fill='context-fill' stroke='context-stroke' d='M1 1h1'/>" Q, Q_DRAWN);
    DRAWS("<path id='p' fill='context-fill' d='M0 0h1'/><use href='#p' fill='none' x='5'/>"
          "<use href='#p' x='2' y='2'/>",
          Q_DRAWN);
    DRAWS("<marker id='m' overflow='visible'><path fill='none' stroke='context-stroke' d='M0 0h1'/>"
          "</marker><g fill='none' style='marker-start:url(#m)'><path d='M9 2h1'/>"
          "<path stroke='red' d='M2 2h1'/></g>",
          Q_DRAWN " M 2 2 L 3 2");
    TELLS("<path stroke='red' stroke-width='-1' d='M2 2h1'/>", Q_DRAWN, "stroke-width: -1 is not");
}

static void viewports_inherit_overflow_if_they_say_so(arb *a)
{
#define VIEW(overflow) "<svg width='3' height='5' overflow='" overflow "'><path d='M2 2h2'/></svg>"
    (void)a;
    DRAWS(VIEW(""), Q_DRAWN);
    DRAWS(VIEW("inherit"), "M 2 2 L 4 2");
    DRAWS("<g overflow='hidden'>" VIEW("inherit") "</g>", Q_DRAWN);
    DRAWS("<svg><g>" VIEW("inherit") "</g></svg>", "M 2 2 L 4 2");
    DRAWS("<g overflow='hidden'>" VIEW("auto") "</g>", "M 2 2 L 4 2");
}

static void the_page_may_be_clipped(arb *a)
{
    (void)a;
    DRAWS_ON(100,
             SIZED("width='100mm' height='100mm' viewBox='0 0 100 100' clip-path='url(#c)' "
                   "font-size='2'",
                   "<clipPath id='c'><rect x='1rem' width='.5em' height='9'/></clipPath>"
                   "<path d='M1 2h9'/>"),
             Q_DRAWN);
}

/* They change how outlines look, not where they are. */
static void effects_are_told(arb *a)
{
    drawing d;
    (void)a;
    CHECK(read_svg(&d, PAGE("\n<g filter='url(#f)'><path style='filter:blur(2px)' d='M2 2h1'/></g>"
                            "<g style='mix-blend-mode:screen'>" Q "</g>")) == 0 &&
          d.count == 2 && caught_lines == 2);
    CHECK(strstr(caught, "test.svg:2: filter: url(#f) is not applied") != NULL &&
          strstr(caught, "mix-blend-mode: screen is not applied") != NULL);
    drawing_free(&d);
    TELLS("<g filter='none' style='mix-blend-mode:normal'>" Q "</g>", Q_DRAWN, "");
    TELLS("<g filter='url(#f)' display='none'/>" Q, Q_DRAWN, "");
}

/* On paper, white boxes below everything else are not seen. */
static void white_pages_are_left_out(arb *a)
{
#define BOX(fill) "<rect width='100' height='100' fill='" fill "'/>"
    static const char whole[] = "M 0 0 L 100 0 L 100 100 L 0 100 L 0 0";
    drawing d;
    char got[400];
    (void)a;
    TELLS("\n" BOX("white") Q, Q_DRAWN, "test.svg:2: <rect> is a white page and not drawn");
    TELLS("<g style='fill:#fff'><path d='M0 0V100H100V0z'/><path d='M9 9H50V30H9z'/></g>" Q,
          Q_DRAWN, "a white page");
    TELLS("<path d='M2 2h1' stroke='white'/>" BOX("#ffffff"), Q_DRAWN, "a white page");
    TELLS(Q "<path d='M9 9H5V3H9z' fill='white'/>", Q_DRAWN " M 9 9 L 5 9 L 5 3 L 9 3 L 9 9", "");
    TELLS("<path d='M9 9H5L9 3z' fill='white'/>", "M 9 9 L 5 9 L 9 3 L 9 9", "");
    TELLS("<path d='M9 9H5V3H9z' fill='white' stroke='red'/>", "M 9 9 L 5 9 L 5 3 L 9 3 L 9 9", "");
    TELLS(BOX("white"), whole, "");     /* there is nothing else */
    TELLS(BOX("#fffffe"), whole, "");
    for (int k = 0; k < 2; k++) {
        static const char text[] = PAGE(BOX("white"));
        d = (drawing){ .white = k > 0, .only = k ? NULL : "white" };
        CHECK(drawing_read_svg(&heard, &d, "f", text, strlen(text)) == 0);
        put_drawing(got, sizeof got, &d, 100);
        CHECK(strcmp(got, whole) == 0);
        drawing_free(&d);
    }
}

static void custom_properties_are_put_in(arb *a)
{
    (void)a;
    DRAWS("<g fill='none' style='--a:none;--b:red'><path style='stroke:var(--a)' d='M1 1h1'/><path "
          "style='stroke:var(--b)' d='M2 2h1'/></g>",
          Q_DRAWN);
    DRAWS("<style>:root{--a:none} .s{fill:var(--a);stroke: var( --a )}</style><path class='s' "
          "d='M1 1h1'/>" Q,
          Q_DRAWN);
    DRAWS("<style>:root{--a:red} .s{fill:var(--a)} .t{--a:none}</style><path class='s t' d='M1 "
          "1h1'/><path class='s' d='M2 2h1'/>",
          Q_DRAWN);
    DRAWS("<style>:root{--a:none;--a:red} svg{--a:none}</style><path fill='var(--a)' d='M2 2h1'/>",
          Q_DRAWN);
    DRAWS("<path fill='var(--a, none)' d='M1 1h1'/><path fill='var(--a)' d='M2 2h1'/>", Q_DRAWN);
    DRAWS("<g style='--a:var(--b,var(--c));--c:none'><path fill='var(--a)' d='M1 1h1'/></g>" Q,
          Q_DRAWN);
    DRAWS("<g style='--a:var(--b);--b:var(--a)'><path fill='var(--a)' d='M2 2h1'/></g>", Q_DRAWN);
    DRAWS("<g style='--x:2px;transform:translate(var(--x),var(--x))'><path d='M0 0h1'/></g>",
          Q_DRAWN);
    DRAWS("<defs><path id='p' fill='var(--a)' d='M1 1h1'/></defs><use href='#p' "
          "style='--a:none'/><use href='#p' x='1' y='1'/>",
          Q_DRAWN);
}

/* Thousands of rules, and thousands of shapes: each shape checks only the rules of its names. */
static void many_rules_cost_little(arb *a)
{
    enum { MANY = 5000 };
    static const char *const rules[] = { ".c%d", "path", ".a.c%d", "#i%d" };
    static char text[MANY * 100];
    (void)a;
    for (size_t k = 0; k < sizeof rules / sizeof rules[0]; k++) {
        char *end = text + sprintf(text, "<svg xmlns='http://www.w3.org/2000/svg'><style>");
        const clock_t start = clock();
        drawing d;
        for (int i = 0; i < MANY; i++) {
            end += sprintf(end, rules[k], i);
            end += sprintf(end, "{fill:none;stroke:%s}", i == MANY - 1 ? "red" : "none");
        }
        end += sprintf(end, "</style>");
        for (int i = 0; i < MANY; i++)
            end += sprintf(end, "<path id='i%d' class='a c%d' d='M0 0H1'/>", i, i);
        strcpy(end, "</svg>");
        CHECK(read_svg(&d, text) == 0 && d.count == (k == 1 ? MANY : 1));
        CHECK((double)(clock() - start) / CLOCKS_PER_SEC < 5);
        drawing_free(&d);
    }
}

/* Rules that no order makes cheap end with a message. */
static void costly_style_sheets_are_stopped(arb *a)
{
    static char text[4000000];
    char *end = text + sprintf(text, "<svg xmlns='http://www.w3.org/2000/svg'><style>");
    (void)a;
    for (int i = 0; i < 10000; i++)
        end += sprintf(end, ".a%d.b%d{fill:none}", i / 100, i % 100);
    end += sprintf(end, "</style><g class='");
    for (int i = 0; i < 100; i++)
        end += sprintf(end, "a%d ", i);
    end += sprintf(end, "' id='g'/>");
    for (int i = 0; i < 2000; i++)
        end += sprintf(end, "<use href='#g'/>");
    strcpy(end, "</svg>");
    check_refuses(text, "the style sheet takes too long", __FILE__, __LINE__);
}

static void style_sheets_hide_too(arb *a)
{
    (void)a;
    DRAWS("<style>.h{display:none}</style><g class='x h'>" P "</g>" Q, Q_DRAWN);
    DRAWS("<style>/* no */ @media print { g { display: none } } a, #i, "
          ".j{fill:red;display:none}</style><g id='i'>" P "</g>" Q,
          Q_DRAWN);
    DRAWS("<style><![CDATA[ g.h { visibility: hidden } ]]></style><g class='h'>" P
          "</g><a class='h'>" Q "</a>",
          Q_DRAWN);
    DRAWS("<style>.h{display:none} #q{display:inline}</style><g class='h' id='q'>" Q "</g>",
          Q_DRAWN);
    DRAWS("<style>#q{display:none} .h{display:inline}</style><g class='h' id='q'>" P "</g>" Q,
          Q_DRAWN);
    DRAWS("<style>g{display:none} g{display:inline}</style><g>" Q "</g>", Q_DRAWN);
    DRAWS("<style>g{display:none}</style><g style='display:inline'>" Q "</g>", Q_DRAWN);
    DRAWS("<style>g{display:none !important}</style><g style='display:inline'>" P "</g>" Q,
          Q_DRAWN);
    DRAWS("<style>g{display:inline}</style><g display='none'>" Q "</g>", Q_DRAWN);
    DRAWS("<style>*{visibility:hidden} .v{visibility:visible}</style><g>" P
          "<path class='v' d='M2 2h1'/></g>",
          Q_DRAWN);
}

static void what_cannot_be_drawn_is_said_once(arb *a)
{
    drawing d;
    (void)a;
    CHECK(read_svg(&d, PAGE("\n<flowRoot>a</flowRoot>\n<flowRoot/>" Q)) == 0 && d.count == 1);
    CHECK(caught_lines == 1 &&
          strcmp(caught, "test.svg:2: <flowRoot> is not drawn: convert text to paths") == 0);
    drawing_free(&d);
    CHECK(read_svg(&d, PAGE("<defs><image/></defs><image display='none'/>"
                            "<image visibility='hidden'/>" Q)) == 0 &&
          caught_lines == 0);
    drawing_free(&d);
    CHECK(read_svg(&d, PAGE("<image/><g clip-path='circle(5)'>" Q
                            "</g><g style='clip-path:circle(6)'>" Q "</g>")) == 0 &&
          caught_lines == 2);
    CHECK(strstr(caught, "trace pictures") != NULL &&
          strstr(caught, "clip-path: circle(5) is not applied") != NULL);
    drawing_free(&d);
    CHECK(read_svg(&d, PAGE("<style>g:huh{display:none}</style>" Q)) == 0 &&
          strstr(caught, "\"g:huh\" is not understood") != NULL);
    drawing_free(&d);
}

/* Also if a tag spans several lines: the line on which it starts counts. */
static void every_curve_knows_its_line(arb *a)
{
    drawing d;
    (void)a;
    CHECK(
        read_svg(&d, PAGE("\n<path\n  d='M1 1h1'\n/><path d='M1 1h1'/>\n<path\n\nd='M1 1h1'/>")) ==
            0 &&
        d.count == 3);
    if (d.count == 3)
        CHECK(d.curve[1].line == 4 && d.curve[2].line == 5);
    drawing_free(&d);
    LACKS("\n<g>\n<path\n  id='p'\n d='M1 1h1e9'\n/></g>", "test.svg:3: <path> is not drawn");
    CHECK(read_svg(&d, "<!DOCTYPE svg [\n\n<!ENTITY e '<line x2=\"1\"/>'>]>\n" PAGE(
                           "<g>\n&e;</g>\n<g\n>\n&e;<line\nx2='1'/></g>")) == 0);
    CHECK(d.count == 3 && d.curve[0].line == 4 && d.curve[1].line == 6 && d.curve[2].line == 8);
    drawing_free(&d);
    CHECK(read_svg(&d, PAGE("\n<path d='M1 1h1h1'/>\n\n<g><path d='M1 1h1'/></g>")) == 0 &&
          d.count == 3);
    if (d.count == 3)
        CHECK(d.curve[0].line == 2 && d.curve[1].line == 2 && d.curve[2].line == 4);
    drawing_free(&d);
}


// Documents
// ---------

static void broken_documents_are_refused(arb *a)
{
    (void)a;
    check_refuses("<html><body/></html>", "test.svg:1: <html> is not an SVG drawing", __FILE__,
                  __LINE__);
    check_refuses("<svg xmlns='urn:other'/>", "is not an SVG drawing", __FILE__, __LINE__);
    check_refuses("<svg xmlns='http://www.w3.org/2000/svg'>\n<g>\n</svg>",
                  "test.svg:3: broken XML: Opening and ending tag mismatch", __FILE__, __LINE__);
    check_refuses("<svg", "broken XML", __FILE__, __LINE__);
    check_refuses("<", "broken XML", __FILE__, __LINE__);
    REFUSES("<text>\xff\xfe</text>", "characters that are not UTF-8: save it as UTF-8");
    /* libxml2 would print a line of its own, and name the wrong cause */
    check_refuses("<?xml version='1.0' encoding='EUC-JP'?>" PAGE("<g>\xff\xff\xff</g>"),
                  "test.svg:1: broken XML: characters that are not UTF-8", __FILE__, __LINE__);
    REFUSES("<path d='&nothing;'/>", "broken XML: Entity 'nothing' not defined");
}

#define ENTITIES(declarations, inner) "<!DOCTYPE svg [" declarations "]>" PAGE(inner)

static void entities_are_read_but_cannot_explode(arb *a)
{
    static char text[3000000];
    (void)a;
    DRAWS_ON(100, ENTITIES("<!ENTITY p 'M2 2h1'>", "<path d='&p;'/>"), Q_DRAWN);
    DRAWS_ON(100, ENTITIES("<!ENTITY p SYSTEM 'file:///etc/passwd'>", "<title>&p;</title>" Q),
             Q_DRAWN);
    DRAWS_ON(100, "<!DOCTYPE svg SYSTEM 'http://localhost:1/x.dtd'>" PAGE(Q), Q_DRAWN);

    strcpy(text, "<!DOCTYPE svg [<!ENTITY e0 'M1 1h1'>");               /* ten of ten of .. */
    for (int i = 0; i < 10; i++)
        sprintf(text + strlen(text), "<!ENTITY e%d '&e%d;&e%d;&e%d;&e%d;&e%d;&e%d;&e%d;&e%d;'>",
                i + 1, i, i, i, i, i, i, i, i);
    strcat(text, "]>" PAGE("<path d='&e10;'/>"));
    check_refuses(text, "entities stand for more than", __FILE__, __LINE__);

    /* of elements, which are copied */
    strcpy(text, "<!DOCTYPE svg [<!ENTITY e0 '<g/>'>");
    for (int i = 0; i < 8; i++)
        sprintf(text + strlen(text), "<!ENTITY e%d '&e%d;&e%d;&e%d;&e%d;&e%d;&e%d;&e%d;&e%d;'>",
                i + 1, i, i, i, i, i, i, i, i);
    strcat(text, "]><svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1 1'>");
    for (int i = 0; i <= 8; i++)                                        /* from small to great */
        sprintf(text + strlen(text), "&e%d;", i);
    strcat(text, "</svg>");
    check_refuses(text, "entities stand for more than", __FILE__, __LINE__);

    strcpy(text, "<!DOCTYPE svg [<!ENTITY a '&b;'><!ENTITY b '&a;'>]>" PAGE("&a;"));
    check_refuses(text, "loop", __FILE__, __LINE__);

    strcpy(text, "<!DOCTYPE svg [<!ENTITY e '");                         /* a long one, often */
    char *end = text + strlen(text);
    for (int i = 0; i < 20000; i++)
        end += sprintf(end, " L 1 1");
    end += sprintf(end, "'>]><svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1 1'>");
    for (int i = 0; i < 60000; i++)
        end += sprintf(end, "<path d='M0 0&e;'/>");
    strcpy(end, "</svg>");
    check_refuses(text, "entities stand for more than", __FILE__, __LINE__);
}

/* Short ones, but so many in one text that appending them takes hours; and defaults, which are not
 * entities. */
static void other_ways_to_explode_are_stopped(arb *a)
{
    static char text[10000000];
    char *end =
        text +
        sprintf(
            text,
            "<!DOCTYPE svg [<!ENTITY e 'x'>]>\n<svg xmlns='http://www.w3.org/2000/svg'><title>");
    (void)a;
    for (int i = 0; i < 400000; i++)
        end += sprintf(end, "&e;");
    strcpy(end, "</title></svg>");
    check_refuses(text, "test.svg:2: too many entities in one text", __FILE__, __LINE__);

    end = text + sprintf(text,
                         "<!DOCTYPE svg [<!ATTLIST g a CDATA '%0100000d'>]><svg "
                         "xmlns='http://www.w3.org/2000/svg'>",
                         1);
    for (int i = 0; i < 10000; i++)
        end += sprintf(end, "<g/>");
    strcpy(end, "</svg>");
    check_refuses(text, "entities stand for more than", __FILE__, __LINE__);

    end = text + sprintf(text, "<svg xmlns='http://www.w3.org/2000/svg'><g");
    for (int i = 0; i < 1001; i++)
        end += sprintf(end, " a%d=''", i);
    strcpy(end, "/></svg>");
    check_refuses(text, "<g> has more than 1000 attributes", __FILE__, __LINE__);
}

/* Programs write such files: one path for a whole scan, or a whole drawing in one line. */
static void long_data_and_long_lines_are_read(arb *a)
{
    static char text[16000000];
    char *end = text +
                sprintf(text,
                        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'><path d='M0 0");
    const clock_t start = clock();
    drawing d;
    (void)a;
    for (int i = 0; i < 1300000; i++)
        end += sprintf(end, i < 9 ? "H%dH0  " : "        ", i % 9);
    end += sprintf(end, "'/>");
    for (int i = 0; i < 50000; i++)
        end += sprintf(end, "<line x2='%d'/>", 1 + i % 9);
    strcpy(end, "</svg>");
    CHECK(read_svg(&d, text) == 0 && d.count == 16 + 50000);
    CHECK((double)(clock() - start) / CLOCKS_PER_SEC < 10);
    drawing_free(&d);
}

/* For any bytes, the reader ends with a drawing within its limits or with one line. */
static void damaged_documents_do_no_harm(arb *a)
{
    static const char whole[] = PAGE(
        "<style>.a{display:none}</style><defs><symbol id='s' viewBox='0 0 9 9'><path d='M1 1a5 4 "
        "30 1 0 3 3s1 2 3 4z'/>"
        "</symbol></defs><g class='a' transform='rotate(30 4 5) scale(2)'><use href='#s' x='5' "
        "width='40%'/></g><rect width='9' height='4' rx='1'/>"
        "<polyline points='1,2 3,4'/><svg viewBox='0 0 5 5' preserveAspectRatio='xMinYMax "
        "slice'><circle r='2mm'/></svg>");
    static const char bits[] = "<>/'\"=#&;:{}(),.-+0123456789eEmMaAzZsSlL %\n\t";
    char text[sizeof whole];
    drawing d;

    memcpy(text, whole, sizeof whole);
    for (unsigned n = 1 + arb_below(a, 4); n > 0; n--)
        text[150 + arb_below(a, sizeof whole - 151)] = bits[arb_below(a, sizeof bits - 1)];
    const int code = read_svg(&d, text);
    CHECK(code == 0 || code == EX_DATAERR);
    CHECK(code == 0 || caught_lines >= 1);
    for (size_t i = 0; i < d.count; i++)
        for (int k = 0; k < 4; k++)
            CHECK(fabs(d.curve[i].p[k][0]) <= DRAWING_LIMIT &&
                  fabs(d.curve[i].p[k][1]) <= DRAWING_LIMIT);
    for (size_t i = 1; i < d.count; i++)
        CHECK(d.curve[i].path == d.curve[i - 1].path + 1 ||
              (d.curve[i].path == d.curve[i - 1].path &&
               memcmp(d.curve[i].p[0], d.curve[i - 1].p[3], sizeof d.curve[i].p[0]) == 0));
    drawing_free(&d);
}

/* A choice of layers or colours leaves these curves. */
static void check_drawn(drawing d, const char *text, const char *choice, const char *drawn)
{
    char got[400];

    CHECK(drawing_read_svg(&heard, &d, "f", text, strlen(text)) == 0);
    put_drawing(got, sizeof got, &d, 100);
    if (strcmp(got, drawn) != 0)
        printf("%s: %s\n", choice, got);
    CHECK(strcmp(got, drawn) == 0);
    drawing_free(&d);
}

/* A choice of what is not there is refused, and the choices that there are, are named. */
static void check_refused(drawing d, const char *text, const char *named)
{
    hear();
    CHECK(drawing_read_svg(&heard, &d, "f", text, strlen(text)) == EX_DATAERR && caught_lines == 1);
    CHECK(strstr(caught, named) != NULL);
    drawing_free(&d);
}

/* Layers of Inkscape by name, or by the number that their names begin with, with what is in them;
 * what is in none of them is left out. */
static void layers_are_chosen(arb *a)
{
    static const char text[] =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"100mm\" "
        "viewBox=\"0 0 100 100\" xmlns:i=\"http://www.inkscape.org/namespaces/inkscape\">"
        "<g i:groupmode=\"layer\" i:label=\"2 red\"><path d=\"M1 1h1\"/>"
        "<g i:groupmode=\"layer\" i:label=\"fine\"><path d=\"M2 2h1\"/></g></g>"
        "<g i:groupmode=\"layer\" i:label=\"20 blue\"><g><path d=\"M3 3h1\"/></g></g>"
        "<g i:groupmode=\"layer\" id=\"frame\"><path d=\"M4 4h1\"/></g>"
        "<g i:label=\"2 group\"><path d=\"M5 5h1\"/></g><path d=\"M6 6h1\"/></svg>";
    static const struct {
        const char *layers, *drawn;
    } chosen[] = { { "2", "M 1 1 L 2 1 M 2 2 L 3 2" },
                   { "2 red", "M 1 1 L 2 1 M 2 2 L 3 2" },
                   { "fine", "M 2 2 L 3 2" },
                   { "frame,20", "M 3 3 L 4 3 M 4 4 L 5 4" },
                   { "fine,2", "M 1 1 L 2 1 M 2 2 L 3 2" },
                   { NULL,
                     "M 1 1 L 2 1 M 2 2 L 3 2 M 3 3 L 4 3 M 4 4 L 5 4 M 5 5 L 6 5 M 6 6 L 7 6" } };
    static const char *const none[] = { "red", "2 group", "3", "", "2,,20", "frame," };
    (void)a;
    for (size_t i = 0; i < sizeof chosen / sizeof chosen[0]; i++) {
        const drawing d = { .layers = chosen[i].layers };
        check_drawn(d, text, chosen[i].layers, chosen[i].drawn);
    }
    for (size_t i = 0; i < sizeof none / sizeof none[0]; i++) {
        const drawing d = { .layers = none[i] };
        check_refused(d, text, "give one of \"2 red\", \"fine\", \"20 blue\", \"frame\"");
    }
}

/* The colour of the stroke counts, or else that of the fill. */
static void colours_are_chosen(arb *a)
{
    static const char text[] = PAGE(
        "<path stroke='red' d='M1 1h1'/><g style='stroke:#F00;fill:blue'><path d='M2 2h1'/></g>"
        "<path stroke='rgb(0, 0,255)' d='M3 3h1'/><path fill='rgb(100%,0%,0%)' d='M4 4h1'/>"
        "<linearGradient id='g'><stop/></linearGradient><path d='M5 5h1'/><path fill='url(#g)' "
        "d='M6 6h1'/><path "
        "stroke='peru' d='M7 7h1'/>");
    static const struct {
        const char *only, *drawn;
    } chosen[] = { { "red", "M 1 1 L 2 1 M 2 2 L 3 2 M 4 4 L 5 4" },
                   { "#00f", "M 3 3 L 4 3" },
                   { "Blue,#000000", "M 3 3 L 4 3 M 5 5 L 6 5" },
                   { "peru", "M 7 7 L 8 7" } };
    (void)a;
    for (size_t i = 0; i < sizeof chosen / sizeof chosen[0]; i++) {
        const drawing d = { .only = chosen[i].only };
        check_drawn(d, text, chosen[i].only, chosen[i].drawn);
    }
    const drawing none = { .only = "green" };
    check_refused(none, text, "give one of #ff0000, #0000ff, #000000, url(#g), peru");
}

/* AxiDraw: % is for notes. */
static void layers_of_notes_are_left_out(arb *a)
{
    static const char text[] =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"100mm\" "
        "viewBox=\"0 0 100 100\" xmlns:i=\"http://www.inkscape.org/namespaces/inkscape\">"
        "<g i:groupmode=\"layer\" i:label=\" % notes\"><path d=\"M1 1h1\"/></g>"
        "<g i:groupmode=\"layer\" i:label=\"1 +S20\"><path d=\"M2 2h1\"/></g></svg>";
    char got[400];
    drawing d;
    (void)a;
    CHECK(read_svg(&d, text) == 0);
    put_drawing(got, sizeof got, &d, 100);
    CHECK(strcmp(got, "M 2 2 L 3 2") == 0 && caught_lines == 2);
    CHECK(strstr(caught, "as AxiDraw does") && strstr(caught, "no speed, height, delay or pause"));
    drawing_free(&d);
}

#define DASHED(style, path, wanted)                                                                \
    DRAWS("<path fill='none' stroke='red' style='" style "' d='" path "'/>", wanted)

static void dashes_cut_lines(arb *a)
{
    (void)a;
    DASHED("stroke-dasharray:2,1", "M0 0H7", "M 0 0 L 2 0 M 3 0 L 5 0 M 6 0 L 7 0");
    DASHED("stroke-dasharray:2", "M0 0H7", "M 0 0 L 2 0 M 4 0 L 6 0");
    DASHED("stroke-dasharray:1 2 3", "M0 0H12", "M 0 0 L 1 0 M 3 0 L 6 0 M 7 0 L 9 0");
    DASHED("stroke-dasharray:2 1;stroke-dashoffset:1", "M0 0H5", "M 0 0 L 1 0 M 2 0 L 4 0");
    DASHED("stroke-dasharray:2 1;stroke-dashoffset:-1", "M0 0H5", "M 1 0 L 3 0 M 4 0 L 5 0");
    DASHED("stroke-dasharray:3 1", "M0 0H2V2", "M 0 0 L 2 0 L 2 1");
    DASHED("stroke-dasharray:3 1", "M0 0H2M0 5H4", "M 0 0 L 2 0 M 0 5 L 3 5");
    DASHED("stroke-dasharray:none", "M0 0H2", "M 0 0 L 2 0");
    DASHED("stroke-dasharray:0", "M0 0H2", "M 0 0 L 2 0");
    DASHED("stroke-dasharray:2 -1", "M0 0H2", "M 0 0 L 2 0");
    DASHED("stroke-dasharray:0 2;stroke-linecap:round", "M0 0H3",
           "M 0 0 L 0.002 0 M 2 0 L 2.002 0");
    DRAWS("<g transform='scale(2 1)' stroke-dasharray='2 1' stroke='red' fill='none'>"
          "<path d='M0 0H4M0 0V4'/></g>",
          "M 0 0 L 4 0 M 6 0 L 8 0 M 0 0 L 0 2 M 0 3 L 0 4");
    DRAWS("<path pathLength='10' stroke-dasharray='5 5' stroke='red' d='M0 0H40'/>",
          "M 0 0 L 20 0");
    DRAWS("<path stroke-dasharray='1 1' d='M0 0H4'/>", "M 0 0 L 4 0");      /* no stroke */
}

/* SVG 2, 13.5.4: a part without length is its ends, if they are not butt; a move alone is none. */
static void parts_without_length_are_dots(arb *a)
{
    (void)a;
#define DOTTED(cap, shape, wanted)                                                                 \
    DRAWS("<g fill='none' stroke='red' stroke-linecap='" cap "'>" shape "</g>", wanted)
    DOTTED("round", "<path d='M5 5h0'/>", "M 4.999 5 L 5.001 5");
    DOTTED("square", "<path d='M5 5z'/>", "M 4.999 5 L 5.001 5");
    DOTTED("round", "<path d='M5 5C5 5 5 5 5 5'/>", "M 4.999 5 L 5.001 5");
    DOTTED("round", "<path d='M5 5h0l0 0z'/>", "M 4.999 5 L 5.001 5");
    DOTTED("round", "<path d='M5 5h0M7 5h2M9 9zm1 1h0'/>",
           "M 4.999 5 L 5.001 5 M 7 5 L 9 5 M 8.999 9 L 9.001 9 M 9.999 10 L 10.001 10");
    DOTTED("round", "<path d='M5 5h0h3'/>", "M 5 5 L 8 5");
    DOTTED("round", "<line x1='5' y1='5' x2='5' y2='5'/>", "M 4.999 5 L 5.001 5");
    DOTTED("square", "<polyline points='5,5 5,5'/>", "M 4.999 5 L 5.001 5");
    DOTTED("square", "<polygon points='5,5'/>", "M 4.999 5 L 5.001 5");
    DOTTED("round", "<path transform='matrix(0 3 -3 0 20 0)' d='M5 5h0'/>",
           "M 5 14.999 L 5 15.001");
    DOTTED("round", "<path d='M5 5M1 1h1'/>", "M 1 1 L 2 1");
    DOTTED("butt", "<path d='M5 5h0M1 1h1'/>", "M 1 1 L 2 1");
    DRAWS("<path stroke-linecap='round' d='M5 5h0M1 1h1'/>", "M 1 1 L 2 1");    /* no stroke */
}

/* The dashes of a curve and their gaps are as long as they are said to be, and leave out
 * nothing. */
static void dashes_cut_curves(arb *a)
{
    char text[600];
    const double on = 1 + arb_below(a, 80) / 10.0, off = 1 + arb_below(a, 80) / 10.0;
    drawing whole, parts;

    for (int k = 0; k < 2; k++) {
        arb same = *a;
        snprintf(
            text, sizeof text,
            PAGE("<path stroke='red' fill='none' stroke-dasharray='%g %g' d='M%u %uC%u %u %u %u "
                 "%u %u'/>"),
            on, k ? off : 0, arb_below(&same, 99), arb_below(&same, 99), arb_below(&same, 99),
            arb_below(&same, 99), arb_below(&same, 99), arb_below(&same, 99), arb_below(&same, 99),
            arb_below(&same, 99));
        CHECK(read_svg(k ? &parts : &whole, text) == 0 && caught_lines == 0);
    }
    const double length = drawing_length(&whole), n = floor(length / (on + off));
    CHECK(fabs(drawing_length(&parts) - n * on - fmin(length - n * (on + off), on)) <
          1e-4 * length);
    for (size_t i = 0; i + 1 < parts.count; i++) {
        const drawing one = { .curve = &parts.curve[i], .count = 1 };
        CHECK(fabs(drawing_length(&one) - on) < 1e-4 * length);
    }
    drawing_free(&whole);
    drawing_free(&parts);
}

int main(void)
{
    PROPERTY(dashes_cut_lines, 1);
    PROPERTY(parts_without_length_are_dots, 1);
    PROPERTY(dashes_cut_curves, 200);
    PROPERTY(colours_are_chosen, 1);
    PROPERTY(layers_of_notes_are_left_out, 1);
    PROPERTY(lines_absolute_and_relative, 1);
    PROPERTY(closing_goes_back_to_the_start, 1);
    PROPERTY(cubics_and_their_reflections, 1);
    PROPERTY(quadratics_and_their_reflections, 1);
    PROPERTY(numbers_without_separators, 1);
    PROPERTY(arcs_that_are_lines_or_nothing, 1);
    PROPERTY(what_has_no_length_is_dropped, 1);
    PROPERTY(points_that_no_machine_reaches_are_left_out, 1);
    PROPERTY(path_data_is_drawn_up_to_its_first_error, 1);
    PROPERTY(shapes, 1);
    PROPERTY(rounded_corners, 1);
    PROPERTY(broken_shapes_are_drawn_without_their_faults, 1);
    PROPERTY(every_transform, 1);
    PROPERTY(transforms_are_about_their_origin, 1);
    PROPERTY(broken_transforms_transform_nothing, 1);
    PROPERTY(numbers_beyond_arithmetic_do_no_harm, 1);
    PROPERTY(every_unit, 1);
    PROPERTY(pages_of_unknown_size, 1);
    PROPERTY(every_aspect_ratio, 1);
    PROPERTY(viewports_within_the_page, 1);
    PROPERTY(use_draws_again, 1);
    PROPERTY(symbols_are_drawn_by_use_alone, 1);
    PROPERTY(circular_uses_draw_nothing, 1);
    PROPERTY(missing_targets_are_told_and_the_rest_is_drawn, 1);
    PROPERTY(what_leaves_a_viewport_is_cut, 1);
    PROPERTY(a_flood_of_uses_is_stopped, 1);
    PROPERTY(depth_is_bounded, 1);
    PROPERTY(switch_draws_the_first_that_applies, 1);
    PROPERTY(hidden_elements_are_left_out, 1);
    PROPERTY(what_is_not_painted_is_left_out, 1);
    PROPERTY(what_is_clear_is_left_out, 1);
    PROPERTY(paint_may_be_none, 1);
    PROPERTY(viewports_inherit_overflow_if_they_say_so, 1);
    PROPERTY(the_page_may_be_clipped, 1);
    PROPERTY(effects_are_told, 1);
    PROPERTY(white_pages_are_left_out, 1);
    PROPERTY(custom_properties_are_put_in, 1);
    PROPERTY(style_sheets_hide_too, 1);
    PROPERTY(many_rules_cost_little, 1);
    PROPERTY(costly_style_sheets_are_stopped, 1);
    PROPERTY(what_cannot_be_drawn_is_said_once, 1);
    PROPERTY(every_curve_knows_its_line, 1);
    PROPERTY(broken_documents_are_refused, 1);
    PROPERTY(entities_are_read_but_cannot_explode, 1);
    PROPERTY(other_ways_to_explode_are_stopped, 1);
    PROPERTY(long_data_and_long_lines_are_read, 1);
    PROPERTY(damaged_documents_do_no_harm, 3000);
    PROPERTY(layers_are_chosen, 1);
    return check_failures();
}
