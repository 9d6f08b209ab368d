#!/usr/bin/env python3
"""Writes the pictures beside this script: PNG files of the kinds that readers treat differently.

The pixel (x, y) of the small ones, 5 x 4, has the number n = x + 5 y; tests/core/io/media/GreyImageFileTest.cpp
knows their values.
"""
import pathlib
import struct
import zlib

FOLDER = pathlib.Path(__file__).parent
GREY, COLOUR, PALETTE, COLOUR_OPACITY = 0, 2, 3, 6
PASSES = [(0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2)]


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def packed(values, bits):
    if bits == 16:
        return b"".join(struct.pack(">H", value) for value in values)
    if bits == 8:
        return bytes(values)
    digits = "".join(format(value, f"0{bits}b") for value in values)
    digits += "0" * (-len(digits) % 8)
    return bytes(int(digits[k : k + 8], 2) for k in range(0, len(digits), 8))


def write(name, width, height, kind, bits, pixel, others=(), interlaced=False):
    def row(y, columns):
        return b"\0" + packed([value for x in columns for value in pixel(x, y)], bits)

    rows = b""
    for left, top, across, down in PASSES if interlaced else [(0, 0, 1, 1)]:
        if left < width:
            rows += b"".join(row(y, range(left, width, across)) for y in range(top, height, down))
    header = struct.pack(">IIBBBBB", width, height, bits, kind, 0, 0, int(interlaced))
    chunks = [(b"IHDR", header), *others, (b"IDAT", zlib.compress(rows, 9)), (b"IEND", b"")]
    png = b"\x89PNG\r\n\x1a\n" + b"".join(chunk(*each) for each in chunks)
    (FOLDER / name).write_bytes(png)


write("grey-1.png", 5, 4, GREY, 1, lambda x, y: [(x + y) % 2])
write("grey-16.png", 5, 4, GREY, 16, lambda x, y: [3000 * (x + 5 * y)])
write("colour-8.png", 5, 4, COLOUR, 8, lambda x, y: [x + 5 * y, 40, 80])
write("colour-16-interlaced.png", 5, 4, COLOUR_OPACITY, 16, lambda x, y: [1000 * (x + 5 * y)] * 3 + [65535 - x],
      interlaced=True)
palette = (b"PLTE", bytes(value for n in range(20) for value in (10 * n,) * 3))
write("palette.png", 5, 4, PALETTE, 8, lambda x, y: [x + 5 * y], [palette, (b"tRNS", bytes([0, 128]))])
# Black on the left, white on the right.
write("large.png", 2050, 1025, GREY, 8, lambda x, y: [0 if x < 1025 else 255])
write("wide.png", 1100, 2, GREY, 8, lambda x, y: [255 * (x >= 550)])
# A dark crack from the lower left to the upper right.
write("crack.png", 64, 64, GREY, 8, lambda x, y: [min(255, 40 * abs(x + y - 63))])
