# SPDX-License-Identifier: Apache-2.0
"""Writing files: completely or not at all."""
import os
import stat
import tempfile


def write_new(folder, name, content):
    """Writes bytes, unless there is such a file: its name tells its content. Makes the folder. Raises OSError."""
    path = os.path.join(folder, name)
    if not os.path.exists(path):
        os.makedirs(folder, exist_ok=True)
        with open(path + ".part", "wb") as file:
            file.write(content)
        os.replace(path + ".part", path)


def write_text(path, text):
    """Writes UTF-8. Raises OSError; then an older file is unchanged."""
    folder = os.path.dirname(os.path.abspath(path))
    descriptor, temporary = tempfile.mkstemp(prefix=".glint-", dir=folder)
    try:
        with os.fdopen(descriptor, "w", encoding="utf-8", errors="replace", newline="\n") as file:
            file.write(text)
        try:
            mode = stat.S_IMODE(os.stat(path).st_mode)
        except OSError:
            mask = os.umask(0)
            os.umask(mask)
            mode = 0o666 & ~mask
        os.chmod(temporary, mode)
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise
