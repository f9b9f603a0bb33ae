/* tests/tools/test_clip.c -- clip paths of SVG
 * SPDX-License-Identifier: MIT
 *
 * cairo judges which points of a curve are inside of a clip path.
 */
#include <cairo.h>

#include "tools/drawn.h"

#define CUT(clip, inner, wanted)                                                                   \
    DRAWS("<defs><clipPath id='c'>" clip "</clipPath></defs>" inner, wanted)
#define BOX "<rect x='2' y='2' width='4' height='4'/>"

#define EVERYWHERE "maskUnits='userSpaceOnUse' width='100' height='100'"
#define MASKED(mask, inner, wanted)                                                                \
    DRAWS("<defs><mask id='m' fill='white' " EVERYWHERE ">" mask "</mask></defs>" inner, wanted)

static void white_masks_cut(arb *a)
{
    (void)a;
    MASKED("<rect x='2' y='2' width='4' height='4'/>", "<path mask='url(#m)' d='M0 3H9'/>",
           "M 2 3 L 6 3");
    CHECK(caught_lines == 0);
    MASKED("<rect x='2' y='2' width='4' height='4' fill='#fff'/><rect width='9' height='9' "
           "fill='none'/>",
           "<g style='mask:url(#m)'><path d='M0 3H9'/></g>", "M 2 3 L 6 3");
    CHECK(caught_lines == 0);
    /* half of its box, and what is outside of all */
    DRAWS("<mask id='m' maskContentUnits='objectBoundingBox'><path d='M-1 -1H.5V2H-1z' "
          "fill='white'/></mask><path mask='url(#m)' d='M2 2H6V4'/>",
          "M 2 2 L 4 2");
    MASKED("", "<path mask='url(#m)' d='M0 3H9'/>", "");
    /* its region is that of the box, which is none of a line */
    DRAWS("<mask id='m' fill='white'><rect width='9' height='9'/></mask>"
          "<path mask='url(#m)' d='M0 3H9'/><path d='M0 5h1'/>",
          "M 0 5 L 1 5");
    /* black holes, gradients and strokes: all is drawn, and a line says so */
    static const char *const others[] = {
        "<path d='M0 0h9v9H0z'/><path d='M2 2h4v4z' fill='black'/>",
        "<linearGradient id='g'><stop/></linearGradient><path d='M2 2h4v4z' fill='url(#g)'/>",
        "<path d='M2 2h4v4z' fill='none' stroke='white'/>", "<path d='M2 2h4v4z' fill='gray'/>"
    };
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++) {
        char text[600];
        drawing d;
        snprintf(text, sizeof text,
                 PAGE("<mask id='m' fill='white' " EVERYWHERE
                      ">%s</mask><path mask='url(#m)' d='M0 3H9'/>"),
                 others[i]);
        CHECK(read_svg(&d, text) == 0 && d.count == 1 && d.curve[0].p[3][0] > 8.9);
        drawing_free(&d);
    }
}

