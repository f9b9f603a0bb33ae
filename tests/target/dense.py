#!/usr/bin/env python3
# tests/target/dense.py -- prints the drawing as in a dense G-code file: points at equal distances
# along its curves
# SPDX-License-Identifier: MIT
"""usage: dense.py CUBICS.csv SPACING > points.loft

CUBICS.csv has a cubic per line; points.loft has lines from point to point (LOFT.md)."""
import math
import sys

MOST = 5000             # points per curve of a .loft file


def main(path, spacing):
    rows = [[float(x) for x in line.split(",")] for line in open(path)
            if line.strip() and not line.startswith("#")]
    fine = []
    for c in rows:
        for k in range(4000):
            t = k / 4000
            b = ((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3)
            fine.append(tuple(sum(b[j] * c[2 * j + i] for j in range(4)) for i in (0, 1)))
    fine.append(tuple(rows[-1][6:8]))
    along = [0.0]
    for p, q in zip(fine, fine[1:]):
        along.append(along[-1] + math.dist(p, q))
    count = round(along[-1] / spacing)
    j, last = 0, ""
    for k in range(count + 1):
        s = along[-1] * k / count
        while j + 2 < len(along) and along[j + 1] < s:
            j += 1
        w = (s - along[j]) / (along[j + 1] - along[j])
        row = " ".join(f"{a + w * (b - a):.6f}" for a, b in zip(fine[j], fine[j + 1]))
        if k % MOST == 0 and k < count:
            print("line")
            if last:
                print(last)
        print(row)
        last = row


if __name__ == "__main__":
    main(sys.argv[1], float(sys.argv[2]))
