#!/usr/bin/env python3
"""tests/bench/stops.py -- when a machine that moves evenly slows down behind a switch

usage: stops.py RECORD STEPS STEPS_PER_TICK

The switch of x closes with the pulse that reaches STEPS. Prints `name value` lines, in ms from that
pulse: `even`, the last pulse in the pattern of the ticks before; `slower`, the first one that comes
later; `last`, the last one of all.

SPDX-License-Identifier: MIT
"""
import sys

TICK, LATE = 16000, 150         # cycles: a tick, and less than a slot of 200


def main(name, touch, per_tick):
    when, place = [], []
    for line in open(name, encoding="ascii"):
        cell = line.split(",")
        if line[0].isdigit() and (not place or int(cell[1]) != place[-1]):
            when.append(int(cell[0]))
            place.append(int(cell[1]))
    at = place.index(touch)
    even, slower = when[at], None
    for k in range(at + 1, len(when)):
        if when[k] - when[k - per_tick] > TICK + LATE:
            slower = when[k]
            break
        even = when[k]
    for key, value in ("even", even), ("slower", slower), ("last", when[-1]):
        if value is not None:
            print(key, "%.3f" % ((value - when[at]) / TICK))


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))
