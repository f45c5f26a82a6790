"""Reads a PNG of 8-bit RGB and compares two of them by structure; Python's standard library only."""
import struct
import zlib

BACKGROUND = 246  # luminance of an empty place


def luminance(path):
    """Rows of grey values 0..255."""
    with open(path, "rb") as file:
        data = file.read()
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError(f"{path} is no PNG")
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
        packed += body if kind == b"IDAT" else b""
        at += 12 + length
    if depth != 8 or colour not in (2, 6):
        raise ValueError(f"{path} is not 8-bit RGB")
    step = 3 if colour == 2 else 4
    raw, previous, rows = zlib.decompress(packed), bytearray(width * step), []
    for y in range(height):
        start = y * (width * step + 1)
        previous = unfilter(raw[start], bytearray(raw[start + 1:start + 1 + width * step]), previous, step)
        rows.append([(299 * previous[i] + 587 * previous[i + 1] + 114 * previous[i + 2]) // 1000
                     for i in range(0, width * step, step)])
    return rows


def unfilter(kind, line, above, step):
    for i in range(len(line)):
        left, up, corner = (line[i - step] if i >= step else 0), above[i], (above[i - step] if i >= step else 0)
        if kind == 4:
            guess = left + up - corner
            by = min((left, up, corner), key=lambda v: abs(guess - v))
        else:
            by = (0, left, up, (left + up) // 2)[kind]
        line[i] = (line[i] + by) & 255
    return line


def blocks(rows, size=10):
    """Means over squares of `size` pixels."""
    return [[sum(sum(row[x:x + size]) for row in rows[y:y + size]) / size ** 2
             for x in range(0, len(rows[0]) - size + 1, size)] for y in range(0, len(rows) - size + 1, size)]


def similarity(one, other):
    """(correlation of the blocks' luminance, overlap of the silhouettes as intersection over union)."""
    a, b = ([v for row in blocks(rows) for v in row] for rows in (one, other))
    mean_a, mean_b = sum(a) / len(a), sum(b) / len(b)
    product = sum((x - mean_a) * (y - mean_b) for x, y in zip(a, b))
    norm = (sum((x - mean_a) ** 2 for x in a) * sum((y - mean_b) ** 2 for y in b)) ** 0.5
    inside = [(abs(x - BACKGROUND) > 8, abs(y - BACKGROUND) > 8) for x, y in zip(a, b)]
    union = sum(x or y for x, y in inside)
    return product / norm if norm else 0.0, sum(x and y for x, y in inside) / union if union else 0.0
