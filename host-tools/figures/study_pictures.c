/* host-tools/figures/study_pictures.c
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "polygon/gb.h"     /* loft_gb_place */

#include "draw/mesh_contour.h"           /* contour_heights */
#include "engine/engine_sided.h"    /* cut */
#include "draw/gallery.h"
#include "figures/study_pictures.h"
#include "base/tool.h"

#define PANELS 15
#define CELLS  48
#define LEVELS 40

static const double shifts[5] = { -1.6, -0.6, 0, 1.4, 4.4 },
                    heights[5] = { 0.05, 0.15, 0.2, 0.25, 0.4 };
static const char *const names[CHAPTER_KINDS] = { "Wachspress", "mean value", "harmonic" };

/* The content of one panel. */
typedef struct {
    surfaces all;
    mesh m;
    double *value, level[LEVELS];
    char title[80];
} view;

typedef struct {
    const engine *e;
    const chapter_pentagon *p;
    const char *folder;
    view seen[PANELS];
    gallery_panel panel[PANELS];
    size_t count;
} album;

/* The patch with one kind of coordinates, heights times `scale`, V0 at `top`. */
static int make_view(album *a, unsigned kind, double scale, double top, view **out)
{
    view *w = &a->seen[a->count];
    surface *s = surfaces_add(&w->all, SURFACE_GB, 0);
    surface_point p[46];
    unsigned where[2];

    s->n = s->m = s->corners = CHAPTER_SIDES;
    s->coordinates = kind == 0   ? COORDINATES_WACHSPRESS
                     : kind == 1 ? COORDINATES_MEANVALUE
                                 : COORDINATES_HARMONIC;
    memcpy(s->domain, a->p->v, sizeof a->p->v);
    if (engine_sides_f64.cut(s, where) != 0)
        return tool_error(EX_DATAERR, "%s: not a simple polygon that runs counterclockwise",
                          a->p->name);
    memset(p, 0, sizeof p);
    for (unsigned i = 0; i < CHAPTER_SIDES; i++)
        for (unsigned k = 0; k < 3; k++)
            for (unsigned j = k; j + k <= 5; j++)
                chapter_net(a->p->v, i, j, k, p[loft_gb_place(CHAPTER_SIDES, 5, i, j, k)].p);
    chapter_middle(a->p->v, p[45].p);
    for (unsigned i = 0; i < 46; i++) {
        p[i].p[2] = i < 45 ? scale * p[i].p[2] : top;
        p[i].w = p[i].c = 1;
        surface_add_point(s, &p[i]);
    }
    a->panel[a->count] = (gallery_panel){ .m = &w->m, .title = w->title };
    a->count++;
    *out = w;
    return mesh_make(tool_host(), &w->m, &w->all, a->p->name, a->e, CELLS, CELLS / 4);
}

static void clear_views(album *a)
{
    for (size_t i = 0; i < a->count; i++) {
        surfaces_free(&a->seen[i].all);
        mesh_free(&a->seen[i].m);
        free(a->seen[i].value);
    }
    memset(a->seen, 0, sizeof a->seen);
    memset(a->panel, 0, sizeof a->panel);
    a->count = 0;
}

/* Draw the collected views, unless there was an error before. */
static int hang_picture(album *a, int code, gallery g, const char *name)
{
    char file[400], title[160];

    snprintf(file, sizeof file, "%s/%s-%s.png", a->folder, a->p->name, name);
    snprintf(title, sizeof title, "%s: %s", a->p->name, g.title);
    g.title = title;
    g.output = file;
    if (code == 0)
        code = gallery_draw(tool_host(), &g, a->panel, a->count);
    if (code == 0)
        printf("drawn %s\n", file);
    clear_views(a);
    return code;
}

static int draw_movement(album *a)
{
    int code = 0;

    for (size_t i = 0; i < 3 && code == 0; i++) {
        const double dz = (double)i * 1.4 - 1.4;
        view *w;
        code = make_view(a, 0, 1, CHAPTER_V0 + dz, &w);
        snprintf(w->title, sizeof w->title, "dz = %g", dz);
        a->panel[a->count - 1].net = &w->all;
    }
    return hang_picture(a, code,
                        (gallery){ .title = "the point in the middle moves up and down",
                                   .columns = 3,
                                   .azimuth = -60,
                                   .elevation = 22,
                                   .size = 1100 },
                        "movement");
}

