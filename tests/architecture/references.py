#!/usr/bin/env python3
"""Checks that every citation in the sources, [Name Year ...], has an entry in docs/references.md."""
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parents[2]
# [Whitted 1980], [Daimon and Masumura 2002, eq. 3], [Sultanova et al. 2009]; standards by their number: [CIE 15:2004], [IEC 61966-2-1].
CITATION = re.compile(r"\[((?:[A-Z][\w'.-]+|and|et|al\.|&|,|de|van|von)(?: (?:[A-Z][\w'.-]+|and|et al\.|&|de|van|von))*,? (?:1[6-9]|20)\d\d[a-z]?|(?:CIE|IEC|ISO) [\d:.-]*\d)")
entries = set(re.findall(r"^- \*\*\[([^\]]+)\]\*\* \S", (root / "docs" / "references.md").read_text(encoding="utf-8"), re.MULTILINE))
problems, cited = [], set()
for folder in ("src", "shaders", "tests", "benchmarks"):
    for path in sorted((root / folder).rglob("*")):
        if path.suffix not in (".h", ".cpp", ".comp"):
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            for name in CITATION.findall(line):
                cited.add(name)
                if name not in entries:
                    problems.append(f"{path.relative_to(root)}:{number}: docs/references.md lacks [{name}]")
if not cited:
    problems.append("no citation was found")
print("\n".join(problems) or f"{len(cited)} works are cited; docs/references.md lists them all.")
for name in sorted(entries - cited):
    print(f"note: nobody cites [{name}]")
sys.exit(1 if problems else 0)
