# SPDX-License-Identifier: GPL-3.0-or-later
"""unittest for tests that mostly wait for real programs: all of them wait at once."""
import io
import sys
import unittest
from concurrent.futures import ThreadPoolExecutor


def _units(suite):
    """The tests that run beside one another. Those of a class with something in common run one after another."""
    for tests in suite:
        shares = any("setUpClass" in vars(one) for test in tests for one in type(test).__mro__[:-2])
        yield from [tests] if shares else (unittest.TestSuite([test]) for test in tests)


def _run(tests):
    said = io.StringIO()
    return unittest.TextTestRunner(said, verbosity=2).run(tests).wasSuccessful(), said.getvalue()


def main():
    units = list(_units(unittest.defaultTestLoader.loadTestsFromName("__main__")))
    with ThreadPoolExecutor(len(units)) as pool:
        results = list(pool.map(_run, units))
    for _, said in results:
        print(said, file=sys.stderr)
    sys.exit(not all(well for well, _ in results))
