# SPDX-License-Identifier: Apache-2.0
"""What a format cannot say: each item by name, once."""


class Report:
    """Collects warnings. The same text about the same item is kept once, in the order of first mention."""

    def __init__(self):
        self._warnings = {}

    def warn(self, item, text):
        """item: what it is about, as "light 'Key'"; text: what happens to it."""
        self._warnings.setdefault(f"{item}: {text}", None)

    @property
    def warnings(self):
        return list(self._warnings)
