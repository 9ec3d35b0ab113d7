# SPDX-License-Identifier: Apache-2.0
"""glint's Python package, which the viewport renders by: the add-on's own copy, else the one that Blender's Python has."""
import os
import re
import sys
import warnings

from .command import OLDEST

MODULES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "modules")
_MISSING = "glint's Python package is needed here, and is not installed. F12 and the exports work without it."
_HAS_ZIP = "linux", (3, 11)  # the platform and the Python whose package a release's zip has


def how_to_install():
    """What the user is to do for this Blender."""
    own = sys.version_info[:2]
    by_pip = "Install glint's wheel for Python {}.{} into Blender's Python: {} -m pip install FILE.whl".format(*own, sys.executable)
    if (sys.platform, own) == _HAS_ZIP:
        return f"Install the add-on's zip for Linux, io_glint-VERSION-linux-x86_64.zip, which has it. Or: {by_pip}"
    return by_pip


def find():
    """(the module, "") or (None, why there is none)."""
    if os.path.isdir(MODULES) and MODULES not in sys.path:
        sys.path.insert(0, MODULES)
    try:
        import glint  # pylint: disable=import-outside-toplevel
    except ModuleNotFoundError as error:
        if error.name == "glint":
            return None, f"{_MISSING} {how_to_install()}"
        return None, f"glint's Python package needs {error.name}, which is not installed. {how_to_install()}"
    except Exception as error:  # made for another Python or another system: anything may happen  pylint: disable=broad-except
        return None, f"glint's Python package cannot be used: {error}. {how_to_install()}"
    version = getattr(glint, "__version__", "")
    version = version() if callable(version) else version
    if tuple(map(int, re.findall(r"\d+", version)[:2])) < OLDEST:
        return None, (f"glint's Python package is version {version}: this add-on needs {'.'.join(map(str, OLDEST))} or later. "
                      f"{how_to_install()}")
    # Likely mistakes of a scene are for the export and for F12, not for each picture of the viewport.
    warnings.filterwarnings("ignore", category=glint.GlintWarning)
    return glint, ""
