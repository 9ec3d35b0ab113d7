# SPDX-License-Identifier: Apache-2.0
"""glint's Python package, which the viewport renders by: the add-on's own copy, else the one that Blender's Python has."""
import os
import re
import sys
import warnings

from .command import OLDEST

MODULES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "modules")
_MISSING = ("glint's Python package was not found, so the viewport cannot be rendered (F12 can): take the add-on with the "
            "programs inside from a release of glint, or install the package for Blender's Python {}.{}: {}")


def find():
    """(the module, "") or (None, why there is none)."""
    if os.path.isdir(MODULES) and MODULES not in sys.path:
        sys.path.insert(0, MODULES)
    try:
        import glint  # pylint: disable=import-outside-toplevel
    except ImportError as error:
        return None, _MISSING.format(*sys.version_info[:2], error)
    version = getattr(glint, "__version__", "")
    version = version() if callable(version) else version
    if tuple(map(int, re.findall(r"\d+", version)[:2])) < OLDEST:
        return None, f"glint's Python package is version {version}: this add-on needs {'.'.join(map(str, OLDEST))} or later"
    # Likely mistakes of a scene are for the export and for F12, not for each picture of the viewport.
    warnings.filterwarnings("ignore", category=glint.GlintWarning)
    return glint, ""
