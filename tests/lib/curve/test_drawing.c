/* tests/lib/curve/test_drawing.c -- properties of lib/curve/drawing.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact.h"      /* exact_of; CHECK, PROPERTY */
#include "curve/drawing.h"

#define WORDS 400
#define MOST  60                /* curves of a table */

/* A table, and what it must give. */
typedef struct {
    int16_t word[WORDS];
    uint32_t count, curves;
    uint8_t bits;
    int16_t point[MOST][4][2];
    bool line[MOST], begins[MOST];
} sample;

static int16_t arb_word(arb *a, sample *s)
{
    const int16_t w = (int16_t)(arb_below(a, 8) ? (int)arb_below(a, 65536) - 32768
                                : arb_below(a, 2) ? 32767
                                                  : -32768);
    s->word[s->count++] = w;
    return w;
}

static void arb_point(arb *a, sample *s, int16_t at[2])
{
    at[0] = arb_word(a, s);
    at[1] = arb_word(a, s);
}

static void arb_run(arb *a, sample *s, int16_t at[2], bool begins)
{
    const int pieces = 1 + (int)arb_below(a, 4);
    const bool line = arb_below(a, 2);

    s->word[s->count++] = (int16_t)(line ? -pieces : pieces);
    for (int i = 0; i < pieces; i++) {
        int16_t (*p)[2] = s->point[s->curves];
        s->line[s->curves] = line;
        s->begins[s->curves] = begins && i == 0;
        p[0][0] = at[0];
        p[0][1] = at[1];
        for (int k = line ? 3 : 1; k < 4; k++)
            arb_point(a, s, p[k]);
        at[0] = p[3][0];
        at[1] = p[3][1];
        s->curves++;
    }
}

static void arb_table(arb *a, sample *s)
{
    *s = (sample) { .bits = (uint8_t)arb_below(a, 17) };
    for (uint32_t paths = arb_below(a, 5); paths > 0; paths--) {
        int16_t at[2];
        s->word[s->count++] = 0;
        arb_point(a, s, at);
        arb_run(a, s, at, true);
        for (uint32_t runs = arb_below(a, 3); runs > 0; runs--)
            arb_run(a, s, at, false);
    }
}

static long double value(const sample *s, int16_t word) { return ldexpl(word, -s->bits); }

static void each_curve_comes_as_it_is(arb *a)
{
    sample s;
    loft_drawing_walk w;
    loft_cubic c;
    bool lifted;

    arb_table(a, &s);
    const loft_drawing d = { s.word, s.count, s.bits };
    CHECK(loft_drawing_begin(&w, &d) == LOFT_OK);
    for (uint32_t n = 0; n < s.curves; n++) {
        CHECK(loft_drawing_next(&w, &c, &lifted));
        CHECK(lifted == s.begins[n]);
        for (int i = 0; i < LOFT_AXES; i++) {
            for (int k = 0; k < 4; k += s.line[n] ? 3 : 1)
                CHECK(exact_of(c.p[k].axis[i]) == (i < 2 ? value(&s, s.point[n][k][i]) : 0));
            if (!s.line[n] || i > 1)
                continue;
            const long double from = value(&s, s.point[n][0][i]), to = value(&s, s.point[n][3][i]);
            const long double near = 2 * ulp(fmaxl(fabsl(from), fabsl(to)));
            CHECK_EXACT(exact_of(c.p[1].axis[i]), (2 * from + to) / 3, near);
            CHECK_EXACT(exact_of(c.p[2].axis[i]), (from + 2 * to) / 3, near);
        }
    }
    CHECK(!loft_drawing_next(&w, &c, &lifted) && !loft_drawing_next(&w, &c, &lifted));
}

static void what_is_no_table_is_refused(arb *a)
{
    sample s;
    loft_drawing_walk w;

    do
        arb_table(a, &s);
    while (s.count == 0);
    loft_drawing d = { s.word, s.count, 17 };
    CHECK(loft_drawing_begin(&w, &d) == LOFT_ERR_DATA);
    d.bits = 16;
    d.count--;                                          /* cut off */
    CHECK(loft_drawing_begin(&w, &d) == LOFT_ERR_DATA);
    d.count = 3;                                        /* a path without a curve */
    CHECK(loft_drawing_begin(&w, &d) == LOFT_ERR_DATA);
    d.words++;                                          /* no path */
    s.word[1] = (int16_t)(1 + arb_below(a, 30000));
    CHECK(loft_drawing_begin(&w, &d) == LOFT_ERR_DATA);
}

/* Whatever the words are: it is refused, or ends without reading beyond them. */
static void no_table_is_read_beyond_its_end(arb *a)
{
    loft_drawing_walk w;
    loft_cubic c;
    bool lifted;
    const uint32_t count = arb_below(a, 40);
    static int16_t words[40];
    int16_t *word = words + 40 - count;                 /* they end where the array does */

    for (uint32_t i = 0; i < count; i++)
        word[i] = (int16_t)((int)arb_below(a, 7) - 3);
    const loft_drawing d = { word, count, 8 };
    if (loft_drawing_begin(&w, &d) == LOFT_OK) {
        uint32_t curves = 0;
        while (loft_drawing_next(&w, &c, &lifted) && curves < 100)
            curves++;
        CHECK(w.next == count && curves < 40);
    }
}

int main(void)
{
    PROPERTY(each_curve_comes_as_it_is, 3000);
    PROPERTY(what_is_no_table_is_refused, 1000);
    PROPERTY(no_table_is_read_beyond_its_end, 20000);
    return check_failures();
}
