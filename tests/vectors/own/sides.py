# tests/vectors/own/sides.py -- rows of patches with n sides: normals and curvatures, isophotes,
# triangles of them; toric patches as tensor products
# SPDX-License-Identifier: MIT
"""usage: python3 tests/vectors/own/sides.py FOLDER     writes the CSV files, the same each time"""
import math
import random
import sys

from exact import (F, add, bernstein_of, cross, digits, dot, mul, numbers, points, raw, root, scale,
                   sub, trim, value, write)
from sheets import Level, cosine, light_slope

rnd = random.Random(1976)
POLYGONS = [[(40, -35), (10, 45), (-50, 5)],
            [(30, -40), (45, 25), (-15, 40), (-40, -25)],
            [(0, -50), (45, -20), (35, 40), (-30, 45), (-50, -15)],
            [(20, -50), (50, 0), (20, 50), (-20, 45), (-50, 5), (-30, -40)]]


def arb(size=10):
    return F(rnd.randint(-size * 65536, size * 65536), 65536)


# A function of x and y with its derivatives: f, x, y, xx, xy, yy

class Jet:
    def __init__(self, *c):
        self.c = [F(x) for x in c] + [F(0)] * (6 - len(c))

    def __add__(self, o):
        return Jet(*[a + b for a, b in zip(self.c, o.c)])

    def __mul__(self, o):
        f, x, y, xx, xy, yy = self.c
        g, u, v, uu, uv, vv = o.c
        return Jet(f * g, x * g + f * u, y * g + f * v, xx * g + 2 * x * u + f * uu,
                   xy * g + x * v + y * u + f * uv, yy * g + 2 * y * v + f * vv)

    def by(self, c):
        return Jet(*[a * c for a in self.c])

    def over(self, o):
        g, u, v, uu, uv, vv = o.c
        inverse = Jet(1 / g, -u / g ** 2, -v / g ** 2, 2 * u * u / g ** 3 - uu / g ** 2,
                      2 * u * v / g ** 3 - uv / g ** 2, 2 * v * v / g ** 3 - vv / g ** 2)
        return self * inverse


# A polynomial, with the same operations

class Line:
    def __init__(self, c):
        self.c = c

    def __add__(self, o):
        return Line(add(self.c, o.c))

    def __mul__(self, o):
        return Line(mul(self.c, o.c))

    def by(self, c):
        return Line(scale(self.c, F(c)))


def wachspress(v, x, y, one):
    """Coordinates without their common denominator: corner areas times the areas of all edges but
    those of the corner."""
    n, out = len(v), []
    area = []
    for (a, b), (c, d) in zip(v, v[1:] + v[:1]):
        area.append(x.by(b - d) + y.by(c - a) + one.by(a * d - b * c))
    for i in range(n):
        (a, b), (c, d), (e, f) = v[i - 1], v[i], v[(i + 1) % n]
        w = one.by((c - a) * (f - b) - (d - b) * (e - a))
        for k in range(n):
            if k != i and k != (i - 1) % n:
                w = w * area[k]
        out.append(w)
    return out


def indices(n, depth):
    """By falling first part, then the second .."""
    if n == 1:
        return [[depth]]
    return [[k] + rest for k in range(depth, -1, -1) for rest in indices(n - 1, depth - k)]


def spatch_weights(depth, phi, one):
    out = []
    for l in indices(len(phi), depth):
        w = one.by(math.factorial(depth))
        for k, times in enumerate(l):
            w = w.by(F(1, math.factorial(times)))
            for _ in range(times):
                w = w * phi[k]
        out.append(w)
    return out


def spatch(net, depth, phi, one):
    """Sums of x w, y w, z w and w."""
    sums = [None] * 4
    for w, p in zip(spatch_weights(depth, phi, one), net):
        for a in range(4):
            more = w.by(p[a] if a < 3 else 1)
            sums[a] = more if sums[a] is None else sums[a] + more
    return sums


def arb_patch(v, depth):
    """A height over the polygon, and a little along it."""
    v = [(F(x), F(y)) for x, y in v]
    net = []
    for l in indices(len(v), depth):
        at = [sum(k * p[i] for k, p in zip(l, v)) / depth / 4 for i in (0, 1)]
        net.append([F((at[0] * 65536).__floor__(), 65536) + arb(1),
                    F((at[1] * 65536).__floor__(), 65536) + arb(1), arb(5)])
    return v, net


# Curvatures