/* B0 is the height of a patch whose points are flat except for V0. */
static int draw_weight(album *a)
{
    int code = 0;

    for (unsigned kind = 0; kind < CHAPTER_KINDS && code == 0; kind++) {
        view *w;
        code = make_view(a, kind, 0, 1, &w);
        snprintf(w->title, sizeof w->title, "%s", names[kind]);
        w->value = tool_grow(NULL, (w->m.vertices + 1) * sizeof *w->value);
        for (size_t i = 0; i < w->m.vertices; i++)
            w->value[i] = w->m.vertex[i].p[2];
        for (int k = 0; k < 6; k++)
            w->level[k] = 0.05 * k + 1e-6;
        a->panel[a->count - 1] = (gallery_panel){
            .m = &w->m, .value = w->value, .level = w->level, .levels = 6, .title = w->title
        };
    }
    return hang_picture(a, code,
                        (gallery){ .title = "weight B0 of the point in the middle",
                                   .columns = 3,
                                   .values = "B0",
                                   .signs = false,
                                   .azimuth = -90,
                                   .elevation = 90,
                                   .note = "lines at 0, 0.05, 0.1 .. 0.25",
                                   .size = 1100 },
                        "weight");
}

static int draw_contours(album *a)
{
    int code = 0;

    for (size_t i = 0; i < 5 && code == 0; i++)
        for (unsigned kind = 0; kind < CHAPTER_KINDS && code == 0; kind++) {
            view *w;
            code = make_view(a, kind, 1, CHAPTER_V0 + shifts[i], &w);
            snprintf(w->title, sizeof w->title, "%s, dz = %g", names[kind], shifts[i]);
            for (int k = 0; k < LEVELS; k++)
                w->level[k] = 0.1 * (k + 1);
            a->panel[a->count - 1].level = w->level;
            a->panel[a->count - 1].levels = LEVELS;
        }
    return hang_picture(a, code,
                        (gallery){ .title = "contours of the height",
                                   .columns = 3,
                                   .azimuth = -90,
                                   .elevation = 90,
                                   .note = "lines every 0.1, the outermost at 0.1",
                                   .size = 1100 },
                        "contours");
}

static int draw_curvature(album *a)
{
    int code = 0;

    for (size_t i = 0; i < 5 && code == 0; i++)
        for (unsigned kind = 0; kind < CHAPTER_KINDS && code == 0; kind++) {
            view *w;
            code = make_view(a, kind, 1.0 / 8, heights[i], &w);
            snprintf(w->title, sizeof w->title, "%s, V0 at %g", names[kind], heights[i]);
            w->value = tool_grow(NULL, (w->m.vertices + 1) * sizeof *w->value);
            for (size_t k = 0; k < w->m.vertices; k++)
                w->value[k] = w->m.vertex[k].gauss;
            a->panel[a->count - 1].value = w->value;
        }
    return hang_picture(a, code,
                        (gallery){ .title = "Gaussian curvature, heights divided by 8",
                                   .columns = 3,
                                   .values = "K",
                                   .signs = true,
                                   .limit = 0.3,
                                   .azimuth = -90,
                                   .elevation = 90,
                                   .size = 1100 },
                        "curvature");
}

int study_pictures(const engine *e, const char *folder)
{
    static album a;
    int code = 0;

    if (mkdir(folder, 0777) != 0 && errno != EEXIST)
        return tool_error(EX_CANTCREAT, "%s: %s: name a folder that can be made", folder,
                          strerror(errno));
    a.e = e;
    a.folder = folder;
    for (unsigned i = 0; i < 3 && code == 0; i++) {
        a.p = &chapter_pentagons[i];
        code = draw_movement(&a);
        code = code ? code : draw_weight(&a);
        code = code ? code : draw_contours(&a);
        code = code ? code : draw_curvature(&a);
    }
    return code;
}
