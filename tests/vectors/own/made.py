# tests/vectors/own/made.py -- rows of what is made of curves and surfaces, from the definitions:
# swept sections, offsets, pieces, arcs, foci, sections by planes
# SPDX-License-Identifier: MIT
"""usage: python3 tests/vectors/own/made.py FOLDER   writes the CSV files, the same each time"""
import random
import sys

import mpmath

from curves import basis, insertion
from exact import (F, add, bernstein_of, casteljau, cross, deriv, digits, dot, grid, mul, numbers,
                   points, power_of, raw, root, roots, scale, sub, value, write)
from sheets import Level, Sheet
from surfaces import arb_graph, arb_sheet, cylinder, sheet_columns, sphere, torus

rnd = random.Random(1975)
mpmath.mp.dps = 50
BITS = 150


def arb(size=10):
    return F(rnd.randint(-size * 65536, size * 65536), 65536)


def arb_points(count, d, size=10):
    return [[arb(size) for _ in range(d)] for _ in range(count)]


def arb_weights(count):
    return [F(rnd.choice([1, 2, 3, 5]), 2) + F(rnd.randint(0, 9999), 65536) for _ in range(count)]


def cut(x):
    """Fewer bits, so that fractions stay small."""
    return F((F(x) * (1 << BITS)).__floor__(), 1 << BITS)


def real(x):
    """A Fraction as an mpf, and back."""
    if isinstance(x, F):
        return mpmath.mpf(x.numerator) / x.denominator
    return F(int(mpmath.floor(mpmath.ldexp(x, BITS))), 1 << BITS)


def of_bezier(p):
    return [power_of([x[k] for x in p]) for k in range(len(p[0]))]


# Swept sections

def reflect(x, normal):
    return [cut(a - 2 * dot(x, normal) / dot(normal, normal) * b) for a, b in zip(x, normal)]


def unit(x):
    length = root(dot(x, x))
    return [cut(a / length) for a in x]


def sweeps():
    rows = []
    for k in range(30):
        pieces, degree = rnd.randint(1, 3), rnd.randint(1, 5)
        # whole points and parameters of eighths: places and derivatives are on the grid of 2^-16
        stations, n = rnd.choice([2, 3, 5, 9]), rnd.randint(0, 3)
        whole = lambda size: F(rnd.randint(-size, size))
        path, at = [], [whole(9), whole(9), whole(9)]
        for _ in range(pieces):
            # steps that lean forward: no cusp, and no place where the path turns back
            piece = [at]
            for _ in range(degree):
                at = [a + s for a, s in zip(at, [F(3) + whole(2), whole(3), whole(3)])]
                piece.append(at)
            path.append(piece)
        up, section = [arb(1), arb(1), F(4)], arb_points(n + 1, 3, 4)
        places = []
        for i in range(stations):
            t = F(i * pieces, stations - 1)
            j = min(t.__floor__(), pieces - 1)
            f = of_bezier(path[j])
            places.append(([value(x, t - j) for x in f], [value(deriv(x), t - j) for x in f]))
        along = unit(places[0][1])
        across = unit([a - dot(up, along) * b for a, b in zip(up, along)])
        out = []
        for i, (p, d) in enumerate(places):
            if i:
                step, goal = [a - b for a, b in zip(p, places[i - 1][0])], unit(d)
                along, across = reflect(along, step), reflect(across, step)
                turn = [a - b for a, b in zip(goal, along)]
                across = unit(reflect(across, turn) if any(turn) else across)
                along = goal
            third = cross(along, across)
            out += [[p[a] + s[0] * across[a] + s[1] * third[a] + s[2] * along[a] for a in range(3)]
                    for s in section]
        rows.append([pieces, degree, points([x for b in path for x in b], raw), stations,
                     numbers(up, raw), n, points(section, raw), points(out, digits)])
    return rows


# Offsets of curves