def forms(d):
    """Normal, Gauss and mean from Px Py Pxx Pxy Pyy."""
    n = cross(d[0], d[1])
    size = dot(n, n)
    e, f, g = dot(d[0], d[0]), dot(d[0], d[1]), dot(d[1], d[1])
    l, m, k = [dot(x, n) for x in d[2:]]
    return ([x / root(size) for x in n], (l * k - m * m) / (size * size),
            (e * k - 2 * f * m + g * l) / (2 * size * root(size)))


def curvatures():
    rows = []
    for k in range(48):
        v = POLYGONS[k % 4]
        depth = rnd.randint(1, 3 if len(v) > 4 else 5)
        v, net = arb_patch(v, depth)
        share = [rnd.randint(1, 9) for _ in v]
        at = [F((sum(s * p[i] for s, p in zip(share, v)) * 65536 / sum(share)).__floor__(), 65536)
              for i in (0, 1)]
        one = Jet(1)
        phi = wachspress(v, Jet(at[0], 1), Jet(at[1], 0, 1), one)
        sums = spatch(net, depth, phi, one)
        p = [s.over(sums[3]) for s in sums[:3]]
        d = [[x.c[i] for x in p] for i in range(1, 6)]
        n = cross(d[0], d[1])
        if dot(n, n) < F(1, 1000) * dot(d[0], d[0]) * dot(d[1], d[1]):
            continue
        n, gauss, mean = forms(d)
        # the derivatives of all weights, summed
        share, steep = [w.over(sums[3]) for w in spatch_weights(depth, phi, one)], []
        for i in range(1, 6):
            steep.append(sum(abs(w.c[i]) for w in share))
        # what an error of 1 in each derivative makes of them, to first order
        small, rise = F(1, 1 << 60), [[F(0)] * 3, [F(0)] * 3]
        for i in range(5):
            for axis in range(3):
                moved = [list(x) for x in d]
                moved[i][axis] += small
                other = forms(moved)
                change = [max(abs(a - b) for a, b in zip(n, other[0])), abs(gauss - other[1]),
                          abs(mean - other[2])]
                rise[i > 1] = [a + b / small for a, b in zip(rise[i > 1], change)]
        rows.append([len(v), depth, points(v, raw), points(net, raw), points([at], raw),
                     numbers(n, digits), digits(gauss), digits(mean),
                     digits(max(steep[:2])), digits(max(steep[2:])), numbers(rise[0], digits),
                     numbers(rise[1], digits)])
    return rows


# Isophotes

class Pair:
    """f + e g + i h, e^2 = e i = i^2 = 0: along a ray, and the derivatives by x and y."""
    def __init__(self, f, g, h):
        self.f, self.g, self.h = f, g, h

    def __add__(self, o):
        return Pair(add(self.f, o.f), add(self.g, o.g), add(self.h, o.h))

    def __mul__(self, o):
        return Pair(mul(self.f, o.f), add(mul(self.f, o.g), mul(self.g, o.f)),
                    add(mul(self.f, o.h), mul(self.h, o.f)))

    def by(self, c):
        return Pair(scale(self.f, F(c)), scale(self.g, F(c)), scale(self.h, F(c)))


def slopes(v, net, depth, middle, ray):
    """The normal without its length along middle + t ray, as polynomials of t: minors of the
    weighted coordinates and their derivatives."""
    one = Pair([F(1)], [], [])
    x, y = Pair([middle[0], ray[0]], [F(1)], []), Pair([middle[1], ray[1]], [], [F(1)])
    s = spatch(net, depth, wachspress(v, x, y, one), one)
    out = []
    for i in range(3):
        a, b, w, sum_ = s[(i + 1) % 3], s[(i + 2) % 3], s[3], []
        for p, q, r in ((a, b, w), (b, w, a), (w, a, b)):
            sum_ = add(sum_, mul(p.f, sub(mul(q.g, r.h), mul(q.h, r.g))))
        out.append(sum_)
    return out


def simple_roots(p):
    """In 0..1, by the changes of sign of Bernstein coefficients; None where one is not simple."""
    p = trim(p)
    if not p:
        return None
    n, found = len(p) - 1, []
    scale_ = math.lcm(*[c.denominator for c in p]) * math.lcm(*[math.comb(n, k)
                                                                for k in range(n + 1)])
    whole = [int(c * scale_) for c in bernstein_of(p, n)]
    todo = [(whole, F(0), F(1))]
    while todo:
        b, low, high = todo.pop()
        signs = [x > 0 for x in b if x != 0]
        changes = sum(x != y for x, y in zip(signs, signs[1:]))
        if b[0] == 0 or b[-1] == 0 or high - low < F(1, 1 << 30):
            return None
        if changes == 1:
            while high - low > F(1, 1 << 80):
                middle = (low + high) / 2
                if (value(p, middle) > 0) == (b[0] > 0):
                    low = middle
                else:
                    high = middle
            found.append(low)
        elif changes > 1:
            left, right, row = [], [], b
            for k in range(n + 1):
                left.append(row[0] << (n - k))
                right.append(row[-1] << (n - k))
                row = [x + y for x, y in zip(row, row[1:])]
            middle = (low + high) / 2
            todo += [(left, low, middle), (right[::-1], middle, high)]
    return sorted(found)


