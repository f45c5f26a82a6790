#!/usr/bin/env python3
"""picture.py BEFORE.vtu AFTER.vtu OUT.png: a solid at rest and deformed, coloured by displacement. Python's standard library only."""
import base64
import math
import re
import struct
import sys
import zlib

WIDTH, HEIGHT, MARGIN = 520, 430, 16
TYPES = {"Float32": "f", "Float64": "d", "Int32": "i", "Int64": "q", "UInt8": "B"}


def arrays(path):
    """Every DataArray of a VTU file with inline base64 and zlib blocks, by name."""
    text = open(path, encoding="ascii", errors="replace").read()
    word = "I" if 'header_type="UInt32"' in text else "Q"
    size = struct.calcsize(word)
    found = {}
    for attributes, body in re.findall(r"<DataArray([^>]*)>([^<]*)</DataArray>", text):
        name = re.search(r'Name="([^"]*)"', attributes)[1]
        letter = TYPES[re.search(r'type="([^"]*)"', attributes)[1]]
        body = re.sub(r"\s+", "", body)
        if 'format="binary"' not in attributes:
            continue
        count = struct.unpack("<" + word, base64.b64decode(body[:16])[:size])[0]
        head = -(-size * (3 + count) // 3) * 4
        lengths = struct.unpack(f"<{3 + count}{word}", base64.b64decode(body[:head])[: size * (3 + count)])[3:]
        data, start, packed = b"", 0, base64.b64decode(body[head:])
        for length in lengths:
            data += zlib.decompress(packed[start : start + length])
            start += length
        found[name] = struct.unpack(f"<{len(data) // struct.calcsize(letter)}{letter}", data)
    return found


def outer_faces(found):
    faces = {"4": ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)),
             "8": ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))}
    nodes, begin, count = found["connectivity"], 0, {}
    for end in found["offsets"]:
        element = nodes[begin:end]
        for face in faces[str(end - begin)]:
            corners = tuple(element[a] for a in face)
            key = tuple(sorted(corners))
            count[key] = None if key in count else corners
        begin = end
    for corners in filter(None, count.values()):
        yield corners[:3]
        if len(corners) == 4:
            yield (corners[0], corners[2], corners[3])


def view(p):
    """Seen from the front, a little from the right and above."""
    a, b = math.radians(-35), math.radians(20)
    x, y = p[0] * math.cos(a) - p[1] * math.sin(a), p[0] * math.sin(a) + p[1] * math.cos(a)
    return x, p[2] * math.cos(b) + y * math.sin(b), p[2] * math.sin(b) - y * math.cos(b)


def colour(t, shade):
    stops = ((70, 90, 170), (90, 170, 190), (235, 220, 130), (200, 60, 50))
    s = min(max(t, 0), 0.9999) * 3
    lower, upper, f = stops[int(s)], stops[int(s) + 1], s - int(s)
    return tuple(int((a + (b - a) * f) * shade) for a, b in zip(lower, upper))


def draw(pixels, depth, left, points, triangles, value, scale, centre):
    screen = [(left + WIDTH / 2 + scale * (x - centre[0]), HEIGHT / 2 - scale * (y - centre[1]), z) for x, y, z in points]
    for i, j, k in triangles:
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = screen[i], screen[j], screen[k]
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        if area >= 0:
            continue  # turned away
        u = [q - p for p, q in zip(points[i], points[j])]
        v = [q - p for p, q in zip(points[i], points[k])]
        n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        length = math.sqrt(sum(c * c for c in n)) or 1
        shade = 0.45 + 0.55 * abs(0.3 * n[0] + 0.5 * n[1] + 0.8 * n[2]) / length / 0.99
        paint = colour((value[i] + value[j] + value[k]) / 3, min(shade, 1))
        for y in range(max(int(min(ay, by, cy)), 0), min(int(max(ay, by, cy)) + 1, HEIGHT - 1) + 1):
            for x in range(max(int(min(ax, bx, cx)), 0), min(int(max(ax, bx, cx)) + 1, 2 * WIDTH - 1) + 1):
                w0 = ((bx - x) * (cy - y) - (by - y) * (cx - x)) / area
                w1 = ((cx - x) * (ay - y) - (cy - y) * (ax - x)) / area
                if w0 < -0.01 or w1 < -0.01 or w0 + w1 > 1.01:
                    continue
                z = w0 * az + w1 * bz + (1 - w0 - w1) * cz
                if z > depth[y][x]:
                    depth[y][x], pixels[y][x] = z, paint


def write_png(path, pixels):
    rows = b"".join(b"\0" + bytes(c for pixel in row for c in pixel) for row in pixels)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", 2 * WIDTH, HEIGHT, 8, 2, 0, 0, 0)
    with open(path, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def main():
    found = [arrays(path) for path in sys.argv[1:3]]
    rest = found[0]["Points"] if "Points" in found[0] else found[0]["points"]
    X = [rest[3 * n : 3 * n + 3] for n in range(len(rest) // 3)]
    triangles = list(outer_faces(found[0]))
    shapes = []
    for one in found:
        u = one["displacement"]
        u = [u[3 * n : 3 * n + 3] for n in range(len(X))]
        shapes.append(([view([a + b for a, b in zip(x, d)]) for x, d in zip(X, u)], [math.sqrt(sum(c * c for c in d)) for d in u]))
    largest = max(shapes[1][1]) or 1
    every = [p for points, _ in shapes for p in points]
    low, high = [min(p[a] for p in every) for a in (0, 1)], [max(p[a] for p in every) for a in (0, 1)]
    scale = min((WIDTH - 2 * MARGIN) / (high[0] - low[0]), (HEIGHT - 2 * MARGIN) / (high[1] - low[1]))
    centre = [(a + b) / 2 for a, b in zip(low, high)]
    pixels = [[(255, 255, 255)] * (2 * WIDTH) for _ in range(HEIGHT)]
    depth = [[-1e30] * (2 * WIDTH) for _ in range(HEIGHT)]
    for k, (points, size) in enumerate(shapes):
        draw(pixels, depth, k * WIDTH, points, triangles, [s / largest for s in size], scale, centre)
    write_png(sys.argv[3], pixels)
    print(f"{sys.argv[3]}: left at rest, right deformed; red is {largest:.4g}")


if __name__ == "__main__":
    main()
