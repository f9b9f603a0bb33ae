/* tests/tools/test_pattern.c -- shapes that are filled with patterns, in SVG
 * SPDX-License-Identifier: MIT
 *
 * Where the tiles are is what librsvg 2.54 shows.
 */
#include "tools/drawn.h"

#define LINE "<path d='M0 1H4' fill='none' stroke='red'/>"
#define TILE(attributes) "<pattern id='p' " attributes ">" LINE "</pattern>"
#define USER "width='4' height='4' patternUnits='userSpaceOnUse' "
#define FILLED(attributes)                                                                         \
    "<rect x='2' y='2' width='8' height='4' fill='url(#p)' " attributes "/>"

static void tiles_are_cut_at_the_shape(arb *a)
{
    (void)a;
    DRAWS(TILE(USER) FILLED(""), "M 2 5 L 4 5 M 4 5 L 8 5 M 8 5 L 10 5");
    DRAWS(TILE(USER "x='1' y='3'") FILLED(""), "M 2 4 L 5 4 M 5 4 L 9 4 M 9 4 L 10 4");
    DRAWS(TILE(USER) FILLED("stroke='red'"), "M 2 5 L 4 5 M 4 5 L 8 5 M 8 5 L 10 5"
                                             " M 2 2 L 10 2 L 10 6 L 2 6 L 2 2");
    DRAWS(TILE(USER "patternTransform='scale(2)'") FILLED(""), "M 2 2 L 8 2 M 8 2 L 10 2");
    DRAWS(TILE(USER) "<g transform='translate(1 0)'>" FILLED("") "</g>",
          "M 3 5 L 5 5 M 5 5 L 9 5 M 9 5 L 11 5");
    DRAWS(TILE(USER) "<path fill-rule='evenodd' fill='url(#p)' d='M0 0H9V3H0zM3 0H6V3H3z'/>",
          "M 0 1 L 3 1 M 6 1 L 8 1 M 8 1 L 9 1");
    CHECK(caught_lines == 0);
}

static void their_size_may_be_that_of_the_shape(arb *a)
{
    (void)a;
    DRAWS(TILE("width='.5' height='.5'") FILLED(""),
          "M 2 3 L 6 3 M 6 3 L 10 3 M 2 5 L 6 5 M 6 5 L 10 5");
    DRAWS(TILE("x='25%' width='50%' height='1' viewBox='0 0 8 8'") FILLED(""),
          "M 4 2.5 L 6 2.5 M 8 2.5 L 10 2.5");
    DRAWS("<pattern id='p' width='.5' height='1' patternContentUnits='objectBoundingBox'>"
          "<path d='M0 .5H.25' fill='none' stroke='red'/></pattern>" FILLED(""),
          "M 2 4 L 4 4 M 6 4 L 8 4");
}

static void they_inherit_from_where_they_refer_to(arb *a)
{
    (void)a;
    DRAWS("<g fill='none' stroke='red'><pattern id='q' " USER "><path d='M0 1H4'/></pattern></g>"
          "<pattern id='p' href='#q' y='1'/>" FILLED(""),
          "M 2 2 L 4 2 M 4 2 L 8 2 M 8 2 L 10 2 M 2 6 L 4 6 M 4 6 L 8 6 M 8 6 L 10 6");
    DRAWS("<pattern id='p' href='#p'/>" FILLED("") LINE, "M 0 1 L 4 1");
    DRAWS("<pattern id='p' " USER "><rect width='4' height='4' fill='url(#p)'/>" LINE
          "</pattern>" FILLED(""),
          "M 2 5 L 4 5 M 4 5 L 8 5 M 8 5 L 10 5");              /* not in itself */
    DRAWS("<path d='M0 1H4' fill='url(#none)'/><path d='M0 2H4' fill='url(#none) red'/>",
          "M 0 2 L 4 2");
}

#define PLACED "M 2 5 L 4 5 M 4 5 L 8 5 M 8 5 L 10 5"

