"""The C++ files of the tree, for the checks beside this file."""
import pathlib

FOLDERS = ["core", "cpu", "cuda", "contact", "models", "run", "viz", "app", "examples", "tests"]
SUFFIXES = {".hpp", ".cpp", ".cu", ".cuh"}


def cpp_files(root, folders=FOLDERS):
    """Paths relative to `root`, sorted."""
    root = pathlib.Path(root)
    found = (p.relative_to(root) for f in folders if (root / f).is_dir() for p in (root / f).rglob("*"))
    return sorted(p for p in found if p.suffix in SUFFIXES)


def without_comments(text):
    """The code with comments, strings and preprocessor lines blanked; line breaks stay."""
    out, i, n = [], 0, len(text)
    while i < n:
        two = text[i:i + 2]
        if two == "//":
            end = text.find("\n", i)
            i = n if end < 0 else end
        elif two == "/*":
            end = text.find("*/", i + 2)
            end = n if end < 0 else end + 2
            out.append("\n" * text.count("\n", i, end))
            i = end
        elif text.startswith('R"', i):
            opening = text.index("(", i)
            closing = ")" + text[i + 2:opening] + '"'
            end = text.index(closing, opening) + len(closing)
            out.append('""' + "\n" * text.count("\n", i, end))
            i = end
        elif text[i] == "'" and out and out[-1][-1:].isalnum() and text[i + 1:i + 2].isalnum():
            i += 1  # digit separator
        elif text[i] in "\"'":
            quote, start = text[i], i
            i += 1
            while i < n and text[i] != quote and text[i] != "\n":
                i += 2 if text[i] == "\\" else 1
            i += 1
            out.append(quote + quote + "\n" * text.count("\n", start, i))
        elif text[i] == "#" and (not out or "".join(out[-200:]).rsplit("\n", 1)[-1].strip() == ""):
            while i < n and text[i] != "\n":
                i += 2 if two[:1] != "\n" and text[i] == "\\" and text[i + 1:i + 2] == "\n" else 1
        else:
            out.append(text[i])
            i += 1
    return "".join(out)
