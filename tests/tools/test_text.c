/* tests/tools/test_text.c -- text of SVG: the outlines that Pango and cairo give at once, the
 * places that lists, anchors and paths give, and letters of single lines
 * SPDX-License-Identifier: MIT
 */
#include <pango/pangocairo.h>

#include "support/kept_fonts.h"
#include "tools/drawn.h"
#include "svg/svg_file.h"

#define FONT "DejaVu Sans"

static bool box_of(const char *inner, const char *how, double box[2][2])
{
    char text[4000];
    drawing d = { .text = how };

    snprintf(text, sizeof text, PAGE("<g font-family='" FONT "' font-size='8'>%s</g>"), inner);
    hear();
    const bool good = drawing_read_svg(&heard, &d, "test.svg", text, strlen(text)) == 0 &&
                      drawing_box(&d, box);
    drawing_free(&d);
    return good;
}

/* Do both draw in boxes that are `x` and `y` apart (mm, y up)? */
static void check_apart(const char *a, const char *b, double x, double y, const char *file,
                        int line)
{
    double one[2][2], other[2][2];
    const double by[2] = { x, y };

    if (!box_of(a, NULL, one) || !box_of(b, NULL, other)) {
        printf("%s:%d: nothing drawn: %s\n", file, line, caught);
        check_bad = true;
        return;
    }
    for (int k = 0; k < 4; k++)
        if (fabs(other[k / 2][k % 2] - one[k / 2][k % 2] - by[k % 2]) > 1e-4) {
            printf("%s:%d: %s %g away\n", file, line, k % 2 ? "y" : "x",
                   other[k / 2][k % 2] - one[k / 2][k % 2]);
            check_bad = true;
        }
}
#define APART(a, b, x, y) check_apart(a, b, x, y, __FILE__, __LINE__)