def offsets():
    rows = []
    cases = [(arb_points(4, 2), F(k % 5 - 2) or F(3, 2)) for k in range(16)]
    arch = [[F(0), F(0)], [F(0), F(8)], [F(8), F(8)], [F(8), F(0)]]
    cases += [(arch, F(-6)), (arch, F(6)), (arch, F(1)), (arch, F(-3))]
    for p, d in cases:
        x, y = of_bezier(p)
        dx, dy = deriv(x), deriv(y)
        bend = sub(mul(dx, deriv(dy)), mul(dy, deriv(dx)))
        square = add(mul(dx, dx), mul(dy, dy))
        found = roots(sub(scale(mul(bend, bend), d * d), mul(square, mul(square, square))))
        cusps = [t for t, _ in found if d * value(bend, t) > 0]
        at, places, behind = [], [], []
        for k in range(65):
            t = F(k, 64)
            speed = root(value(square, t))
            if speed < F(1, 16):
                continue
            at.append(t)
            places.append([value(x, t) - d * value(dy, t) / speed,
                           value(y, t) + d * value(dx, t) / speed])
            runs = 1 - d * value(bend, t) / speed ** 3
            far = all(abs(t - c) > F(1, 32) for c in cusps) and abs(runs) * speed > 4
            behind.append(str(int(runs < 0)) if far else '-')
        rows.append([points(p, raw), raw(d), raw(F(1, 256)), numbers(at, raw),
                     points(places, digits), ' '.join(behind)])
    return rows


# Knots inserted

def inserts():
    rows = []
    for k in range(60):
        p, d, weighted = rnd.randint(1, 9), rnd.randint(2, 3), k % 2
        inner = sorted(F(rnd.randint(1, 4 * 65536 - 1), 65536) if rnd.random() < .7 else F(2)
                       for _ in range(rnd.randint(0, 5)))
        knots = [F(0)] * (p + 1) + inner + [F(4)] * (p + 1)
        u = rnd.choice(inner) if inner and k % 5 == 0 else F(rnd.randint(1, 4 * 65536 - 1), 65536)
        if knots.count(u) >= p or any(knots.count(x) > p for x in inner):
            continue
        count = len(knots) - p - 1
        pts = arb_points(count, d)
        w = arb_weights(count) if weighted else [F(1)] * count
        m = insertion(knots, p, u, count)
        new_w = [sum(a * b for a, b in zip(row, w)) for row in m]
        new = [[sum(a * b * q[i] for a, b, q in zip(row, w, pts)) / v for i in range(d)]
               for row, v in zip(m, new_w)]
        rows.append([p, count, d, numbers(knots, raw), points(pts, raw),
                     numbers(w, raw) if weighted else '-', raw(u), points(new, digits),
                     numbers(new_w, digits)])
    return rows


# Patches with weights

