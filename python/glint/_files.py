# SPDX-License-Identifier: Apache-2.0
"""Files that are written whole or not at all."""

from __future__ import annotations

import os
import stat
import tempfile
from typing import Any, Tuple

from ._expect import shown


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


def read_source(source: Any, unnamed: str) -> Tuple[str, bytes, bool]:
    """The name and the content of a file, by its path or an object with read(); and whether it is a file on a disk.

    unnamed: the name of an object without one. A text is encoded as UTF-8.
    """
    read = getattr(source, "read", None)
    if read is None:
        if not isinstance(source, (str, os.PathLike)):
            raise TypeError(f"paths: expected a path or an object with read(), found {shown(source)}")
        name = os.fspath(source)
        with open(name, "rb") as file:
            return name, file.read(), True
    content = read()
    if isinstance(content, str):
        content = content.encode()
    if not isinstance(content, (bytes, bytearray, memoryview)):
        raise TypeError(f"read() of a file object: expected bytes or a string, found {type(content).__name__}")
    name = getattr(source, "name", None)
    is_named = isinstance(name, str) and os.path.isfile(name)
    return name if isinstance(name, str) and name else unnamed, bytes(content), is_named