def isophotes():
    rows = []
    for k in range(40):
        v = POLYGONS[k % 4]
        sides, depth = len(v), 2 if len(v) > 4 else rnd.randint(2, 3)
        # many coordinates, of which an LSB is little; the middle is exact
        v, net = arb_patch([(64 * sides * x, 64 * sides * y) for x, y in v], depth)
        net = [[a / (64 * sides) for a in p[:2]] + [p[2]] for p in net]
        net = [[F((a * 65536).__floor__(), 65536) for a in p] for p in net]
        middle = [sum(p[i] for p in v) / sides for i in (0, 1)]
        # a direction that has this cosine with the normal somewhere
        n = [value(x, F(1, 2)) for x in
             slopes(v, net, depth, middle, [p - m for p, m in zip(v[k % sides], middle)])]
        n = [F((x / root(dot(n, n)) * 65536).__floor__(), 65536) for x in n]
        d = [arb(3), arb(3), F(4)]
        c = F((cosine(n, d) * 65536).__floor__(), 65536)
        if k // 4 % 2 == 0:
            d = [F((3 * x * 65536).__floor__(), 65536) for x in cross(n, d)]
            c = F(0)
        level = Level(8 * sides)
        for i in range(level.size):
            side, share = i // 8, F(i % 8, 8)
            end = [(1 - share) * v[side][a] + share * v[(side + 1) % sides][a] for a in (0, 1)]
            n = slopes(v, net, depth, middle, [e - m for e, m in zip(end, middle)])
            along = []
            for a, x in zip(n, d):
                along = add(along, scale(a, x))
            f = along
            if c:
                square = []
                for a in n:
                    square = add(square, mul(a, a))
                f = sub(mul(along, along), scale(square, c * c * dot(d, d)))
            here = simple_roots(f)
            if here is None:
                level.fine = False
                break
            here = [t for t in here if c == 0 or value(along, t) > 0]
            level.fine = level.fine and all(t * level.size < level.size - 1 for t in here)
            level.add(here, lambda t: light_slope(n, d, t), lambda t: (t, F(i, level.size)))
        if level.good():
            rows.append([sides, depth, points(v, raw), points(net, raw), numbers(d, raw), raw(c)] +
                        level.columns())
    return rows


# Triangles

