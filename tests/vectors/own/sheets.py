# tests/vectors/own/sheets.py -- patches and triangles along lines of constant parameters, and the
# equations of surfaces
# SPDX-License-Identifier: MIT
"""A sheet along a line is a list of polynomials x w, y w, z w, w. A target is a sheet with an
equation that is 0 on it, and a test whether a point that solves it lies within its border."""
import math

from exact import (F, add, digits, dot, grid, mul, points, power_of, root, roots, scale, sub,
                   value)


class Sheet:
    def __init__(self, kind, m, n, net, w=None):
        self.kind, self.m, self.n, self.net, self.w = kind, m, n, net, w
        self.high = [[x * v for x in p] + [v] for p, v in zip(net, w or [F(1)] * len(net))]

    def line(self, fixed, c):
        """Along the line u = c (fixed 0) or v = c (fixed 1)."""
        return [power_of([p[k] for p in self.controls(fixed, c)]) for k in range(4)]

    def controls(self, fixed, c):
        if self.kind == 'triangle':
            from_, to = ((1 - c, c, F(0)), (F(0), c, 1 - c)) if fixed == 0 else \
                        ((1 - c, F(0), c), (F(0), 1 - c, c))
            return [self.blossom([from_] * (self.m - k) + [to] * k) for k in range(self.m + 1)]
        m, n = self.m, self.n
        if fixed == 0:
            rows = [[self.high[i * (n + 1) + j] for i in range(m + 1)] for j in range(n + 1)]
        else:
            rows = [self.high[i * (n + 1):(i + 1) * (n + 1)] for i in range(m + 1)]
        return [halve(row, c) for row in rows]

    def blossom(self, at):
        """Of a triangle: rows of the net by falling share of corner 1."""
        n, points = self.m, list(self.high)
        for share in at:
            index = lambda i, j: (i * (i + 1)) // 2 + j         # row i has i + 1 points
            points = [[share[0] * a + share[1] * b + share[2] * c
                       for a, b, c in zip(points[index(i, j)], points[index(i + 1, j)],
                                          points[index(i + 1, j + 1)])]
                      for i in range(n) for j in range(i + 1)]
            n -= 1
        return points[0]

    def slope(self, fixed):
        """The derivative of a patch by u or v, in weighted coordinates."""
        m, n, h = self.m, self.n, self.high
        at = lambda i, j: h[i * (n + 1) + j]
        if fixed == 0:
            net = [[m * (a - b) for a, b in zip(at(i + 1, j), at(i, j))]
                   for i in range(m) for j in range(n + 1)]
            m -= 1
        else:
            net = [[n * (a - b) for a, b in zip(at(i, j + 1), at(i, j))]
                   for i in range(m + 1) for j in range(n)]
            n -= 1
        out = Sheet(self.kind, m, n, [p[:3] for p in net])
        out.high = net
        return out

    def point(self, u, v):
        if self.kind == 'triangle':
            h = self.blossom([(1 - u - v, u, v)] * self.m)
        else:
            h = halve(self.controls(0, u), v)
        return [x / h[3] for x in h[:3]]


def halve(points, t):
    while len(points) > 1:
        points = [[(1 - t) * a + t * b for a, b in zip(p, q)] for p, q in zip(points, points[1:])]
    return points[0]


class Target(Sheet):
    """equation(x, y, z, w) of polynomials; inside(point) with room to the border."""
    def __init__(self, sheet, equation, inside):
        super().__init__(sheet.kind, sheet.m, sheet.n, sheet.net, sheet.w)
        self.equation, self.inside = equation, inside


