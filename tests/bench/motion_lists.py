#!/usr/bin/env python3
# tests/bench/motion_lists.py -- writes shapes as lists of moves, each cut in many ways
# SPDX-License-Identifier: MIT
# usage: tests/bench/motion_lists.py FOLDER      (reads tests/drawings/outline12.csv)
#
# A line of a list is a cubic: x y z of four control points, and a feed. Coordinates are multiples
# of 2^-16 mm.
import math, random, sys


def lerp(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def cut(p, t):
    """Both parts of a cubic."""
    a, b, c = lerp(p[0], p[1], t), lerp(p[1], p[2], t), lerp(p[2], p[3], t)
    d, e = lerp(a, b, t), lerp(b, c, t)
    m = lerp(d, e, t)
    return (p[0], a, d, m), (m, e, c, p[3])


def cuts(p, places):
    out, before = [], 0
    for t in places:
        head, p = cut(p, (t - before) / (1 - before))
        out.append(head)
        before = t
    return out + [p]


def even(n):
    return [k / n for k in range(1, n)]


def chance(n, r):
    return sorted(r.uniform(0.001, 0.999) for _ in range(n - 1))


def line(a, b):
    return a, lerp(a, b, 1 / 3), lerp(a, b, 2 / 3), b


def at(p, t):
    return cut(p, t)[0][3]


def chords(path, size):
    """Lines of `size` mm along the curves."""
    points = [path[0][0]]
    for p in path:
        looks = [at(p, k / 4096) for k in range(4097)]
        gone = 0
        for a, b in zip(looks, looks[1:]):
            gone += math.dist(a, b)
            if gone >= size:
                points.append(b)
                gone = 0
        points.append(p[3])
    return [line(a, b) for a, b in zip(points, points[1:]) if a != b]


def star():
    points = [(r * math.cos(k * math.pi / 5), r * math.sin(k * math.pi / 5))
              for k, r in enumerate([20, 8] * 5)]
    points.append(points[0])
    return [line(a, b) for a, b in zip(points, points[1:])]


def grain(x):
    return round(x * 65536) / 65536


def write(folder, name, path):
    end = None
    with open('%s/%s.moves' % (folder, name), 'w') as f:
        for p in path:
            p = [tuple(grain(x) for x in q) for q in p]
            if end is not None:
                p[0] = end
            end = p[3]
            print(*('%.16g %.16g %.16g' % (q + (0,))[:3] for q in p), 1, file=f)


def main():
    folder, r = sys.argv[1], random.Random(1)
    outline = []
    for row in open('tests/drawings/outline12.csv'):
        if not row.startswith('#'):
            x = [float(v) for v in row.split(',')]
            outline.append(tuple((x[k], x[k + 1]) for k in range(0, 8, 2)))
    for name, path in (('outline', outline), ('star', star())):
        for n in (1, 2, 4, 8, 16, 32):
            write(folder, '%s-cut-%d' % (name, n), [q for p in path for q in cuts(p, even(n))])
            if n > 1:
                write(folder, '%s-chance-%d' % (name, n),
                      [q for p in path for q in cuts(p, chance(n, r))])
    write(folder, 'outline-chords', chords(outline, 0.01))
    for length in (0.2, 0.5, 1, 2, 5, 10, 20, 60):
        write(folder, 'line-%g' % length, [line((0, 0), (length, 0))])


if __name__ == '__main__':
    main()