def triangles():
    rows = []
    for k in range(32):
        v = POLYGONS[k % 4]
        sides = len(v)
        depth = rnd.randint(1, min(4, 9 // (sides - 2)))
        v, net = arb_patch(v, depth)
        edge = rnd.randrange(sides)
        share = [F(rnd.randint(0, 32), 64) for _ in range(2)]
        middle = [sum(p[i] for p in v) / sides for i in (0, 1)]
        at = [(1 - share[0] - share[1]) * m + share[0] * a + share[1] * b
              for m, a, b in zip(middle, v[edge], v[(edge + 1) % sides])]
        one = Jet(1)
        sums = [x.c[0] for x in spatch(net, depth, wachspress(v, Jet(at[0]), Jet(at[1]), one), one)]
        rows.append([sides, depth, points(v, raw), points(net, raw), edge, points([share], raw),
                     numbers([x / sums[3] for x in sums[:3]], digits)])
    return rows


# Toric patches as tensor products

LATTICES = [[(0, 0), (4, 0), (0, 4)], [(0, 0), (3, 0), (3, 2), (0, 2)],
            [(0, 0), (2, 0), (2, 1), (1, 2), (0, 2)],
            [(0, 0), (1, 0), (2, 1), (2, 2), (1, 2), (0, 1)],
            [(0, 0), (2, 0), (3, 1), (3, 2), (2, 3), (0, 3)],
            [(1, 0), (2, 0), (3, 1), (3, 2), (2, 3), (1, 3), (0, 2), (0, 1)]]


def edges(v):
    """The shortest whole normal of each edge, inward, and its height at 0."""
    out = []
    for (a, b), (c, d) in zip(v, v[1:] + v[:1]):
        size = math.gcd(c - a, d - b)
        x, y = (b - d) // size, (c - a) // size
        out.append((x, y, -(x * a + y * b)))
    return out


def heights(e, p):
    return [x * p[0] + y * p[1] + o for x, y, o in e]


def toric_net(e, span):
    """By the definition of the patch: whole points, factors, points."""
    lattice = [(x, y) for y in span for x in span if min(heights(e, (x, y))) >= 0]
    c = [rnd.randint(1, 6) for _ in lattice]
    w = [F(rnd.randint(16384, 4 * 65536), 65536) for _ in lattice]
    return lattice, c, w, [[x * 4 + arb(1), y * 4 + arb(1), arb(5)] for x, y in lattice]


def in_quarter(e, p, k):
    """s and t at vertex k, whose angle has the determinant 1."""
    h, (a, b, _), (c, d, _) = heights(e, p), e[k - 1], e[k]
    assert a * d - b * c == 1
    s = t = F(1)
    for j, (x, y, _) in enumerate(e):
        s *= h[j] ** (x * d - y * c)
        t *= h[j] ** (a * y - b * x)
    return s, t


def weighted_mean(weight, net):
    return [sum(w * q[i] for w, q in zip(weight, net)) / sum(weight) for i in range(3)]


def torics():
    rows = []
    for k in range(36):
        v = LATTICES[k % 6]
        e = edges(v)
        lattice, c, w, net = toric_net(e, range(6))
        share = [rnd.randint(1, 9) ** 2 for _ in v]
        p = [F((sum(s * q[i] for s, q in zip(share, v)) * 65536 / F(sum(share))).__floor__(),
               65536) for i in (0, 1)]
        vertex, (s, t) = [(i, st) for i in range(len(v)) for st in [in_quarter(e, p, i)]
                          if max(st) <= 1][0]
        factor = [a * b for a, b in zip(c, w)]
        local = [(heights(e, l)[vertex - 1], heights(e, l)[vertex]) for l in lattice]
        weight = []
        for f, l in zip(factor, lattice):
            for h, power in zip(heights(e, p), heights(e, l)):
                f *= h ** power
            weight.append(f)
        point = weighted_mean(weight, net)
            steep = [0.0] * 3
        for i, x in ((0, s), (1, t)):
            degree = max(l[i] for l in local)
            on = sum(f for f, l in zip(factor, local) if l[i] == 0)
            a = float(sum(factor) / on) ** (1 / degree)
            u = a * float(x) / (1 - float(x) + a * float(x))
            for axis in range(3):
                by = sum(f * l[i] * (q[axis] - point[axis]) for f, l, q in zip(weight, local, net))
                steep[axis] += abs(float(by / x / sum(weight))) * a / (u + a * (1 - u)) ** 2
        rows.append([len(v), points([[F(x) for x in q] for q in v], raw), points(net, raw),
                     numbers([F(x) for x in c], raw), numbers(w, raw), vertex, digits(s), digits(t),
                     numbers(point, digits), digits(F(max(steep)))])
    return rows


if __name__ == '__main__':
    to = sys.argv[1]
    write(to, 'spatch_curvature', 'S-patch over the polygon v with Wachspress coordinates: unit '
          'normal Px x Py  Gaussian and mean curvature at x y; A and B: sums of the magnitudes of '
          'first and second derivatives of the weights; rise1 and rise2: what errors of 1 in all '
          'first and in all second derivatives make of the three', 'sides,depth,v_q16,net_q16,'
          'at_q16,N,gauss,mean,A,B,rise1,rise2', curvatures())
    write(to, 'spatch_isophote', 'S-patch over a polygon: all u v on the lines v = k/size of the '
          'disk of polygon/disk.h (u from the mean of the vertices to the boundary) where the '
          'normal and D have this cosine; slope = the least of d cos / du there',
          'sides,depth,v_q16,net_q16,D_q16,cos_q16,size,count,slope,uv', isophotes())
    write(to, 'spatch_triangle', 'S-patch over the polygon v with Wachspress coordinates: its '
          'point at these shares of the vertices edge and edge + 1  the rest is of the mean of all',
          'sides,depth,v_q16,net_q16,edge,share_q16,P', triangles())
    write(to, 'toric_tensor', 'toric patch over the lattice polygon v with coefficients c and '
          'weights w: its point at a point of the polygon  by the definition; s t = that point in '
          'the quarter of this vertex: prod h_j^normal_j = s^normal_(vertex - 1) t^normal_vertex; '
          'slope = the largest |dP/du| + |dP/dv| of its tensor product there',
          'sides,v_q16,net_q16,c_q16,w_q16,vertex,s,t,P,slope', torics())
