/* lib/curve/drawing.c
 * SPDX-License-Identifier: MIT
 */
#include "curve/drawing.h"

static int16_t word_at(const loft_drawing_walk *w, uint32_t i)
{
    return loft_flash_word(&w->of.words[i]);
}

/* A word has 16 bits, so that raw Q16.16 holds it with any number of bits behind the point. */
static loft_real coordinate(loft_drawing_walk *w)
{
    const int32_t word = word_at(w, w->next++);
    return loft_real_from_raw(word * ((int32_t)1 << (16 - w->of.bits)));
}

static void point(loft_drawing_walk *w, loft_vec *p)
{
    for (int i = 0; i < 2; i++) {
        const loft_real x = coordinate(w);
        if (i < LOFT_AXES)
            p->axis[i] = x;
    }
}

/* True if paths and runs end where the table ends. */
static bool whole(const loft_drawing_walk *w)
{
    uint32_t i = 0;

    while (i < w->of.count) {
        const int32_t run = word_at(w, i);
        const uint32_t words = run == 0 ? 3 : 1 + (uint32_t)(run < 0 ? -2 * run : 6 * run);
        if (words > w->of.count - i || (i == 0 && run != 0))
            return false;
        i += words;
        if (run == 0 && (i == w->of.count || word_at(w, i) == 0))
            return false;           /* a path without a curve */
    }
    return true;
}

enum loft_status loft_drawing_begin(loft_drawing_walk *w, const loft_drawing *d)
{
    *w = (loft_drawing_walk) { .of = *d };
    return d->bits <= 16 && whole(w) ? LOFT_OK : LOFT_ERR_DATA;
}

bool loft_drawing_next(loft_drawing_walk *w, loft_cubic *c, bool *lifted)
{
    bool begins = false;

    if (w->left == 0) {
        if (w->next == w->of.count)
            return false;
        int32_t run = word_at(w, w->next++);
        if (run == 0) {
            point(w, &w->at);
            begins = true;
            run = word_at(w, w->next++);
        }
        w->lines = run < 0;
        w->left = (uint16_t)(run < 0 ? -run : run);
    }
    w->left--;
    *lifted = begins;
    const loft_vec from = w->at;
    if (w->lines) {
        point(w, &w->at);
        *c = loft_cubic_line(from, w->at);
    } else {
        c->p[0] = from;
        for (int k = 1; k < 4; k++) {
            c->p[k] = from;
            point(w, &c->p[k]);
        }
        w->at = c->p[3];
    }
    return true;
}
