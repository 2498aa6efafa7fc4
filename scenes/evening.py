#!/usr/bin/env python3
"""Makes evening.hdr, the sky of gold.toml: a low sun between clouds, over hills. Nothing of it was photographed.

    scenes/evening.py [WIDTH]      writes evening.hdr beside itself; WIDTH / 2 rows, 256 x 128 when left out

The picture has all longitudes from left to right and all latitudes from top to bottom. Change it, run it, and render.
"""
import math
import os
import sys


def smooth(edge0, edge1, x):
    t = min(max((x - edge0) / (edge1 - edge0), 0.0), 1.0)
    return t * t * (3 - 2 * t)


def mix(a, b, t):
    return [x + (y - x) * t for x, y in zip(a, b)]


def clouds(azimuth, elevation):
    """Bands that thin out upwards: 0 to 1."""
    turn = azimuth + 0.35 * math.sin(3 * azimuth) + 0.9 * elevation
    wave = (math.sin(5 * turn + 9 * elevation) + 0.6 * math.sin(11 * turn - 31 * elevation + 1.3)
            + 0.4 * math.sin(23 * turn + 47 * elevation + 0.4) + 0.25 * math.sin(41 * turn - 83 * elevation))
    return smooth(0.35, 1.3, wave) * smooth(0.02, 0.15, elevation) * smooth(1.25, 0.5, elevation)


def radiance(azimuth, elevation):
    """Linear red, green and blue. The sun stands at azimuth 0.5 radians, 0.1 above the horizon; the hills lie below it."""
    hills = -0.045 + 0.022 * math.sin(4 * azimuth + 1) + 0.012 * math.sin(9 * azimuth)
    cosine = (math.cos(elevation) * math.cos(0.1) * math.cos(azimuth - 0.5) + math.sin(elevation) * math.sin(0.1))
    apart = math.acos(min(max(cosine, -1.0), 1.0))
    up = math.sin(max(elevation, 0.0))
    sky = mix([0.80, 0.46, 0.24], [0.24, 0.38, 0.62], smooth(0.0, 0.35, up))
    sky = mix(sky, [0.07, 0.15, 0.36], smooth(0.25, 1.0, up))
    glow = math.exp(-apart / 0.28)
    sky = [s + g * glow for s, g in zip(sky, [2.0, 0.95, 0.30])]
    lit = mix([0.32, 0.30, 0.36], [1.9, 1.05, 0.55], math.exp(-apart / 0.7))
    sky = mix(sky, lit, 0.85 * clouds(azimuth, elevation))
    # Dark hills with soft crests, and fields below them that take the colour of the evening.
    ground = mix([0.030, 0.035, 0.055], [0.16, 0.12, 0.075], smooth(hills, -0.35, elevation))
    sky = mix(ground, sky, smooth(hills - 0.012, hills + 0.012, elevation))
    if elevation < hills:
        return sky
    sun = smooth(0.15, 0.07, apart)  # veiled by haze
    return [s + g * sun for s, g in zip(sky, [16.0, 10.0, 4.5])]


def rgbe(colour):
    most = max(colour)
    if most < 1e-30:
        return (0, 0, 0, 0)
    mantissa, exponent = math.frexp(most)
    return tuple(min(int(c * mantissa * 256 / most), 255) for c in colour) + (exponent + 128,)


def coded(values):
    """One channel of a row, in stretches of up to 128 bytes: what packs the file finds more in them than in runs."""
    stretches = (values[at:at + 128] for at in range(0, len(values), 128))
    return b"".join(bytes((len(stretch),)) + bytes(stretch) for stretch in stretches)


def main():
    width = int(sys.argv[1]) if len(sys.argv) > 1 else 256
    height = width // 2
    picture = bytearray(b"#?RADIANCE\n# made by scenes/evening.py\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (height, width))
    for row in range(height):
        elevation = math.pi / 2 - math.pi * (row + 0.5) / height
        pixels = [rgbe(radiance(math.pi - 2 * math.pi * (column + 0.5) / width, elevation)) for column in range(width)]
        picture += bytes((2, 2, width >> 8, width & 255))
        for channel in range(4):
            picture += coded([pixel[channel] for pixel in pixels])
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "evening.hdr"), "wb") as file:
        file.write(picture)


main()