static void clip_paths_cut(arb *a)
{
    (void)a;
    CUT(BOX, "<path clip-path='url(#c)' d='M0 3H9'/>", "M 2 3 L 6 3");
    CUT(BOX, "<path style='clip-path:url(\"#c\")' d='M0 3H9'/>", "M 2 3 L 6 3");
    CUT(BOX, "<g clip-path='url(#c)'><path d='M0 3H9'/><path d='M3 3h1'/><path d='M8 8h1'/></g>",
        "M 2 3 L 6 3 M 3 3 L 4 3");
    CUT(BOX, "<path clip-path='url(#c)' d='M0 3H4V9'/>", "M 2 3 L 4 3 L 4 6");
    CUT(BOX, "<path clip-path='url(#c)' d='M0 3H9V5H0'/>", "M 2 3 L 6 3 M 6 5 L 2 5");
    CUT(BOX, "<g transform='translate(10 0)'><path clip-path='url(#c)' d='M0 3H9'/></g>",
        "M 12 3 L 16 3");
    CUT(BOX, "<g transform='scale(2)' clip-path='url(#c)'><path d='M0 3H9'/></g>", "M 4 6 L 12 6");
    CUT(BOX BOX, "<path clip-path='url(#c)' d='M0 3H9'/>", "M 2 3 L 6 3");
    CUT(BOX "<rect x='7' y='2' width='1' height='4'/>", "<path clip-path='url(#c)' d='M0 3H9'/>",
        "M 2 3 L 6 3 M 7 3 L 8 3");
    CUT("<path d='M0 0h9v9h-9zM2 2h4v4h-4z' clip-rule='evenodd'/>",
        "<path clip-path='url(#c)' d='M0 3H12'/>", "M 0 3 L 2 3 M 6 3 L 9 3");
    CUT("<path d='M0 0h9v9h-9zM2 2h4v4h-4z'/>", "<path clip-path='url(#c)' d='M-1 3H12'/>",
        "M 0 3 L 9 3");
    CUT("<path d='M2 2h4v4'/>", "<path clip-path='url(#c)' d='M0 3H9'/>", "M 3 3 L 6 3");
    CUT("", "<path clip-path='url(#c)' d='M0 3H9'/>", "");
    CUT(BOX, "<path clip-path='url(#none)' d='M0 3H9'/>", "M 0 3 L 9 3");
    CUT(BOX, "<rect clip-path='url(#c)' x='2' y='2' width='4' height='4'/>",
        "M 2 2 L 6 2 L 6 6 L 2 6 L 2 2");
    DRAWS("<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='.5' height='1'/>"
          "</clipPath><path clip-path='url(#c)' d='M2 3H10M2 5H10'/>",
          "M 2 3 L 6 3 M 2 5 L 6 5");
    DRAWS("<clipPath id='c' transform='translate(1)'>" BOX "</clipPath>"
          "<path clip-path='url(#c)' d='M0 3H9'/>",
          "M 3 3 L 7 3");
    DRAWS("<clipPath id='c'><path clip-path='url(#c)' d='M2 2h4v4h-4z'/></clipPath>"
          "<path clip-path='url(#c)' d='M0 3H9'/>",
          "M 2 3 L 6 3");               /* one that clips itself */
}

#define RING "<path d='M0 0h9v9h-9zM2 2h4v4h-4z'/>"
#define LINE "<path clip-path='url(#c)' d='M-1 3H12'/>"

/* The style of a clip path is that of the place where it stands. */
static void clip_paths_inherit_from_where_they_stand(arb *a)
{
    (void)a;
    DRAWS("<g clip-rule='evenodd'><clipPath id='c'>" RING "</clipPath></g>" LINE,
          "M 0 3 L 2 3 M 6 3 L 9 3");
    DRAWS("<g style='clip-rule:evenodd'><defs><clipPath id='c'>" RING "</clipPath></defs></g>" LINE,
          "M 0 3 L 2 3 M 6 3 L 9 3");
    DRAWS("<clipPath id='c' clip-rule='evenodd'>" RING "</clipPath>" LINE,
          "M 0 3 L 2 3 M 6 3 L 9 3");
    DRAWS("<svg clip-rule='evenodd'><clipPath id='c'>" RING "</clipPath>" LINE "</svg>",
          "M 0 3 L 2 3 M 6 3 L 9 3");
    DRAWS("<g clip-rule='evenodd'><clipPath id='c'><g/><path clip-rule='nonzero' "
          "d='M0 0h9v9h-9zM2 2h4v4h-4z'/></clipPath></g>" LINE,
          "M 0 3 L 9 3");
    DRAWS("<clipPath id='c'>" RING "</clipPath><g clip-rule='evenodd'>" LINE "</g>", "M 0 3 L 9 3");
}

/* What hides or paints elsewhere does not matter in a clip path; `visibility` and `display` of its
 * children do. */
