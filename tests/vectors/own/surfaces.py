# tests/vectors/own/surfaces.py -- rows of what surfaces are asked, from the definitions
# SPDX-License-Identifier: MIT
"""usage: python3 tests/vectors/own/surfaces.py FOLDER  writes the CSV files, the same each time"""
import random
import sys
from math import comb, prod

import mpmath

from curves import basis, solve
from exact import (F, add, cross, digits, dot, grid, mul, numbers, points, power_of, raw, roots,
                   scale, sub, value, write)
from sheets import (Level, Over, Sheet, bernstein2, branches, circle2, cosine, cylinder, graph,
                    halve, light_slope, places, plane, product2, sphere, torus)

rnd = random.Random(1974)
SIDE = 12


def arb(size=6):
    return F(rnd.randint(-size * 65536, size * 65536), 65536)


def sheet_columns(s):
    return [s.kind, s.m, s.n, points(s.net, raw), numbers(s.w, raw) if s.w else '-']


def arb_graph(m, n, size=4):
    return graph(m, n, [arb(size) for _ in range((m + 1) * (n + 1))], SIDE)


def arb_sheet(m, n):
    s = arb_graph(m, n)
    net = [[grid(p[0]) + arb(1), grid(p[1]) + arb(1), p[2]] for p in s.net]
    return Sheet('tensor', m, n, net)


def arb_triangle(n):
    net = [[F(SIDE * i, n) - F(SIDE * j, n), F(SIDE * j, n), arb(4)]
           for i in range(n + 1) for j in range(i + 1)]
    return Sheet('triangle', n, n, [[grid(x) for x in p] for p in net])


# Surfaces that meet

def meets():
    tol, rows = F(1, 32), []

    def take(a, b, known=None, lines=8):
        count = known if known else branches(a, b, 160)
        rows.append(sheet_columns(a) + sheet_columns(b) +
                    [raw(tol), count[0], count[1], points(places(a, b, lines), digits)])

    def over(m, n, f):
        """Two graphs whose difference is f(u, v) times 8."""
        a = arb_graph(m, n, 2)
        z = [p[2] + 8 * c for p, c in zip(a.net, bernstein2(f, m, n))]
        take(a, Over(graph(m, n, z, SIDE)))

    over(2, 2, circle2(F(1, 2), F(1, 2), F(3, 8)))                          # closed
    over(2, 2, circle2(F(1, 2), F(1, 2), F(1, 16)))                         # small
    over(2, 2, circle2(F(0), F(0), F(3, 4)))
    over(4, 4, product2(circle2(F(1, 4), F(1, 2), F(3, 16)), circle2(F(3, 4), F(1, 2), F(3, 16))))
    over(4, 4, product2(circle2(F(1, 2), F(1, 2), F(1, 4)), circle2(F(1, 2), F(1, 2), F(7, 16))))
    over(3, 3, {(0, 0): F(1, 6), (1, 0): F(-3, 4), (2, 0): F(1), (0, 1): F(1, 5), (0, 3): F(-1, 3)})
    hyperbola = {(0, 0): F(1, 4) - F(1, 256), (1, 0): F(-1, 2), (0, 1): F(-1, 2), (1, 1): F(1)}
    over(1, 1, hyperbola)                                                   # near a saddle
    saddle = {**hyperbola, (0, 0): F(1, 4)}
    a = arb_graph(1, 1, 2)
    z = [p[2] + 8 * c for p, c in zip(a.net, bernstein2(saddle, 1, 1))]
    take(a, Over(graph(1, 1, z, SIDE)), ('-', '-'))
    touch = {(0, 0): F(1, 4), (0, 1): F(-1), (0, 2): F(1)}                  # along a line
    a = arb_graph(2, 2, 2)
    z = [p[2] + 8 * c for p, c in zip(a.net, bernstein2(touch, 2, 2))]
    take(a, Over(graph(2, 2, z, SIDE)), ('-', '-'), 4)
    over(2, 2, {(0, 0): F(1, 4) + F(1, 64), (0, 1): F(-1), (0, 2): F(1)})    # 1/8 above
    over(2, 2, {(0, 0): F(1, 4) - F(1, 64), (0, 1): F(-1), (0, 2): F(1)})    # two lines
    room = F(1, 50)
    for m, n in ((2, 2), (3, 3), (3, 2)):
        take(arb_sheet(m, n), plane([F(-3), F(-3), arb(1)], [F(20), F(0), arb(3)],
                                    [F(0), F(20), arb(3)], room))
    for n in (2, 3):
        take(arb_triangle(n), plane([F(-14), F(-3), arb(1)], [F(40), F(1), arb(2)],
                                    [F(0), F(30), arb(2)], room))
    upright = plane([F(-1), F(5), F(-20)], [F(14), F(1), F(0)], [F(0), F(0), F(40)], room)
    take(arb_sheet(3, 3), upright)
    round_ = sphere(8, F(1, 8))
    for h in (1, 4, 7):
        take(round_, plane([F(-3), F(-2), F(h)], [F(20), F(1), F(0)], [F(0), F(30), F(0)], room))
    slanted = plane([F(-1), F(0), F(10)], [F(10), F(1), F(-9)], [F(1), F(9), F(-5)], room)
    take(round_, slanted)
    small = Sheet('tensor', 2, 1, [[p[1] - 10, p[0], p[2]] for p in cylinder(3, 0, 20, 0).net],
                  cylinder(3, 0, 20, 0).w)
    take(small, cylinder(8, -10, 10, F(1, 16)))
    take(cylinder(5, -2, 10, F(0)), sphere(7, F(1, 16)))
    take(torus(6, 2, F(0)), plane([F(-1), F(-2), F(1)], [F(20), F(0), F(0)], [F(0), F(20), F(1)],
                                  room))
    take(arb_sheet(2, 2), torus(7, 3, F(1, 8)))
    take(torus(6, 2, F(0)), cylinder(7, -1, 10, F(1, 8)))
    return rows


