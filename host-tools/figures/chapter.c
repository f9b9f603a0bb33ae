/* host-tools/figures/chapter.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>

#include "figures/chapter.h"

const char *const chapter_kinds[CHAPTER_KINDS] = { "W", "MV", "H" };

/* One is regular, in the unit circle; two are not. */
const chapter_pentagon chapter_pentagons[3] = {
    { "P1_regular",
      { { 0, 1 },
        { -0.95105651629515357, 0.30901699437494742 },
        { -0.58778525229247313, -0.80901699437494742 },
        { 0.58778525229247313, -0.80901699437494742 },
        { 0.95105651629515357, 0.30901699437494742 } } },
    { "P2_irregular",
      { { -1, -0.5 }, { 0.5, -0.875 }, { 1.25, 0 }, { 0.25, 1 }, { -0.75, 0.625 } } },
    { "P3_irregular",
      { { -1.25, -0.25 }, { 0.25, -0.75 }, { 1.5, -0.125 }, { 0.5, 0.625 }, { -0.75, 0.75 } } }
};

// The net
// -------

void chapter_middle(const double v[CHAPTER_SIDES][2], double c[2])
{
    c[0] = c[1] = 0;
    for (unsigned i = 0; i < CHAPTER_SIDES; i++)
        for (int k = 0; k < 2; k++)
            c[k] += v[i][k] / CHAPTER_SIDES;
}

void chapter_net(const double v[CHAPTER_SIDES][2], unsigned side, unsigned j, unsigned k,
                 double out[3])
{
    const double *a = v[side], *b = v[(side + 1) % CHAPTER_SIDES],
                 t = (double)(j - k) / (5 - 2 * k);
    double c[2];

    chapter_middle(v, c);
    for (int i = 0; i < 2; i++) {
        const double from = a[i] + (c[i] - a[i]) * k / 3, to = b[i] + (c[i] - b[i]) * k / 3;
        out[i] = from + t * (to - from);
    }
    out[2] = 0.4 * ((j < 5 - j ? j : 5 - j) + k);
}


// Of a point
// ----------

chapter_jet chapter_height(const chapter_point *p, double scale, double dz)
{
    const chapter_jet *z = &p->p[2], *b = &p->b0;

    return (chapter_jet){ scale * (z->f + dz * b->f),   scale * (z->x + dz * b->x),
                          scale * (z->y + dz * b->y),   scale * (z->xx + dz * b->xx),
                          scale * (z->xy + dz * b->xy), scale * (z->yy + dz * b->yy) };
}

double chapter_gauss(const chapter_point *p, double height)
{
    const chapter_jet x = p->p[0], y = p->p[1],
                      z = chapter_height(p, 1.0 / 8, 8 * height - CHAPTER_V0);
    const double n[3] = { y.x * z.y - z.x * y.y, z.x * x.y - x.x * z.y, x.x * y.y - y.x * x.y };
    const double square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];      /* also E G - F^2 */
    const double l = n[0] * x.xx + n[1] * y.xx + n[2] * z.xx,
                 m = n[0] * x.xy + n[1] * y.xy + n[2] * z.xy,
                 q = n[0] * x.yy + n[1] * y.yy + n[2] * z.yy;

    return (l * q - m * m) / (square * square);
}

/* Let the height be a function of X and Y with gradient g and second derivatives H: z_x = g . (X,
 * Y)_x, and z_xx less g . (X, Y)_xx is H of (X, Y)_x twice; so for the direction (u, v) of the
 * pentagon with the image T across g, H(T, T) = the same of (u, v). */
double chapter_across(const chapter_point *p, double dz)
{
    const chapter_jet x = p->p[0], y = p->p[1], z = chapter_height(p, 1, dz);
    const double det = x.x * y.y - x.y * y.x;
    const double g[2] = { (z.x * y.y - z.y * y.x) / det, (x.x * z.y - x.y * z.x) / det },
                 size = hypot(g[0], g[1]);
    const double t[2] = { -g[1] / size, g[0] / size };
    const double u = (t[0] * y.y - t[1] * x.y) / det, v = (x.x * t[1] - y.x * t[0]) / det;
    const double xx = z.xx - g[0] * x.xx - g[1] * y.xx, xy = z.xy - g[0] * x.xy - g[1] * y.xy,
                 yy = z.yy - g[0] * x.yy - g[1] * y.yy;

    return u * u * xx + 2 * u * v * xy + v * v * yy;
}
