#!/usr/bin/env python3
# tests/bench/motion_chords.py -- shapes as smooth cubics, and as the chords that CAM programs write
# SPDX-License-Identifier: MIT
# usage: tests/bench/motion_chords.py lists FOLDER
#        tests/bench/motion_chords.py judge FILE.svg PLANS..
#
# `lists` writes SHAPE-cubics.moves and SHAPE-SAG-HOW-DECIMALS.moves: chords whose sag is at most
# SAG parts of a tolerance of 0.005 mm, of even or random lengths (HOW), with coordinates rounded to
# 3 or 4 decimals of a mm, or 4 of an inch. Lines are as those of motion_lists.py.
# `judge` prints the worst ratios of plans of these lists, for each machine, and draws the time over
# that of the cubics: against the sag, and against the feed, a panel for each shape.
import math, random, sys

from motion_lists import line, write

TOL = 0.005
SAGS = (0.02, 0.1, 0.3, 0.5, 0.7, 0.95)


def shapes():
    """Name: a curve c(t), smooth for t from 0 to its end, and that end; some are in space."""
    turn = 2 * math.pi
    spiral = lambda t: (2 + 0.5 * t)
    return {
        'circle1': (lambda t: (math.cos(t), math.sin(t), 0), turn),
        'circle4': (lambda t: (4 * math.cos(t), 4 * math.sin(t), 0), turn),
        'circle15': (lambda t: (15 * math.cos(t), 15 * math.sin(t), 0), turn),
        'ellipse': (lambda t: (8 * math.cos(t), 4 * math.sin(t), 0), turn),
        'spiral': (lambda t: (spiral(t) * math.cos(t), spiral(t) * math.sin(t), 0), 3 * turn),
        'trochoid': (lambda t: (0.25 * t + 1.5 * math.cos(t), 1.5 * math.sin(t), 0), 5 * turn),
        'clothoid': (clothoid, 5),
        'helix': (lambda t: (6 * math.cos(t), 6 * math.sin(t), 0.3 * t), 2 * turn),
        'bean': (lambda t: ((6 + 2 * math.cos(2 * t)) * math.cos(t),
                            (6 + math.sin(3 * t)) * math.sin(t), math.sin(t)), turn),
    }


def clothoid(t, steps=64):
    """Curvature grows with the length; Simpson's rule on an even grid that ends at t."""
    n = 2 * steps
    w = [1 if k in (0, n) else 4 if k % 2 else 2 for k in range(n + 1)]
    h = t / n
    f = [math.pi * (k * h) ** 2 / 20 for k in range(n + 1)]
    return (4 * h / 3 * sum(a * math.cos(b) for a, b in zip(w, f)),
            4 * h / 3 * sum(a * math.sin(b) for a, b in zip(w, f)), 0)


def slope(c, t):
    d = 1e-4
    return tuple((8 * (p - m) - (q - n)) / (12 * d) for p, m, q, n in
                 zip(c(t + d), c(t - d), c(t + 2 * d), c(t - 2 * d)))


def cubics(c, end, pieces):
    """Hermite cubics at even parameters."""
    out = []
    for k in range(pieces):
        a, b = end * k / pieces, end * (k + 1) / pieces
        p, q, u, v = c(a), c(b), slope(c, a), slope(c, b)
        s = (b - a) / 3
        out.append((p, tuple(x + s * d for x, d in zip(p, u)),
                    tuple(x - s * d for x, d in zip(q, v)), q))
    return out


def sag(c, a, b):
    """The distance of the curve from the chord, near its middle."""
    p, q, m = c(a), c(b), c((a + b) / 2)
    chord = [y - x for x, y in zip(p, q)]
    length = math.hypot(*chord)
    off = [y - x for x, y in zip(p, m)]
    along = sum(x * y for x, y in zip(off, chord)) / length
    return math.dist(off, [along / length * x for x in chord])


def chord_ends(c, end, most, r):
    """Parameters of points whose chords have a sag of at most `most`; r draws parts of it."""
    ts = [0.0]
    step = end / 100
    while ts[-1] < end:
        want = most * (r.uniform(0.2, 1) if r else 1)
        a = ts[-1]
        for _ in range(8):          # the sag grows with the square of the step
            step *= math.sqrt(want / max(sag(c, a, a + step), want / 64))
        ts.append(min(a + step, end))
    if r is None:                   # even: as many, spread so that the last one is not short
        n = len(ts) - 1
        part = (n - 1 + (end - ts[-2]) / step) / n
        ts = [0.0]
        for k in range(n - 1):
            a, b = ts[-1], step
            for _ in range(8):
                b *= math.sqrt(most * part ** 2 / max(sag(c, a, a + b), most / 64))
            ts.append(min(a + b, end * (1 - 1e-9)))
        ts.append(end)
    return ts