def pierces():
    tol, rows = F(1, 32), []

    def take(p, w, b):
        h = [power_of([x[k] * v for x, v in zip(p, w or [F(1)] * len(p))]) for k in range(3)]
        h.append(power_of(w or [F(1)] * len(p)))
        found = []
        for t, times in roots(b.equation(*h)):
            at = [value(x, t) / value(h[3], t) for x in h[:3]]
            if b.inside(at):
                found.append((t, times, at))
        rows.append([len(p) - 1, points(p, raw), numbers(w, raw) if w else '-'] + sheet_columns(b) +
                    [raw(tol), numbers([t for t, _, _ in found], digits),
                     numbers([k for _, k, _ in found], str),
                     points([x for _, _, x in found], digits)])

    room = F(1, 50)
    for degree in range(1, 8):
        for _ in range(2):
            p = [[arb(9), arb(9), arb(6)] for _ in range(degree + 1)]
            take(p, None, plane([F(-12), F(-12), F(0)], [F(24), F(0), arb(1)],
                                [F(0), F(24), arb(1)], room))
            q = [[abs(x) for x in a] for a in p]
            w = [F(1) + F(rnd.randint(0, 65536), 65536) for _ in q]
            take(q, w, sphere(8, F(1, 8)))
            take(q, None, cylinder(6, -9, 9, F(1, 8)))
    # touching: a line along the top of a cylinder's side, a parabola on a plane
    take([[F(4), F(2), F(3)], [F(4), F(3), F(-3)], [F(4), F(4), F(3)]], None,
         plane([F(0), F(0), F(0)], [F(9), F(0), F(0)], [F(0), F(9), F(0)], room))
    take([[F(1), F(1), F(7)], [F(7), F(1), F(1)]], None, sphere(5, F(1, 8)))
    take([[F(7), F(0), F(1)], [F(1), F(0), F(9)]], None, cylinder(5, -3, 3, F(1, 8)))
    return rows


# Light

def normals(s, u):
    """The normal along u = const, as polynomials of v."""
    h, a, b = s.line(0, u), s.slope(0).line(0, u), s.slope(1).line(0, u)
    return cross_poly([sub(mul(a[k], h[3]), mul(h[k], a[3])) for k in range(3)],
                      [sub(mul(b[k], h[3]), mul(h[k], b[3])) for k in range(3)])


def cross_poly(a, b):
    return [sub(mul(a[i - 2], b[i - 1]), mul(a[i - 1], b[i - 2])) for i in range(3)]


def sum_of(ps):
    out = []
    for p in ps:
        out = add(out, p)
    return out


