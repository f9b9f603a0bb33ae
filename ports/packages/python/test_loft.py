# ports/packages/python/test_loft.py -- the module against numpy
# SPDX-License-Identifier: MIT
import unittest

import numpy

import loft

POINTS = numpy.array([[0, 0, 1], [10, 40, 2], [30, 40, -3], [40, 0, 7.5]])


def true(t):
    t = numpy.asarray(t)[..., None]
    s = 1 - t
    return s**3 * POINTS[0] + 3*s*s*t * POINTS[1] + 3*s*t*t * POINTS[2] + t**3 * POINTS[3]


class Curves(unittest.TestCase):
    def test_points_are_those_of_numpy(self):
        t = numpy.linspace(0, 1, 101)
        numpy.testing.assert_allclose(loft.Bezier(POINTS)(t), true(t), rtol=0, atol=1e-12)

    def test_a_walk_is_the_points(self):
        walked = loft.Bezier(POINTS).walk(64)
        numpy.testing.assert_allclose(walked, true(numpy.arange(1, 65) / 64), rtol=0, atol=1e-12)
        self.assertEqual(walked[-1].tolist(), POINTS[3].tolist())

    def test_derivatives(self):
        numpy.testing.assert_allclose(loft.Bezier(POINTS).deriv(0), 3 * (POINTS[1] - POINTS[0]),
                                      atol=1e-9)

    def test_length_is_that_of_many_chords(self):
        chords = numpy.diff(true(numpy.linspace(0, 1, 20001)), axis=0)
        self.assertAlmostEqual(loft.Bezier(POINTS).length(1e-7),
                               numpy.linalg.norm(chords, axis=1).sum(), places=5)

    def test_chords_are_within_the_tolerance(self):
        chords = loft.Bezier(POINTS).flatten(0.1)
        fine = true(numpy.linspace(0, 1, 2001))
        worst = 0
        for p in fine:
            a, b = chords[:-1], chords[1:]
            u = numpy.clip(((p - a) * (b - a)).sum(1) / ((b - a)**2).sum(1), 0, 1)
            worst = max(worst, numpy.linalg.norm(p - a - u[:, None] * (b - a), axis=1).min())
        self.assertTrue(0.001 < worst <= 0.1, worst)

    def test_what_is_wrong_is_said(self):
        for points in ([[1, 2, 3, 4]], [[numpy.nan, 0], [1, 1]]):
            with self.assertRaises(ValueError):
                loft.Bezier(points).walk(8)

    def test_docstrings_are_those_of_the_headers(self):
        self.assertIn('error', loft.Bezier.__call__.__doc__)
        self.assertIn('range', loft.Bezier.walk.__doc__)


class Plans(unittest.TestCase):
    def test_a_plan_ends_at_rest_and_keeps_its_limits(self):
        path = [[[0, 0], [20, 0], [20, 10], [20, 20]], [[20, 20], [20, 30], [20, 40], [40, 40]]]
        motion = loft.plan(path, feed=50, accel=500, jerk=10000)
        self.assertEqual(motion.position[-1].tolist(), [40, 40, 0])
        self.assertLess(abs(motion.derivative(1)).max(), 50.1)
        self.assertLess(abs(motion.derivative(2)).max(), 505)

    def test_many_curves_go_through_a_small_ring(self):
        chain = [[[i, 0], [i + 1/3, 0], [i + 2/3, 0], [i + 1, 0]] for i in range(200)]
        self.assertEqual(loft.plan(chain, feed=40).position[-1].tolist(), [200, 0, 0])

    def test_curves_apart_are_refused(self):
        with self.assertRaises(ValueError):
            loft.plan([[[0, 0]] * 3 + [[1, 1]], [[5, 5]] * 3 + [[6, 6]]], feed=10)


if __name__ == '__main__':
    unittest.main()
