#!/usr/bin/env python3
"""Fails when a file, a function or a line is longer than the style card allows.

usage: check_size.py ROOT [--largest N]
"""
import argparse
import pathlib
import re

from sources import cpp_files, without_comments

LIMITS = {"file": 400, "function": 60, "line": 110}
# path -> {what: (limit, reason)}; every entry is a debt that needs a reason.
EXCEPTIONS = {}

CONTROL = re.compile(r"^\s*(if|for|while|switch|catch|do|else|try|return|namespace|enum|extern)\b")
SIGNATURE = re.compile(r"\)\s*(const|noexcept|override|final|mutable|&|&&|\s)*(->[^{;]*)?(requires[^{;]*)?$")
INITIALISERS = re.compile(r"\)\s*(noexcept\s*)?:\s*[\w:]+\s*[({]")


def functions(text):
    """(first line, length) of every function body; lambdas count with the function around them."""
    code = without_comments(text)
    stack, statement, start_line, line = [], "", 1, 1
    for c in code:
        if c == "\n":
            line += 1
        if c == "{":
            head = statement.strip()
            inside = any(kind == "function" for kind, _ in stack)
            is_function = (not inside and not CONTROL.match(head) and "(" in head
                           and (SIGNATURE.search(head) or INITIALISERS.search(head)))
            stack.append(("function" if is_function else "other", start_line))
            statement = ""
        elif c == "}":
            if stack:
                kind, first = stack.pop()
                if kind == "function":
                    yield first, line - first + 1
            statement = ""
        elif c == ";":
            statement = ""
        else:
            if not statement.strip() and not c.isspace():
                start_line = line
            statement += c


def measures(path, text):
    """(what, place, value) of everything that has a limit."""
    lines = text.splitlines()
    yield "file", str(path), len(lines)
    for number, line in enumerate(lines, 1):
        if len(line) > LIMITS["line"]:
            yield "line", f"{path}:{number}", len(line)
    for first, length in functions(text):
        yield "function", f"{path}:{first}", length


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--largest", type=int, default=0)
    arguments = parser.parse_args()
    found, errors = {"file": [], "function": [], "line": []}, []
    for path in cpp_files(arguments.root):
        exceptions = EXCEPTIONS.get(path.as_posix(), {})
        for what, place, value in measures(path, (arguments.root / path).read_text()):
            found[what].append((value, place))
            limit = exceptions.get(what, (LIMITS[what], ""))[0]
            if value > limit:
                errors.append(f"{place}: {what} of {value} "
                              f"{'characters' if what == 'line' else 'lines'}, limit {limit}")
    for what in ("file", "function"):
        values = sorted(found[what])
        if values:
            p90 = values[int(0.9 * (len(values) - 1))][0]
            print(f"{what}: {len(values)}, median {values[len(values) // 2][0]}, p90 {p90}, largest {values[-1][0]}")
        for value, place in reversed(values[len(values) - arguments.largest:] if arguments.largest else []):
            print(f"  {value:4} {place}")
    print(*errors[:50], f"{len(errors)} over the limit", sep="\n")
    raise SystemExit(bool(errors))


main()