def isophotes():
    rows = []
    cases = [(arb_sheet(2, 2), 0), (arb_sheet(3, 3), 0), (arb_graph(2, 3), 0), (sphere(5, 0), 0),
             (torus(6, 2, 0), 0), (arb_graph(3, 3), F(3, 4)), (arb_sheet(2, 2), F(7, 8)),
             (sphere(5, 0), F(1, 2)), (torus(6, 2, 0), F(5, 8)), (cylinder(4, 0, 9, 0), F(1, 4)),
             (arb_graph(2, 2), F(1, 2)), (arb_sheet(3, 2), F(-3, 4))]
    for s, c in cases:
        c = F(c)
        for size in (16, 32, 64):
            d = [arb(3), arb(3), arb(3) if c == 0 else F(4)]
            level = Level(size)
            for i in range(size + 1):
                n = normals(s, F(i, size))
                along = sum_of(scale(n[k], d[k]) for k in range(3))
                f = along if c == 0 else sub(
                    mul(along, along), scale(sum_of(mul(x, x) for x in n), c * c * dot(d, d)))
                if not f or not any(n):
                    continue
                here = [t for t, _ in roots(f)
                        if c == 0 or (value(along, t) > 0) == (c > 0)]
                level.add(here, lambda t: light_slope(n, d, t), lambda t: (F(i, size), t))
            if level.good():
                rows.append(sheet_columns(s) + [numbers(d, raw), raw(c)] + level.columns())
                break
    return rows


def lights():
    rows = []
    some = lambda: rnd.choice([F(0), F(1), F(rnd.randint(0, 65536), 65536)])
    pole = sphere(5, 0)
    for k in range(30):
        s = [arb_sheet(3, 3), arb_graph(2, 3), pole, torus(6, 2, 0), cylinder(4, 0, 9, 0)][k % 5]
        u, v, d = some(), some(), [arb(3), arb(3), arb(3)]
        n = [value(x, v) for x in normals(s, u)]
        if not any(n):                                  # a pole: its limit
            n = [value(x, v) for x in normals(s, u - F(1, 1 << 90))]
        rows.append(sheet_columns(s) + [numbers([u, v], raw), numbers(d, raw),
                                        digits(cosine(n, d))])
    return rows


# Fits

def fit_curve(b, data):
    """Least squares with kept ends: rows b of B-splines, points."""
    m = len(b[0])
    inner = range(1, m - 1)
    if not inner:
        return [data[0], data[-1]], F(1)
    normal = [[sum(r[i] * r[j] for r in b) for j in inner] for i in inner]
    rest = [[x - r[0] * y - r[-1] * z for x, y, z in zip(p, data[0], data[-1])]
            for r, p in zip(b, data)]
    right = [[sum(r[i] * p[k] for r, p in zip(b, rest)) for k in range(len(data[0]))]
             for i in inner]
    each = [[r[i] for r in b] for i in inner]
    out = solve(normal, right)
    gain = max(sum(abs(x) for x in row) for row in solve(normal, each))
    return [data[0]] + out + [data[-1]], gain


def fits():
    rows = []
    for _ in range(16):
        p, q = rnd.randint(1, 4), rnd.randint(1, 4)
        m, n = p + 1 + rnd.randint(0, 2), q + 1 + rnd.randint(0, 2)
        knots = lambda p, m: [F(0)] * (p + 1) + sorted(
            F(rnd.randint(1, 3), 4) for _ in range(m - p - 1)) + [F(1)] * (p + 1)
        ku, kv = knots(p, m), knots(q, n)
        r, c = m + rnd.randint(1, 4), n + rnd.randint(1, 4)
        u, v = [[F(k, count - 1) for k in range(count)] for count in (r, c)]
        u, v = [[grid(x) for x in t] for t in (u, v)]
        try:
            data = [[[arb(), arb(), arb()] for _ in v] for _ in u]
            bu, bv = [basis(ku, p, x) for x in u], [basis(kv, q, x) for x in v]
            first, gain = fit_curve(bv, data[0])
            last, _ = fit_curve(bv, data[-1])
            left, gain_u = fit_curve(bu, [row[0] for row in data])
            right, _ = fit_curve(bu, [row[-1] for row in data])
            net = [[None] * n for _ in range(m)]
            for i in range(m):
                net[i][0], net[i][-1] = left[i], right[i]
            net[0], net[-1] = first, last
            inner = [(i, j) for i in range(1, m - 1) for j in range(1, n - 1)]
            places_ = [(a, b) for a in range(r) for b in range(c)]
            form = {(a, b): {(i, j): bu[a][i] * bv[b][j] for i in range(m) for j in range(n)}
                    for a, b in places_}
            if inner:
                rest = {}
                for at in places_:
                    rest[at] = [data[at[0]][at[1]][k] - sum(
                        x * net[i][j][k] for (i, j), x in form[at].items() if (i, j) not in inner)
                        for k in range(3)]
                normal = [[sum(form[at][x] * form[at][y] for at in places_) for y in inner]
                          for x in inner]
                side = [[sum(form[at][x] * rest[at][k] for at in places_) for k in range(3)]
                        for x in inner]
                for (i, j), x in zip(inner, solve(normal, side)):
                    net[i][j] = x
        except StopIteration:
            continue
        rows.append([p, q, m, n, numbers(ku, raw), numbers(kv, raw), r, c, numbers(u, raw),
                     numbers(v, raw), points([x for row in data for x in row], raw),
                     digits(max(gain, gain_u)), points([x for row in net for x in row], digits)])
    return rows


