/* host-tools/draw/mesh_file.c -- a mesh as binary STL or PLY
 * SPDX-License-Identifier: MIT
 *
 * Both are little-endian. STL: a header of 80 bytes, the count, and per triangle the normal and the
 * corners as floats, and two bytes. PLY: a header of text lines, the corners with normals as
 * floats, and per triangle a 3 and three indices.
 */
#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "draw/mesh.h"
#include "base/create.h"      /* create_refused */
#include "base/host.h"

static void put32(FILE *file, uint32_t x)
{
    for (int k = 0; k < 4; k++)
        putc((int)(x >> (8 * k) & 255), file);
}

static void put_vector(FILE *file, const double v[ENGINE_AXES])
{
    for (int i = 0; i < ENGINE_AXES; i++) {
        const float x = (float)v[i];
        uint32_t bits;
        memcpy(&bits, &x, sizeof bits);
        put32(file, bits);
    }
}

/* The k-th triangle of a cell, and its normal. Returns false for a triangle without area. */
static bool triangle(const mesh *m, const mesh_cell *c, int k, size_t corner[3],
                     double normal[ENGINE_AXES])
{
    const double *a, *b, *z;
    double length = 0;

    corner[0] = c->corner[0];
    corner[1] = c->corner[k + 1];
    corner[2] = c->corner[k + 2];
    a = m->vertex[corner[0]].p;
    b = m->vertex[corner[1]].p;
    z = m->vertex[corner[2]].p;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, n = (i + 2) % 3;
        normal[i] = (b[j] - a[j]) * (z[n] - a[n]) - (b[n] - a[n]) * (z[j] - a[j]);
        length += normal[i] * normal[i];
    }
    length = sqrt(length);
    for (int i = 0; i < 3 && length > 0; i++)
        normal[i] /= length;
    return length > 0;
}

typedef void face_sink(FILE *file, const mesh *m, const size_t corner[3],
                       const double normal[ENGINE_AXES]);

/* Pass all triangles to the sink. Returns their number. */
static size_t every_triangle(const mesh *m, face_sink *sink, FILE *file)
{
    size_t count = 0, corner[3];
    double normal[ENGINE_AXES];

    for (size_t i = 0; i < m->cells; i++)
        for (int k = 0; k < 2; k++)
            if (triangle(m, &m->cell[i], k, corner, normal)) {
                count++;
                if (sink != NULL)
                    sink(file, m, corner, normal);
            }
    return count;
}

static void stl_face(FILE *file, const mesh *m, const size_t corner[3],
                     const double normal[ENGINE_AXES])
{
    put_vector(file, normal);
    for (int k = 0; k < 3; k++)
        put_vector(file, m->vertex[corner[k]].p);
    putc(0, file);
    putc(0, file);
}

static void ply_face(FILE *file, const mesh *m, const size_t corner[3],
                     const double normal[ENGINE_AXES])
{
    (void)m;
    (void)normal;
    putc(3, file);
    for (int k = 0; k < 3; k++)
        put32(file, (uint32_t)corner[k]);
}

static void write_stl(FILE *file, const mesh *m, size_t count)
{
    char header[80] = "binary STL by loft, mm";

    fwrite(header, 1, sizeof header, file);
    put32(file, (uint32_t)count);
    every_triangle(m, stl_face, file);
}

static void write_ply(FILE *file, const mesh *m, size_t count)
{
    fprintf(file, "ply\nformat binary_little_endian 1.0\ncomment by loft, mm\nelement vertex %zu\n",
            m->vertices);
    for (int k = 0; k < 6; k++)
        fprintf(file, "property float %s%c\n", k < 3 ? "" : "n", "xyz"[k % 3]);
    fprintf(file, "element face %zu\nproperty list uchar uint vertex_indices\nend_header\n", count);
    for (size_t i = 0; i < m->vertices; i++) {
        put_vector(file, m->vertex[i].p);
        put_vector(file, m->vertex[i].normal);
    }
    every_triangle(m, ply_face, file);
}

static bool ends_with(const char *text, const char *end)
{
    return strlen(text) >= strlen(end) && strcasecmp(text + strlen(text) - strlen(end), end) == 0;
}

int mesh_write(host *h, const mesh *m, const char *output, size_t *triangles)
{
    const bool stl = ends_with(output, ".stl");

    if (!stl && !ends_with(output, ".ply"))
        return host_error(h, EX_USAGE, "mesh.name", (host_place){ output, 0 }, NULL,
                          "give a name that ends with .stl or .ply");
    FILE *file = create_file(output);
    if (file == NULL)
        return create_refused(h, output, errno);
    *triangles = every_triangle(m, NULL, NULL);
    (stl ? write_stl : write_ply)(file, m, *triangles);
    const bool good = !ferror(file);
    if (fclose(file) != 0 || !good)
        return host_error(h, EX_IOERR, "file.not-written", (host_place){ output, 0 },
                          "is the disk full?", "cannot be written: %s", strerror(errno));
    return 0;
}