/* The ink and the width that Pango gives for a whole layout, at 1000 px an em. */
static double layout_box(const char *text, PangoWeight weight, PangoStyle style, double box[2][2])
{
    PangoFontMap *map           = pango_cairo_font_map_new_for_font_type(CAIRO_FONT_TYPE_FT);
    PangoContext *context       = pango_font_map_create_context(map);
    PangoLayout *layout         = pango_layout_new(context);
    PangoFontDescription *f     = pango_font_description_from_string(FONT);
    cairo_font_options_t *plain = cairo_font_options_create();
    cairo_surface_t *surface    = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
    cairo_t *cairo              = cairo_create(surface);
    int width;

    cairo_font_options_set_hint_style(plain, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(plain, CAIRO_HINT_METRICS_OFF);
    pango_cairo_context_set_font_options(context, plain);
    pango_context_set_round_glyph_positions(context, FALSE);
    pango_font_description_set_absolute_size(f, 1000 * PANGO_SCALE);
    pango_font_description_set_weight(f, weight);
    pango_font_description_set_style(f, style);
    pango_layout_set_font_description(layout, f);
    pango_layout_set_text(layout, text, -1);
    pango_layout_get_size(layout, &width, NULL);
    cairo_move_to(cairo, 0, 0);
    pango_cairo_layout_line_path(cairo, pango_layout_get_line_readonly(layout, 0));
    cairo_path_extents(cairo, &box[0][0], &box[0][1], &box[1][0], &box[1][1]);
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
    cairo_font_options_destroy(plain);
    pango_font_description_free(f);
    g_object_unref(layout);
    g_object_unref(context);
    g_object_unref(map);
    return (double)width / PANGO_SCALE / 1000;
}

static void outlines_are_those_of_a_layout(arb *a)
{
    static const struct {
        PangoWeight weight;
        PangoStyle style;
        const char *css;
    } looks[] = { { PANGO_WEIGHT_NORMAL, PANGO_STYLE_NORMAL, "font-weight:normal" },
                  { PANGO_WEIGHT_BOLD, PANGO_STYLE_NORMAL, "font-weight:bold" },
                  { PANGO_WEIGHT_BOLD, PANGO_STYLE_NORMAL, "font:700 16px/1.2 " FONT },
                  { PANGO_WEIGHT_NORMAL, PANGO_STYLE_ITALIC, "font-style:italic" } };
    static const char *const words[] = { "AVATAR",
                                         "fi fl ffi",
                                         "W\xC3\xB6rter, To.",
                                         "Tj",
                                         "\xD7\xA9\xD7\x9C\xD7\x95\xD7\x9D",
                                         "a \xD7\xA9\xD7\x9C b" };
    const size_t which = arb_below(a, 6), look = arb_below(a, 4);
    const double size = 1 + (double)arb_below(a, 400) / 16, x = (double)arb_below(a, 1000) / 16,
                 y = (double)arb_below(a, 1000) / 16;
    static const double parts[] = { 0, 0.5, 1 };
    static const char *const anchors[] = { "start", "middle", "end" };
    const size_t anchor = arb_below(a, 3);
    double wanted[2][2], box[2][2];
    char inner[400];

    const double width = layout_box(words[which], looks[look].weight, looks[look].style, wanted);
    snprintf(inner, sizeof inner,
             "<text x='%.4f' y='%.4f' text-anchor='%s' style='%s;font-size:%.4f'>%s</text>", x, y,
             anchors[anchor], looks[look].css, size, words[which]);
    CHECK(box_of(inner, NULL, box) && caught_lines == 0);
    for (int k = 0; k < 2; k++) {
        const double left = x - parts[anchor] * width * size + wanted[k][0] / 1000 * size,
                     up   = 100 - y - wanted[1 - k][1] / 1000 * size;
        CHECK(fabs(box[k][0] - left) < 2e-4 * size && fabs(box[k][1] - up) < 2e-4 * size);
    }
}

static void letters_have_places_of_their_own(arb *a)
{
    (void)a;
    APART("<text x='10' y='20'>A</text>", "<text x='30' y='25'>A</text>", 20, -5);
    APART("<text x='10' y='20'>A</text>", "<text dx='3' dy='-2' x='10' y='20'>A</text>", 3, 2);
    APART("<text x='10' y='20'>A</text>", "<text dx='1em' x='10' y='20'>A</text>", 8, 0);
    APART("<text x='10' y='20'>A</text>",
          "<text x='50' y='50'><tspan x='10' y='20'>A</tspan></text>", 0, 0);
    APART("<text x='10 30' y='20'>AA</text>", "<text x='10' y='20'>A<tspan x='30'>A</tspan></text>",
          0, 0);
    APART("<text x='10' y='20'>oo</text>", "<text x='10' y='20'>o<tspan>o</tspan></text>", 0, 0);
    APART("<text x='10 20 30' y='20'>A<tspan x='40'>B</tspan>C</text>",
          "<text x='10' y='20'>A<tspan x='40'>B</tspan><tspan x='30'>C</tspan></text>", 0, 0);
    APART("<text x='10' y='20' dy='0 5'>AA</text>",
          "<text x='10' y='20'>A<tspan dy='5'>A</tspan></text>", 0, 0);
    APART("<text x='10' y='20'>\n  A \n\t B\n </text>", "<text x='10' y='20'>A B</text>", 0, 0);
    APART("<text x='10' y='20'>A</text>", "<text xml:space='preserve' x='10' y='20'>A </text>", 0,
          0);
    APART("<text x='10' y='20'>A</text>",
          "<text x='10' y='20'>A<tspan display='none'>BBB</tspan></text>", 0, 0);
    APART("<text x='10' y='20'>A</text>",
          "<text x='10' y='20'>A<tspan visibility='hidden'>BBB</tspan></text>", 0, 0);
    APART("<text x='10' y='20'>A</text>",
          "<text x='10' y='20' transform='translate(1 2)'><tspan baseline-shift='3'>A</tspan>"
          "</text>",
          1, 1);
    APART("<g transform='translate(10 20) rotate(30)'><text>A</text></g>",
          "<text x='10' y='20' rotate='30'>A</text>", 0, 0);
    APART("<text x='10' y='20' letter-spacing='5'>oo</text>",
          "<text x='10' y='20'>o<tspan dx='5'>o</tspan></text>", 0, 0);
    APART("<text x='10' y='20'>o o</text>",
          "<text x='10' y='20' word-spacing='-2'>o <tspan dx='2'>o</tspan></text>", 0, 0);
}

/* Characters of UTF-8 in a text. */
static size_t count_characters(const char *text)
{
    size_t count = 0;

    for (; *text != '\0'; text++)
        count += ((unsigned char)*text & 0xC0) != 0x80;
    return count;
}

static const char *character(const char *text, size_t which)
{
    for (size_t k = 0; k < which; k++)
        while (((unsigned char)*++text & 0xC0) == 0x80)
            ;
    return text;
}

/* Letters kern, join and are ordered as a whole: neither an element around some of them nor places
 * that come to nothing change that. */
static void letters_join_across_elements(arb *a)
{
    static const char *const words[] = { "AVATAR",
                                         "VAVA To.",
                                         "Wo fi ffi",
                                         "T.Y.P",
                                         "\xD8\xA8\xD8\xB9\xD8\xB6 \xD8\xA7\xD9\x84\xD9\x86",
                                         "a \xD7\xA9\xD7\x9C\xD7\x95 b",
                                         "x\xCC\x90y e\xCC\x81z" };
    const char *word = words[arb_below(a, 7)];
    const size_t n = count_characters(word), from = 1 + arb_below(a, (uint32_t)n - 1),
                 to = from + arb_below(a, (uint32_t)(n - from));
    char plain[300], around[400];

    snprintf(plain, sizeof plain, "<text x='10' y='20'>%s</text>", word);
    snprintf(around, sizeof around,
             "<text x='10' y='20'>%.*s<tspan fill='red'>%.*s</tspan>%s</text>",
             (int)(character(word, from) - word), word,
             (int)(character(word, to) - character(word, from)), character(word, from),
             character(word, to));
    APART(plain, around, 0, 0);
    if (word[0] == 'A' || word[0] == 'V')       /* all of one height */
        APART("<text x='10' y='20'>AVATAR</text>",
              "<text x='10' y='20' dx='0 2 -2 3 -3'>AVATAR</text>", 0, 0);
}

static void properties_of_fonts_hold_where_they_stand(arb *a)
{
    double kerned[2][2], plain[2][2];

    (void)a;
    APART("<text y='20'>AB</text>", "<g baseline-shift='5'><text y='20'>AB</text></g>", 0, 0);
    APART("<text y='20'>AB</text>", "<g alignment-baseline='hanging'><text y='20'>AB</text></g>", 0,
          0);
    APART("<text y='20' dominant-baseline='middle'>A<tspan>B</tspan></text>",
          "<text y='20' dominant-baseline='middle'>A<tspan alignment-baseline='baseline'>B</tspan>"
          "</text>",
          0, 0);
    APART("<text y='20'>\xD8\xA8\xD8\xB9</text>",
          "<text y='20' letter-spacing='5'>\xD8\xA8\xD8\xB9</text>", 0, 0);
    APART("<text y='20'>AVA</text>", "<text y='20' font-kerning='none'>AVA</text>", 0, 0);
    APART("<text y='20' style='font:8px DejaVu Sans'>AVA</text>",
          "<g style='font-kerning:none'><text y='20' style='font:8px DejaVu Sans'>AVA</text></g>",
          0, 0);
    CHECK(box_of("<text y='20'>AVA</text>", NULL, kerned));
    CHECK(box_of("<text y='20' style='font-kerning:none'>AVA</text>", NULL, plain));
    CHECK(plain[1][0] > kerned[1][0] + 0.2);
    /* DejaVu Sans: x is 1120 of 2048 high, its ascent is 1901 */
    APART("<text y='20'>A</text>", "<text y='20' dominant-baseline='middle'>A</text>", 0,
          -4 * 1120 / 2048.0);
    APART("<text y='20'>A</text>", "<text y='20' dominant-baseline='mathematical'>A</text>", 0,
          -4 * 1901 / 2048.0);
    /* the last letter of a part has its gap, too */
    APART("<text x='10' y='20'>I<tspan textLength='40'>I</tspan>I</text>",
          "<text x='10' y='20'>III</text>", 0, 0);
    CHECK(box_of("<text x='10' y='20'><tspan textLength='40'>II</tspan>I</text>", NULL, kerned) &&
          box_of("<text x='10' y='20' textLength='40'>II</text>", NULL, plain));
    CHECK(fabs(kerned[1][0] - (2 * plain[1][0] - 10 - (plain[0][0] - 10))) < 3);
}

static void text_follows_a_path(arb *a)
{
    (void)a;
    const char *line = "<defs><path id='p' d='M10 50H40H90'/></defs>";
    char both[400];

    snprintf(both, sizeof both, "%s<text><textPath href='#p'>Along</textPath></text>", line);
    APART("<text x='10' y='50'>Along</text>", both, 0, 0);
    snprintf(both, sizeof both,
             "%s<text text-anchor='end'><textPath startOffset='50%%' href='#p'>Along</textPath>"
             "</text>",
             line);
    APART("<text x='50' y='50' text-anchor='end'>Along</text>", both, 0, 0);
    snprintf(both, sizeof both,
             "<defs><path id='p' d='M10 50V90'/></defs>"
             "<text dy='3'><textPath href='#p' startOffset='5'>A</textPath></text>");
    APART("<g transform='translate(10 50) rotate(90)'><text x='5' y='0'>A</text></g>", both, -3, 0);
    snprintf(both, sizeof both, "%s<text x='5' y='9'><textPath href='#p'>Along</textPath></text>",
             line);
    APART("<text x='15' y='50'>Along</text>", both, 0, 0);
    snprintf(both, sizeof both, "%s<text><textPath href='#p' x='5' dy='9'>Along</textPath></text>",
             line);
    APART("<text x='10' y='50'>Along</text>", both, 0, 0);
    snprintf(both, sizeof both,
             "%s<text><textPath href='#p'>Along<textPath href='#p'>of</textPath></textPath></text>",
             line);
    APART("<text x='10' y='50'>Along</text>", both, 0, 0);
    snprintf(both, sizeof both,
             "%s<text text-decoration='underline'><textPath href='#p'>Along</textPath></text>",
             line);
    APART("<text x='10' y='50' text-decoration='underline'>Along</text>", both, 0, 0);
    double box[2][2];
    snprintf(both, sizeof both,
             "%s<text><textPath startOffset='79' href='#p'>AAA</textPath></text>", line);
    CHECK(!box_of(both, NULL, box));        /* beyond its end */
}

/* Like DRAWS, with letters of single lines: a unit of Hershey is size / 30. */
/* One that has no single lines becomes an outline; the others do not. */
static void a_letter_without_lines_is_an_outline(arb *a)
{
    static const char text[] = PAGE("<text x='10' y='50' font-size='30'>T\xD0\x96T\xD0\x96</text>");
    unsigned lines = 0, outlines = 0, shapes = 1;
    drawing d = { .text = "line" };

    (void)a;
    caught_lines = 0;
    CHECK(drawing_read_svg(&heard, &d, "test.svg", text, strlen(text)) == 0 && caught_lines == 1);
    for (size_t i = 0; i < d.count; i++) {
        const bool filled = d.curve[i].fill & DRAWING_FILLED;
        lines += !filled;
        outlines += filled;
        shapes += i > 0 && d.curve[i].fill != d.curve[i - 1].fill;
    }
    CHECK(lines == 4 && outlines > 20 && shapes == 4);
    drawing_free(&d);
}

/* Angles have no units, parts no transform, and a decoration is a list of its own words. */
static void what_means_nothing_in_text_changes_nothing(arb *a)
{
    (void)a;
    APART("<text y='9' rotate='90'>HI</text>", "<text y='9' rotate='90'>HI</text>", 0, 0);
    APART("<text y='9'>HI</text>", "<text y='9' rotate='5mm'>HI</text>", 0, 0);
    CHECK(strstr(caught, "rotate is not used") != NULL);
    APART("<text y='9'>HI</text>", "<text y='9'><tspan transform='scale(3)'>HI</tspan></text>", 0,
          0);
    APART("<text y='9'>HI</text>", "<text y='9' text-decoration='underline,overline'>HI</text>", 0,
          0);
    APART("<text y='9' text-decoration='underline'>HI</text>",
          "<text y='9' style='text-decoration:underline wavy red'>HI</text>", 0, 0);
    APART("<text y='9'>HI<tref href='#a'/></text>", "<text y='9' text-anchor='start'>HI</text>", 0,
          0);
    APART("<text y='9' text-anchor='end'>H</text>",
          "<text y='9' text-anchor='end' letter-spacing='5'>H</text>", 0, 0);
    APART("<text y='9'>a b</text>",
          "<text y='9' xml:space='preserve'><tspan xml:space='default'>  a   b</tspan></text>", 0,
          0);
}

#define TT "M 18 29 L 18 50 M 11 29 L 25 29 M 66 29 L 66 50 M 59 29 L 73 29"

static void single_lines(arb *a)
{
    static const struct {
        const char *inner, *drawn;
    } texts[] = {
        { "<text x='10' y='50' font-size='30'>T</text>", "M 18 29 L 18 50 M 11 29 L 25 29" },
        { "<text x='10' y='50' font-size='30' text-anchor='end'>T</text>",
          "M 2 29 L 2 50 M -5 29 L 9 29" },
        { "<text x='10' y='50' font-size='30'>-<tspan dx='1'>-</tspan></text>",
          "M 14 41 L 32 41 M 41 41 L 59 41" },
        { "<text x='10' y='50' font-size='30'>\xC3\xA8</text>", NULL },
        { "<text x='10' y='50' font-size='30'>\xE2\x80\x93</text>", "M 14 41 L 32 41" },
        { "<text x='10' y='50' font-size='30' textLength='64'>TT</text>", TT },
        { "<text x='10' y='50' font-size='30' textLength='64' lengthAdjust='spacing'>TT </text>",
          TT },
        { "<text x='74' y='50' font-size='30' textLength='64' text-anchor='end'>TT</text>", TT },
        { "<text x='10' y='50' font-size='30' textLength='64' "
          "lengthAdjust='spacingAndGlyphs'>TT</text>",
          "M 26 29 L 26 50 M 12 29 L 40 29 M 58 29 L 58 50 M 44 29 L 72 29" },
        { "<text x='10' y='50' font-size='30'>T<tspan textLength='48'>TT</tspan></text>",
          "M 18 29 L 18 50 M 11 29 L 25 29 M 34 29 L 34 50 M 27 29 L 41 29 M 66 29 L 66 50 M 59 29 "
          "L 73 29" },
        { "<text x='10' y='50' font-size='30' textLength='64'>T<tspan font-size='15'/></text>",
          "M 18 29 L 18 50 M 11 29 L 25 29" },
    };

    (void)a;
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        char text[1000], got[4000];
        drawing d = { .text = "line" };
        snprintf(text, sizeof text, PAGE("%s"), texts[i].inner);
        CHECK(drawing_read_svg(&heard, &d, "test.svg", text, strlen(text)) == 0);
        put_drawing(got, sizeof got, &d, 100);
        if (texts[i].drawn != NULL && strcmp(got, texts[i].drawn) != 0) {
            printf("%s: %s\n", texts[i].inner, got);
            check_bad = true;
        }
        drawing_free(&d);
    }
    double plain[2][2], accent[2][2];
    CHECK(box_of("<text x='9' y='50'>e</text>", "line", plain) &&
          box_of("<text x='9' y='50'>\xC3\xA8</text>", "line:futural", accent));
    CHECK(accent[1][1] > plain[1][1] + 0.2 && accent[0][1] >= plain[0][1]);
    CHECK(!box_of("<text x='9' y='50'>e</text>", "none", plain) && caught_lines == 0);
    CHECK(!box_of("<text x='9' y='50'>e</text>", "line:nofont", plain) &&
          strstr(caught, "--text line: no font \"nofont\""));
    CHECK(!box_of("<text/>", "thick", plain) && strstr(caught, "give outline, line, line:FONT"));
    CHECK(box_of("<text x='9' y='50'>\xD0\x96</text>", "line", plain) &&
          strstr(caught, "letters without single lines"));
}

