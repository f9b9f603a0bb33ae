/* host-tools/surface.c -- the kinds of surfaces, and files of them
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>
#include <string.h>

#include "source.h"     /* source_read */
#include "surface.h"
#include "tool.h"       /* tool_error, tool_grow, sysexits */

const char *surface_name(enum surface_kind kind)
{
    static const char *const names[SURFACE_KINDS] = {
        [SURFACE_TENSOR] = "tensor", [SURFACE_TRIANGLE] = "triangle", [SURFACE_COONS] = "coons", [SURFACE_BICUBIC] = "bicubic",
        [SURFACE_PN] = "pn", [SURFACE_SPHERE] = "sphere", [SURFACE_OCTANT] = "octant"
    };
    return names[kind];
}

bool surface_is_triangle(const surface *s)
{
    return s->kind == SURFACE_TRIANGLE || s->kind == SURFACE_PN || s->kind == SURFACE_OCTANT;
}

unsigned surface_points(const surface *s)
{
    switch (s->kind) {
    case SURFACE_TENSOR:   return (s->m + 1) * (s->n + 1);
    case SURFACE_TRIANGLE: return (s->m + 1) * (s->m + 2) / 2;
    case SURFACE_COONS:    return 2 * s->orders * (s->m + s->n + 2);
    case SURFACE_BICUBIC:  return 16;
    case SURFACE_PN:       return 3;
    default:               return 1;
    }
}

surface *surfaces_add(surfaces *all, enum surface_kind kind, unsigned line)
{
    all->surface = tool_grow(all->surface, (all->count + 1) * sizeof *all->surface);
    surface *s = &all->surface[all->count++];
    *s = (surface){ .kind = kind, .orders = 1, .line = line };
    return s;
}

void surface_add_point(surface *s, const surface_point *p)
{
    if ((s->count & (s->count - 1)) == 0)       /* at powers of two there is room for as many again */
        s->point = tool_grow(s->point, (s->count ? 2 * s->count : 1) * sizeof *s->point);
    s->point[s->count++] = *p;
}

void surfaces_free(surfaces *all)
{
    for (size_t i = 0; i < all->count; i++)
        free(all->surface[i].point);
    free(all->surface);
    *all = (surfaces){ 0 };
}

/* The first thing that is neither space nor comment. */
static const char *start_of(const char *text)
{
    if (strncmp(text, "\xEF\xBB\xBF", 3) == 0)
        text += 3;
    for (text += strspn(text, " \t\r\n"); *text == '#'; text += strspn(text, " \t\r\n"))
        text += strcspn(text, "\n");
    return text;
}

int surfaces_read(surfaces *all, const char *file)
{
    size_t size;
    int code;
    char *text = source_read(file, &size, &code);

    if (text == NULL)
        return code;
    if (strlen(text) == size && surface_begins(start_of(text)))
        code = surfaces_read_text(all, source_name(file), text);
    free(text);
    return code;
}

int surfaces_read_only(surfaces *all, const char *file)
{
    const int code = surfaces_read(all, file);

    if (code == 0 && all->count == 0)
        return tool_error(EX_DATAERR, "%s: no surface in it: begin with tensor, triangle, coons, bicubic, pn, sphere or octant",
                          source_name(file));
    return code;
}