static void clip_paths_are_of_geometry(arb *a)
{
    (void)a;
    CUT("<rect x='2' y='2' width='4' height='4' opacity='0'/>", LINE, "M 2 3 L 6 3");
    CUT("<rect x='2' y='2' width='4' height='4' style='fill:none;fill-opacity:0'/>", LINE,
        "M 2 3 L 6 3");
    DRAWS("<clipPath id='c' style='display:none'>" BOX "</clipPath>" LINE, "M 2 3 L 6 3");
    DRAWS("<clipPath id='c' opacity='0'>" BOX "</clipPath>" LINE, "M 2 3 L 6 3");
    DRAWS("<defs display='none'><clipPath id='c'>" BOX "</clipPath></defs>" LINE, "M 2 3 L 6 3");
    CUT("<rect x='2' y='2' width='4' height='4' display='none'/>", LINE, "");
    CUT("<rect x='2' y='2' width='4' height='4' visibility='hidden'/>", LINE, "");
    CUT("<g>" BOX "</g><rect x='7' y='2' width='1' height='4'/>", LINE, "M 7 3 L 8 3");
}

static void clip_paths_are_clipped(arb *a)
{
    (void)a;
    DRAWS("<clipPath id='d'><rect x='4' width='9' height='9'/></clipPath>"
          "<clipPath id='c' clip-path='url(#d)'>" BOX "</clipPath>" LINE,
          "M 4 3 L 6 3");
    DRAWS("<clipPath id='d'><rect x='4' width='9' height='9'/></clipPath><clipPath id='c'>"
          "<rect clip-path='url(#d)' x='2' y='2' width='4' height='4'/>"
          "<rect x='8' width='1' height='9'/></clipPath>" LINE,
          "M 4 3 L 6 3 M 8 3 L 9 3");
    DRAWS("<clipPath id='e'><rect width='5' height='9'/></clipPath>"
          "<clipPath id='d' clip-path='url(#e)'><rect x='4' width='9' height='9'/></clipPath>"
          "<clipPath id='c'><rect clip-path='url(#d)' x='2' y='2' width='4' "
          "height='4'/></clipPath>" LINE,
          "M 4 3 L 5 3");
    DRAWS("<clipPath id='d' clip-path='url(#c)'>" BOX "</clipPath>"
          "<clipPath id='c' clip-path='url(#d)'><rect x='3' width='9' height='9'/></clipPath>" LINE,
          "M 3 3 L 6 3");
}

/* The box is that of the geometry, whatever is seen of it. */
static void boxes_count_what_is_hidden(arb *a)
{
#define HALF(attributes)                                                                           \
    "<clipPath id='c' clipPathUnits='objectBoundingBox' " attributes                               \
    "><rect width='.5' height='1'/></clipPath>"
    (void)a;
    DRAWS(HALF("") "<g clip-path='url(#c)'><path d='M0 3H12M0 5h1'/>"
                   "<rect visibility='hidden' width='16' height='9'/></g>",
          "M 0 3 L 8 3 M 0 5 L 1 5");
    DRAWS(HALF("") "<g clip-path='url(#c)'><path d='M0 3H12M0 5h1'/>"
                   "<rect fill='none' width='16' height='9'/></g>",
          "M 0 3 L 8 3 M 0 5 L 1 5");
    DRAWS(HALF("") "<path stroke='red' stroke-dasharray='1 9' d='M0 3H16M0 5h1' "
                   "clip-path='url(#c)'/>",
          "M 0 3 L 1 3 M 0 5 L 1 5");
    DRAWS(HALF("transform='translate(4)'") "<path d='M0 3H8M0 5H8' clip-path='url(#c)'/>",
          "M 4 3 L 8 3 M 4 5 L 8 5");
    DRAWS("<mask id='m' width='.5' height='2' fill='white'><rect width='99' height='99'/></mask>"
          "<path d='M0 3H8M0 5H8' mask='url(#m)'/>",
          "M 0 3 L 3.2 3 M 0 5 L 3.2 5");
}

