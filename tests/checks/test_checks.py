#!/usr/bin/env python3
"""The checks find what they are for: each is run on a small tree with one mistake in it."""
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
LONG = "int f(int a) {\n" + "  ++a;\n" * 60 + "  return a;\n}\n"
CASES = [  # script, file, content, expected text
    ("check_includes.py", "core/a.hpp", "#include <glisson/cpu/b.hpp>\n", "core/ must not include cpu/"),
    ("check_includes.py", "models/a.cpp", "#include <glisson/run/b.hpp>\n", "models/ must not include run/"),
    ("check_includes.py", "core/a.hpp", "#include <Eigen/Core>\n", "Eigen only in host"),
    ("check_includes.py", "core/a.hpp", "__global__ void f();\n", "CUDA outside cuda/"),
    ("check_includes.py", "models/a.cpp", "void f() { std::cout << 1; }\n", "never prints"),
    ("check_includes.py", "app/a.cpp", "#include <CLI/CLI.hpp>\n", "CLI11"),
    ("check_includes.py", "core/a.hpp", "// __global__ in a comment\n#include <glisson/core/b.hpp>\n", None),
    ("check_includes.py", "cuda/a.cu", "__global__ void f();\n", None),
    ("check_size.py", "core/a.cpp", LONG, "function of 63 lines"),
    ("check_size.py", "core/a.cpp", "\n" * 401, "file of 401 lines"),
    ("check_size.py", "core/a.cpp", "//" + "x" * 120 + "\n", "line of 122 characters"),
    ("check_size.py", "core/a.cpp", "namespace a {\n" + "int x;\n" * 80 + "}\n", None),
    ("check_size.py", "core/a.cpp", "struct A {\n" + "int f() { return 1; }\n" * 80 + "};\n", None),
    ("check_size.py", "core/a.cpp", "A::A(int x) : x_(x) {\n" + "x;\n" * 70 + "}\n", "function of 72 lines"),
    ("check_size.py", "core/a.cpp", 'auto s = "{ } (";\nint f() {\n}\n' + "// }\n" * 70, None),
]


def main():
    failures = 0
    for script, name, content, expected in CASES:
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, name)
            path.parent.mkdir(parents=True)
            path.write_text(content)
            done = subprocess.run([sys.executable, HERE / script, folder], capture_output=True, text=True)
        good = done.returncode == (expected is not None) and (expected or "") in done.stdout
        if not good:
            failures += 1
            print(f"{script} on {name} {content[:40]!r}: expected {expected!r}, got\n{done.stdout}{done.stderr}")
    print(f"{len(CASES)} cases, {failures} failures")
    sys.exit(bool(failures))


main()