def rounded(p, decimals):
    if decimals == 'inch':
        return tuple(round(x / 25.4, 4) * 25.4 for x in p)
    return tuple(round(x, int(decimals)) for x in p)


def lists(folder):
    for name, (c, end) in shapes().items():
        write(folder, name + '-cubics', cubics(c, end, 192))
        for at in SAGS:
            for how, decimals in (('even', '4'), ('even', '3'), ('even', 'inch'), ('random', '3')):
                r = random.Random(name + how) if how == 'random' else None
                points = [rounded(c(t), decimals) for t in chord_ends(c, end, at * TOL, r)]
                path = [line(a, b) for a, b in zip(points, points[1:]) if a != b]
                write(folder, '%s-%g-%s-%s' % (name, at, how, decimals), path)


def judge(out, files):
    """Rows of bench_motion_lists.c with their feeds at the end, of machine M in FILE-M.out."""
    rows = []
    for name in files:
        machine, took, feeds = name[-5], {}, set()
        plans = []
        for row in open(name):
            word = row.split()
            bad = len(word) != 9        # there is no plan
            plan = (word[0], float(word[-1]), math.inf if bad else float(word[1]),
                    math.inf if bad else float(word[5]))
            plans.append(plan)
            took[plan[:2]] = plan[2]
            feeds.add(plan[1])
        mine = []
        for name, feed, time, off in plans:
            shape, *how = name.split('-')
            if len(how) == 3:
                mine.append((time / took[shape + '-cubics', feed], '%s@%g' % (name, feed),
                             shape, float(how[0]), feed, ' '.join(how[1:])))
        feeds = sorted(feeds)
        grows = [(took[name, b] / took[name, a], '%s@%g' % (name, b))
                 for name, _ in took for a, b in zip(feeds, feeds[1:])]
        for key, found in (('fine', [r for r in mine if r[3] <= 0.5]),
                           ('coarse', [r for r in mine if r[3] > 0.5]),
                           ('off', [(p[3], '%s@%g' % p[:2]) for p in plans]), ('feed', grows)):
            worst = max(found, default=(0, 'none'))
            print(key, machine, '%.4f' % worst[0], worst[1])
        print('above', machine, sum(r[0] > (1.02 if r[3] <= 0.5 else 1.05) for r in mine), 'of',
              len(mine), 'chains of chords are above, mean %.4f'
              % (sum(r[0] for r in mine) / len(mine)))
        rows += mine
    draw(rows, out)


def draw(rows, out):
    """Time over that of the cubics, the worst of all machines, a panel for each shape."""
    wide, high, top = 300, 170, 40
    colours = dict(zip(dict.fromkeys(row[5] for row in rows),
                       ('#1f77b4', '#ff7f0e', '#2ca02c', '#d62728')))
    svg = []

    def text(x, y, what, size=10, colour='black'):
        svg.append('<text x="%g" y="%g" font-size="%g" font-family="sans-serif" fill="%s">%s</text>'
                   % (x, y, size, colour, what))

    for k, (how, colour) in enumerate(colours.items()):
        text(40 + 90 * k, 30, how, colour=colour)
    for column, (key, title) in enumerate(((3, 'sag / tol'), (4, 'feed, mm/s'))):
        x0 = 40 + column * wide
        text(x0, 16, 'worst time over that of the cubics, by ' + title)
        values = sorted({row[key] for row in rows})
        x = lambda i: x0 + (wide - 70) * i / max(1, len(values) - 1)
        for k, name in enumerate(dict.fromkeys(row[2] for row in rows)):
            panel = [row for row in rows if row[2] == name]
            y0, peak = top + k * high, max(1.1, max(row[0] for row in panel))
            y = lambda r: y0 + (high - 50) * (1 - (r - 0.9) / (peak - 0.9))
            text(x0, y0 - 4, '%s, up to %.3f' % (name, max(row[0] for row in panel)))
            for bound, colour in ((1, '#999'), (1.02, '#c00')):
                svg.append('<path d="M%g,%gh%g" stroke="%s" stroke-width="0.5"/>'
                           % (x0, y(bound), wide - 70, colour))
            for i, value in enumerate(values):
                text(x(i) - 6, y0 + high - 36, '%g' % value, 9)
            for how, colour in colours.items():
                points = ['%g,%g' % (x(i), y(max(row[0] for row in panel
                                                  if row[key] == value and row[5] == how)))
                          for i, value in enumerate(values)]
                svg.append('<polyline points="%s" fill="none" stroke="%s"/>'
                           % (' '.join(points), colour))
    with open(out, 'w') as f:
        f.write('<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d">'
                '<rect width="100%%" height="100%%" fill="white"/>%s</svg>\n'
                % (2 * wide + 40, top + high * len({row[2] for row in rows}), ''.join(svg)))


if __name__ == '__main__':
    if sys.argv[1] == 'lists':
        lists(sys.argv[2])
    else:
        judge(sys.argv[2], sys.argv[3:])
