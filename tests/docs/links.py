#!/usr/bin/env python3
"""Every link and picture in the documentation that points into the source tree leads somewhere; so does every heading that is linked to."""
import os
import re
import sys

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))


def pages():
    for folder in (ROOT, os.path.join(ROOT, "docs"), os.path.join(ROOT, "docs", "decisions")):
        for name in sorted(os.listdir(folder)):
            if name.endswith(".md"):
                yield os.path.join(folder, name)


def anchors(page):
    with open(page, encoding="utf-8") as file:
        for heading in re.findall(r"^#+ (.*)$", file.read(), flags=re.M):
            yield re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def main():
    wrong = 0
    checked = 0
    for page in pages():
        with open(page, encoding="utf-8") as file:
            text = re.sub(r"```.*?```", lambda block: "\n" * block.group(0).count("\n"), file.read(), flags=re.S)
        for match in re.finditer(r"\]\(([^)\s]+)\)", text):
            target = match.group(1)
            if re.match(r"[a-z]+:", target):
                continue
            checked += 1
            path, _, anchor = target.partition("#")
            whole = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
            if not os.path.exists(whole) or (anchor and anchor not in anchors(whole)):
                line = text.count("\n", 0, match.start()) + 1
                print(f"{os.path.relpath(page, ROOT)}:{line}: {target} leads nowhere")
                wrong += 1
    if checked == 0:
        print("no links were found")
    sys.exit(1 if wrong or checked == 0 else 0)


if __name__ == "__main__":
    main()
