"""Reads the arrays of a .vtu that Glisson wrote; Python's standard library only."""
import base64
import struct
import xml.etree.ElementTree as ElementTree
import zlib

CODES = {"Float32": "f", "Float64": "d", "Int32": "i", "Int64": "q", "UInt8": "B"}


def decoded(text):
    """Blocks of vtkZLibDataCompressor behind a header of 64-bit numbers: count, size, last size, compressed sizes."""
    first = base64.b64decode(text[:32])
    count = struct.unpack("<Q", first[:8])[0]
    length = (8 * (3 + count) + 2) // 3 * 4
    sizes = struct.unpack(f"<{3 + count}Q", base64.b64decode(text[:length]))[3:]
    packed, at, raw = base64.b64decode(text[length:]), 0, b""
    for size in sizes:
        raw += zlib.decompress(packed[at:at + size])
        at += size
    return raw


def arrays(path):
    """name -> numbers, or tuples of as many as the array has components."""
    result = {}
    for array in ElementTree.parse(path).iter("DataArray"):
        if array.get("format") != "binary":
            continue
        raw, code = decoded(array.text.strip()), CODES[array.get("type")]
        numbers = struct.unpack(f"<{len(raw) // struct.calcsize(code)}{code}", raw)
        components = int(array.get("NumberOfComponents", 1))
        result[array.get("Name")] = numbers if components == 1 else list(zip(*[iter(numbers)] * components))
    return result
