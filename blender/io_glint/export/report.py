# SPDX-License-Identifier: Apache-2.0
"""What a format cannot say: each item by name, once."""


class Report:
    """Collects warnings. The same text about the same item is kept once, in the order of first mention."""

    def __init__(self):
        self._warnings = {}

    def warn(self, item, text):
        """item: what it is about, as "light 'Key'"; text: what happens to it."""
        self._warnings.setdefault((item, text), None)

    @property
    def entries(self):
        """(item, text) of each."""
        return list(self._warnings)

    @property
    def warnings(self):
        return [f"{item}: {text}" for item, text in self._warnings]
