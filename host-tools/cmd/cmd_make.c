/* host-tools/cmd/cmd_make.c -- loft make: curves and surfaces made of curves, as .loft
 * SPDX-License-Identifier: MIT
 */
#include "cmd/commands.h"
#include "make/decide.h"

static int run_make(void *options)
{
    static const decide_question *const table[3] = { make_q16, make_f32, make_f64 };
    return decide_run(tool_host(), "make", table, MAKE_VERBS, options);
}

const command command_make = {
    .name = "make",
    .arguments = "VERB [--of NUMBER,..] [FILE|-]",
    .summary = "raise, lower, cut, join or reverse curves; surfaces from curves and around holes",
    .detail =
        "Of the curves in FILE (host-tools/LOFT.md), piece by piece, in the same format:\n"
        "  raise    with a degree higher by --of, up to 32 (with weights 18): `loft plot "
        "--control`\n"
        "           and other drawings take such degrees, and what computes takes up to 9\n"
        "  lower    the nearest curve with a degree lower by --of and the same ends, and how near\n"
        "  lowest   the lowest degree that stays within --of mm, and how near\n"
        "  join     neighbours that are parts of one polynomial curve within --of mm, as one\n"
        "  insert   B-splines and NURBS, the same curves with the knots --of u,.. once more each\n"
        "  thin     B-splines and NURBS without knots that they do not need within --of mm; how "
        "near\n"
        "  cut      the part of each curve between two of its parameters, --of FROM,TO\n"
        "  pieces   curves of any kind as Bezier curves\n"
        "  split    the parts of each piece, cut at --of t,t,..\n"
        "  reverse  the path from its end to its start\n"
        "Surfaces, as tensor patches:\n"
        "  ruled    the lines between two pieces\n"
        "  skin     through all pieces, in order: the cubic spline of each control point, natural "
        "ends\n"
        "  hull     the same, with ends that are not a knot\n"
        "  revolve  each piece turned about the z axis: four quarters\n"
        "  sweep    the first curve, in x and y, along the others, without a twist: --of stations, "
        "and\n"
        "           the direction of its x at the start, if not z: STATIONS,X,Y,Z\n"
        "  coons    between four curves of any kind: v = 0, v = 1, u = 0, u = 1\n"
        "  gordon   through a network of curves of any kind: the first --of along u, the others "
        "along "
        "v\n"
        "Pieces of different degrees are raised to the highest one. Curves of a network meet at "
        "joints.\n"
        "Through a grid of points, one row in a curve, bicubic patches with the twists\n"
        "  ferguson 0   adini  of Coons patches   bessel  of parabolas\n"
        "Of the surfaces in FILE; tensor patches and triangles without weights:\n"
        "  raise    with degrees higher by --of, up to 32 (with weights 18), which `loft plot`\n"
        "           takes; `tetra` to 9\n"
        "  split    at --of u,v: four parts, or the three triangles around that point\n"
        "  quarter  four parts, cut in the middles\n"
        "  patches  tensor patches and triangles of coons, bicubic, pn, octant, nurbs-surface, "
        "spatch,\n"
        "           toric, basepoint\n"
        "  meet     the lines in which each two of them meet, within --of mm: every branch; an "
        "spatch\n"
        "           as triangles of degree depth (sides - 2) up to 9, a toric whose vertices are "
        "at "
        "most\n"
        "           9 high over each side; ring and gb have no such form: `loft contour` cuts "
        "them\n"
        "  continue each triangle beyond its edge T2 T3, to a corner with --of shares of T2, T3\n"
        "Others:\n"
        "  gregory  `coons slopes 3 3` as a Gregory patch, which keeps all slopes with any twists\n"
        "  fill     the hole with 3 to 8 sides between tensor patches, with their tangent planes: "
        "a "
        "`gb`\n"
        "           patch of degree --of (5), and the largest angle between the planes\n",
    .options = decide_rows,
    .size = sizeof(decide_options),
    .run = run_make,
};
