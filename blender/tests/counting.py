# SPDX-License-Identifier: Apache-2.0
"""Runs a suite of unittest and counts; used in both Pythons."""
import json
import sys
import unittest
from typing import NamedTuple


class Counts(NamedTuple):
    run: int
    failed: int
    skipped: int

    def __add__(self, other):
        return Counts(*(a + b for a, b in zip(self, other)))


def run(suite):
    """A suite that is empty because nothing could be loaded counts as failed through its import errors."""
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(suite)
    failed = {str(test) for test, _ in result.failures + result.errors}
    return Counts(result.testsRun, len(failed), len(result.skipped))


def write(path, counts):
    with open(path, "w", encoding="utf-8") as file:
        json.dump(list(counts), file)
