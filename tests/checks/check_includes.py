#!/usr/bin/env python3
"""Fails when a folder includes a folder that it must not know, or when CUDA leaks out of its files.

usage: check_includes.py ROOT
The arrows are those of ARCHITECTURE.md.
"""
import pathlib
import re
import sys

from sources import cpp_files

MAY_INCLUDE = {
    "core": set(),
    "cpu": {"core"},
    "cuda": {"core"},
    "models": {"core"},
    "contact": {"core"},
    "shells": {"core"},
    "run": {"core", "cpu", "cuda", "models", "contact", "shells"},
    "viz": {"core", "models", "contact"},
    "app": {"core", "cpu", "models", "contact", "shells", "run", "viz"},
}
# The library has no console; only the command line, tests and examples print.
PRINTS = re.compile(r"#\s*include\s*<(iostream|print)>|\bstd::(cout|cerr|clog)\b|\b(f?printf|f?puts)\s*\(")
CUDA = re.compile(r"cuda_runtime|__global__|__device__|__host__|<<<|__syncthreads|__shfl|__shared__|__launch_bounds__")
INCLUDE = re.compile(r"\s*#\s*include\s*[<\"](?:glisson/)?(\w+)/")
CUDA_OK = "core/base/host_device.hpp"


def errors_in(path, text):
    folder = path.parts[0]
    allowed = MAY_INCLUDE.get(folder)
    for number, line in enumerate(text.splitlines(), 1):
        code = line.split("//")[0]
        place = f"{path}:{number}"
        included = INCLUDE.match(line)
        if allowed is not None and included and included[1] in MAY_INCLUDE and included[1] not in allowed | {folder}:
            yield f"{place}: {folder}/ must not include {included[1]}/"
        if included and "glisson/" not in line and included[1] in MAY_INCLUDE and folder != "tests":
            yield f"{place}: include by the full path, <glisson/{included[1]}/...>"
        if included and 'Eigen/' in line and path.suffix != ".cpp":
            yield f"{place}: Eigen only in host .cpp files"
        if allowed is not None and folder != "app" and path.name != "main.cpp" and PRINTS.search(code):
            yield f"{place}: the library never prints"
        if folder not in ("cuda", "tests") and path.as_posix() != CUDA_OK and CUDA.search(code):
            yield f"{place}: CUDA outside cuda/"
        if "CLI/" in line and line.lstrip().startswith("#") and path.as_posix() != "app/command_line.cpp":
            yield f"{place}: CLI11 costs seconds per file; only app/command_line.cpp includes it"


def main():
    root = pathlib.Path(sys.argv[1])
    files = cpp_files(root)
    errors = [e for path in files for e in errors_in(path, (root / path).read_text())]
    print(*errors, f"{len(files)} files, {len(errors)} errors", sep="\n")
    sys.exit(bool(errors))


main()
