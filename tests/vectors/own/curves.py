# tests/vectors/own/curves.py -- rows of what curves are asked, from the definitions
# SPDX-License-Identifier: MIT
"""usage: python3 tests/vectors/own/curves.py FOLDER    writes the CSV files, the same each time"""
import random
import sys
from math import comb

from sympy import Poly, Symbol

from exact import (F, add, bernstein_of, casteljau, cross, deriv, digits, dot, grid, mul, numbers,
                   points, power_of, raw, root, roots, sub, trim, value, write)

rnd = random.Random(1973)


def arb(size=10):
    return F(rnd.randint(-size * 65536, size * 65536), 65536)


def arb_points(count, d, size=10):
    return [[arb(size) for _ in range(d)] for _ in range(count)]


def arb_weights(count):
    return [F(rnd.choice([1, 2, 3, 5, 8, 50]), 2) + F(rnd.randint(0, 9999), 65536)
            for _ in range(count)]


def homogeneous(p, w):
    """Polynomials x w, y w, .., w."""
    w = w or [F(1)] * len(p)
    axes = [power_of([x[k] * v for x, v in zip(p, w)]) for k in range(len(p[0]))]
    return axes + [power_of(w)]


def weights(w):
    return numbers(w, raw) if w else '-'


# Inflections

def wronskian(p, w):
    """P' x P'' times w^3: the determinant of (x w, y w, w), its first and second derivatives."""
    h = homogeneous(p, w)
    h = [h, [deriv(x) for x in h], [deriv(deriv(x)) for x in h]]
    det = []
    for a, b, c in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        det = add(det, mul(h[0][a], sub(mul(h[1][b], h[2][c]), mul(h[1][c], h[2][b]))))
    return det


def inflections():
    rows, cases = [], []
    for n in range(2, 10):
        for _ in range(3):
            cases.append((arb_points(n + 1, 2), None))
        zigzag = [[F(k), F(3 * (-1) ** k + rnd.randint(-1, 1))] for k in range(n + 1)]
        cases.append((zigzag, None))
    for n in range(2, 8):
        for _ in range(3):
            cases.append((arb_points(n + 1, 2), arb_weights(n + 1)))
    for n in (1, 3, 6):                                         # straight
        cases.append(([[F(k * k - 3 * k), F(2 * k * k - 6 * k + 1)] for k in range(n + 1)], None))
    # y = a polynomial of x = t whose second derivative has given roots, on the grid of 2^-16
    for zeros in ([F(1, 4)] * 2, [F(1, 2)] * 3, [F(0), F(1)], [F(1, 8), F(1, 8), F(7, 8)],
                  [F(0)] * 3 + [F(1)] * 2, [F(3, 8)] * 4, [F(1, 2), F(1, 2) + F(1, 256)],
                  [F(1, 2), F(1, 2) + F(1, 64), F(1, 2) - F(1, 64)]):
        p = [F(5040)]
        for z in zeros:
            p = mul(p, [-z, F(1)])
        for _ in range(2):
            p = [F(0)] + [c / (k + 1) for k, c in enumerate(p)]
        n = len(p) - 1
        x, y = bernstein_of([F(0), F(n)], n), bernstein_of(p, n)
        cases.append(([[a, grid(b)] for a, b in zip(x, y)], None))
    # a cusp: P' = 0 at 1/2, cubic and raised; a curve that stops at its start
    cusp = [[F(0), F(0)], [F(4), F(4)], [F(0), F(4)], [F(4), F(0)]]
    cases.append((cusp, None))
    cases.append(([[F(0), F(0)], [F(0), F(0)], [F(3), F(4)], [F(8), F(2)], [F(1), F(-5)]], None))
    cases.append(([[F(1), F(1)]] * 3 + [[F(3), F(4)], [F(8), F(2)], [F(1), F(-5)]], None))
    # a circle and a hyperbola have none
    cases.append(([[F(1), F(0)], [F(1), F(1)], [F(0), F(1)]], [F(1), F(1), F(2)]))
    for p, w in cases:
        det = wronskian(p, w)
        found = roots(det) if det else []
        rows.append([len(p) - 1, points(p, raw), weights(w), 'ok' if det else 'straight',
                     len(found), numbers([t for t, _ in found], digits),
                     numbers([m for _, m in found], str)])
    return rows


