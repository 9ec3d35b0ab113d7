# SPDX-License-Identifier: Apache-2.0
"""Writing PNG files from arrays of numpy, which only some images need: the others are copied as they are."""
import struct
import zlib

try:
    import numpy as np
except ImportError:  # Debian's Blender does not require it
    np = None

LEVEL = 3  # of zlib: with the filter below, photographs are hardly smaller with more


def _chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def encoded(values, bits):
    """An array (height, width, 3 or 4) of numbers from 0 to 1, rows from the top, as a PNG of 8 or 16 bits a channel."""
    height, width, channels = values.shape
    words = np.rint(np.clip(values, 0, 1) * ((1 << bits) - 1)).astype(">u2" if bits == 16 else "u1")
    rows = np.frombuffer(words.tobytes(), np.uint8).reshape(height, -1)
    lines = np.empty((height, rows.shape[1] + 1), np.uint8)
    lines[:, 0] = 2  # the filter Up: each byte less that above it
    lines[0, 1:], lines[1:, 1:] = rows[0], rows[1:] - rows[:-1]
    header = struct.pack(">IIBBBBB", width, height, bits, 6 if channels == 4 else 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + b"".join((
        _chunk(b"IHDR", header), _chunk(b"IDAT", zlib.compress(lines.tobytes(), LEVEL)), _chunk(b"IEND", b"")))
