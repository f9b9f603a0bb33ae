#!/usr/bin/python3
# tests/bench/topp_jerk.py -- searches the shortest time for a path under limits of speed,
# acceleration and jerk, by linear programs
# SPDX-License-Identifier: MIT
"""
usage: topp_jerk.py [--grid N] FILE..      (needs python3-scipy)

FILE (made by build/bench/motion) has a line `limits A0 A1 .. J0 J1 ..`, then for each place of the
path `s  u..  k..  k'..  top`: length, direction, curvature vector, its derivative by s, largest
speed squared. Prints per file: path, time, largest use of each limit.

On a grid of s with x = v^2 and a = x'/2, acceleration and jerk of an axis are

    u a + k x        and        sqrt(x) (u a' + 3 k a + k' x)

The second is within +-J when the bracket is within J / sqrt(x), which is convex in x: its tangent
at the last x stays below it. So every linear program gives a profile that keeps the limits on the
grid, and each is at least as fast as the last. Rest is left with all of the jerk at most,
s = J t^3 / 6: that bounds x at the first place, and the first cell takes 3 h / v; likewise at the
end. The grid is denser there.
"""
import sys
import numpy as np
from scipy.optimize import linprog
from scipy.sparse import coo_matrix, vstack


def read(name):
    with open(name) as f:
        first = f.readline().split()
        rows = np.array([[float(v) for v in line.split()] for line in f])
    axes = (len(first) - 1) // 2
    accel = np.array([float(v) for v in first[1:1 + axes]])
    jerk = np.array([float(v) for v in first[1 + axes:]])
    return accel, jerk, rows, axes


def resample(rows, n):
    """n + 1 places, denser at both ends; joints and bounds take the worse of their neighbours."""
    s, length = rows[:, 0], rows[-1, 0]
    z = np.linspace(0, 1, n + 1)
    want = length * (z - 0.9 * np.sin(2 * np.pi * z) / (2 * np.pi))
    out = np.array([np.interp(want, s, rows[:, c]) for c in range(rows.shape[1])]).T
    out[:, 0] = want
    return out