/* The tiles of context-fill are those of what is used; a pattern is turned about its origin. */
static void they_stand_where_they_are_given(arb *a)
{
    (void)a;
    DRAWS(TILE(USER) "<defs><rect id='s' transform='translate(1 0)' x='1' y='2' width='8' "
                     "height='4' fill='context-fill'/></defs><use href='#s' fill='url(#p)'/>",
          PLACED);
    DRAWS(TILE(USER) "<marker id='m' markerWidth='8' markerHeight='4' markerUnits='userSpaceOnUse'>"
                     "<rect width='8' height='4' fill='context-fill'/></marker>"
                     "<path d='M2 2z' fill='url(#p)' marker-start='url(#m)'/>",
          PLACED);
    DRAWS(TILE(USER "patternTransform='scale(2)' transform-origin='0 -3'") FILLED(""),
          "M 2 5 L 8 5 M 8 5 L 10 5");
    DRAWS(TILE(USER "patternTransform='scale(2)' style='transform-origin:0px -3px'") FILLED(""),
          "M 2 5 L 8 5 M 8 5 L 10 5");
    CHECK(caught_lines == 0);
}

/* Each loss is one line. */
static void what_they_lose_is_told(arb *a)
{
    (void)a;
    DRAWS(
        TILE("width='1' height='1'") "<defs><rect id='s' x='2' y='2' width='8' height='4' "
                                     "fill='context-fill'/></defs><use href='#s' fill='url(#p)'/>",
        "M 2 3 L 6 3");
    CHECK(caught_lines == 1 && strstr(caught, "takes the box of each shape") != NULL);
    DRAWS(TILE(USER) "<path d='M0 1H4' stroke='url(#p)'/>", "M 0 1 L 4 1");
    CHECK(caught_lines == 1 && strstr(caught, "stroke of a pattern") != NULL);
}

static void too_many_are_left_out_and_told(arb *a)
{
    (void)a;
    DRAWS("<pattern id='p' width='.01' height='.01' patternUnits='userSpaceOnUse'>" LINE
          "</pattern>" FILLED("") LINE,
          "M 0 1 L 4 1");
    CHECK(caught_lines == 1 && strstr(caught, "pattern of 320000 tiles is left out"));
    DRAWS(TILE("width='0' height='1'") FILLED("") LINE, "M 0 1 L 4 1");
    DRAWS(TILE("") FILLED("") LINE, "M 0 1 L 4 1");
    CHECK(caught_lines == 0);
}

/* Patterns in the tiles of others: 1.4 kB would take minutes. */
static void nested_ones_are_bounded(arb *a)
{
    char text[3000] = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>";
    drawing d;
    (void)a;
    for (int i = 0; i < 3; i++) {
        const double w = 100 / exp2(i + 1);
        sprintf(text + strlen(text),
                "<pattern id='p%d' patternUnits='userSpaceOnUse' width='%g' height='%g' "
                "patternTransform='rotate(%d)'>",
                i, w, w, 7 * i + 3);
        for (int k = 0; k < 4; k++)
            sprintf(text + strlen(text),
                    "<path d='M0 %gC%g 0 0 %g %g %gS%g 0 0 0z' stroke='red' fill='url(#p%d)'/>",
                    k * w / 4, w, w, w, w, w / 2, i + 1);
        strcat(text, "</pattern>");
    }
    strcat(text, "<path d='M0 0C90 0 0 90 100 100H0z' fill='url(#p0)'/><path d='M0 0H9'/></svg>");
    CHECK(read_svg(&d, text) == 0 && caught_lines == 1 && strstr(caught, "is left out") != NULL);
    CHECK(d.count == 1);
    drawing_free(&d);
}

/* One line, and the shapes are filled without what is at fault. */
static void faults_in_them_are_told(arb *a)
{
    static const char *const odd[] = { "x=')1'", "width='1 2'", "patternTransform='turn(3)'" };
    const char *which              = odd[arb_below(a, 3)];
    char text[600];
    drawing d;

    snprintf(text, sizeof text,
             PAGE("<pattern id='p' height='4' %s>" LINE "</pattern>"
                  "<path fill='url(#p)' d='M0 0h9v9z'/><path fill='url(#p)' d='M9 9h9v9z'/>"),
             which);
    CHECK(read_svg(&d, text) == 0 && caught_lines == 1);
    CHECK(strstr(caught, "is not used") != NULL ||
          strstr(caught, "nothing is transformed") != NULL);
    drawing_free(&d);
}

int main(void)
{
    PROPERTY(faults_in_them_are_told, 10);
    PROPERTY(nested_ones_are_bounded, 1);
    PROPERTY(tiles_are_cut_at_the_shape, 1);
    PROPERTY(their_size_may_be_that_of_the_shape, 1);
    PROPERTY(they_inherit_from_where_they_refer_to, 1);
    PROPERTY(they_stand_where_they_are_given, 1);
    PROPERTY(what_they_lose_is_told, 1);
    PROPERTY(too_many_are_left_out_and_told, 1);
    return check_failures();
}
