# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""Pixels of PNG files of 8 bits per sample."""
import struct
import zlib

import numpy as np


def _unfiltered(rows, width, channels):
    """PNG's five filters, taken back row by row."""
    above, lines = np.zeros(width * channels, np.uint8), []
    for row in rows:
        kind, line = row[0], row[1:].astype(np.uint8)
        if kind == 2:
            line = line + above
        elif kind in (1, 3, 4):
            for k in range(len(line)):
                left = int(line[k - channels]) if k >= channels else 0
                up, corner = int(above[k]), int(above[k - channels]) if k >= channels else 0
                guess = left + up - corner
                nearest = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]
                line[k] = (int(line[k]) + {1: left, 3: (left + up) // 2, 4: nearest}[kind]) & 255
        lines.append(line)
        above = line
    return np.array(lines)


def pixels_of(name):
    """Array of (height, width, 3)."""
    with open(name, "rb") as file:
        data = file.read()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", name
    place, packed = 8, b""
    while place < len(data):
        size, kind = struct.unpack(">I4s", data[place:place + 8])
        body = data[place + 8:place + 8 + size]
        if kind == b"IHDR":
            width, height, bits, colours = struct.unpack(">IIBB", body[:10])
        packed += body if kind == b"IDAT" else b""
        place += 12 + size
    channels = {2: 3, 6: 4}[colours]
    assert bits == 8
    rows = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(height, 1 + channels * width)
    return _unfiltered(rows, width, channels).reshape(height, width, channels)[:, :, :3]
