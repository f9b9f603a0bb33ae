/* host-tools/draw/export.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>

#include "base/host.h"
#include "draw/export.h"
#include "engine/engine.h"      /* engine_f64: chords */

#define HPGL_PER_MM 40          /* of its plotter units */
#define DECIMALS    6
#define THIRD       1e-9        /* mm: inner points so close to the thirds make a line */

/* A number without needless zeros. */
static void put_number(FILE *out, double x)
{
    char text[40];
    int n = snprintf(text, sizeof text, "%.*f", DECIMALS, x);

    while (text[n - 1] == '0')
        n--;
    n -= text[n - 1] == '.';
    text[n] = '\0';
    fputs(text[0] == '-' && text[1] == '0' && text[2] == '\0' ? "0" : text, out);
}

static bool is_drawn(const drawing_curve *c)    { return !(c->feed < 0); }

/* True if curve i begins a path, also behind a travel. */
static bool begins(const drawing *d, size_t i)
{
    return i == 0 || d->curve[i].path != d->curve[i - 1].path || !is_drawn(&d->curve[i - 1]);
}

static bool is_line(const drawing_curve *c)
{
    for (int i = 0; i < 2; i++)
        if (fabs(c->p[1][i] - (2 * c->p[0][i] + c->p[3][i]) / 3) > THIRD ||
            fabs(c->p[2][i] - (c->p[0][i] + 2 * c->p[3][i]) / 3) > THIRD)
            return false;
    return true;
}

static bool in_space(const drawing *d)
{
    for (size_t i = 0; i < d->count; i++)
        for (int k = 0; k < 4; k++)
            if (fabs(d->curve[i].z[k]) > 0)
                return true;
    return false;
}


// SVG
// ---

static void put_svg_curve(const drawing_curve *c, double top, FILE *out)
{
    const bool line = is_line(c);

    fputs(line ? "L" : "C", out);
    for (int k = line ? 3 : 1; k < 4; k++) {
        fputs(k > 1 && !line ? " " : "", out);
        put_number(out, c->p[k][0]);
        fputs(" ", out);
        put_number(out, top - c->p[k][1]);
    }
}

static void put_attribute(FILE *out, const char *before, double x, const char *after)
{
    fputs(before, out);
    put_number(out, x);
    fputs(after, out);
}

