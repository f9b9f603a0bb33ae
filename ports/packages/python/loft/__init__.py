# ports/packages/python/loft/__init__.py -- curves and plans over numpy arrays, in double
# SPDX-License-Identifier: MIT
"""Curves and motion, exactly: the C library loft in double.

    curve = loft.Bezier([[0, 0], [10, 40], [30, 40], [40, 0]])
    curve(0.5)                         # a point; curve([0, 0.5, 1]) is an array of three
    curve.walk(64)                     # 64 points by forward differences
    loft.plan([[[0, 0], [20, 0], [20, 10], [20, 20]]], feed=50).position

Points are rows of up to three numbers; what is missing is 0.
"""
import numpy

from ._documents import DOCUMENTS
from ._loft import ffi, lib

__all__ = ['Bezier', 'Motion', 'plan']


def _points(points):
    given = numpy.atleast_2d(numpy.asarray(points, dtype=float))
    if given.ndim != 2 or not 1 <= given.shape[1] <= 3:
        raise ValueError('points: give rows of 1 to 3 numbers')
    out = numpy.zeros((len(given), 3))
    out[:, :given.shape[1]] = given
    return out


def _check(status, what):
    if status != lib.LOFT_OK:
        cause = {lib.LOFT_ERR_ARG: 'an argument is wrong', lib.LOFT_ERR_RANGE: 'out of range',
                 lib.LOFT_ERR_SPACE: 'no room'}.get(status, f'status {status}')
        raise ValueError(f'{what}: {cause}')


def _documented(name):
    def put(function):
        function.__doc__ = f'{function.__doc__ or ""}\n\n{name}: {DOCUMENTS[name]}'.strip()
        return function
    return put


class Bezier:
    """A Bezier curve with control points in rows."""

    def __init__(self, points):
        self.points = _points(points)
        self._memory = ffi.from_buffer('loft_vec[]', self.points)
        self._curve = ffi.new('loft_bezier *')
        _check(lib.loft_bezier_init(self._curve, self._memory, len(self.points) - 1), 'Bezier')

    @_documented('loft_bezier_eval')
    def __call__(self, t):
        t = numpy.asarray(t, dtype=float)
        out = numpy.empty(t.shape + (3,))
        for i, row in zip(t.flat, out.reshape(-1, 3)):
            row[:] = list(lib.loft_bezier_eval(self._curve, i).axis)
        return out

    @_documented('loft_bezier_deriv')
    def deriv(self, t, k=1):
        t = numpy.asarray(t, dtype=float)
        out, one = numpy.empty(t.shape + (3,)), ffi.new('loft_vec *')
        for i, row in zip(t.flat, out.reshape(-1, 3)):
            _check(lib.loft_bezier_deriv(self._curve, k, i, one), 'deriv')
            row[:] = list(one.axis)
        return out

    @_documented('loft_forward_init')
    def walk(self, n):
        walk, out = ffi.new('loft_forward *'), numpy.empty((n, 3))
        _check(lib.loft_forward_init(walk, self._curve, n), 'walk')
        count = lib.loft_forward_run(walk, ffi.from_buffer('loft_vec[]', out), n)
        return out[:count]

    def _cubic(self):
        if len(self.points) != 4:
            raise ValueError('length, flatten: for cubics, four control points')
        cubic = ffi.new('loft_cubic *')
        ffi.buffer(cubic.p)[:] = self.points.tobytes()
        return cubic

    @_documented('loft_cubic_arclen')
    def length(self, tol=1e-6):
        return lib.loft_cubic_arclen(self._cubic(), tol)

    @_documented('loft_flatten_init')
    def flatten(self, tol):
        state, one, out = ffi.new('loft_flatten *'), ffi.new('loft_vec *'), [self.points[0]]
        _check(lib.loft_flatten_init(state, self._cubic(), tol), 'flatten')
        while lib.loft_flatten_next(state, one):
            out.append(list(one.axis))
        return numpy.array(out)


class Motion:
    """What a plan gives: `time` in s, `position` in mm, and their derivatives by differences."""

    def __init__(self, position, tick):
        self.position, self.tick = position, tick
        self.time = numpy.arange(len(position)) * tick

    def derivative(self, order):
        return numpy.diff(self.position, order, axis=0) / self.tick ** order


@_documented('loft_plan_next')
def plan(cubics, feed, speed=500, accel=2000, jerk=20000, tol=0.005, corner=0, tick_hz=1000):
    """The motion along a chain of cubics, each four points, within limits per axis."""
    limits, machine = ffi.new('loft_limits *'), ffi.new('loft_plan *')
    each = [numpy.broadcast_to(numpy.asarray(x, dtype=float), 3).tolist()
            for x in (speed, accel, jerk)]
    lib.py_limits(limits, *each, tol, corner, tick_hz)
    room = 64
    moves = ffi.new('loft_move[]', room)
    knots = ffi.new('loft_knot[]', 400)
    _check(lib.loft_plan_init(machine, limits, moves, room, knots, len(knots)), 'plan: limits')
    waiting = [_points(c) for c in cubics]
    if not waiting or any(len(c) != 4 for c in waiting):
        raise ValueError('plan: give cubics, four control points each')
    rows, span, walk = [waiting[0][:1]], ffi.new('loft_span *'), ffi.new('loft_forward *')
    done, move = 0, ffi.new('loft_move *')
    while True:
        while done < len(waiting) and lib.py_left(machine) > 0:
            ffi.buffer(move.curve.p)[:] = waiting[done].tobytes()
            move.feed = feed
            status = lib.loft_plan_push(machine, move)
            if status == lib.LOFT_ERR_SPACE:
                break
            _check(status, f'plan: curve {done}')
            done += 1
        if done == len(waiting):
            lib.loft_plan_end(machine)
        state = lib.loft_plan_next(machine, span)
        if state == lib.LOFT_PLAN_SPAN:
            _check(lib.loft_span_walk(walk, span), 'plan: span')
            out = numpy.empty((1024, 3))
            rows.append(out[:lib.loft_forward_run(walk, ffi.from_buffer('loft_vec[]', out), 1024)])
        elif state == lib.LOFT_PLAN_REST and done == len(waiting):
            return Motion(numpy.concatenate(rows), 1 / tick_hz)
