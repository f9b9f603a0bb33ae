/* host-tools/cmd/cmd_decide.c -- loft decide: questions of the texts, decided exactly
 * SPDX-License-Identifier: MIT
 */
#include "cmd/commands.h"
#include "make/decide.h"

static int run_decide(void *options)
{
    static const decide_question *const table[3] = { decide_q16, decide_f32, decide_f64 };
    return decide_run(tool_host(), "decide", table, DECIDE_QUESTIONS, options);
}

const command command_decide = {
    .name = "decide",
    .arguments = "QUESTION [--of NUMBER,..] [FILE|-] [FILE]",
    .summary = "positive, convex, copositive, which conic, where curves meet, ..",
    .detail =
        "Of the numbers --of:\n"
        "  positive    is a polynomial with these Bernstein coefficients above 0? How many roots?\n"
        "              To degree 128: 1 s at 64, half a minute at 128, three times that where\n"
        "              roots are multiple\n"
        "  convex      is it, or its polygon, convex? To degree 128 likewise\n"
        "  copositive  is a symmetric matrix, a11 a12 .. a22 .., copositive? To order 6\n"
        "  triangle    is a triangular net, row by row, convex and not below 0?\n"
        "  shares      barycentric coordinates: of a point, behind 3 corners x,y, or 4 corners "
        "x,y,z\n"
        "  plane       equation, normal and distance: 2 points x,y of a line and one more, or 3 "
        "x,y,z\n"
        "  sphere      equation, distance and normal at a point: centre x,y,z, radius, point "
        "x,y,z\n"
        "  weights     Bernstein polynomials: the degree, then t, v,w of a triangle or v,w,x\n"
        "  solid       the value at v,w,x of coefficients over a tetrahedron, and its net, raised\n"
        "  iterate     Bernstein's operator on a triangle: times (0: forever), v,w, then the "
        "samples\n"
        "  over        the integral over a triangle: 3 corners x,y, then the coefficients\n"
        "  operator    Bernstein's operator of samples at 0, 1/n, .., 1; the last number is x\n"
        "  smooth      the same operator, applied again and again; the last numbers are times and "
        "x\n"
        "  power       the coefficients of 1, t, t^2 .. of a polynomial in Bernstein form\n"
        "  integral    of it over 0..1, and between the last two numbers\n"
        "Of the curves in FILE (host-tools/LOFT.md):\n"
        "  bend        first and second derivative and curvature of each piece at --of t,..\n"
        "  frame       at --of t,.. of each piece: the direction along, the one across that does "
        "not\n"
        "              twist from place to place (at the first one near z), and Frenet's normal\n"
        "  inflections where the curvature in the plane is 0, of any degree (with weights to 7); "
        "it\n"
        "              changes its sign where the multiplicity is odd\n"
        "  loops       where each curve crosses itself, within --of mm: pieces, their parameters\n"
        "  degree      the exact degree, as curves of that degree\n"
        "  conic       the kind, foci, centre and axes of rational quadratics, and cubics that "
        "are\n"
        "              conics; weights of any sign, also 0\n"
        "  meet        where polynomial pieces of degree 1 to 4 meet in the plane: two numbers of\n"
        "              pieces, their parameters, the multiplicity (0: ends of one curve)\n"
        "  enclosed    area, centroid and second moments (xx xy yy) of a closed chain\n"
        "  under       the integral of y dx of each piece between two parameters --of t,t\n"
        "Of the surfaces in FILE with a net: all but Gregory patches, `ring` and `gb`. A `spatch` "
        "has\n"
        "wachspress coordinates, a convex polygon and depth (sides - 2) up to 9; a `toric` a "
        "polygon\n"
        "whose vertices are at most 9 high over each side:\n"
        "  nearest     the point nearest to --of x,y,z\n"
        "  ray         where the ray --of x,y,z,dx,dy,dz meets them: t, u, v; `touch` is not "
        "decided\n"
        "  area        of each, with weights too: each patch within --of mm^2 (0.001)\n"
        "  volume      that they enclose: without weights exactly, else each patch within --of "
        "mm^3;\n"
        "              its centroid: without weights exactly, else within about patches times "
        "--of\n"
        "              over volume^(2/3)\n"
        "Of the curves in one FILE and the surfaces with nets in a second one:\n"
        "  pierce      all places where they meet, --of mm apart at least: t, u, v, the point; "
        "`touch`\n"
        "              is not decided\n"
        "Of the tensor patches and triangles in FILE:\n"
        "  polar       of triangles: how many arguments, their v,w, then v,w of the others\n"
        "  join        how each continues the one before across u = 1: C0 C1 G1; of triangles the\n"
        "              order of derivatives that agree across the edge T2 T3: --of the shares of "
        "T2, "
        "T3\n"
        "              of the new corner\n"
        "Answers about signs, kinds and numbers are exact for the numbers as read in the number "
        "type.\n",
    .options = decide_rows,
    .size = sizeof(decide_options),
    .run = run_decide,
};