# Frames

def derivatives(h, t):
    """P and its first three derivatives, of weighted coordinates as polynomials."""
    jets = []
    for x in h:
        jet = []
        for _ in range(4):
            jet.append(value(x, t))
            x = deriv(x)
        jets.append(jet)
    weight, out = jets[-1], []
    for k in range(4):
        sums = []
        for axis, jet in enumerate(jets[:-1]):
            binomial = [1, k, k * (k - 1) // 2, 1]
            x = jet[k] - sum(binomial[i] * weight[i] * out[k - i][axis] for i in range(1, k + 1))
            sums.append(x / weight[0])
        out.append(sums)
    return out


def frame_row(p, w, t):
    row = [len(p) - 1, points(p, raw), weights(w), raw(t)]
    return row + frame_columns(homogeneous(p, w), t)


def frame_columns(h, t):
    d = derivatives(h, t)
    binormal = cross(d[1], d[2])
    if not any(d[1]):
        return ['stops'] + ['-'] * 5
    speed = root(dot(d[1], d[1]))
    bend = root(dot(binormal, binormal))
    if not any(binormal):
        return ['straight', '0', '-', '-', '-', '-']
    tangent = [x / speed for x in d[1]]
    across = [x / bend for x in binormal]
    return ['ok', digits(bend / speed ** 3), digits(dot(binormal, d[3]) / bend ** 2),
            numbers(tangent, digits), numbers(cross(across, tangent), digits),
            numbers(across, digits)]


def frames():
    rows = []
    some = lambda: rnd.choice([F(0), F(1), F(1, 2), F(1, 65536), F(rnd.randint(0, 65536), 65536)])
    for n in range(2, 10):
        for _ in range(3):
            rows.append(frame_row(arb_points(n + 1, 3), None, some()))
            rows.append(frame_row(arb_points(n + 1, 3), arb_weights(n + 1), some()))
    flat = [[F(0), F(0), F(0)], [F(2), F(1), F(3)], [F(4), F(2), F(-1)], [F(6), F(3), F(2)]]
    cubic = [[F(0)] * 3, [F(1), F(0), F(0)], [F(2), F(1), F(0)], [F(3), F(3), F(3)]]
    line = [[F(k), F(-2 * k), F(3 * k)] for k in (0, 1, 5, 6)]
    cusp = [[F(0), F(0), F(0)], [F(4), F(4), F(8)], [F(0), F(4), F(8)], [F(4), F(0), F(0)]]
    stop = [[F(1), F(2), F(3)]] * 2 + [[F(3), F(4), F(5)], [F(8), F(2), F(1)]]
    quarter = [[F(5), F(0), F(1)], [F(5), F(5), F(1)], [F(0), F(5), F(1)]]
    for p, w in ((flat, None), (cubic, None), (line, None), (line, [F(1), F(3), F(1, 2), F(2)]),
                 (cusp, None), (stop, None), (quarter, [F(1), F(1), F(2)])):
        for t in (F(0), F(1, 2), F(1), F(1, 65536)):
            rows.append(frame_row(p, w, t))
    return rows


def basis_polynomials(knots, p, span):
    """The B-splines as polynomials of u on the span after this knot."""
    count = len(knots) - 1
    row = [[F(1)] if i == span else [] for i in range(count)]
    for d in range(1, p + 1):
        out = []
        for i in range(count - d):
            rise, fall = knots[i + d] - knots[i], knots[i + d + 1] - knots[i + 1]
            sum_ = mul(row[i], [-knots[i] / rise, 1 / rise]) if rise else []
            out.append(add(sum_, mul(row[i + 1], [knots[i + d + 1] / fall, -1 / fall])
                           if fall else []))
        row = out
    return row


def nurbs_frames():
    rows = []
    for k in range(60):
        p = rnd.randint(2, 9)
        inner = sorted(F(rnd.randint(1, 15), 4) for _ in range(rnd.randint(0, 5)))
        if any(inner.count(x) >= p for x in inner):
            continue
        knots = [F(0)] * (p + 1) + inner + [F(4)] * (p + 1)
        count = len(knots) - p - 1
        pts, w = arb_points(count, 3), arb_weights(count) if k % 3 else [F(1)] * count
        u = rnd.choice([F(0), F(4), F(rnd.randint(0, 4 * 65536), 65536)] + inner)
        span = max(i for i in range(count) if knots[i] <= u and knots[i] < knots[i + 1])
        b = basis_polynomials(knots, p, span)
        h = []
        for axis in range(4):
            sum_ = []
            for x, y, z in zip(b, pts, w):
                sum_ = add(sum_, x, z * (y[axis] if axis < 3 else 1))
            h.append(sum_)
        rows.append([p, count, numbers(knots, raw), points(pts, raw), numbers(w, raw), raw(u)] +
                    frame_columns(h, u))
    return rows


# Knots removed

def solve(matrix, right):
    """Gauss: a square matrix; right is a list of rows."""
    rows = [list(a) + list(b) for a, b in zip(matrix, right)]
    n = len(rows)
    for c in range(n):
        pivot = next(r for r in range(c, n) if rows[r][c] != 0)
        rows[c], rows[pivot] = rows[pivot], rows[c]
        rows[c] = [x / rows[c][c] for x in rows[c]]
        for r in range(n):
            if r != c and rows[r][c]:
                rows[r] = [x - rows[r][c] * y for x, y in zip(rows[r], rows[c])]
    return [row[n:] for row in rows]


def insertion(knots, p, u, count):
    """The matrix that gives the points with u inserted once more from the `count` without it."""
    k = max(i for i in range(len(knots) - 1) if knots[i] <= u)
    rows = []
    for i in range(count + 1):
        row = [F(0)] * count
        if i <= k - p:
            row[i] = F(1)
        elif i > k - knots.count(u):
            row[i - 1] = F(1)
        else:
            a = (u - knots[i]) / (knots[i + p] - knots[i])
            row[i], row[i - 1] = a, 1 - a
        rows.append(row)
    return rows


def basis(knots, p, u):
    """All B-splines at u, from the right; at the end from the left."""
    count = len(knots) - p - 1
    last = u == knots[-1]
    row = [F(int(knots[i] < knots[i + 1] == u if last else knots[i] <= u < knots[i + 1]))
           for i in range(len(knots) - 1)]
    for d in range(1, p + 1):
        row = [(F(0) if knots[i + d] == knots[i] else
                (u - knots[i]) / (knots[i + d] - knots[i]) * row[i]) +
               (F(0) if knots[i + d + 1] == knots[i + 1] else
                (knots[i + d + 1] - u) / (knots[i + d + 1] - knots[i + 1]) * row[i + 1])
               for i in range(len(row) - 1)]
    return row[:count]


def without_knot(p, knots, pts, w, index):
    """One knot less. Of the p - s + 1 equations that have two unknowns the middle one is dropped;
    of two middle ones each in turn, and the mean of both is taken. With weights in homogeneous
    points."""
    u = knots[index]
    fewer = knots[:index] + knots[index + 1:]
    count = len(pts) - 1
    m = insertion(fewer, p, u, count)
    mixed = [i for i in range(count + 1) if sum(1 for x in m[i] if x) == 2]
    high = [[x * v for x in a] + [v] for a, v in zip(pts, w)] if w else pts
    solutions = []
    for drop in sorted({mixed[(len(mixed) - 1) // 2], mixed[len(mixed) // 2]}):
        keep = [i for i in range(count + 1) if i != drop]
        solutions.append(solve([m[i] for i in keep], [high[i] for i in keep]))
    q = [[sum(s[i][k] for s in solutions) / len(solutions) for k in range(len(high[0]))]
         for i in range(count)]
    again = [[sum(a * q[i][k] for i, a in enumerate(row)) for k in range(len(high[0]))]
             for row in m]
    return q, again


def removals(weighted):
    rows = []
    for _ in range(60):
        p, d = rnd.randint(1, 7), rnd.randint(2, 3)
        inner, k = [], F(0)
        for _ in range(rnd.randint(1, 5)):
            k += F(rnd.randint(1, 5 * 65536), 65536) if rnd.random() < .8 else F(1, 256)
            inner += [k] * min(p, rnd.choice([1, 1, 1, 2, 3, p]))
        end = k + F(rnd.randint(1, 3))
        knots = [F(0)] * (p + 1) + inner + [end] * (p + 1)
        index = p + 1 + rnd.randrange(len(inner))
        count = len(knots) - p - 1
        u = knots[index]
        pts, w = arb_points(count, d), None
        if weighted:
            w = [F(8) + F(rnd.randint(0, 1 << 18), 65536) for _ in pts]
        fewer = knots[:index] + knots[index + 1:]
        if rnd.random() < .6:
            # removable, but for the rounding of its points
            m = insertion(fewer, p, u, count - 1)
            v = [sum(a * w[i] for i, a in enumerate(row)) for row in m] if w else [F(1)] * count
            pts = [[grid(sum(a * pts[i][k] * (w[i] if w else 1) for i, a in enumerate(row)) / x)
                    for k in range(d)] for row, x in zip(m, v)]
            w = [grid(x) for x in v] if w else None
        q, again = without_knot(p, knots, pts, w, index)
        head = [p, count, d, numbers(knots, raw), points(pts, raw)]
        if not w:
            off = [dot(z, z) for z in ([x - y for x, y in zip(a, b)] for a, b in zip(again, pts))]
            if all(abs(x) < 30000 for a in q for x in a):
                rows.append(head + [index, points(q, digits), digits(root(max(off)))])
            continue
        if not all(F(1, 128) < a[d] < 200 for a in q):
            continue
        point = lambda k, x, high: [sum(b * a[i] for b, a in zip(basis(k, p, x), high))
                                    for i in range(d + 1)]
        far = F(0)
        for i in range(1, 32):
            x = end * F(2 * i + 1, 67)
            a = point(knots, x, [[y * v for y in z] + [v] for z, v in zip(pts, w)])
            b = point(fewer, x, q)
            off = [y / a[d] - z / b[d] for y, z in zip(a[:d], b[:d])]
            far = max(far, dot(off, off))
        rows.append(head + [numbers(w, raw), index,
                            points([[x / a[d] for x in a[:d]] for a in q], digits),
                            numbers([a[d] for a in q], digits), digits(root(far))])
    return rows


# Curves that cross themselves

def self_crossings(p, w):
    """All s < t with P(s) = P(t), by the resultant in t of both divided differences."""
    import sympy
    s, t = sympy.symbols('s t')
    h = homogeneous(p, w)
    q = lambda c: sympy.Rational(c.numerator, c.denominator)
    poly = lambda c, x: sum((q(a) * x ** k for k, a in enumerate(c)), sympy.Integer(0))
    both = []
    for axis in h[:2]:
        num = sympy.expand(poly(axis, s) * poly(h[2], t) - poly(axis, t) * poly(h[2], s))
        both.append(sympy.Poly(sympy.cancel(num / (s - t)), s, t))
    res = sympy.Poly(sympy.resultant(both[0], both[1], t), s)
    coefficients = [F(int(c.p), int(c.q)) for c in reversed(res.all_coeffs())]
    found = [r for r, _ in roots(trim(coefficients))]
    out = []
    at = lambda u: [value(h[k], u) / value(h[2], u) for k in range(2)]
    for i, a in enumerate(found):
        for b in found[i + 1:]:
            if all(abs(x - y) < F(1, 1 << 60) for x, y in zip(at(a), at(b))):
                out.append((a, b))
    return out


def loops(weighted):
    rows, cases = [], []
    for n in (3, 3, 4, 4, 4, 5, 5):
        for _ in range(2):
            cases.append(arb_points(n + 1, 2))
    cases.append([[F(0), F(0)], [F(10), F(8)], [F(-6), F(8)], [F(4), F(0)]])
    cases.append([[F(0), F(0)], [F(10), F(8)], [F(-6), F(8)], [F(0), F(0)]])       # closed
    cases.append([[F(0), F(0)], [F(1), F(8)], [F(3), F(8)], [F(4), F(0)]])         # none
    cases.append([[F(0), F(0)], [F(4) + F(1, 8), F(4)], [F(-2), F(4)], [F(2), F(0)]])
    cases.append([[F(0), F(0)], [F(30), F(20)], [F(-20), F(20)], [F(30), F(-20)], [F(-20), F(-20)],
                  [F(10), F(0)]])
    for p in cases:
        w = arb_weights(len(p)) if weighted else None
        found = self_crossings(p, w)
        rows.append([len(p) - 1, points(p, raw), weights(w), len(found), points(found, digits)])
    return rows


# The nearest point, and the box

def nearest():
    rows = []
    for n in range(1, 10):
        for k in range(4):
            d = 2 + k % 2
            p = arb_points(n + 1, d)
            x = arb_points(1, d, 20)[0]
            if k == 3:
                x = [grid(a) for a in casteljau(p, F(rnd.randint(0, 65536), 65536))]
            axes = [sub(power_of([a[k] for a in p]), [x[k]]) for k in range(d)]
            square = []
            for a in axes:
                square = add(square, mul(a, a))
            at = [F(0), F(1)] + [t for t, _ in roots(deriv(square))]
            best = min(at, key=lambda t: value(square, t))
            rows.append([n, d, points(p, raw), points([x], raw), digits(best),
                         digits(root(value(square, best)))])
    return rows


def boxes():
    rows = []
    for n in range(0, 10):
        for k in range(3):
            p = arb_points(n + 1, 3, (10, 10, 1)[k])
            low, high = [], []
            for axis in range(3):
                c = power_of([a[axis] for a in p])
                at = [F(0), F(1)] + ([t for t, _ in roots(deriv(c))] if len(c) > 1 else [])
                low.append(min(value(c, t) for t in at))
                high.append(max(value(c, t) for t in at))
            rows.append([n, points(p, raw), points([low, high], digits)])
    return rows


# Signs

def sign_of(b):
    """Not below 0 on 0..1, above 0 there, the number of different roots (-1: 0 everywhere)."""
    n, x = len(b) - 1, Symbol('x')
    p = Poly([b[n - k] * comb(n, k) for k in range(n + 1)], x, domain='ZZ')  # x = t / (1 - t)
    if p.is_zero:
        return 1, 0, -1
    low = min(k for (k,) in p.monoms())
    ends = int(low > 0) + int(p.degree() < n)
    p = Poly(p.all_coeffs()[:p.degree() - low + 1], x, domain='ZZ')     # its ends are not 0
    inside = [(len(f.intervals(inf=0)), k) for f, k in p.sqf_list()[1]]
    changes = any(count > 0 and k % 2 for count, k in inside)
    found = sum(count for count, _ in inside) + ends
    nonnegative = not changes and int(p.LC()) > 0
    return int(nonnegative), int(nonnegative and not found), found


def touching(n, i, p, q):
    """t^i (1 - t)^(n - 2 - i) (p t - q (1 - t))^2, whole coefficients."""
    b = [0] * (n + 1)
    b[i] = q * q * (n - i) * (n - i - 1)
    b[i + 1] = -2 * p * q * (i + 1) * (n - i - 1)
    b[i + 2] = p * p * (i + 1) * (i + 2)
    return b


def squared(r):
    """n (n - 1) (2 t - 1)^2 times the polynomial of degree n - 2, whole coefficients."""
    n, r = len(r) + 1, [0, 0] + r + [0, 0]
    return [(n - k) * (n - k - 1) * r[k + 2] - 2 * k * (n - k) * r[k + 1] + k * (k - 1) * r[k]
            for k in range(n + 1)]


def high_signs():
    nets, own = [], random.Random(1973)
    for n in (10, 11, 14, 17, 20, 25, 32):
        i = own.randint(0, n - 2)
        once = touching(n, i, own.randint(1, 90), own.randint(1, 90))
        for off in (-1, 0, 1):
            nets.append([x + (off if k == i + 1 else 0) for k, x in enumerate(once)])
        nets.append([own.randint(-40000, 40000) for _ in range(n + 1)])
        nets.append([own.randint(-1, 9) * 65536 for _ in range(n + 1)])
    for n, p, q in ((10, 9, 14), (12, 22, 21), (16, 117, 55), (20, 286, 323), (32, 17595, 17081)):
        for off in (-1, 0, 1):
            nets.append([q * q + off] + [0] * (n // 2 - 1) + [-1] + [0] * (n // 2 - 1) + [p * p])
    nets.append([0] * 33)
    for n in (33, 48, 64):
        nets.append([own.randint(-40000, 40000) for _ in range(n + 1)])
        nets.append(squared([own.randint(-200, 900) for _ in range(n - 1)]))
    for n in (64, 100, 128):
        i = own.randint(0, n - 2)
        for off in (-1, 0, 1):
            once = touching(n, i, 3, 4)
            nets.append([x + (off if k == i + 1 else 0) for k, x in enumerate(once)])
    for last in (-1, 0, 1):
        nets.append([65536] + [0] * 31 + [-1] + [0] * 31 + [last])
    nets.append([0] * 129)
    rows = []
    for b in nets:
        second = [x - 2 * y + z for x, y, z in zip(b, b[1:], b[2:])]
        rows.append([len(b) - 1, numbers(b, str), *sign_of(b), sign_of(second)[0]])
    return rows


if __name__ == '__main__':
    to = sys.argv[1]
    write(to, 'bezier_flat', 'plane Bezier curve of degree n with weights w or - : all t in [0 1] '
          'with P\' x P\'\' = 0 (numerator for weights) and their multiplicities; status straight '
          'when it is 0 everywhere', 'n,P_q16,w_q16,status,count,t,mult', inflections())
    write(to, 'curve_frame', 'Bezier curve in space of degree n with weights w or - : curvature  '
          'torsion  Frenet frame at t; status stops where P\' = 0  straight where P\' x P\'\' = 0',
          'n,P_q16,w_q16,t_q16,status,kappa,tau,T,N,B', frames())
    write(to, 'bspline_thin', 'B-spline of degree p with n points and full knots U: points Q '
          'without the knot of this index  from both ends; far = largest distance of P from the '
          'points that Q has with the knot inserted again', 'p,n,d,U_q16,P_q16,knot,Q,far',
          removals(False))
    write(to, 'curve_loops', 'plane Bezier curve of degree n with weights w or - : all s < t in '
          '[0 1] with P(s) = P(t)  as s t pairs sorted by s', 'n,P_q16,w_q16,count,st',
          loops(False))
    write(to, 'curve_closest', 'Bezier curve of degree n: parameter and distance of its point '
          'nearest to X', 'n,d,P_q16,X_q16,t,dist', nearest())
    write(to, 'curve_box', 'Bezier curve of degree n in space: the lower and the upper corner of '
          'its smallest box', 'n,P_q16,box', boxes())
    write(to, 'nurbs_thin', 'as bspline_thin with weights w: in weighted coordinates; dist = '
          'largest of 31 distances of both curves', 'p,n,d,U_q16,P_q16,w_q16,knot,Q,wQ,dist',
          removals(True))
    write(to, 'nurbs_frame', 'NURBS curve in space of degree p with n points  full knots U: '
          'curvature  torsion  Frenet frame at u; at a knot of the piece behind it',
          'p,n,U_q16,P_q16,w_q16,u_q16,status,kappa,tau,T,N,B', nurbs_frames())
    write(to, 'rational_loops', 'as curve_loops with weights', 'n,P_q16,w_q16,count,st',
          loops(True))
    write(to, 'positivity_high', 'Bernstein coefficients b_0..b_n  degree 10..128: nonneg on '
          '[0 1]  positive on [0 1]  roots = number of distinct roots in [0 1] (-1: identically '
          'zero)  '
          'convex on [0 1]; exact', 'n,b_q16,nonneg,positive,roots,convex', high_signs())
