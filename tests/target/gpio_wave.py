#!/usr/bin/env python3
# tests/target/gpio_wave.py -- prints numbers from the record of gpio.sh's guest at its lines
# SPDX-License-Identifier: MIT
"""usage: gpio_wave.py DUMP CASE OUT.csv > VALUES

VALUES are lines `name value`. OUT.csv has rows `slot,x,y,z` as `loft simulate --record` writes
them, with the time in us for the slot.

DUMP has sections `=== NAME`: `map` and the version, the kernel's list of chips; and of each case
what the program said, the slots it recorded, the changes of outputs that the tracepoint saw, and
when switches were pulled.
"""
import re
import sys

AXES = "xyz"
# chip, step, dir: as in gpio_init.sh
WHERE = {"x": ("motors", 0, 1), "y": ("switches", 0, 1), "z": ("motors", 3, 4)}
ENABLE = ("motors", 2)          # active low


def sections(path):
    found, name = {}, None
    for line in open(path, errors="replace"):
        if line.startswith("=== "):
            name = line[4:].strip()
            found[name] = []
        elif name:
            found[name].append(line.rstrip("\n"))
    return found


def main(dump, case, out):
    part = sections(dump)
    chips = re.findall(r"GPIOs (\d+)-\d+, parent: [^,]*, (\w+)", "\n".join(part["map" + case[-1]]))
    base = {label: int(first) for first, label in chips}
    step = {base[chip] + s: axis for axis, (chip, s, _) in WHERE.items()}
    turn = {base[chip] + d: axis for axis, (chip, _, d) in WHERE.items()}
    enable = base[ENABLE[0]] + ENABLE[1]

    at, dirs, high = dict.fromkeys(AXES, 0), dict.fromkeys(AXES, 0), set()
    rose, fell, turned = {}, {}, {}
    times, enabled, setup, hold, width, low = [], [], [], [], [], []
    with open(out, "w") as csv:
        print("slot,x,y,z", file=csv)
        for line in part[case + ".lines"]:
            us, number, value = map(int, line.split())
            if number in turn:
                axis = turn[number]
                dirs[axis] = value
                turned[axis] = us
                if axis in fell:
                    hold.append(us - fell[axis])
            elif number == enable:
                enabled.append(value)
            elif number in step and value:
                axis = step[number]
                high.add(axis)
                at[axis] += -1 if dirs[axis] else 1
                if axis in turned:
                    setup.append(us - turned.pop(axis))
                if axis in fell:
                    low.append(us - fell[axis])
                rose[axis] = us
                times.append(us)
                print(us, *at.values(), sep=",", file=csv)
            elif number in step and step[number] in rose:
                axis = step[number]
                high.discard(axis)
                fell[axis] = us
                width.append(us - rose[axis])

    said = "\n".join(part[case + ".said"])
    pulls = [line.split() for line in part[case + ".pulls"]]
    report = re.search(r"lateness of (\d+) pulses: worst ([\d.]+) us;"
                       r".* slower by ([\d.]+) ms in \d+ places, ran dry (\d+)", said)
    slot_hz, slots, before = 0.0, [], (0, 0, 0)
    for line in part[case + ".record"]:
        if line.startswith("# slot_hz"):
            slot_hz = float(line.split("=")[1])
        elif line[:1].isdigit():
            slot, *now = map(int, line.split(","))
            slots.append((slot, sum(a != b for a, b in zip(now, before))))
            before = now
    print("position", *at.values())
    print("told", *re.findall(r"position (-?\d+ -?\d+ -?\d+)", said)[-1:])
    print("code", *re.findall(r"^code (\d+)", said, re.M))
    print("ended", *re.findall(r"^job \w+ (done|aborted)", said, re.M))
    print("pulses", len(times))
    print("enable", *enabled)
    print("high", len(high))
    for name, values in (("width", width), ("low", low), ("setup", setup), ("hold", hold)):
        print(name, min(values) if values else "")
    if report:
        print("counted", report[1])
        print("worst", report[2])
        print("slower", report[3])
        print("dry", report[4])

    # a slot with several steps is several pulses; those of another chip come a few us later:
    # the first one is the time of the slot
    first, taken = [], 0
    for _, count in slots:
        first += times[taken:taken + 1]
        taken += count
    print("recorded", taken)
    if taken == len(times) and len(slots) > 1:
        planned = [(b - a) * 1e6 / slot_hz for (a, _), (b, _) in zip(slots, slots[1:])]
        real = [b - a for a, b in zip(first, first[1:])]
        print("closer", max(p - r for p, r in zip(planned, real)))
        print("apart", max(r - p for p, r in zip(planned, real)))
        print("longer", (first[-1] - first[0] - sum(planned)) / 1000)
        print("took", (first[-1] - first[0]) / sum(planned))
    if len(times) > 1:
        print("pause", max(b - a for a, b in zip(times, times[1:])) / 1000)
    if pulls:
        closed = int(pulls[-1][0])
        print("standing", (times[-1] - closed) / 1000 if times else "")
        print("between", sum(int(pulls[1][0]) + 100000 < us < closed for us in times))


if __name__ == "__main__":
    main(*sys.argv[1:4])
