#!/usr/bin/env python3
"""tests/e2e/raster.py -- rows of pixels for a laser, and where a machine has changed its level

usage: raster.py make MODE ROWS WIDTH SEED [SLOPE]   prints G-code; MODE: M3 or M4
       raster.py check RECORD GCODE                  prints `name value` lines about a record

Rows go to and fro, each with pixels of WIDTH/2 .. WIDTH*3/2 mm and S of 0..1000; between them the
laser is off. SLOPE: a row rises by so much per mm. Output 1 of the record is compared with the
G-code:

    levels    so many changes of the level in the record
    energy    mm: the energy from the start of a row to any pulse is at most that of so many mm at
              full power away from what the G-code asks; with M3, where it is asked for each second,
              level times way
    stops     longer than 20 ms between two pulses of a row
    standing  the level 60 ms after a pulse, if none follows for 100 ms

SPDX-License-Identifier: MIT
"""
import bisect
import math
import os
import random
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "target"))
from energy import read                    # noqa: E402  (pulses, levels, steps per mm)

ROW = 0.25


def make(mode, rows, width, seed, slope):
    chance = random.Random(seed)
    print("G21 G90\n%s S0 F3600" % mode)
    for n in range(rows):
        way = 1 if n % 2 == 0 else -1
        x, end = (2.0, 22.0) if way > 0 else (22.0, 2.0)
        print("G0 X%.3f Y%.3f" % (x, 2 + ROW * n + slope * x))
        while (end - x) * way > 1e-9:
            to = way * x + width * (0.5 + chance.random())
            x = end if way * end - to < width / 2 else way * to
            level = 0 if chance.random() < 0.2 else chance.randrange(1, 1001)
            print("G1 X%.3f Y%.3f S%d" % (x, 2 + ROW * n + slope * x, level))
    print("M5")


def rows_of(name):
    """Of each row: its start and end, its pixels as (mm along it, S/1000), the feed in mm/s."""
    rows, feed = [], 1.0
    for line in open(name, encoding="ascii"):
        word = {w[0]: float(w[1:]) for w in line.split()}
        feed = word.get("F", 60 * feed) / 60
        if "X" not in word:
            continue
        to = (word["X"], word["Y"])
        if word["G"] == 0:
            rows.append((to, []))
        else:
            rows[-1][1].append((math.dist(rows[-1][0], to), word["S"] / 1000, to))
    return [(start, pixels[-1][2], [(a, s) for a, s, _ in pixels], feed) for start, pixels in rows]


class Row:
    """The pulses of a row, as mm along it over time."""

    def __init__(self, start, end, pulses):
        length = math.dist(start, end)
        unit = [(b - a) / length for a, b in zip(start, end)]
        self.times, self.along = [], []
        for t, at in pulses:
            by = [a - b for a, b in zip(at, start)]
            along = by[0] * unit[0] + by[1] * unit[1]
            if math.hypot(by[0] - along * unit[0], by[1] - along * unit[1]) < 0.02:
                self.times.append(t)
                self.along.append(along)
        first = max(k for k, a in enumerate(self.along) if a <= 0.02 and k < len(self.along) / 2)
        self.times, self.along, self.length = self.times[first:], self.along[first:], length

    def at(self, t):
        k = bisect.bisect_right(self.times, t)
        if k == 0 or k == len(self.times):
            return self.along[min(k, len(self.times) - 1)]
        a, b = self.times[k - 1], self.times[k]
        return self.along[k - 1] + (self.along[k] - self.along[k - 1]) * (t - a) / (b - a)


def energy_off(row, changes, pixels, feed):
    """The largest difference, in mm at full power; feed None: level times way."""
    done, asked, worst, level, k, n, came = 0.0, 0.0, 0.0, 0.0, 0, 0, 0.0
    since, place = row.times[0], 0.0
    for t, along in zip(row.times, row.along):
        while True:
            more = k < len(changes) and changes[k][0] <= t
            end = max(changes[k][0], since) if more else t
            way = row.at(end) - place
            done += level * ((end - since) * feed if feed else way)
            since, place = end, place + way
            if not more:
                break
            level = changes[k][1]
            k += 1
        while n < len(pixels) and came < along:
            to = min(along, pixels[n][0])
            asked += (to - came) * pixels[n][1]
            came = to
            if to < pixels[n][0]:
                break
            n += 1
        worst = max(worst, abs(done - asked))
    return worst


def check(record, gcode):
    pulses, levels, _ = read(record)
    pulses = [(t, at[:2]) for t, at in pulses]
    constant = any(line.startswith("M3") for line in open(gcode, encoding="ascii"))
    stops, energy, begin = 0, 0.0, [0]
    rows = rows_of(gcode)
    for start, end, pixels, feed in rows:       # each begins where the tool is at its start
        k = begin[-1]
        while math.dist(pulses[k][1], start) > 0.02:
            k += 1
        begin.append(k)
    begin = begin[1:] + [len(pulses)]
    for n, (start, end, pixels, feed) in enumerate(rows):
        row = Row(start, end, pulses[begin[n]:begin[n + 1]])
        energy = max(energy, energy_off(row, levels, pixels, None if constant else feed))
        stops += sum(b - a > 0.02 for a, b, x in zip(row.times, row.times[1:], row.along)
                     if 1 < x < row.length - 1)
    standing = 0.0
    for (a, _), (b, _) in zip(pulses, pulses[1:]):
        if b - a > 0.1:
            k = bisect.bisect_right([t for t, _ in levels], a + 0.06)
            standing = max(standing, levels[k - 1][1] if k else 0)
    print("rows %d\nlevels %d\nenergy %.4f\nstops %d\nstanding %g" %
          (len(rows), len(levels), energy, stops, standing))


if __name__ == "__main__":
    if sys.argv[1] == "make":
        make(sys.argv[2], int(sys.argv[3]), float(sys.argv[4]), int(sys.argv[5]),
             float(sys.argv[6]) if len(sys.argv) > 6 else 0.0)
    else:
        check(sys.argv[2], sys.argv[3])