static void floods_of_letters_are_stopped(arb *a)
{
    char *text = tool_grow(NULL, 300000);
    char *end  = text + sprintf(text, "<svg xmlns='http://www.w3.org/2000/svg' width='9' "
                                     "height='9'><text id='t'>");

    (void)a;
    for (int i = 0; i < 210000; i++)
        *end++ = 'i';
    strcpy(end, "</text></svg>");
    check_refuses(text, "<text>: more than 200000 letters", __FILE__, __LINE__);
    free(text);
}

static void damaged_text_does_no_harm(arb *a)
{
    char text[] = PAGE("<path id='p' d='M1 9C2 3 4 5 60 70'/><text x='1 2' y='3em' rotate='5 6' "
                       "style='font:bold 9px/1 serif;letter-spacing:1px'>ab \xC3\xA4<tspan dx='1' "
                       "dy='2 3'>c</tspan><textPath xlink:href='#p' startOffset='9%'>on it"
                       "</textPath></text>");
    drawing d = { .text = arb_below(a, 2) ? "line" : NULL };

    for (size_t k = 1 + arb_below(a, 4); k > 0; k--)
        text[arb_below(a, sizeof text - 1)] = (char)(1 + arb_below(a, 255));
    hear();
    const int code = drawing_read_svg(&heard, &d, "test.svg", text, strlen(text));
    CHECK(code == 0 || (code == EX_DATAERR && caught_lines >= 1));
    for (size_t i = 0; code == 0 && i < d.count; i++)
        for (int k = 0; k < 4; k++)
            CHECK(isfinite(d.curve[i].p[k][0]) && isfinite(d.curve[i].p[k][1]));
    drawing_free(&d);
}

int main(void)
{
    PROPERTY(outlines_are_those_of_a_layout, 200);
    PROPERTY(letters_have_places_of_their_own, 1);
    PROPERTY(letters_join_across_elements, 100);
    PROPERTY(properties_of_fonts_hold_where_they_stand, 1);
    PROPERTY(text_follows_a_path, 1);
    PROPERTY(what_means_nothing_in_text_changes_nothing, 1);
    PROPERTY(single_lines, 1);
    PROPERTY(a_letter_without_lines_is_an_outline, 1);
    PROPERTY(floods_of_letters_are_stopped, 1);
    PROPERTY(damaged_text_does_no_harm, 300);
    return check_failures();
}
