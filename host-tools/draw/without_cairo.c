/* host-tools/draw/without_cairo.c -- replaces all pictures if loft is built without cairo
 * SPDX-License-Identifier: MIT
 */
#include "base/tool.h"
#include "draw/gallery.h"
#include "draw/plan_plot.h"
#include "draw/plot.h"
#include "draw/surface_plot.h"

static int refused(const char *output)
{
    return tool_error(EX_UNAVAILABLE,
                      "%s: this loft was built without cairo, which draws: build "
                      "it with cairo",
                      output);
}

bool plot_known(const char *output, bool *png)
{
    (void)output;
    *png = false;
    return true;                /* the functions that draw refuse it */
}

int plan_plot(const plan_picture *p) { return refused(p->output); }

int plot_draw(const plot_options *o, plot_result *found)
{
    (void)found;
    return refused(o->output);
}

int surface_plot(const surface_options *o) { return refused(o->output); }

int gallery_draw(const gallery *g, const gallery_panel panel[], size_t count)
{
    (void)panel;
    (void)count;
    return refused(g->output);
}