# Areas

def real(x):
    return mpmath.mpf(x.numerator) / x.denominator


def area_and_cone(s, apex, nodes):
    """Area, volume of the cone from a point, and its moments about it, of a net with weights or
    without."""
    h = Sheet(s.kind, s.m, s.n, s.net, s.w)
    slopes = [] if s.kind == 'triangle' else [h.slope(0), h.slope(1)]
    for part in [h] + slopes:
        part.high = [[real(F(x)) for x in p] for p in part.high]
    area = volume = mpmath.mpf(0)
    moment = [area] * 3
    for x, wx in nodes:
        for y, wy in nodes:
            u, v, part = real(x), real(y), wx * wy
            if s.kind == 'triangle':
                v, part = v * (1 - u), part * (1 - u)
                here, rest = (1 - u - v, u, v), s.m - 1
                p, a, b = [h.blossom(z) for z in ([here] * s.m, [(-1, 1, 0)] + [here] * rest,
                                                  [(-1, 0, 1)] + [here] * rest)]
                a, b = [[s.m * z for z in q] for q in (a, b)]
            else:
                p, a, b = [halve(z.controls(0, u), v) for z in [h] + slopes]
            at = [z / p[3] for z in p[:3]]
            a, b = [[(z - q[3] * w) / p[3] for z, w in zip(q, at)] for q in (a, b)]
            normal = cross(a, b)
            area += part * mpmath.sqrt(sum(z * z for z in normal))
            away = [z - real(w) for z, w in zip(at, apex)]
            det = part * sum(z * q for z, q in zip(away, normal))
            volume += det / 3
            moment = [sum_ + det * z / 4 for sum_, z in zip(moment, away)]
    return area, volume, moment


def areas():
    mpmath.mp.dps = 30
    rows = []
    nodes = list(gauss(40))

    def take(s):
        area = area_and_cone(s, [F(0)] * 3, nodes)[0]
        rows.append([s.m, s.n, points(s.net, raw), mpmath.nstr(area, 14)])

    for m, n in ((1, 1), (2, 1), (2, 2), (3, 3)):
        for k in range(2):
            take(arb_sheet(m, n) if k == 0 else arb_graph(m, n, 1))
    take(Sheet('tensor', 2, 2, [[F(4 * i * (1 + j)), F(3 * j), F(2 * j)] for i in range(3)
                                for j in range(3)]))
    return rows


def cones():
    """By two Gauss rules that agree."""
    rows = []
    fine, coarse = list(gauss(44)), list(gauss(36))

    def take(s):
        apex = [arb() for _ in range(3)]
        a, v, p = area_and_cone(s, apex, fine)
        b, w, q = area_and_cone(s, apex, coarse)
        assert abs(a - b) < 1e-9 and abs(v - w) < 1e-9
        assert all(abs(x - y) < 1e-8 for x, y in zip(p, q))
        rows.append(sheet_columns(s) + [points([apex], raw), mpmath.nstr(a, 14),
                                        mpmath.nstr(v, 14),
                                        numbers(p, lambda x: mpmath.nstr(x, 14))])

    for s in (sphere(F(5), F(1)), cylinder(F(3), F(-2), F(4), F(1)), torus(F(6), F(2), F(1))):
        take(s)
    for m, n in ((1, 1), (1, 2), (2, 2), (3, 3)):
        s = arb_graph(m, n, 2)
        take(Sheet('tensor', m, n, s.net, [1 + F(rnd.randint(0, 65536), 65536) for _ in s.net]))
    take(arb_graph(3, 2, 2))
    for n in (1, 2, 3):
        take(arb_triangle(n))
    return rows