class Program:
    def __init__(self, accel, jerk, rows, axes):
        s = rows[:, 0]
        self.n = len(s)
        self.h = np.diff(s)
        self.u, self.k = rows[:, 1:1 + axes], rows[:, 1 + axes:1 + 2 * axes]
        self.kd, self.top = rows[:, 1 + 2 * axes:1 + 3 * axes], rows[:, -1]
        self.accel, self.jerk, self.axes = accel, jerk, axes
        self.top = self.top.copy()
        for end, near, h in (0, 1, self.h[0]), (-1, -2, self.h[-1]):
            most = np.min(jerk / np.maximum(np.abs(self.u[end]), 1e-9))
            self.top[near] = min(self.top[near], most ** 2 / 4 * (6 * h / most) ** (4 / 3))
        self.weight = 2 * self.h
        self.weight[[0, -1]] *= 1.5
        self.linear()

    def linear(self):
        """rows of acceleration (twice per node, with a before and after), and of jerk's bracket"""
        n, h = self.n, self.h
        cell = coo_matrix((np.concatenate([-1 / (2 * h), 1 / (2 * h)]),
                           (np.tile(np.arange(n - 1), 2),
                            np.concatenate([np.arange(n - 1), np.arange(1, n)]))),
                          shape=(n - 1, n)).tocsr()
        inner = np.arange(1, n - 1)
        pick = lambda idx: coo_matrix((np.ones(len(idx)), (np.arange(len(idx)), idx)),
                                      shape=(len(idx), n)).tocsr()
        mean = (h[1:] + h[:-1]) / 2
        blocks, bounds, brackets = [], [], []
        for i in range(self.axes):
            diag = lambda v: coo_matrix((v, (np.arange(len(v)), np.arange(len(v)))),
                                        shape=(len(v), len(v))).tocsr()
            for at in (np.arange(n - 1), np.arange(1, n)):
                blocks.append(diag(self.u[at, i]) @ cell + diag(self.k[at, i]) @ pick(at))
                bounds.append(np.full(n - 1, self.accel[i]))
            before, behind = cell[:-1], cell[1:]
            brackets.append(diag(self.u[inner, i] / mean) @ (behind - before)
                            + diag(1.5 * self.k[inner, i]) @ (behind + before)
                            + diag(self.kd[inner, i]) @ pick(inner))
        self.accel_rows, self.accel_bounds = vstack(blocks).tocsr(), np.concatenate(bounds)
        self.brackets, self.inner = brackets, inner

    def time(self, x):
        r = np.sqrt(x)
        return float(np.sum(self.weight / (r[1:] + r[:-1])))

    def gradient(self, x):
        r = np.sqrt(np.maximum(x, 1e-12))
        g = np.zeros(self.n)
        w = -self.weight / (r[1:] + r[:-1]) ** 2
        g[:-1] += w / (2 * r[:-1])
        g[1:] += w / (2 * r[1:])
        return g

    def uses(self, x):
        a = self.accel_rows @ x / self.accel_bounds
        j = max(float(np.max(np.abs(np.sqrt(x[self.inner]) * (b @ x)) / self.jerk[i]))
                for i, b in enumerate(self.brackets))
        return float(np.max(x / self.top)) ** 0.5, float(np.max(np.abs(a))), j

    def start(self):
        """slow, and within every limit"""
        s = np.concatenate([[0], np.cumsum(self.h)])
        away = np.minimum(s, s[-1] - s)
        ends = (away / s[-1]) ** (4 / 3) * s[-1] ** 2
        shape = np.minimum(np.minimum(np.min(self.top[2:-2]), ends), self.top)
        scale = 1.0
        while max(self.uses(scale * shape)) > 0.9:
            scale /= 2
        return scale * shape

    def step(self, x, trust):
        xi = x[self.inner]
        root = 1 / np.sqrt(xi)
        slope = coo_matrix((0.5 * root / xi, (np.arange(len(xi)), self.inner)),
                           shape=(len(xi), self.n)).tocsr()
        A, b = [self.accel_rows, -self.accel_rows], [self.accel_bounds, self.accel_bounds]
        for i, rows in enumerate(self.brackets):
            for sign in (1, -1):
                A.append(sign * rows + self.jerk[i] * slope)
                b.append(self.jerk[i] * 1.5 * root)
        bound = [(x[k] / trust, min(self.top[k], x[k] * trust)) for k in range(self.n)]
        bound[0] = bound[-1] = (0, 0)
        g = self.gradient(x)
        found = linprog(g / np.max(np.abs(g)), A_ub=vstack(A).tocsr(), b_ub=np.concatenate(b),
                        bounds=bound, method='highs')
        return found.x if found.status == 0 else None


def solve(name, n):
    accel, jerk, rows, axes = read(name)
    p = Program(accel, jerk, resample(rows, n), axes)
    x = p.start()
    best, trust = p.time(x), 4.0
    for _ in range(80):
        y = p.step(x, trust)
        t = p.time(np.maximum(y, 0)) if y is not None else np.inf
        if t < best * (1 - 1e-5):
            x, best = np.maximum(y, 0), t
        elif trust > 1.05:
            trust = 1 + (trust - 1) / 3
        else:
            break
    return best, p.uses(x)


def main():
    args, n = sys.argv[1:], 300
    if args[:1] == ['--grid']:
        n, args = int(args[1]), args[2:]
    if not args or args[0].startswith('-'):
        sys.exit(__doc__)
    for name in args:
        time, (speed, accel, jerk) = solve(name, n)
        print(f'{name} {time:.5f} {speed:.4f} {accel:.4f} {jerk:.4f}', flush=True)


if __name__ == '__main__':
    main()
