"""Compiles every header by itself, included twice: each brings what it needs, and only once.

usage: headers_alone.py INCLUDE_DIRECTORY COMPILER FLAG...
"""
import pathlib
import subprocess
import sys

root, *compiler = sys.argv[1:]
headers = sorted(path.relative_to(root).as_posix() for path in pathlib.Path(root).rglob("*.hpp"))
failures = []
for header in headers:
    program = f"#include <{header}>\n" * 2
    run = subprocess.run([*compiler, f"-I{root}", "-fsyntax-only", "-x", "c++", "-"],
                         input=program, capture_output=True, text=True)
    if run.returncode != 0:
        failures.append(f"{header} does not compile by itself:\n{run.stderr}")
print(f"{len(headers)} headers, {len(failures)} do not compile by themselves")
sys.exit("\n".join(failures) or (0 if headers else "no headers found"))
