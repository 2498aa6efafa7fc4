#!/usr/bin/env python3
"""Makes the four images of maps.toml: bricks.png (heights), dents.png (normals), rust.png (how much) and panes.png
(colours). All of them repeat without a seam. Nothing of them was photographed.

    scenes/maps.py      writes them beside itself

Change it, run it, and render.
"""
import math
import os
import struct
import zlib


def smooth(edge0, edge1, x):
    t = min(max((x - edge0) / (edge1 - edge0), 0.0), 1.0)
    return t * t * (3 - 2 * t)


def write_png(name, width, height, pixel):
    """`pixel(u, v)`: one number or three from 0 to 1, as they stand in the file; u to the right, v upward, in 0..1."""
    rows, channels = [], 1
    for row in range(height):
        numbers = []
        for column in range(width):
            value = pixel((column + 0.5) / width, 1 - (row + 0.5) / height)
            channels = len(value) if isinstance(value, tuple) else 1
            numbers += [round(255 * min(max(x, 0.0), 1.0)) for x in (value if channels == 3 else (value,))]
        # Each byte as what is new beside its left neighbour, which packs best.
        before = [0] * channels + numbers[:-channels]
        rows.append(bytes([1]) + bytes((x - y) % 256 for x, y in zip(numbers, before)))
    part = lambda kind, data: (struct.pack('>I', len(data)) + kind + data
                               + struct.pack('>I', zlib.crc32(kind + data)))
    head = struct.pack('>IIBBBBB', width, height, 8, 2 if channels == 3 else 0, 0, 0, 0)
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), name), 'wb') as file:
        file.write(b'\x89PNG\r\n\x1a\n' + part(b'IHDR', head) + part(b'IDAT', zlib.compress(b''.join(rows), 9))
                   + part(b'IEND', b''))


def bricks(u, v):
    """Two courses of two bricks each, the upper one moved by half a brick: 1 on a brick, 0 in the mortar."""
    along, up = 2 * u + (0.5 if v > 0.5 else 0.0), 2 * v
    x, y = abs(along % 1 - 0.5), abs(up % 1 - 0.5)  # from the middle of the brick, 0.5 at its edge
    return smooth(0.485, 0.45, x) * smooth(0.47, 0.40, y)


def dents(u, v):
    """The normals of round dents, two in each copy, beside each other like the cells of a honeycomb."""
    def slope(cx, cy):
        x, y = (u - cx + 0.5) % 1 - 0.5, (v - cy + 0.5) % 1 - 0.5
        far = math.hypot(x, y)
        deep = 2.6 * smooth(0.5, 0.28, far)  # of a bowl, towards its middle
        return deep * x, deep * y
    (ax, ay), (bx, by) = slope(0.25, 0.25), slope(0.75, 0.75)
    x, y = -(ax + bx), -(ay + by)
    size = math.sqrt(x * x + y * y + 1)
    return 0.5 + 0.5 * x / size, 0.5 + 0.5 * y / size, 0.5 + 0.5 / size


def rust(u, v):
    """Spots with soft edges."""
    turn = 2 * math.pi
    wave = 0.0
    for i, j, size, at in ((1, 2, 1.0, 0.3), (2, -1, 0.9, 1.7), (3, 1, 0.7, 4.0), (-1, 4, 0.6, 2.2), (5, 3, 0.4, 5.1),
                           (4, -5, 0.4, 0.9), (7, 2, 0.25, 3.3), (-3, 8, 0.25, 1.2)):
        wave += size * math.sin(turn * (i * u + j * v) + at)
    return smooth(0.1, 1.0, wave)


def panes(u, v):
    """Four panes in a frame."""
    x, y = abs(2 * u % 1 - 0.5), abs(2 * v % 1 - 0.5)
    lit = 1.0 if max(x, y) < 0.4 else 0.0
    colour = {(0, 0): (1.0, 0.75, 0.35), (1, 0): (1.0, 0.5, 0.3), (0, 1): (0.95, 0.85, 0.5), (1, 1): (1.0, 0.7, 0.3)}
    return tuple(lit * c for c in colour[int(2 * u), int(2 * v)])


write_png('bricks.png', 64, 64, bricks)
write_png('dents.png', 32, 32, dents)
write_png('rust.png', 64, 64, rust)
write_png('panes.png', 20, 20, panes)