def gauss(n):
    """Nodes in 0..1 as Fractions of 2^-120, and weights, by Newton's method."""
    for k in range(1, n + 1):
        x = mpmath.cos(mpmath.pi * (k - 0.25) / (n + 0.5))
        for _ in range(8):
            before, p = mpmath.mpf(1), x
            for i in range(2, n + 1):
                before, p = p, ((2 * i - 1) * x * p - (i - 1) * before) / i
            slope = n * (x * p - before) / (x * x - 1)
            x -= p / slope
        yield F(int(mpmath.floor((x + 1) / 2 * 2 ** 120)), 1 << 120), 1 / ((1 - x * x) * slope ** 2)


# Higher degrees

def raises():
    """Nets of degrees from 19 to 32, by sums of products of binomials."""
    rows = []

    def one_way(line, to):
        n = len(line) - 1
        share = lambda i, k: F(comb(n, i) * comb(to - n, k - i), comb(to, k))
        return [[sum(share(i, k) * line[i][a] for i in range(max(0, k - to + n), min(n, k) + 1))
                 for a in range(3)] for k in range(to + 1)]

    def triangle(net, n, to):
        order = lambda d: [(d - r, r - k, k) for r in range(d + 1) for k in range(r + 1)]
        share = lambda at, b: F(prod(comb(x, y) for x, y in zip(at, b)), comb(to, n))
        return [[sum(share(at, b) * p[a] for b, p in zip(order(n), net)) for a in range(3)]
                for at in order(to)]

    for n, to in ((1, 19), (2, 24), (3, 32), (5, 20), (7, 25), (9, 19), (9, 28)):
        s = arb_triangle(n)
        rows.append(sheet_columns(s) + ['-', to - n, points(triangle(s.net, n, to), digits)])
    for k, (m, n, to) in enumerate(((1, 2, 32), (3, 3, 19), (4, 2, 30), (6, 1, 26), (9, 3, 32),
                                    (2, 9, 24))):
        s = arb_sheet(m, n)
        lines = [s.net[i * (n + 1):(i + 1) * (n + 1)] for i in range(m + 1)]
        if k % 2 == 0:
            high = list(zip(*[one_way(line, to) for line in zip(*lines)]))
        else:
            high = [one_way(line, to) for line in lines]
        rows.append(sheet_columns(s) + ['uv'[k % 2], to - (n if k % 2 else m),
                                        points([p for line in high for p in line], digits)])
    return rows


if __name__ == '__main__':
    to = sys.argv[1]
    sheet = lambda a: f'kind{a},m{a},n{a},net{a}_q16,w{a}_q16'
    write(to, 'surface_meet', 'two surfaces A and B (tensor m x n or triangle  weights or - ): '
          'number of branches in which they meet  of closed ones  - where not decided; points: all '
          'places on the lines u = k/8 and v = k/8 of A  but not those near the border of B',
          sheet('A') + ',' + sheet('B') + ',tol_q16,branches,closed,points', meets())
    write(to, 'curve_pierce', 'Bezier curve (degree n  weights or - ) and a surface: all t where '
          'they meet  their multiplicities and points', 'n,P_q16,w_q16,' + sheet('B') +
          ',tol_q16,t,mult,points', pierces())
    write(to, 'surface_light', 'cosine of the angle between the normal Pu x Pv at u v and D  at a '
          'pole of its limit', sheet('A') + ',uv_q16,D_q16,cos', lights())
    write(to, 'isophote', 'all u v on the lines u = k/size where the normal and D have this '
          'cosine  at most one between neighbours of the grid; slope = the least of d cos / '
          'dv there',
          sheet('A') + ',D_q16,cos_q16,size,count,slope,uv', isophotes())
    write(to, 'surface_fit', 'control points of the B-spline surface (degrees p q  m x n points  '
          'full knots U V) nearest to r x c points at u  v: corners kept  borders nearest to the '
          'border points  then the least sum of squares; gain = largest sum of a row of the '
          'inverse of both ways', 'p,q,m,n,U_q16,V_q16,r,c,u_q16,v_q16,P_q16,gain,Q', fits())
    write(to, 'net_area', 'area of a tensor patch  14 digits', 'm,n,net_q16,area', areas())
    write(to, 'net_cone', 'area of a surface  and the volume of the cone over it from a point '
          '(positive where Pu x Pv points away)  and the first moments of the cone about that '
          'point  14 digits', sheet('A') + ',apex_q16,area,volume,moment', cones())
    write(to, 'net_high', 'surface without weights: its net with the degree along u or v  or that '
          'of a triangle  higher by times: 19 to 32', sheet('A') + ',along,times,Q', raises())
