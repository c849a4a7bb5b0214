#!/usr/bin/env python3
"""isa_symbols.py ISA=OBJECT...: what objects compiled for one instruction set define for others to link with is named after that set.

Of an inline function or template that several objects define, the linker keeps any one. If that were one with AVX-512 in it, machines
without would crash far from its source."""
import re
import subprocess
import sys

problems, seen = [], 0
for argument in sys.argv[1:]:
    isa, _, path = argument.partition("=")
    for line in subprocess.run(["nm", "--defined-only", "-C", path], check=True, capture_output=True, text=True).stdout.splitlines():
        _, kind, name = line.split(None, 2)
        if name.startswith("DW.ref."):  # the address of a function elsewhere, for the unwinder
            continue
        seen += 1
        # Upper case is global; W, V and u may be merged with those of other objects.
        if (kind.isupper() or kind == "u") and not re.search(rf"(?<![a-z0-9]){isa}(?![a-z0-9])", name):
            problems.append(f"{path.rsplit('/', 1)[-1]} ({isa}): {name}")
if seen == 0:
    problems.append("no symbols were read")
print("\n".join(problems) or f"{seen} symbols are local or named after their instruction set.")
sys.exit(1 if problems else 0)
