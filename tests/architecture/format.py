#!/usr/bin/env python3
"""Says which of the project's C++ files clang-format 14 would change (--fix: changes them). Skips without that version."""
import pathlib
import shutil
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parents[2]
program = shutil.which("clang-format-14") or shutil.which("clang-format")
version = subprocess.run([program, "--version"], capture_output=True, text=True).stdout if program else ""
if " 14." not in version:
    print("clang-format 14 is not here: formatting is not checked.")
    sys.exit(77)
files = [p for folder in ("src", "tests", "benchmarks", "fuzz") for p in sorted((root / folder).rglob("*")) if p.suffix in (".h", ".cpp")]
if not files:
    sys.exit("no file was found to check")
if "--fix" in sys.argv:
    sys.exit(subprocess.run([program, "-i", *map(str, files)]).returncode)
differ = []
for path in files:
    text = path.read_bytes()
    if subprocess.run([program, f"--assume-filename={path}"], input=text, capture_output=True, check=True).stdout != text:
        differ.append(str(path.relative_to(root)))
for name in differ:
    print(f"{name}: clang-format 14 would change it")
if differ:
    print("tests/architecture/format.py --fix formats everything.")
sys.exit(1 if differ else 0)