/* The page begins at 0, 0; without a page it is the box. */
static void put_svg_head(const drawing *d, bool layers, double *top, FILE *out)
{
    double box[2][2] = { { 0 } };
    const bool page  = d->width > 0 && d->height > 0;

    (void)drawing_box(d, box);
    const double left = page ? 0 : box[0][0], bottom = page ? 0 : box[0][1],
                 width = page ? d->width : fmax(box[1][0] - left, 1e-3),
                 height = page ? d->height : fmax(box[1][1] - bottom, 1e-3);
    *top = bottom + height;
    fputs("<svg xmlns=\"http://www.w3.org/2000/svg\" ", out);
    if (layers)
        fputs("xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" ", out);
    put_attribute(out, "width=\"", width, "mm\" ");
    put_attribute(out, "height=\"", height, "mm\" ");
    put_attribute(out, "viewBox=\"", left, " 0 ");
    put_attribute(out, "", width, " ");
    put_attribute(out, "", height, "\" fill=\"none\" stroke=\"#000\" stroke-width=\"0.2\">\n");
}

static void put_escaped(const char *text, FILE *out)
{
    for (; *text != '\0'; text++)
        switch (*text) {
        case '&': fputs("&amp;", out);  break;
        case '<': fputs("&lt;", out);   break;
        case '"': fputs("&quot;", out); break;
        default:  fputc(*text, out);    break;
        }
}

/* From the layer `from` to the layer `to`; 0: in none. */
static void change_layer(const export_options *o, unsigned from, unsigned to, FILE *out)
{
    if (from == to)
        return;
    fputs(from > 0 ? "</g>\n" : "", out);
    if (to == 0)
        return;
    fputs("<g inkscape:groupmode=\"layer\" inkscape:label=\"", out);
    put_escaped(o->layers->name[to - 1], out);
    fputs("\">\n", out);
}

int export_svg(const export_options *o, FILE *out)
{
    const drawing *d   = o->d;
    const size_t named = o->layers ? o->layers->count : 0;
    bool open          = false;
    unsigned layer     = 0;
    double top;

    put_svg_head(d, named > 0, &top, out);
    for (size_t i = 0; i < d->count; i++) {
        const drawing_curve *c = &d->curve[i];
        if (!is_drawn(c))
            continue;
        if (begins(d, i)) {
            const unsigned in = c->layer <= named ? c->layer : 0;
            fputs(open ? "\"/>\n" : "", out);
            change_layer(o, layer, in, out);
            put_attribute(out, "<path d=\"M", c->p[0][0], " ");
            put_number(out, top - c->p[0][1]);
            layer = in;
            open  = true;
        }
        put_svg_curve(c, top, out);
    }
    fputs(open ? "\"/>\n" : "", out);
    change_layer(o, layer, 0, out);
    fputs("</svg>\n", out);
    return 0;
}


// Numbers
// -------

int export_csv(const export_options *o, FILE *out)
{
    if (in_space(o->d))
        return host_error(o->host, EX_DATAERR, "export.heights", (host_place){ o->name, 0 },
                          "export .loft", "has heights, which these rows have not");
    fputs("x0,y0,x1,y1,x2,y2,x3,y3\n", out);
    for (size_t i = 0; i < o->d->count; i++)
        for (int k = 0; k < 4 && is_drawn(&o->d->curve[i]); k++) {
            put_number(out, o->d->curve[i].p[k][0]);
            fputs(",", out);
            put_number(out, o->d->curve[i].p[k][1]);
            fputs(k < 3 ? "," : "\n", out);
        }
    return 0;
}

int export_loft(const export_options *o, FILE *out)
{
    const bool space = in_space(o->d);

    for (size_t i = 0; i < o->d->count; i++) {
        const drawing_curve *c = &o->d->curve[i];
        if (!is_drawn(c))
            continue;
        fputs("bezier 3\n", out);
        for (int k = 0; k < 4; k++) {
            put_number(out, c->p[k][0]);
            fputs(" ", out);
            put_number(out, c->p[k][1]);
            if (space)
                put_attribute(out, " ", c->z[k], "");
            fputs("\n", out);
        }
    }
    return 0;
}


// HP-GL
// -----

typedef struct {
    FILE *out;
    long at[2];
    bool down;
} plotter;

static void put_place(plotter *p, const double mm[2], bool draws)
{
    const long to[2] = { lround(mm[0] * HPGL_PER_MM), lround(mm[1] * HPGL_PER_MM) };

    if (draws && to[0] == p->at[0] && to[1] == p->at[1])
        return;
    if (draws)
        fprintf(p->out, p->down ? ",%ld,%ld" : "PD%ld,%ld", to[0], to[1]);
    else
        fprintf(p->out, "%sPU%ld,%ld;", p->down ? ";\n" : "", to[0], to[1]);
    p->at[0] = to[0];
    p->at[1] = to[1];
    p->down  = draws;
}

static void put_chord(void *context, const double point[ENGINE_AXES])
{
    put_place(context, point, true);
}

int export_hpgl(const export_options *o, FILE *out)
{
    const drawing *d = o->d;
    plotter p        = { .out = out };
    int status       = 0;

    fputs("IN;SP1;\n", out);
    for (size_t i = 0; i < d->count && status == 0; i++) {
        const drawing_curve *c = &d->curve[i];
        double flat[4][ENGINE_AXES];
        if (!is_drawn(c))
            continue;
        if (begins(d, i))
            put_place(&p, c->p[0], false);
        for (int k = 0; k < 4; k++) {
            flat[k][0] = c->p[k][0];
            flat[k][1] = c->p[k][1];
            flat[k][2] = 0;
        }
        status = engine_f64.flatten((const double(*)[ENGINE_AXES])flat, o->tol, put_chord, &p);
        if (status != 0)
            return host_error(
                o->host, EX_DATAERR, "export.tolerance", (host_place){ o->name, c->line }, NULL,
                "%s",
                engine_status(status, "its chords want a tolerance above 0: give a larger --tol"));
    }
    fprintf(out, "%sPU0,0;SP0;\n", p.down ? ";\n" : "");
    return 0;
}
