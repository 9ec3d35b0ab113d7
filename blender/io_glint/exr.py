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
_MINUS_128 = bytes((v - 128) & 255 for v in range(256))


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
    # The predictor: each byte but the first is the difference to the one before, plus 128.
    differences = raw[:1] + raw[1:].translate(_MINUS_128)
    plain = bytes(map((255).__and__, accumulate(differences)))
    half = (len(plain) + 1) // 2
    out = bytearray(len(plain))
    out[0::2], out[1::2] = plain[:half], plain[half:]
    return bytes(out)


def read(path, names=None):
    """The file's parts; names: only these. Raises OSError or ExrError."""
    with open(path, "rb") as file:
        data = file.read()
    try:
        return _read(data, names)
    except (IndexError, struct.error, zlib.error, KeyError, ValueError) as error:
        raise ExrError(f"{path}: {error}") from None


def _read(data, names):
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
    parts = []
    for attributes in headers:
        x0, y0, x1, y1 = struct.unpack("<4i", attributes["dataWindow"])
        width, height = x1 - x0 + 1, y1 - y0 + 1
        channels = _channel_list(attributes["channels"])
        name = attributes.get("name", b"").decode("latin-1")
        lines = _LINES[attributes["compression"][0]]
        count = -(-height // lines)
        offsets = struct.unpack_from(f"<{count}q", data, at)
        at += 8 * count
        if names is not None and name not in names:
            continue
        part = Part(name, width, height, {n: array(kind, bytes(4 * width * height)) for n, kind in channels})
        for offset in offsets:
            _read_block(data, offset + (4 if version & _MULTIPART else 0), part, y0, lines, channels,
                        attributes["compression"][0])
        parts.append(part)
    return parts


def write_first_part(path, out):
    """Copies the first part of a file of several, the picture, into a plain file. Raises OSError or ExrError."""
    with open(path, "rb") as file:
        data = file.read()
    try:
        plain = _first_part(data)
    except (IndexError, struct.error, KeyError, ValueError) as error:
        raise ExrError(f"{path}: {error}") from None
    with open(out, "wb") as file:
        file.write(plain)


def _first_part(data):
    magic, version = struct.unpack_from("<ii", data, 0)
    if magic != 20000630 or not version & _MULTIPART:
        raise ValueError("no OpenEXR file of several parts")
    header, at = b"", 8
    while data[at]:
        begin = at
        name, at = _text(data, at)
        _, at = _text(data, at)
        at += 4 + struct.unpack_from("<i", data, at)[0]
        if name == "chunkCount":
            (count,) = struct.unpack_from("<i", data, at - 4)
        if name not in ("name", "type", "chunkCount"):
            header += data[begin:at]
    at += 1
    while data[at]:
        _, at = _header(data, at)
    blocks, offsets = [], []
    position = 8 + len(header) + 1 + 8 * count
    for offset in struct.unpack_from(f"<{count}q", data, at + 1):
        size = 8 + struct.unpack_from("<i", data, offset + 8)[0]
        blocks.append(data[offset + 4:offset + 4 + size])
        offsets.append(position)
        position += size
    return struct.pack("<ii", magic, version & ~_MULTIPART) + header + b"\0" + struct.pack(
        f"<{count}q", *offsets) + b"".join(blocks)


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