static void add_numbers(arb *a, char *to, int count)
{
    for (int k = 0; k < count; k++)
        sprintf(to + strlen(to), " %u", arb_below(a, 100));
}

/* Is a point on a curve of the drawing? */
static bool is_drawn(const drawing *d, const double at[2])
{
    for (size_t i = 0; i < d->count; i++)
        for (int k = 0; k <= 400; k++) {
            double p[2];
            drawing_eval(&d->curve[i], k / 400.0, p);
            if (hypot(p[0] - at[0], p[1] - at[1]) < 0.6)
                return true;
        }
    return false;
}

static void what_is_inside_stays(arb *a)
{
    const bool evenodd = arb_below(a, 2);
    char clip[400] = "M", curve[200] = "M", text[1500];
    drawing outline, whole, parts;

    add_numbers(a, clip, 2);
    strcat(clip, "C");
    add_numbers(a, clip, 24);
    add_numbers(a, curve, 2);
    strcat(curve, "C");
    add_numbers(a, curve, 6);
    snprintf(text, sizeof text, PAGE("<path d='%s'/>"), clip);
    CHECK(read_svg(&outline, text) == 0);
    snprintf(text, sizeof text, PAGE("<path d='%s'/>"), curve);
    CHECK(read_svg(&whole, text) == 0);
    snprintf(text, sizeof text,
             PAGE("<clipPath id='c'><path clip-rule='%s' d='%s'/></clipPath><path "
                  "clip-path='url(#c)' d='%s'/>"),
             evenodd ? "evenodd" : "nonzero", clip, curve);
    CHECK(read_svg(&parts, text) == 0 && caught_lines == 0);

    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
    cairo_t *cairo           = cairo_create(surface);
    cairo_set_tolerance(cairo, 0.01);
    cairo_set_fill_rule(cairo, evenodd ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
    cairo_move_to(cairo, outline.curve[0].p[0][0], outline.curve[0].p[0][1]);
    for (size_t i = 0; i < outline.count; i++) {
        const drawing_curve *c = &outline.curve[i];
        cairo_curve_to(cairo, c->p[1][0], c->p[1][1], c->p[2][0], c->p[2][1], c->p[3][0],
                       c->p[3][1]);
    }
    for (size_t i = 0; i < whole.count; i++)
        for (int k = 1; k < 60; k++) {
            double p[2];
            unsigned in = 0;
            drawing_eval(&whole.curve[i], k / 60.0, p);
            for (int n = 0; n < 9; n++)     /* within 1.5 mm all are on one side */
                in += cairo_in_fill(cairo, p[0] + 1.5 * (n % 3 - 1), p[1] + 1.5 * (n / 3 - 1)) != 0;
            if (in == 9)
                CHECK(is_drawn(&parts, p));
        }
    for (size_t i = 0; i < parts.count; i++)
        for (int k = 1; k < 20; k++) {      /* and nothing is drawn outside */
            double p[2];
            unsigned in = 0;
            drawing_eval(&parts.curve[i], k / 20.0, p);
            for (int n = 0; n < 9; n++)
                in += cairo_in_fill(cairo, p[0] + 0.02 * (n % 3 - 1), p[1] + 0.02 * (n / 3 - 1)) !=
                      0;
            CHECK(in > 0);
        }
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
    drawing_free(&outline);
    drawing_free(&whole);
    drawing_free(&parts);
}

int main(void)
{
    PROPERTY(clip_paths_cut, 1);
    PROPERTY(white_masks_cut, 1);
    PROPERTY(clip_paths_inherit_from_where_they_stand, 1);
    PROPERTY(clip_paths_are_of_geometry, 1);
    PROPERTY(clip_paths_are_clipped, 1);
    PROPERTY(boxes_count_what_is_hidden, 1);
    PROPERTY(what_is_inside_stays, 200);
    return check_failures();
}
