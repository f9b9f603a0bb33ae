/* host-tools/read/drawing_curves.c -- a drawing of curves of any kind: converts each to cubics
 * SPDX-License-Identifier: MIT
 *
 * A curve that starts where the one before ends continues its path. Polynomials up to degree 3 are
 * kept. Others are cut into cubics within DRAWING_TOL.
 */
#include "base/host.h"
#include "geometry/curve_text.h"   /* curves_is_text, curves_read_text */
#include "read/drawing_curves.h"
#include "geometry/drawn.h"   /* drawn_pieces, drawn_cubics */
#include "base/memory.h"    /* memory_grow */

typedef struct {
    host *host;
    drawing *d;
    const curve *c;
    const char *file;
    int code, status;
} pen;

static void draw(void *context, double p[4][CURVE_AXES])
{
    pen *out = context;

    if (out->code == 0)
        out->code = drawing_join_space(out->host, out->d, out->file, out->c->line, p, 0);
}

static void draw_piece(void *context, const piece *p, bool first)
{
    pen *out = context;

    (void)first;
    if (out->code == 0 && out->status == 0)
        out->status = drawn_cubics(p, DRAWING_TOL, draw, out);
}

static int draw_curve(pen *out)
{
    const int opened = drawn_pieces(out->c, draw_piece, out),
              status = opened != 0 ? opened : out->status;

    if (out->code != 0 || status == 0)      /* only the first fault is reported */
        return out->code;
    return host_error(out->host, EX_DATAERR, "curve.not-drawn",
                      (host_place){ out->file, out->c->line }, NULL, "%s: %s",
                      curve_name(out->c->kind), curve_status(out->c, status));
}

int drawing_read_curves(host *h, drawing *d, const char *file, const char *text)
{
    curves *all = d->of = memory_grow(NULL, sizeof *d->of);
    int code;

    *all = (curves){ .drawn = true };
    code = curves_read_text(h, all, file, text);
    for (size_t i = 0; i < all->count && code == 0; i++) {
        pen out = { h, d, &all->curve[i], file, 0, 0 };
        code = draw_curve(&out);
    }
    return code;
}

static int probe_loft(const reader *r, const char *file, const char *text, size_t size)
{
    (void)r, (void)size;
    return curves_is_text(file, text) ? READER_WORD : READER_NOT;
}

static int read_whole(host *h, drawing *d, const char *file, source *s)
{
    return drawing_read_curves(h, d, file, s->text);
}

const reader reader_loft = { .name   = "curves as LOFT.md describes them",
                             .probe  = probe_loft,
                             .read   = read_whole,
                             .curves = curves_read_text };
