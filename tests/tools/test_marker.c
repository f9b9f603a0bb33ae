/* tests/tools/test_marker.c -- markers of SVG
 * SPDX-License-Identifier: MIT
 *
 * Places and directions are those that browsers and librsvg 2.54 show; at a closed part's first
 * vertex those of browsers, half way between both sides.
 */
#include "tools/drawn.h"

/* A marker of one stroke, from its reference point one unit on, in the direction of the path. */
#define TICK "<path d='M0 0H1' fill='none' stroke='red' stroke-width='.1'/>"
#define MARKER(attributes)                                                                         \
    "<marker id='m' overflow='visible' " attributes ">" TICK "</marker>"
#define LINE(attributes, data) "<path fill='none' stroke='black' " attributes " d='" data "'/>"
#define ALL "marker-start='url(#m)' marker-mid='url(#m)' marker-end='url(#m)'"

static void they_stand_on_vertices(arb *a)
{
    (void)a;
    DRAWS(MARKER("") LINE("marker-start='url(#m)'", "M2 2V8H9"), "M 2 2 L 2 8 L 9 8 M 2 2 L 3 2");
    DRAWS(MARKER("") LINE("marker-mid='url(#m)'", "M2 2V8H9"), "M 2 2 L 2 8 L 9 8 M 2 8 L 3 8");
    DRAWS(MARKER("") LINE("marker-end='url(#m)'", "M2 2V8H9"), "M 2 2 L 2 8 L 9 8 M 9 8 L 10 8");
    DRAWS(MARKER("") "<g style='marker: url(\"#m\")'><line x1='2' y1='2' x2='4' y2='2' "
                     "stroke='red' marker-end='none'/></g>",
          "M 2 2 L 4 2 M 2 2 L 3 2");
    DRAWS(MARKER("") "<polyline points='2,2 4,2 6,2' stroke='red' fill='none' "
                     "marker-mid='url(#m)'/>",
          "M 2 2 L 4 2 L 6 2 M 4 2 L 5 2");
    DRAWS(MARKER("") "<rect x='2' y='2' width='1' height='1' fill='red' style='marker:url(#m)'/>",
          "M 2 2 L 3 2 L 3 3 L 2 3 L 2 2");         /* shapes of other kinds have none */
    DRAWS(MARKER("") "<path d='M2 2H4' fill='none' marker-end='url(#m)'/>", "M 4 2 L 5 2");
    DRAWS(
        MARKER("") "<path visibility='hidden' d='M2 2H4' stroke='red' marker-end='url(#m)'/>" LINE(
            "marker-end='url(#none)'", "M1 1H2"),
        "M 1 1 L 2 1");
    CHECK(caught_lines == 0);
}

static void they_turn_with_the_path(arb *a)
{
    (void)a;
    DRAWS(MARKER("orient='auto'") LINE(ALL, "M2 2V8H9"),
          "M 2 2 L 2 8 L 9 8 M 2 2 L 2 3 M 2 8 L 2.707 8.707 M 9 8 L 10 8");
    DRAWS(MARKER("orient='auto-start-reverse'") LINE("marker-start='url(#m)'", "M2 2V8"),
          "M 2 2 L 2 8 M 2 2 L 2 1");
    DRAWS(MARKER("orient='90'") LINE("marker-end='url(#m)'", "M2 2H4"), "M 2 2 L 4 2 M 4 2 L 4 3");
    DRAWS(MARKER("orient='.25turn'") LINE("marker-end='url(#m)'", "M2 2H4"),
          "M 2 2 L 4 2 M 4 2 L 4 3");
    /* a quarter of a circle is several curves, and has two vertices */
    DRAWS(MARKER("orient='auto'") "<path fill='none' d='M20 10A10 10 0 0 1 10 20' " ALL "/>",
          "M 20 10 L 20 11 M 10 20 L 9 20");
    DRAWS(MARKER("orient='auto'") "<path fill='none' d='M2 2C2 2 2 4 2 8' marker-start='url(#m)'/>",
          "M 2 2 L 2 3");                           /* its first leg has no length */
    DRAWS(MARKER("orient='auto'") "<path fill='none' d='M2 2h2v2h-2z' " ALL "/>",
          "M 2 2 L 2.707 1.293 M 4 2 L 4.707 2.707 M 4 4 L 3.293 4.707 M 2 4 L 1.293 3.293"
          " M 2 2 L 2.707 1.293");
}

static void their_size_is_that_of_the_stroke(arb *a)
{
    (void)a;
    DRAWS(MARKER("") LINE("stroke-width='3' marker-end='url(#m)'", "M2 2H4"),
          "M 2 2 L 4 2 M 4 2 L 7 2");
    DRAWS(MARKER("markerUnits='userSpaceOnUse'")
              LINE("stroke-width='3' marker-end='url(#m)'", "M2 2H4"),
          "M 2 2 L 4 2 M 4 2 L 5 2");
    DRAWS(MARKER("refX='1' refY='2'") LINE("marker-end='url(#m)'", "M2 2H4"),
          "M 2 2 L 4 2 M 3 0 L 4 0");
    DRAWS(MARKER("viewBox='0 0 6 6' refX='3' refY='3'") LINE("marker-end='url(#m)'", "M2 2H4"),
          "M 2 2 L 4 2 M 2.5 0.5 L 3 0.5");
    DRAWS(MARKER("viewBox='0 0 6 6' refX='right' refY='center'")
              LINE("marker-end='url(#m)'", "M2 2H4"),
          "M 2 2 L 4 2 M 1 0.5 L 1.5 0.5");
    DRAWS(MARKER("markerWidth='0'") LINE("marker-end='url(#m)'", "M2 2H4"), "M 2 2 L 4 2");
    DRAWS(MARKER("orient='auto'") "<g transform='translate(9 9) rotate(90) scale(2)'>" LINE(
              "marker-end='url(#m)'", "M0 0H1") "</g>",
          "M 9 9 L 9 11 M 9 11 L 9 13");
}

/* What is outside of the marker's viewport is cut; its style is that of where it stands. */
static void they_are_cut_and_keep_their_style(arb *a)
{
    (void)a;
    DRAWS("<g fill='none' stroke='red'><marker id='m' markerWidth='2' markerHeight='2'>"
          "<path d='M0 1H9'/></marker></g>" LINE("marker-end='url(#m)'", "M2 2H4"),
          "M 2 2 L 4 2 M 4 3 L 6 3");
    DRAWS("<marker id='m'><path d='M0 1H1'/></marker>"          /* not the stroke of the line */
          "<g fill='none'>" LINE("marker-end='url(#m)'", "M2 2H4") "</g>",
          "M 2 2 L 4 2 M 4 3 L 5 3");
    DRAWS("<marker id='m' overflow='visible'>" LINE(
              "marker-end='url(#m)'", "M0 0H1") "</marker>" LINE("marker-end='url(#m)'", "M2 2H4"),
          "M 2 2 L 4 2 M 4 2 L 5 2");               /* not in itself */
    DRAWS(MARKER("") "<clipPath id='c'><path d='M0 0h3v9h-3z' marker-end='url(#m)'/></clipPath>"
                     "<path clip-path='url(#c)' d='M2 2H4'/>",
          "M 2 2 L 3 2");
}

int main(void)
{
    PROPERTY(they_stand_on_vertices, 1);
    PROPERTY(they_turn_with_the_path, 1);
    PROPERTY(their_size_is_that_of_the_stroke, 1);
    PROPERTY(they_are_cut_and_keep_their_style, 1);
    return check_failures();
}
