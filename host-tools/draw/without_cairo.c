/* host-tools/draw/without_cairo.c -- replaces all pictures if loft is built without cairo
 * SPDX-License-Identifier: MIT
 */
#include "base/host.h"
#include "draw/gallery.h"
#include "draw/plan_plot.h"
#include "draw/plot.h"
#include "draw/surface_plot.h"

static int refused(host *h, const char *output)
{
    return host_error(h, EX_UNAVAILABLE, "picture.no-cairo", (host_place){ output, 0 },
                      "build it with cairo", "this loft was built without cairo, which draws");
}

bool plot_known(const char *output, bool *png)
{
    (void)output;
    *png = false;
    return true;                /* the functions that draw refuse it */
}

int plan_plot(host *h, const plan_picture *p) { return refused(h, p->output); }

int plot_draw(host *h, const plot_options *o, plot_result *found)
{
    (void)found;
    return refused(h, o->output);
}

int surface_plot(host *h, const surface_options *o) { return refused(h, o->output); }

int gallery_draw(host *h, const gallery *g, const gallery_panel panel[], size_t count)
{
    (void)panel;
    (void)count;
    return refused(h, g->output);
}