def arb_patch(k):
    if k % 3 == 0:
        return [sphere(5, 0), torus(6, 2, 0), cylinder(4, 0, 9, 0)][k // 3 % 3]
    m, n = rnd.randint(0, 5), rnd.randint(0, 5)
    return Sheet('tensor', m, n, arb_points((m + 1) * (n + 1), 3), arb_weights((m + 1) * (n + 1)))


def patch_slopes():
    rows = []
    some = lambda: rnd.choice([F(0), F(1), F(rnd.randint(0, 65536), 65536)])
    for k in range(45):
        s, u, v = arb_patch(k), some(), some()
        slope = []
        for fixed, t in ((1, u), (0, v)):
            h = s.line(fixed, v if fixed == 1 else u)
            w = value(h[3], t)
            slope.append([(value(deriv(x), t) - value(x, t) / w * value(deriv(h[3]), t)) / w
                          for x in h[:3]])
        rows.append([s.m, s.n, points(s.net, raw), numbers(s.w, raw), raw(u), raw(v)] +
                    [points([x], digits) for x in slope])
    return rows


def lines_of(s, along):
    """The weighted points of each line along u or v."""
    n = s.n + 1
    if along == 'u':
        return [[s.high[i * n + j] for i in range(s.m + 1)] for j in range(n)]
    return [s.high[i * n:(i + 1) * n] for i in range(s.m + 1)]


def net_of(lines, along):
    order = list(zip(*lines)) if along == 'u' else lines
    flat = [p for line in order for p in line]
    return [points([[x / p[3] for x in p[:3]] for p in flat], digits),
            numbers([p[3] for p in flat], digits)]


def patch_splits():
    rows = []
    for k in range(40):
        s, along = arb_patch(k), 'uv'[k % 2]
        t = F(rnd.randint(0, 65536), 65536) if k % 4 else F(1, 2)
        left, right = [], []
        for line in lines_of(s, along):
            n = len(line) - 1
            left.append([casteljau(line[:i + 1], t) for i in range(n + 1)])
            right.append([casteljau(line[i:], t) for i in range(n + 1)])
        rows.append([s.m, s.n, points(s.net, raw), numbers(s.w, raw), along, raw(t)] +
                    net_of(left, along) + net_of(right, along))
    return rows


def patch_raises():
    rows = []
    for k in range(40):
        s, along, times = arb_patch(k), 'uv'[k % 2], rnd.randint(0, 4)
        out = []
        for line in lines_of(s, along):
            axes = [bernstein_of(power_of([p[a] for p in line]), len(line) - 1 + times)
                    for a in range(4)]
            out.append(list(zip(*axes)))
        rows.append([s.m, s.n, points(s.net, raw), numbers(s.w, raw), along, times] +
                    net_of(out, along))
    return rows


# Arcs

def turned(x, y, a):
    return x * mpmath.cos(a) - y * mpmath.sin(a), x * mpmath.sin(a) + y * mpmath.cos(a)


def sweep_of(start, end, turns):
    """The angle from start to end the way of `turns`, and whole turns more."""
    a = mpmath.atan2(end[1], end[0]) - mpmath.atan2(start[1], start[0])
    full, sign = 2 * mpmath.pi, 1 if turns > 0 else -1
    a = (sign * a) % full
    if a < mpmath.mpf(10) ** -30 or full - a < mpmath.mpf(10) ** -30:
        a = full
    return sign * (a + (abs(turns) - 1) * full)


def arcs():
    rows = []
    some = lambda k: [F(0), F(1), F(1, 2), F(rnd.randint(0, 65536), 65536)][k % 4]
    for k in range(48):
        start, centre, t = [real(arb()) for _ in range(3)], [real(arb()) for _ in range(2)], some(k)
        turns = rnd.choice([1, -1, 1, -1, 2, -3])
        arm = [start[i] - centre[i] for i in (0, 1)]
        end = turned(*arm, 2 * mpmath.pi * rnd.random())
        if k % 8 == 7:
            end = arm
        end = [real(grid(real(x))) for x in (centre[0] + end[0], centre[1] + end[1])] + \
            [real(arb())]
        end_arm = [end[i] - centre[i] for i in (0, 1)]
        if mpmath.hypot(*arm) < 2:
            continue
        full = sweep_of(arm, end_arm, turns)
        here, last = turned(*arm, full * real(t)), turned(*arm, full)
        at = [centre[i] + here[i] + (end_arm[i] - last[i]) * real(t) for i in (0, 1)]
        at.append(start[2] + (end[2] - start[2]) * real(t))
        rows.append(['centre', numbers([real(x) for x in start], raw),
                     numbers([real(x) for x in end], raw), numbers([real(x) for x in centre], raw),
                     '0', '0', turns, raw(t), points([[real(x) for x in at]], digits)])
    for k in range(48):
        start, end, t = arb_points(1, 3)[0], arb_points(1, 3)[0], some(k)
        radii = [F(11) + abs(arb()), F(11) + abs(arb())]
        angle = F(rnd.randint(-180, 180)) if k % 3 else F(0)
        large, turns = rnd.randint(0, 1), rnd.choice([1, -1])
        if k % 6 == 0:
            radii = [F(1), F(2)]                        # too small: enlarged
        if k % 4 == 1:
            radii[1] = radii[0]
        # SVG 1.1, F.6.5
        turn = real(angle) * mpmath.pi / 180
        half = turned(*[(real(a) - real(b)) / 2 for a, b in zip(start[:2], end[:2])], -turn)
        rx, ry = real(radii[0]), real(radii[1])
        fit = (half[0] / rx) ** 2 + (half[1] / ry) ** 2
        if fit > 1:
            rx, ry = rx * mpmath.sqrt(fit), ry * mpmath.sqrt(fit)
            fit = mpmath.mpf(1)
        root_ = mpmath.sqrt((1 - fit) / fit) * (1 if bool(large) != (turns > 0) else -1)
        middle = (root_ * rx * half[1] / ry, -root_ * ry * half[0] / rx)
        a, b = [((sign * half[0] - middle[0]) / rx, (sign * half[1] - middle[1]) / ry)
                for sign in (1, -1)]
        here = turned(*a, sweep_of(a, b, turns) * real(t))
        place = turned(rx * here[0] + middle[0], ry * here[1] + middle[1], turn)
        at = [real(start[i] + end[i]) / 2 + place[i] for i in (0, 1)]
        at.append(real(start[2]) + real(end[2] - start[2]) * real(t))
        rows.append(['ellipse', numbers(start, raw), numbers(end, raw), numbers(radii, raw),
                     raw(angle), large, turns, raw(t), points([[real(x) for x in at]], digits)])
    return rows


# Foci

def product3(p, q):
    return [[(p[i] * q[j] + p[j] * q[i]) / 2 for j in range(3)] for i in range(3)]


def line_through(p, q):
    return [p[1] - q[1], q[0] - p[0], p[0] * q[1] - p[1] * q[0]]


def foci_of(p, w):
    """The matrix of the conic; its foci are z = centre +- sqrt(f (a - c + 2 i b) / det)."""
    sides = [line_through(p[1], p[2]), line_through(p[2], p[0]), line_through(p[0], p[1])]
    middle, ends = product3(sides[1], sides[1]), product3(sides[0], sides[2])
    q = [[w[0] * w[2] * x - 4 * w[1] * w[1] * y for x, y in zip(r, s)]
         for r, s in zip(middle, ends)]
    det = q[0][0] * q[1][1] - q[0][1] ** 2
    if det == 0:
        a, b = [mpmath.mpc(real(x[0] - p[1][0]), real(x[1] - p[1][1])) for x in (p[0], p[2])]
        z = a * b / (a + b)
        return 'parabola', [[p[1][0] + real(z.real), p[1][1] + real(z.imag)]]
    centre = [(q[0][1] * q[1][2] - q[1][1] * q[0][2]) / det,
              (q[0][1] * q[0][2] - q[0][0] * q[1][2]) / det]
    f = q[0][2] * centre[0] + q[1][2] * centre[1] + q[2][2]
    z = mpmath.sqrt(mpmath.mpc(real(f * (q[0][0] - q[1][1]) / det), real(2 * f * q[0][1] / det)))
    return 'ellipse' if det > 0 else 'hyperbola', \
        [[centre[0] + s * real(z.real), centre[1] + s * real(z.imag)] for s in (1, -1)]


def foci():
    rows = []
    for k in range(60):
        p = arb_points(3, 2)
        w = [F(1), rnd.choice([F(1, 2), F(3, 2), F(-1, 2), F(-2), F(1), F(-1), arb(2)]), F(1)]
        if k % 3 == 0:
            w[2] = F(rnd.randint(1, 5))
        if k == 0:
            p, w = [[F(5), F(0)], [F(5), F(5)], [F(0), F(5)]], [F(1), F(1), F(2)]      # a circle
        if abs(w[0] * w[2] - w[1] ** 2) < F(1, 64) and w[0] * w[2] != w[1] ** 2:
            continue
        kind, at = foci_of(p, w)
        if all(abs(x) < 8000 for z in at for x in z):
            rows.append([points(p, raw), numbers(w, raw), kind, points(at, digits)])
    return rows


# Sections by planes

def sections():
    rows = []
    directions = [(1, 2, 2, 3), (2, 3, 6, 7), (4, 4, 7, 9), (-1, 4, 8, 9), (2, -6, 9, 11),
                  (0, 0, 1, 1), (6, -2, 3, 7)]
    cases = [arb_sheet(2, 2), arb_sheet(3, 3), arb_graph(2, 3), sphere(5, 0), torus(6, 2, 0),
             arb_sheet(3, 2), cylinder(4, 0, 9, 0), arb_graph(3, 3)]
    for k in range(24):
        s, (x, y, z, length) = cases[k % 8], directions[k % 7]
        d = [F(x), F(y), F(z)]
        middle = s.point(F(rnd.randint(20, 44), 64), F(rnd.randint(20, 44), 64))
        far = grid(dot(middle, d) / length)
        for size in (16, 32, 64):
            level = Level(size)
            for i in range(size + 1):
                h = s.line(0, F(i, size))
                f = sub(add(add(scale(h[0], d[0]), scale(h[1], d[1])), scale(h[2], d[2])),
                        scale(h[3], far * length))
                if not f:
                    continue
                level.add([t for t, _ in roots(f)],
                          lambda t: abs(value(deriv(f), t) / value(h[3], t)) / length,
                          lambda t: (F(i, size), t))
            if level.good():
                rows.append(sheet_columns(s) + [numbers(d, raw), raw(far)] + level.columns())
                break
    return rows


# Lengths

def lengths():
    rows = []
    for k in range(30):
        p = arb_points(4, 3)
        if k == 0:
            p = [[F(i * i), F(0), F(-2 * i * i)] for i in range(4)]                 # straight
        slope = [[real(c) for c in reversed(deriv(x))] for x in of_bezier(p)]
        speed = lambda t: mpmath.sqrt(sum(mpmath.polyval(x, t) ** 2 for x in slope))
        pieces = [mpmath.mpf(i) / 16 for i in range(17)]
        rows.append([points(p, raw), digits(real(mpmath.quad(speed, pieces)))])
    return rows


if __name__ == '__main__':
    to = sys.argv[1]
    write(to, 'sweep_sections', 'control points of a section (degree n  x across  y at a right '
          'angle  z along) at equal steps of the parameter of a path of Bezier curves (degree m): '
          'frame of double reflection (Wang et al 2008); across = up without its part along the '
          'path', 'pieces,m,path_q16,stations,up_q16,n,section_q16,Q', sweeps())
    write(to, 'curve_offset', 'plane cubic: points P + distance N at t  N to the left of travel; '
          'behind: 1 where the offset runs backwards  - near cusps',
          'P_q16,distance_q16,tol_q16,t_q16,at,behind', offsets())
    write(to, 'knot_insert', 'B-spline of degree p with n points  full knots U  weights w or - : '
          'points and weights with the knot u once more', 'p,n,d,U_q16,P_q16,w_q16,u_q16,Q,wQ',
          inserts())
    net = 'm,n,net_q16,w_q16,'
    write(to, 'patch_slopes', 'rational tensor patch: Pu and Pv at u v', net + 'u_q16,v_q16,Pu,Pv',
          patch_slopes())
    write(to, 'patch_split', 'rational tensor patch split at t along u or v: nets and weights of '
          'both pieces', net + 'along,t_q16,L,wL,R,wR', patch_splits())
    write(to, 'patch_raise', 'rational tensor patch with its degree along u or v higher by times: '
          'net and weights', net + 'along,times,Q,wQ', patch_raises())
    write(to, 'arc_place', 'arc in the first two axes  the third in proportion to the angle; '
          'centre: given by it (arms of different lengths: the difference in proportion too); '
          'ellipse: as SVG 1.1 F.6  data = radii: the place at the fraction t',
          'kind,from_q16,to_q16,data_q16,degrees_q16,large,turns,t_q16,at', arcs())
    write(to, 'conic_foci', 'foci of the conic with these control points and weights  in any order',
          'P_q16,w_q16,kind,foci', foci())
    write(to, 'surface_section', 'all u v on the lines u = k/size at this distance along D; slope '
          '= the least change of the distance with v there',
          'kindA,mA,nA,netA_q16,wA_q16,D_q16,distance_q16,size,count,slope,uv', sections())
    write(to, 'cubic_length', 'length of a cubic in space', 'P_q16,length', lengths())
