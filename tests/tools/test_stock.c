/* tests/tools/test_stock.c -- blocks: their words, their places, what leaves them, what is left
 * SPDX-License-Identifier: MIT
 */
#include "mill/left.h"
#include "mill/stock.h"
#include "tools/drawn.h"            /* CHECK, tool_error */
#include "geometry/surface_text.h"

static void words_are_read_or_refused(arb *a)
{
    static const char *const wrong[] = {
        "",         "60x40",      "60x40x20x", "60x40x20@1,2",    "0x40x20",         "-6x40x20",
        "60 40 20", "60x40x5000", "nanx40x20", "60x40x20@1,2,3,", "60x40x20@0,0,1e9"
    };
    stock s = { 0 };

    (void)a;
    CHECK(stock_parse("60x40.5x20", &s) && s.given && !s.placed);
    CHECK(s.size[0] == 60 && s.size[1] == 40.5 && s.size[2] == 20);
    CHECK(stock_parse("6x4x2@-1,2.5,-3", &s) && s.given && s.placed);
    CHECK(s.low[0] == -1 && s.low[1] == 2.5 && s.low[2] == -3);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        CHECK(!stock_parse(wrong[i], &s) && !s.given);
}

/* A ramp from z 1 to 5 over x 0 to 10, y 20 to 26. */
static void read_ramp(surfaces *all)
{
    *all = (surfaces){ 0 };
    CHECK(surfaces_read_text(&heard, all, "-", "tensor 1 1\n0 20 1\n0 26 1\n10 20 5\n10 26 5\n") ==
          0);
}

static int place(const char *text, const mill_trim *trim, stock *s)
{
    const mill_trim none = { 0 };
    surfaces all;

    caught[0] = '\0';
    read_ramp(&all);
    CHECK(stock_parse(text, s));
    const int code = stock_place(&heard, s, &all, trim ? trim : &none, "ramp.loft");
    surfaces_free(&all);
    return code;
}

static void blocks_are_placed_or_refused(arb *a)
{
    double loop[4][2][2] = { { { -1, 19 }, { 5, 19 } },
                             { { 5, 19 }, { 5, 30 } },
                             { { 5, 30 }, { -1, 30 } },
                             { { -1, 30 }, { -1, 19 } } };
    const mill_trim half = { .edge = loop, .count = 4, .plane = true };
    stock s;

    (void)a;
    CHECK(place("14x8x6", NULL, &s) == 0 && s.placed);
    CHECK_NEAR(s.low[0], -2, 1.1e-3);
    CHECK_NEAR(s.low[1], 19, 1.1e-3);
    CHECK_NEAR(s.low[2], -1, 1.1e-3);
    CHECK(s.low[2] + s.size[2] >= 5 - 1e-9);
    CHECK(place("10x6x4", NULL, &s) == 0);              /* exactly as large as the surface */
    CHECK(place("9x8x6", NULL, &s) == EX_DATAERR);
    CHECK(strstr(caught, "ramp.loft:1: tensor: reaches to x ") != NULL);
    CHECK(strstr(caught, "0.500 mm beyond the block: give a larger --stock") != NULL);
    CHECK(place("14x8x3", NULL, &s) == EX_DATAERR);
    CHECK(strstr(caught, "reaches to z 1.000, 1.000 mm below the block") != NULL);
    CHECK(place("14x8x6@-2,19,-2", NULL, &s) == EX_DATAERR);
    CHECK(strstr(caught, "reaches to z 5.000, 1.000 mm beyond the block") != NULL);
    CHECK(place("5x6x2", &half, &s) == 0);              /* of the half: 0 to 5, height 1 to 3 */
    CHECK_NEAR(s.low[2], 1, 0.05);
}

static void lines_stay_over_the_block(arb *a)
{
    double way[3][ENGINE_AXES] = { { 1, 1, 50 }, { 9, 1, -2 }, { 9, 9, 50 } };
    const mill_cut path = { .point = way, .count = 3 };
    stock s;

    (void)a;
    CHECK(stock_parse("10x10x5@0,0,-2", &s) && stock_holds(&heard, &s, &path, "a.loft") == 0);
    way[1][2] = -2.5;
    caught[0] = '\0';
    CHECK(stock_holds(&heard, &s, &path, "a.loft") == EX_DATAERR);
    CHECK(strstr(caught, "z -2.500, 0.500 mm below the block: give a thicker --stock") != NULL);
    way[2][1] = 13;
    caught[0] = '\0';
    CHECK(stock_holds(&heard, &s, &path, "a.loft") == EX_DATAERR);
    CHECK(strstr(caught, "y 13.000, 3.000 mm beyond the block: give a larger --stock, or a smaller "
                         "--area") != NULL);
}

/* A flat end of radius 2 along x = 0 to 20 at y = 0, z = 3; a block to z = 5. */
static void blocks_end_at_their_top_and_sides(arb *a)
{
    static record_pulse pulse[203];
    const record r = { .pulse = pulse, .count = 203, .machine = machine_usual() };
    const mesh_vertex below = { .p = { 10, 1, 2.5 }, .normal = { 0, 0, 1 } },
                      never = { .p = { 10, 6, 2.5 }, .normal = { 0, 0, 1 } },
                      beside = { .p = { 10, 9, 2.5 }, .normal = { 0, 0, 1 } };
    mesh m = { 0 };
    double least = INFINITY, most = -INFINITY, wide = 0;
    left_over l;
    stock s;

    (void)a;
    pulse[0] = (record_pulse){ 0, { 0, 0, 9 } };
    for (int i = 1; i < 203; i++)
        pulse[i] = (record_pulse){ (uint64_t)i, { (i - 1) / 10.0, 0, 3 } };
    CHECK(stock_parse("20x16x4@0,-8,1", &s));
    left_make(&l, &r, 2, 0);
    CHECK_NEAR(left_at(&l, &below), 0.5, 1e-12);
    CHECK(left_at(&l, &never) == 0);
    l.block = &s;
    CHECK_NEAR(left_at(&l, &below), 0.5, 1e-12);
    CHECK_NEAR(left_at(&l, &never), 2.5, 1e-12);
    CHECK(left_at(&l, &beside) == 0);
    left_around(&l, &m);
    CHECK(m.mapped == 0 && m.cells > 200 * 160 && m.vertices == 4 * m.cells);
    for (size_t i = 0; i < m.vertices; i++) {
        const double *const p = m.vertex[i].p;
        least = fmin(least, p[2]);
        most = fmax(most, p[2]);
        wide = fmax(wide, fabs(p[0] - 10) / 10);
        wide = fmax(wide, fabs(p[1]) / 8);
        CHECK(fabs(p[1]) >= 2.0001 || p[2] <= 3 + 1e-12);      /* the groove is empty */
        CHECK(fabs(p[1]) <= 2.0001 || p[0] == 0 || p[0] == 20 || fabs(p[1]) == 8 || p[2] == 5);
    }
    CHECK(least == 1 && most == 5);
    CHECK_NEAR(wide, 1, 1e-12);
    mesh_free(&m);
    left_free(&l);
}

int main(void)
{
    PROPERTY(words_are_read_or_refused, 1);
    PROPERTY(blocks_are_placed_or_refused, 1);
    PROPERTY(lines_stay_over_the_block, 1);
    PROPERTY(blocks_end_at_their_top_and_sides, 1);
    return check_failures();
}
