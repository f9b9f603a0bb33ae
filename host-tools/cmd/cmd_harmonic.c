/* host-tools/cmd/cmd_harmonic.c -- loft harmonic: harmonic coordinates of a polygon as a table for
 * lib/polygon/harmonic.h
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cmd/commands.h"
#include "engine/engine_harmonic.h"    /* harmonic_solve; the domain that judges polygons */
#include "base/create.h"      /* create_refused */
#include "base/c_name.h"
#include "base/text_lines.h"
#include "base/source.h"

typedef struct {
    lines at;
    double v[HARMONIC_SIDES][2];
    unsigned n;
} reading;

static int vertex(void *context)
{
    reading *r = context;
    double xy[2];

    if (lines_numbers_alone(&r->at, xy, 2) != 2)
        return lines_wrong(&r->at, "harmonic.vertex", "not a vertex", "give two numbers, x and y");
    if (r->n == HARMONIC_SIDES)
        return lines_wrong(&r->at, "harmonic.too-many", "a ninth vertex", "give 3 to 8");
    memcpy(r->v[r->n++], xy, sizeof xy);
    return 0;
}

/* Rounded as the number type has it: the table is for that polygon. */
static void round_vertices(reading *r, const engine *e)
{
    for (unsigned i = 0; i < r->n; i++)
        for (int k = 0; k < 2; k++)
            r->v[i][k] = e == &engine_q16   ? nearbyint(r->v[i][k] * 65536) / 65536
                         : e == &engine_f32 ? (double)(float)r->v[i][k]
                                            : r->v[i][k];
}

/* Decided on numbers of 16 bits: finer ones do not matter for what is solved. */
static int judge(const reading *r, const char *name)
{
    loft_spot v[LOFT_SIDES_MAX];
    unsigned side[2];

    if (r->n < 3)
        return tool_error(EX_DATAERR,
                          "%s: %u vertices, not 3 to 8: give one per line, counterclockwise", name,
                          r->n);
    for (unsigned i = 0; i < r->n; i++)
        for (int k = 0; k < 2; k++)
            if (!real_of(r->v[i][k], &v[i].at[k]))
                return tool_error(EX_DATAERR, "%s: vertex %u is beyond 32767: scale the polygon",
                                  name, i + 1);
    switch (loft_outline_of(v, r->n)) {
    case LOFT_OUTLINE_BROKEN:
        loft_outline_fault(v, r->n, side);
        return tool_error(EX_DATAERR,
                          "%s: edges %u and %u cross or touch (edge 1 is from vertex 1 to vertex "
                          "2): give a simple polygon",
                          name, side[0] + 1, side[1] + 1);
    case LOFT_OUTLINE_CLOCKWISE:
        return tool_error(EX_DATAERR,
                          "%s: the vertices run clockwise: give them in the other order", name);
    default:                     return 0;
    }
}

static int read_polygon(reading *r, const char *file)
{
    size_t size;
    int code = 0;
    char *text = source_read(tool_host(), file, &size, &code);

    if (text == NULL)
        return code;
    r->at.file = source_name(file);
    code = lines_read(&r->at, text, vertex, r);
    free(text);
    return code;
}


// The table
// ---------

static void write_number(FILE *out, long double x, const engine *e)
{
    if (e == &engine_q16)
        fprintf(out, " INT64_C(%lld),", (long long)roundl(x * 0x1p32L));
    else
        fprintf(out, " %.17Lg,", x);
}

static void write_header(FILE *out, const harmonic_series *s, const engine *e, const char *name)
{
    fprintf(out,
            "/* Harmonic coordinates of a polygon with %u sides in %s, by `loft harmonic`: error "
            "at most %.2Lg.\n *\n",
            s->sides, e->name, s->bound + s->weight * HARMONIC_ROUNDING);
    for (unsigned i = 0; i < s->sides; i++)
        fprintf(out, " *     %.9g, %.9g\n", s->v[i][0], s->v[i][1]);
    fprintf(out, " */\nstatic const loft_acc %s_coefficient[%u] = {\n", name, s->terms * s->sides);
    for (unsigned k = 0; k < s->terms; k++) {
        fprintf(out, "   ");
        for (unsigned i = 0; i < s->sides; i++)
            write_number(out, s->coefficient[k * s->sides + i], e);
        fprintf(out, "\n");
    }
    fprintf(out, "};\n");
    if (s->pole_count > 0)
        fprintf(out, "static const loft_harmonic_pole %s_pole[%u] = {\n", name, s->pole_count);
    for (unsigned i = 0; i < s->pole_count; i++) {
        fprintf(out, "    { {");
        write_number(out, s->pole[i][0], e);
        write_number(out, s->pole[i][1], e);
        fprintf(out, " },");
        write_number(out, s->pole[i][2], e);
        fprintf(out, " },\n");
    }
    fprintf(out,
            "%sstatic const loft_harmonic_table %s_table = {\n    %s_coefficient, %s%s, %u, %u, "
            "%u, %u, {",
            s->pole_count > 0 ? "};\n" : "", name, name, s->pole_count > 0 ? name : "0",
            s->pole_count > 0 ? "_pole" : "", s->terms, s->sides, s->poles, s->degree);
    for (unsigned i = 0; i < s->sides; i++)
        fprintf(out, " %u,", s->powers[i]);
    fprintf(out, " }, %u, {", s->straight);
    for (unsigned i = 0; i < s->sides; i++)
        fprintf(out, " %u,", s->corner_poles[i]);
    fprintf(out, " }\n};\n");
}

