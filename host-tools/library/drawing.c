/* host-tools/library/drawing.c -- handlers and drawings
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>
#include <string.h>

#include "arrange/order.h"      /* order_apply */
#include "base/memory.h"
#include "base/source.h"        /* source_name */
#include "library/inside.h"
#include "readers.h"            /* drawing_read */

#define JOIN   0.005            /* mm */
#define EFFORT 2.0              /* s */

// The host
// --------

static void tell(void *context, const host_message *m)
{
    const loft_host *h        = context;
    const loft_host_message n = { m->code, m->name, m->at.file, m->at.line, m->what, m->remedy };

    if (h->calls.message != NULL)
        h->calls.message(h->calls.context, &n);
}

static bool show(void *context, const host_progress *p)
{
    const loft_host *h         = context;
    const loft_host_progress n = { p->doing, p->done, p->total };

    return h->calls.progress(h->calls.context, &n);
}

static double time_of(void *context)
{
    const loft_host *h = context;

    return h->calls.now(h->calls.context);
}

loft_host *loft_host_open(const loft_host_calls *calls)
{
    loft_host *h = memory_grow(NULL, sizeof *h);

    *h = (loft_host){ .calls = *calls };
    h->h = (host){ .message  = tell,
                   .progress = calls->progress != NULL ? show : NULL,
                   .now      = calls->now != NULL ? time_of : NULL,
                   .context  = h,
                   .state    = calls->state,
                   .strict   = calls->strict };
    return h;
}

void loft_host_close(loft_host *h)
{
    if (h != NULL)
        host_close(&h->h);
    free(h);
}

void loft_host_no_memory(void (*handler)(size_t bytes)) { memory_is_out(handler); }


// Drawings
// --------

int loft_host_read(loft_host *h, const char *file, loft_host_drawing **out)
{
    loft_host_drawing *d = memory_grow(NULL, sizeof *d);
    const size_t length  = strlen(file) + 1;

    *d = (loft_host_drawing){ .file = memory_grow(NULL, length) };
    memcpy(d->file, file, length);
    const int code = drawing_read(&h->h, &d->d, file);
    if (code != 0) {
        loft_host_drawing_free(d);
        d = NULL;
    }
    *out = d;
    return code;
}

void loft_host_drawing_free(loft_host_drawing *d)
{
    if (d == NULL)
        return;
    drawing_free(&d->d);
    free(d->file);
    free(d);
}

size_t loft_host_curves(const loft_host_drawing *d) { return d->d.count; }

void loft_host_curve_at(const loft_host_drawing *d, size_t i, loft_host_curve *out)
{
    const drawing_curve *c = &d->d.curve[i];

    *out = (loft_host_curve){ .path = c->path, .line = c->line };
    for (int k = 0; k < 4; k++) {
        memcpy(out->p[k], c->p[k], sizeof c->p[k]);
        out->p[k][2] = c->z[k];
    }
}

int loft_host_order(loft_host *h, loft_host_drawing *d, const loft_host_order_options *o)
{
    const double zero[2] = { 0, 0 };
    order_options how    = { .how = "best", .effort = EFFORT, .join = JOIN };

    if (o != NULL) {
        how.effort  = o->effort > 0 ? o->effort : how.effort;
        how.join    = o->join > 0 ? o->join : how.join;
        how.seam    = o->seam;
        how.doubles = o->doubles;
    }
    return order_apply(&h->h, &how, &d->d, zero, false, d->file);
}