def plane(corner, a, b, room):
    """The parallelogram from a corner along a and b."""
    net = [[c + i * x + j * y for c, x, y in zip(corner, a, b)] for i in (0, 1) for j in (0, 1)]
    normal = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    off = dot(normal, corner)

    def equation(x, y, z, w):
        return sub(add(add(scale(x, normal[0]), scale(y, normal[1])), scale(z, normal[2])),
                   scale(w, off))

    def inside(p):
        d = [x - c for x, c in zip(p, corner)]
        aa, ab, bb, da, db = dot(a, a), dot(a, b), dot(b, b), dot(d, a), dot(d, b)
        det = aa * bb - ab * ab
        u, v = (da * bb - db * ab) / det, (db * aa - da * ab) / det
        return room < u < 1 - room and room < v < 1 - room

    return Target(Sheet('tensor', 1, 1, net), equation, inside)


QUARTER = [(1, 0, 1), (1, 1, 1), (0, 1, 2)]             # x, y, weight


def cylinder(radius, low, high, room):
    """A quarter of x^2 + z^2 = R^2, x and z at least 0, along y."""
    net = [[F(radius * x), F(y), F(radius * z)] for x, z, _ in QUARTER for y in (low, high)]
    w = [F(v) for _, _, v in QUARTER for _ in (0, 1)]

    def equation(x, y, z, w):
        return sub(add(mul(x, x), mul(z, z)), scale(mul(w, w), F(radius * radius)))

    return Target(Sheet('tensor', 2, 1, net, w), equation,
                  lambda p: p[0] > room and p[2] > room and low + room < p[1] < high - room)


def sphere(radius, room):
    """An octant of a sphere as a patch with a pole."""
    net, w = [], []
    for r, z, v in QUARTER:
        for x, y, q in QUARTER:
            net.append([F(radius * r * x), F(radius * r * y), F(radius * z)])
            w.append(F(v * q))

    def equation(x, y, z, w):
        return sub(add(add(mul(x, x), mul(y, y)), mul(z, z)), scale(mul(w, w), F(radius * radius)))

    return Target(Sheet('tensor', 2, 2, net, w), equation, lambda p: min(p) > room)


def torus(big, small, room):
    """An eighth of a torus: the outer upper quarter of its circle, turned by 90 degrees."""
    net, w = [], []
    for r, z, v in QUARTER:
        for x, y, q in QUARTER:
            net.append([F((big + small * r) * x), F((big + small * r) * y), F(small * z)])
            w.append(F(v * q))

    def equation(x, y, z, w):
        flat = add(mul(x, x), mul(y, y))
        all_ = add(add(flat, mul(z, z)), scale(mul(w, w), F(big * big - small * small)))
        return sub(mul(all_, all_), scale(mul(flat, mul(w, w)), F(4 * big * big)))

    return Target(Sheet('tensor', 2, 2, net, w), equation,
                  lambda p: min(p) > room and p[0] ** 2 + p[1] ** 2 > (big + room) ** 2)


def graph(m, n, heights, side):
    """Heights over a square."""
    return Sheet('tensor', m, n, [[F(side * i, m), F(side * j, n), heights[i * (n + 1) + j]]
                                  for i in range(m + 1) for j in range(n + 1)])


class Over(Target):
    """A graph over the same square as another one, or as any sheet whose x and y are u and v times
    the side."""
    def __init__(self, sheet):
        super().__init__(sheet, None, lambda p: True)


def equation_on(a, b, fixed, c):
    """The polynomial along the line whose roots are where a meets b."""
    x, y, z, w = a.line(fixed, c)
    if isinstance(b, Over):
        return sub(z, b.line(fixed, c)[2])
    return b.equation(x, y, z, w)


def places(a, b, lines):
    """Points where the lines u = k / lines and v = k / lines of a meet b."""
    out = []
    for fixed in (0, 1):
        for k in range(lines + (a.kind != 'triangle')):
            c = F(k, lines)
            h = a.line(fixed, c)
            for t, _ in roots(equation_on(a, b, fixed, c)):
                weight = value(h[3], t)
                p = [value(x, t) / weight for x in h[:3]]
                if b.inside(p):
                    out.append(p)
    return out