/* A row for each pole, then one for each term. */
static void write_csv(FILE *out, const harmonic_series *s)
{
    for (unsigned i = 0; i < s->pole_count; i++)
        fprintf(out, "pole %u,%.17Lg,%.17Lg,%.17Lg\n", i, s->pole[i][0], s->pole[i][1],
                s->pole[i][2]);
    fprintf(out, "term,coefficients of each vertex\n");
    for (unsigned k = 0; k < s->terms; k++) {
        fprintf(out, "%u", k);
        for (unsigned i = 0; i < s->sides; i++)
            fprintf(out, ",%.17Lg", s->coefficient[k * s->sides + i]);
        fprintf(out, "\n");
    }
}

static int write_table(const harmonic_series *s, const engine *e, const char *output)
{
    const size_t length = strlen(output);
    char name[64];

    if (length < 3 || (strcmp(output + length - 2, ".h") != 0 &&
                       strcmp(output + length - 4 * (length > 4), ".csv") != 0))
        return tool_error(EX_USAGE, "%s: what kind of file: give a name that ends with .h or .csv",
                          output);
    FILE *out = create_file(output);
    if (out == NULL)
        return create_refused(tool_host(), output, errno);
    c_name_of(output, name);
    if (output[length - 1] == 'h')
        write_header(out, s, e, name);
    else
        write_csv(out, s);
    return fclose(out) == 0
               ? 0
               : tool_error(EX_IOERR, "%s: cannot be written: is the disk full?", output);
}

typedef struct {
    const char *file, *output;
    option_list at;
    const engine *e;
} harmonic_options;

static const option harmonic_rows[] = {
    { "output", OPTION_FILE(harmonic_options, output), .value = "FILE",
      .help = "or -o: where the table goes, .h (C, for the number type) or .csv" },
    { "at", OPTION_LIST(harmonic_options, at), .least = -32768, .most = 32767, .value = "X,Y",
      .counts = "2", .help = "print the coordinates of this point, inside or on the boundary" },
    ENGINE_ROW(harmonic_options, e, "q16", "number type of the table"),
    { "file", OPTION_WORD(harmonic_options, file), .value = "POLYGON", .standard = "-" },
    { 0 }
};

/* What is known of the table, or the coordinates of a point. */
static void print_series(const harmonic_options *o, const harmonic_series *s, long double error)
{
    long double phi[HARMONIC_SIDES];

    if (o->at.count == 0) {
        printf("error at most %.2Lg, proved on the whole boundary from %u points; %u terms "
               "(polynomial of degree %u, %u poles), table of %u bytes\n",
               error, s->points, s->terms, s->degree, s->pole_count,
               s->terms * s->sides * 8 + s->pole_count * 24);
        return;
    }
    harmonic_at(s, o->at.value, phi);
    for (unsigned i = 0; i < s->sides; i++)
        printf("%s%.15Lg", i ? "," : "", phi[i]);
    printf("\n");
}

static int solve(const harmonic_options *o, reading *r)
{
    const harmonic_target target = o->e == &engine_q16   ? HARMONIC_TARGET_Q16
                                   : o->e == &engine_f32 ? HARMONIC_TARGET_F32
                                                         : HARMONIC_TARGET_F64;
    harmonic_series s;
    int code = 0;

    harmonic_solve(r->v, r->n, target, &s);
    const long double error = s.bound + s.weight * HARMONIC_ROUNDING;
    print_series(o, &s, error);
    if (o->output != NULL)
        code = write_table(&s, o->e, o->output);
    harmonic_free(&s);
    if (code == 0 && error > 1e-6L)
        return tool_error(EX_DATAERR,
                          "%s: the error is above 1e-6, %.2g: the polygon is too narrow "
                          "somewhere: widen it there, or cut it in two",
                          source_name(o->file), (double)error);
    return code;
}

static int run_harmonic(void *options)
{
    const harmonic_options *o = options;
    reading r                 = { .n = 0 };
    int code                  = create_check(tool_host(), o->output);

    if (code != 0)
        return code;
    code = read_polygon(&r, o->file);
    round_vertices(&r, o->e);
    if (code == 0)
        code = judge(&r, source_name(o->file));
    return code == 0 ? solve(o, &r) : code;
}

const command command_harmonic = {
    .name = "harmonic",
    .arguments = "POLYGON|- [-o TABLE.h|.csv]",
    .summary = "harmonic coordinates of a polygon as a table for lib/polygon/harmonic.h",
    .detail = "POLYGON has one vertex per line, x and y, counterclockwise, 3 to 8 of them; it need "
              "not be "
        "convex. Solves Laplace's equation on it and\n"
              "prints a bound of the error, which holds on the whole polygon, and the size of the "
              "table.\n",
    .options = harmonic_rows,
    .size = sizeof(harmonic_options),
    .run = run_harmonic,
};
