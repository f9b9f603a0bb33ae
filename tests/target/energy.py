#!/usr/bin/env python3
"""tests/target/energy.py -- energy of output 1 for each mm of the path, in a record of pulses

usage: energy.py RECORD [WAY]

Prints `name value` lines. Energy is level times time, in full-power ms; the path is that of the
steps, seen every 5 ms. Each window is WAY mm long (2), or the motion between two stops. It counts
if the machine was faster than 1 mm/s all the time. A pause of 50 ms without a pulse is a stop.
After the last pulse the path may go on for less than a step: what that takes does not count.

SPDX-License-Identifier: MIT
"""
import math
import sys

SAMPLE, STOP, SLOW = 0.005, 0.05, 1.0       # s, s, mm/s
EDGE = 0.02                                 # s: within a step of rest the machine still moves


def read(name):
    """Pulses (s, place in mm), changes of output 1 (s, level 0..1), and steps/mm of each axis."""
    hz, per_mm, pulses, levels = 1.0, [], [], []
    for line in open(name, encoding="ascii"):
        word = line.split()
        if line.startswith("# slot_hz"):
            hz = float(word[3])
        elif line.startswith("# steps_per_mm"):
            per_mm.append(float(word[3]))
        elif line.startswith("# output 1 "):
            levels.append((int(word[7]) / hz, int(word[4]) / 65535))
        elif line[0].isdigit():
            cell = line.split(",")
            pulses.append((int(cell[0]) / hz,
                           [int(c) / s for c, s in zip(cell[1:], per_mm)]))
    return pulses, levels, per_mm


def energy_to(levels, times):
    """The energy up to each of the times, in s of full power."""
    out, total, at, now, k = [], 0.0, 0.0, 0.0, 0
    for t in times:
        while k < len(levels) and levels[k][0] <= t:
            total += now * (levels[k][0] - at)
            at, now = levels[k]
            k += 1
        total += now * (t - at)
        at = t
        out.append(total)
    return out


def places_at(pulses, times):
    out, k = [], 0
    for t in times:
        while k + 1 < len(pulses) and pulses[k + 1][0] <= t:
            k += 1
        out.append(pulses[k][1])
    return out


def stopped_at(pulses, times, edge):
    """Is each of the times in a stop, and not within `edge` of its pulses?"""
    stops = [(a[0] + edge, b[0] - edge)
             for a, b in zip(pulses, pulses[1:]) if b[0] - a[0] > STOP]
    out, k = [], 0
    for t in times:
        while k < len(stops) and stops[k][1] < t:
            k += 1
        out.append(k < len(stops) and stops[k][0] <= t)
    return out


def main(name, least):
    pulses, levels, per_mm = read(name)
    first, last = pulses[0][0], pulses[-1][0]
    times = [first + i * SAMPLE for i in range(int((last - first) / SAMPLE) + 1)]
    place, energy = places_at(pulses, times), energy_to(levels, times)
    stop, stands = stopped_at(pulses, times, 0), stopped_at(pulses, times, EDGE)
    windows, way, since, standing = [], 0.0, 0, 0.0
    for i in range(1, len(times)):
        step = math.dist(place[i], place[i - 1])
        if stands[i] and stands[i - 1]:
            standing += energy[i] - energy[i - 1]
        if step < SLOW * SAMPLE or stop[i]:
            way, since = 0.0, i
            continue
        way += step
        if way >= least:
            windows.append((energy[i] - energy[since]) / way)
            way, since = 0.0, i
    total = sum(math.dist(a, b) for a, b in zip(place, place[1:]))
    mean = sum(windows) / max(len(windows), 1)
    print("windows", len(windows))
    print("way %.3f" % total)
    print("seconds %.3f" % (last - first))
    print("mean %.4f" % (1000 * mean))
    worst = max((abs(w / mean - 1) for w in windows), default=1) if mean else 1
    print("worst %.2f" % (100 * worst))
    print("standing %.5f" % (1000 * standing))
    after = energy_to(levels, [last + EDGE, last + 3600])
    print("after %.5f" % (1000 * max(after[1] - after[0] - mean / min(per_mm), 0)))


if __name__ == "__main__":
    main(sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 2.0)
