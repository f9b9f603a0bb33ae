# tests/vectors/own/beyond.py -- rows outside of 0..1 and of the triangle, from the definitions
# SPDX-License-Identifier: MIT
"""usage: python3 tests/vectors/own/beyond.py FOLDER  writes the CSV files, the same each time

There eval clamps and extrapolate does not: the reader of a row calls the one that extrapolates, and
where a row is inside both, which must agree. One row in four is inside."""
import random
import sys
from math import comb, factorial

from exact import F, ONE, digits, numbers, points, raw, write

rnd = random.Random(36)
ROWS = 12


def arb(size=60):
    return F(rnd.randint(-size * ONE, size * ONE), ONE)


def vector(size=60):
    return [arb(size) for _ in range(3)]


def place(row):
    """Barycentric coordinates that sum to 1, up to 1 outside."""
    if row % 4 == 0:
        a, b = sorted(rnd.randint(0, ONE) for _ in range(2))
    else:
        a, b = rnd.randint(-ONE // 4, ONE), rnd.randint(ONE + 1, 2 * ONE)
    u = [F(a, ONE), F(b - a, ONE), F(ONE - b, ONE)]
    rnd.shuffle(u)
    return u


def mean(ps):
    return [sum(x) / len(ps) for x in zip(*ps)]


def pn_rows():
    """Vlachos, Peters, Boyd, Mitchell, Curved PN triangles (2001); any length of normals."""
    rows = []
    for row in range(ROWS):
        p = [vector() for _ in range(3)]
        n = [[F(rnd.randint(-8, 8), 8) for _ in range(3)] for _ in range(3)]
        for x in n:
            x[rnd.randint(0, 2)] = F(1)
        u = place(row)

        def edge(i, j):
            """Of the edge from corner i to j the point next to i, moved into the plane of i."""
            w = sum((b - a) * c for a, b, c in zip(p[i], p[j], n[i])) / sum(c * c for c in n[i])
            return [(2 * a + b - w * c) / 3 for a, b, c in zip(p[i], p[j], n[i])]

        b = {(3, 0, 0): p[0], (0, 3, 0): p[1], (0, 0, 3): p[2],
             (2, 1, 0): edge(0, 1), (2, 0, 1): edge(0, 2), (1, 2, 0): edge(1, 0),
             (1, 0, 2): edge(2, 0), (0, 2, 1): edge(1, 2), (0, 1, 2): edge(2, 1)}
        e, v = mean([x for k, x in b.items() if 3 not in k]), mean(p)
        b[1, 1, 1] = [x + (x - y) / 2 for x, y in zip(e, v)]
        order = [(2, 1, 0), (2, 0, 1), (1, 2, 0), (1, 1, 1), (1, 0, 2), (0, 2, 1), (0, 1, 2)]
        at = [sum(weight(3, k, u) * x[axis] for k, x in b.items()) for axis in range(3)]
        rows.append([points(p, raw), points(n, raw), numbers(u, raw),
                     points([b[k] for k in order], digits), numbers(at, digits)])
    return rows


def weight(n, k, u):
    """The Bernstein polynomial of degree n over a triangle."""
    out = F(factorial(n))
    for j, x in zip(k, u):
        out = out / factorial(j) * x ** j
    return out


def nodes(n):
    return [(n - i, i - j, j) for i in range(n + 1) for j in range(i + 1)]


def iterated_rows():
    """f at the nodes is replaced by the values of its polynomial there, again and again."""
    rows = []
    for row in range(ROWS):
        n, times, u = 1 + row % 4, 1 + rnd.randint(0, 5), place(row)
        given = [arb() for _ in nodes(n)]

        def polynomial(f, at):
            return sum(weight(n, k, at) * x for k, x in zip(nodes(n), f))

        f = given
        for _ in range(times - 1):
            f = [polynomial(f, [F(i, n) for i in k]) for k in nodes(n)]
        corners = [given[nodes(n).index(k)] for k in ((n, 0, 0), (0, n, 0), (0, 0, n))]
        rows.append([n, ';'.join(raw(x) for x in given), times, numbers(u, raw),
                     digits(polynomial(f, u)), digits(sum(x * y for x, y in zip(u, corners)))])
    return rows


def rational_rows():
    """Near 0..1, where the weights still sum to more than 1."""
    rows = []
    while len(rows) < ROWS:
        n, d = 1 + len(rows) % 4, 1 + rnd.randint(0, 2)
        p = [[arb() for _ in range(d)] for _ in range(n + 1)]
        w = [F(rnd.randint(ONE, 4 * ONE), ONE) for _ in p]
        t = F(rnd.randint(0, ONE), ONE) if len(rows) % 4 == 0 else \
            rnd.choice([F(-1, 4), F(1)]) + F(rnd.randint(1, ONE // 4), ONE)
        basis = [comb(n, i) * t ** i * (1 - t) ** (n - i) for i in range(n + 1)]
        low = [comb(n - 1, i) * t ** i * (1 - t) ** (n - 1 - i) for i in range(n)]
        sums = lambda c: (sum(a * b for a, b in zip(basis, c)),
                          n * sum(a * (y - x) for a, x, y in zip(low, c, c[1:])))
        bottom, slope = sums(w)
        if bottom < 1:
            continue
        at, way = [], []
        for axis in range(d):
            x, dx = sums([a * b[axis] for a, b in zip(w, p)])
            at.append(x / bottom)
            way.append((dx - x / bottom * slope) / bottom)
        rows.append([n, d, points(p, raw), numbers(w, raw), raw(t), numbers(at, digits),
                     numbers(way, digits)])
    return rows


def main():
    to = sys.argv[1]
    write(to, 'pn_triangle', 'PN triangle with points P and normals N of any length: b210;b201;'
          'b120;b111;b102;b021;b012 and the point at u', 'P_q16,N_q16,u_q16,b,p', pn_rows(),
          'pn_beyond')
    write(to, 'rational_eval', 'rational Bezier curve: point and first derivative at t',
          'n,d,P_q16,w_q16,t_q16,p,dp', rational_rows(), 'rational_beyond')
    write(to, 'tri_bernstein_iter', 'Bernstein operator on the triangle iterated k times: value '
          'at u; lim = u1 f(T1)+u2 f(T2)+u3 f(T3)', 'n,f_q16,k,u_q16,value,lim', iterated_rows(),
          'tri_iter_beyond')


if __name__ == '__main__':
    main()
