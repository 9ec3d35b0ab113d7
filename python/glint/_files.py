# SPDX-License-Identifier: Apache-2.0
"""Files that are written whole or not at all."""

from __future__ import annotations

import os
import stat
import tempfile


def write_file(path: str, content: bytes) -> None:
    """Writes a temporary file beside `path` and renames it, as the command does: if an error (OSError) is raised,
    the old file is as it was. Permissions are kept, and links followed. What is no file, such as /dev/stdout or a
    pipe, is written to directly."""
    target = os.path.realpath(path)
    try:
        mode = os.stat(target).st_mode
    except FileNotFoundError:
        mask = os.umask(0)
        os.umask(mask)
        mode = stat.S_IFREG | (0o666 & ~mask)
    else:
        if not stat.S_ISREG(mode):
            with open(path, "wb") as file:
                file.write(content)
            return
        if not os.access(target, os.W_OK):
            raise PermissionError(13, os.strerror(13), path)
    try:
        descriptor, temporary = tempfile.mkstemp(".tmp", ".glint-", os.path.dirname(target))
    except OSError as error:
        raise type(error)(error.errno, error.strerror, path) from None
    try:
        with open(descriptor, "wb") as file:
            os.fchmod(descriptor, stat.S_IMODE(mode))
            file.write(content)
        os.replace(temporary, target)
    except BaseException as error:
        os.unlink(temporary)
        if isinstance(error, OSError):
            raise type(error)(error.errno, error.strerror, path) from None
        raise
