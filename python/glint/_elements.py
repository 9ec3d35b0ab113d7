# SPDX-License-Identifier: Apache-2.0
"""Radii and colors of the elements: of those that molecules usually have, from here; of others, from ASE if it is installed."""

from __future__ import annotations

from typing import Any, Dict, List, Tuple

import numpy as np
import numpy.typing as npt

# Covalent radii in angstrom: B. Cordero et al., Dalton Trans. 2008, 2832. Colors: Jmol's.
_ELEMENTS: Dict[int, Tuple[str, float, str]] = {
    1: ("H", 0.31, "ffffff"), 2: ("He", 0.28, "d9ffff"), 3: ("Li", 1.28, "cc80ff"), 5: ("B", 0.84, "ffb5b5"),
    6: ("C", 0.76, "909090"), 7: ("N", 0.71, "3050f8"), 8: ("O", 0.66, "ff0d0d"), 9: ("F", 0.57, "90e050"),
    11: ("Na", 1.66, "ab5cf2"), 12: ("Mg", 1.41, "8aff00"), 13: ("Al", 1.21, "bfa6a6"), 14: ("Si", 1.11, "f0c8a0"),
    15: ("P", 1.07, "ff8000"), 16: ("S", 1.05, "ffff30"), 17: ("Cl", 1.02, "1ff01f"), 19: ("K", 2.03, "8f40d4"),
    20: ("Ca", 1.76, "3dff00"), 25: ("Mn", 1.39, "9c7ac7"), 26: ("Fe", 1.32, "e06633"), 27: ("Co", 1.26, "f090a0"),
    28: ("Ni", 1.24, "50d050"), 29: ("Cu", 1.32, "c88033"), 30: ("Zn", 1.22, "7d80b0"), 34: ("Se", 1.20, "ffa100"),
    35: ("Br", 1.20, "a62929"), 47: ("Ag", 1.45, "c0c0c0"), 53: ("I", 1.39, "940094"), 79: ("Au", 1.36, "ffd123"),
}  # fmt: skip
_OTHER = ("", 1.2, "ff1493")
_NUMBERS = {symbol.upper(): number for number, (symbol, _, _) in _ELEMENTS.items()}


def numbers_of(words: Any) -> List[int]:
    """Atomic numbers of symbols, or of names of atoms such as 'CA1', which is then carbon; 0 if not known."""
    found = []
    for word in words:
        letters = "".join(letter for letter in str(word).strip() if letter.isalpha()).upper()
        is_symbol = str(word).strip().isalpha() and letters in _NUMBERS
        found.append(_NUMBERS[letters] if is_symbol else _NUMBERS.get(letters[:1], 0))
    return found


def numbers_of_symbols(symbols: Any) -> List[int]:
    """Atomic numbers of symbols or of numbers; 0 if a symbol is not known."""
    try:
        from ase.data import atomic_numbers  # type: ignore[import]
    except ImportError:
        atomic_numbers = {symbol: number for number, (symbol, _, _) in _ELEMENTS.items()}
    return [
        atomic_numbers.get(one.strip().capitalize(), 0) if isinstance(one, str) else int(one) for one in symbols
    ]


def looks_of(numbers: Any) -> Tuple[npt.NDArray[Any], npt.NDArray[Any]]:
    """Covalent radii in angstrom, (N,), and colors, (N, 3)."""
    numbers = np.asarray(numbers, dtype=int)
    rows = [_ELEMENTS.get(int(number), _OTHER) for number in numbers]
    radii = np.array([radius for _, radius, _ in rows])
    colors = np.array([[int(digits[i:i + 2], 16) / 255 for i in (0, 2, 4)] for _, _, digits in rows]).reshape(-1, 3)
    others = np.array([int(number) not in _ELEMENTS for number in numbers], bool)
    if others.any():
        try:
            from ase.data import covalent_radii
            from ase.data.colors import jmol_colors  # type: ignore[import]
        except ImportError:
            return radii, colors
        radii[others], colors[others] = covalent_radii[numbers[others]], jmol_colors[numbers[others]]
    return radii, colors
