"""plumb.solve_batch: the answers of plumb.solve, in any layout of memory, by any number of threads."""

import threading
import unittest

import numpy as np

import plumb
from drawn import fields, pairs

ALL = ("overlap", "normal", "points", "iterations", "evaluations")


def by_columns(bodies):
    return plumb.Bodies(*(np.asfortranarray(array) for array in bodies._arrays()))


def by_slices(bodies):
    """Every second entry of arrays twice as large, backwards."""
    out = []
    for array in bodies._arrays():
        large = np.full((2 * len(array), 2 * array.shape[1]), np.nan)
        view = large[::-2, ::2]
        view[:] = array
        out.append(view)
    return plumb.Bodies(*out)


def in_records(bodies):
    """Fields of packed records, at odd places in memory."""
    names, widths = ("semi_axes", "position", "quaternion", "exponents"), (3, 3, 4, 2)
    kind = [("tag", "i1"), *((name, "f8", width) for name, width in zip(names, widths))]
    records = np.zeros(len(bodies), kind)
    for name, array in zip(names, bodies._arrays()):
        records[name] = array
    return plumb.Bodies(*(records[name] for name in names))


class Batch(unittest.TestCase):
    def expect_same(self, one, other):
        one, other = fields(one), fields(other)
        self.assertEqual(one.keys(), other.keys())
        for name in one:
            np.testing.assert_array_equal(one[name], other[name], name)

    def test_ellipsoids_have_the_bits_of_solve(self):
        bodies1, bodies2 = pairs(500)
        contacts = plumb.solve_batch(bodies1, bodies2, want=ALL)
        for i in range(len(contacts)):
            contact = plumb.solve(bodies1[i], bodies2[i])
            for name, values in fields(contacts).items():
                np.testing.assert_array_equal(values[i], getattr(contact, name), name)

    def test_superquadrics_have_the_answers_of_solve_to_rounding(self):
        bodies1, bodies2 = pairs(300, (2, 8))
        contacts = plumb.solve_batch(bodies1, bodies2)
        for i in range(len(contacts)):
            contact = plumb.solve(bodies1[i], bodies2[i])
            self.assertEqual((contacts.status[i], contacts.verdict[i]), (contact.status, contact.verdict))
            self.assertAlmostEqual(contacts.overlap[i], contact.overlap, delta=8 * 1.7 * np.finfo(float).eps)

    def test_layouts_have_the_same_bits(self):
        for exponents in (None, (2, 8)):
            bodies = pairs(1000, exponents)
            expected = plumb.solve_batch(*bodies, want=ALL)
            for layout in (by_columns, by_slices, in_records):
                with self.subTest(layout=layout.__name__, exponents=exponents):
                    self.expect_same(plumb.solve_batch(*map(layout, bodies), want=ALL), expected)

    def test_threads_have_the_same_bits(self):
        bodies = pairs(20000)
        expected = plumb.solve_batch(*bodies, want=ALL)
        for threads in (2, 3, 16):
            self.expect_same(plumb.solve_batch(*bodies, want=ALL, threads=threads), expected)

    def test_warm_batches_have_the_answers_of_cold_ones_in_less_work(self):
        for exponents in (None, (2, 8)):
            bodies1, bodies2 = pairs(1000, exponents)
            last = plumb.solve_batch(bodies1, bodies2, want="charts")
            step = 1e-3 * np.random.default_rng(2).normal(size=bodies2.position.shape)
            for _ in range(3):
                bodies2.position[:] += step
                cold = plumb.solve_batch(bodies1, bodies2, want=ALL)
                warm = plumb.solve_batch(bodies1, bodies2, want=(*ALL, "charts"), last=last)
                np.testing.assert_array_equal(warm.status, cold.status)
                np.testing.assert_array_equal(warm.verdict, cold.verdict)
                np.testing.assert_allclose(warm.overlap, cold.overlap, rtol=0, atol=1e-13)
                self.assertLess(warm.evaluations.sum(), cold.evaluations.sum())
                known = ~np.isnan(last.charts[:, 0]).any(axis=(1, 2))
                np.testing.assert_array_equal(warm.charts[known, 1], last.charts[known, 0])
                last = warm

    def test_a_batch_may_start_where_it_writes(self):
        bodies1, bodies2 = pairs(3000)
        for order in ("C", "F"):
            start = plumb.solve_batch(bodies1, bodies2, want=(*ALL, "charts"))
            out = plumb.Contacts.empty(3000, (*ALL, "charts"), order)
            for name, values in fields(start).items():
                getattr(out, name)[:] = values
            expected = plumb.solve_batch(bodies1, bodies2, want=(*ALL, "charts"), last=start)
            self.assertIs(plumb.solve_batch(bodies1, bodies2, out=out, last=out, threads=2), out)
            self.expect_same(out, expected)

    def test_python_threads_share_bodies(self):
        bodies = pairs(5000)
        expected, found = plumb.solve_batch(*bodies), [None] * 4

        def solve(i):
            found[i] = plumb.solve_batch(*bodies, threads=2)

        workers = [threading.Thread(target=solve, args=(i,)) for i in range(len(found))]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        for contacts in found:
            self.expect_same(contacts, expected)

    def test_answers_go_where_they_are_asked_to(self):
        bodies = pairs(700)
        expected = plumb.solve_batch(*bodies, want=ALL)
        for order in ("C", "F"):
            out = plumb.Contacts.empty(700, ALL, order)
            self.assertIs(plumb.solve_batch(*bodies, out=out), out)
            self.expect_same(out, expected)
        large = np.zeros((700, 10))
        out = plumb.Contacts(*(np.empty(700, np.int32) for _ in range(2)), normal=large[:, 4:7])
        plumb.solve_batch(*bodies, out=out)
        np.testing.assert_array_equal(large[:, 4:7], expected.normal)
        self.assertFalse(large[:, :4].any() or large[:, 7:].any())

    def test_only_what_is_wanted(self):
        bodies = pairs(3)
        self.assertEqual(set(fields(plumb.solve_batch(*bodies, want=()))), {"status", "verdict"})
        points = {"status", "verdict", "points", "contact_point"}
        self.assertEqual(set(fields(plumb.solve_batch(*bodies, want="points"))), points)

    def test_arrays_of_one_dimension_hold_for_all(self):
        bodies1, bodies2 = pairs(200)
        one = plumb.Bodies((1, 0.5, 0.25), (0, 0, 0))
        repeated = plumb.Bodies.of([one[0]] * 200)
        self.expect_same(plumb.solve_batch(one, bodies2), plumb.solve_batch(repeated, bodies2))
        self.expect_same(plumb.solve_batch(bodies2, one), plumb.solve_batch(bodies2, repeated))
        self.assertEqual(len(plumb.solve_batch(one, one)), 1)

    def test_no_pairs(self):
        none = plumb.Bodies(np.empty((0, 3)), np.empty((0, 3)))
        self.assertEqual(plumb.solve_batch(none, none, threads=4).points.shape, (0, 2, 3))
        self.assertEqual(len(plumb.solve_batch(none, plumb.Bodies.of([]))), 0)

    def test_an_illegal_body_is_its_own_affair(self):
        bodies1, bodies2 = pairs(300)
        expected = plumb.solve_batch(bodies1, bodies2)
        wrong = {3: np.nan, 70: np.inf, 299: 0.0}
        for i, value in wrong.items():
            bodies2.semi_axes[i, 1] = value
        found = plumb.solve_batch(bodies1, bodies2)
        rows = list(wrong)
        self.assertTrue(np.all(found.status[rows] == plumb.Status.invalid_input))
        for name, values in fields(found).items():
            if values.dtype.kind == "f":
                self.assertTrue(np.isnan(values[rows]).all(), name)
            np.testing.assert_array_equal(np.delete(values, rows, 0), np.delete(getattr(expected, name), rows, 0), name)

    def test_inputs_are_not_copied(self):
        rows, columns = np.ones((4, 3)), np.ones((3, 4)).T
        for array in (rows, columns, np.ones((8, 6))[::2, ::2]):
            self.assertTrue(np.shares_memory(plumb.Bodies(array, (0, 0, 0)).semi_axes, array))

    def test_readonly_inputs(self):
        bodies1, bodies2 = pairs(50)
        for array in bodies1._arrays():
            array.flags.writeable = False
        self.assertTrue((plumb.solve_batch(bodies1, bodies2).status == plumb.Status.converged).all())


if __name__ == "__main__":
    unittest.main()