def branches(a, b, cells):
    """How many branches there are and how many of them are closed, on a fine grid."""
    f, inside = {}, {}
    steps = [F(i, cells) for i in range(cells + 1)]
    floats = lambda p: [float(c) for c in p]
    horner = lambda p, t: sum_(p, t)
    for i, u in enumerate(steps):
        p = floats(equation_on(a, b, 0, u))
        h = [floats(x) for x in a.line(0, u)]
        for j in range(cells + 1):
            t = j / cells
            f[i, j] = horner(p, t)
            if j < cells and i < cells:
                s = t + .5 / cells
                w = horner(h[3], s)
                inside[i, j] = b.inside([horner(x, s) / w for x in h[:3]])
    sign = lambda i, j: f[i, j] > 0
    owner, open_ = {}, set()

    def find(x):
        while owner[x] != x:
            x = owner[x]
        return x

    for c, is_in in inside.items():
        i, j = c
        if is_in and len({sign(i, j), sign(i + 1, j), sign(i, j + 1), sign(i + 1, j + 1)}) == 2:
            owner[c] = c
    for i, j in owner:
        for ends, other in ((((i, j), (i + 1, j)), (i, j - 1)), (((i, j), (i, j + 1)), (i - 1, j)),
                            (((i + 1, j), (i + 1, j + 1)), (i + 1, j)),
                            (((i, j + 1), (i + 1, j + 1)), (i, j + 1))):
            if sign(*ends[0]) == sign(*ends[1]):
                continue
            if other in owner:
                owner[find((i, j))] = find(other)
            else:
                open_.add((i, j))
    all_ = {find(c) for c in owner}
    return len(all_), len(all_ - {find(c) for c in open_})


def sum_(p, t):
    out = 0.0
    for c in reversed(p):
        out = out * t + c
    return out


def bernstein2(f, m, n):
    """Bernstein coefficients of a polynomial of u and v, {(i, j): c}, on the grid of 2^-16."""
    out = []
    for i in range(m + 1):
        for j in range(n + 1):
            out.append(grid(sum(c * F(math.comb(i, a), math.comb(m, a)) *
                                F(math.comb(j, b), math.comb(n, b))
                                for (a, b), c in f.items() if a <= i and b <= j)))
    return out


def product2(f, g):
    out = {}
    for (a, b), c in f.items():
        for (d, e), x in g.items():
            out[a + d, b + e] = out.get((a + d, b + e), F(0)) + c * x
    return out


def circle2(u, v, r):
    u, v, r = F(u), F(v), F(r)
    return {(0, 0): u * u + v * v - r * r, (1, 0): -2 * u, (0, 1): -2 * v, (2, 0): F(1),
            (0, 2): F(1)}


def cosine(normal, d):
    return dot(normal, d) / (root(dot(normal, normal)) * root(dot(d, d)))


def light_slope(normal, d, t):
    """How fast the cosine of D and the normal, polynomials of t, changes there."""
    e = F(1, 1 << 40) * (1 if t < F(1, 2) else -1)
    light = [cosine([value(x, y) for x in normal], d) for y in (t, t + e)]
    return abs((light[1] - light[0]) / e)


class Level:
    """Where lines of a grid of so many cells meet a level: once in a cell at most, not on a line of
    it, and aslant."""
    def __init__(self, size):
        self.size, self.found, self.slope, self.fine = size, [], None, True

    def add(self, here, slope, place):
        cells = [(t * self.size).__floor__() for t in here]
        self.fine = self.fine and len(set(cells)) == len(cells) and \
            all(t * self.size != k for t, k in zip(here, cells))
        for t in here:
            rise = slope(t)
            self.slope = rise if self.slope is None or rise < self.slope else self.slope
            self.found.append(place(t))

    def good(self):
        return self.fine and self.found and self.slope > F(1, 100)

    def columns(self):
        return [self.size, len(self.found), digits(self.slope), points(self.found, digits)]
