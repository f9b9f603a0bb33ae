# ports/packages/python/example.py -- a plan of two curves: its path, speed and acceleration
# SPDX-License-Identifier: MIT
# usage: python3 example.py PICTURE
import sys

import loft

# %% an S of two cubics, in mm
path = [[[0, 0], [20, 0], [20, 10], [20, 20]], [[20, 20], [20, 30], [20, 40], [40, 40]]]
motion = loft.plan(path, feed=50, accel=500, jerk=10000)
print(f'{len(motion.time) - 1} ticks, ends at {motion.position[-1][:2].tolist()}')

# %% pictures
import matplotlib
matplotlib.use('Agg')
from matplotlib import pyplot

figure, (where, when) = pyplot.subplots(1, 2, figsize=(10, 4))
where.plot(motion.position[:, 0], motion.position[:, 1])
where.set(xlabel='x, mm', ylabel='y, mm', aspect='equal')
when.plot(motion.time[1:], motion.derivative(1)[:, :2])
when.set(xlabel='s', ylabel='mm/s')
figure.savefig(sys.argv[1])
