# SPDX-License-Identifier: Apache-2.0
"""Reads the OpenEXR files that glint writes: scan lines of 32-bit floats or integers, in ZIP blocks, in one or more parts.
Pure Python."""
import struct
import sys
import zlib
from array import array
from itertools import accumulate

_MULTIPART = 0x1000
_LINES = {0: 1, 2: 1, 3: 16}  # by compression: none, ZIPS, ZIP
_KINDS = {0: "I", 2: "f"}


class ExrError(ValueError):
    """The file is not one that glint writes."""


class Part:
    """One part. channels: name -> array of width * height numbers, rows from the top."""

    def __init__(self, name, width, height, channels):
        self.name, self.width, self.height, self.channels = name, width, height, channels


def _text(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode("latin-1"), end + 1


def _header(data, at):
    attributes = {}
    while data[at]:
        name, at = _text(data, at)
        _, at = _text(data, at)
        (size,) = struct.unpack_from("<i", data, at)
        attributes[name] = data[at + 4:at + 4 + size]
        at += 4 + size
    return attributes, at + 1


def _channel_list(value):
    """[(name, type code)] in the order in which the file stores them."""
    out, at = [], 0
    while value[at]:
        name, at = _text(value, at)
        (kind,) = struct.unpack_from("<i", value, at)
        if kind not in _KINDS:
            raise ExrError("half floats are not read")
        out.append((name, _KINDS[kind]))
        at += 16
    return out


def _unzip(data, size):
    if len(data) == size:
        return data  # stored as it is, because ZIP did not make it smaller
    raw = zlib.decompress(data)
    # The predictor: each byte is the difference to the one before, plus 128.
    plain = bytes([v & 255 for v in accumulate(raw, lambda a, b: a + b - 128)])
    half = (len(plain) + 1) // 2
    out = bytearray(len(plain))
    out[0::2], out[1::2] = plain[:half], plain[half:]
    return bytes(out)


def read(path):
    """The file's parts. Raises OSError or ExrError."""
    with open(path, "rb") as file:
        data = file.read()
    try:
        return _read(data)
    except (IndexError, struct.error, zlib.error, KeyError, ValueError) as error:
        raise ExrError(f"{path}: {error}") from None


def _read(data):
    magic, version = struct.unpack_from("<ii", data, 0)
    if magic != 20000630:
        raise ExrError("not an OpenEXR file")
    at, headers = 8, []
    while True:
        attributes, at = _header(data, at)
        headers.append(attributes)
        if not version & _MULTIPART:
            break
        if not data[at]:
            at += 1
            break
    parts, blocks = [], []
    for attributes in headers:
        x0, y0, x1, y1 = struct.unpack("<4i", attributes["dataWindow"])
        width, height = x1 - x0 + 1, y1 - y0 + 1
        channels = _channel_list(attributes["channels"])
        name = attributes.get("name", b"").decode("latin-1")
        parts.append(Part(name, width, height, {n: array(kind, bytes(4 * width * height)) for n, kind in channels}))
        lines = _LINES[attributes["compression"][0]]
        blocks.append((y0, lines, channels, attributes["compression"][0], -(-height // lines)))
    for part, (y0, lines, channels, compression, count) in zip(parts, blocks):
        for offset in struct.unpack_from(f"<{count}q", data, at):
            _read_block(data, offset + (4 if version & _MULTIPART else 0), part, y0, lines, channels, compression)
        at += 8 * count
    return parts


def _read_block(data, at, part, y0, lines, channels, compression):
    y, size = struct.unpack_from("<ii", data, at)
    rows = min(lines, part.height - (y - y0))
    row = 4 * part.width
    raw = data[at + 8:at + 8 + size]
    if compression:
        raw = _unzip(raw, rows * row * len(channels))
    for i in range(rows):
        for c, (name, kind) in enumerate(channels):
            begin = (i * len(channels) + c) * row
            values = array(kind, raw[begin:begin + row])
            if sys.byteorder == "big":
                values.byteswap()
            first = (y - y0 + i) * part.width
            part.channels[name][first:first + part.width] = values
