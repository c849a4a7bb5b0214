#!/usr/bin/env python3
"""Checks the include arrows of docs/arrows.txt.

  arrows.py               every #include under src/lancer and shaders is allowed, and docs/architecture.md shows the same table
  arrows.py --write       writes the table into docs/architecture.md
  arrows.py --self-test   the checker finds each kind of violation in a tree made for it
"""
import fnmatch
import pathlib
import re
import sys
import tempfile

ENDINGS = {".h", ".cpp", ".comp", ".glsl", ".inl"}
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(["<])([^">]+)[">]', re.MULTILINE)
BEGIN, END = "<!-- arrows: made from arrows.txt -->", "<!-- end of arrows -->"


class Arrows:
    def __init__(self, text):
        self.folders = {}  # name -> (folders it may include, in order; what lives there)
        self.only = []     # (pattern, folders)
        self.within = {}   # folder -> patterns
        for number, line in enumerate(text.splitlines(), 1):
            line = line.split("#")[0].strip()
            if not line:
                continue
            kind, rest = line.split(None, 1)
            name, _, rest = rest.partition(":")
            allowed, _, words = rest.partition("|")
            if kind == "folder":
                self.folders[name] = (allowed.split(), words.strip())
            elif kind == "only":
                self.only.append((name, allowed.split()))
            elif kind == "within":
                self.within[name] = allowed.split()
            else:
                raise SystemExit(f"docs/arrows.txt:{number}: unknown word: {kind}")
        for name, (allowed, _) in self.folders.items():
            for other in allowed:
                if other != "*" and other not in self.folders:
                    raise SystemExit(f"docs/arrows.txt: {name} may include {other}, which is no folder")

    def may_include(self, folder, other):
        allowed = self.folders[folder][0]
        return folder == other or "*" in allowed or other in allowed

    def cycles(self):
        """Folders that reach themselves over allowed arrows."""
        def reach(start):
            seen, todo = set(), [f for f in self.folders[start][0] if f != "*"]
            while todo:
                folder = todo.pop()
                if folder not in seen:
                    seen.add(folder)
                    todo += [f for f in self.folders[folder][0] if f != "*"]
            return seen
        return [folder for folder in self.folders if folder in reach(folder)]

    def table(self):
        rows = ["| folder | what lives there | may include, besides itself |", "|---|---|---|"]
        for name, (allowed, words) in self.folders.items():
            may = "everything" if "*" in allowed else ", ".join(allowed) or "nothing of ours"
            rows.append(f"| `{name}` | {words} | {may} |")
        rows.append("")
        for pattern, folders in self.only:
            rows.append(f"- `<{pattern}>` is included in {', '.join(f'`{f}`' for f in folders)} only.")
        for folder, patterns in self.within.items():
            rows.append(f"- `{folder}` includes no system headers but {', '.join(f'`<{p}>`' for p in patterns)}.")
        return "\n".join(rows)


def problems_in_file(arrows, folder, path, text):
    """folder: the path below src/lancer of the folder that holds the file, 'app/window' for example."""
    first = folder.split("/")[0]
    for match in INCLUDE.finditer(text):
        quote, name = match.groups()
        where = f"{path}:{text.count(chr(10), 0, match.start()) + 1}"
        if name.startswith("lancer/"):
            other = name.split("/")[1]
            if quote == "<":
                yield f'{where}: our own header is written "{name}"'
            if other not in arrows.folders:
                yield f"{where}: {name}: docs/arrows.txt knows no folder {other}"
            elif not arrows.may_include(first, other):
                yield f"{where}: {first} may not include {name}; docs/arrows.txt says what it may"
            continue
        if quote == '"':
            yield f'{where}: "{name}": our own headers are written "lancer/folder/file.h", others <in angles>'
        for pattern, folders in arrows.only:
            if fnmatch.fnmatchcase(name, pattern) and not any(folder == f or folder.startswith(f + "/") for f in folders):
                yield f"{where}: <{name}> belongs in {', '.join(folders)} only"
        if first in arrows.within and not any(fnmatch.fnmatchcase(name, p) for p in arrows.within[first]):
            yield f"{where}: {first} may not include <{name}>"


def problems_in_tree(arrows, root):
    """Returns (number of files read, problems)."""
    problems = [f"docs/arrows.txt: {folder} can reach itself" for folder in arrows.cycles()]
    count = 0
    for base, prefix in ((root / "src" / "lancer", ""), (root / "shaders", "shaders")):
        for path in sorted(p for p in base.rglob("*") if p.suffix in ENDINGS):
            count += 1
            folder = "/".join(filter(None, [prefix, path.parent.relative_to(base).as_posix().replace(".", "")]))
            shown = path.relative_to(root).as_posix()
            if folder.split("/")[0] not in arrows.folders:
                problems.append(f"{shown}: docs/arrows.txt knows no folder {folder.split('/')[0] or '(none)'}")
                continue
            problems += problems_in_file(arrows, folder, shown, path.read_text(encoding="utf-8"))
    return count, problems


def with_table(document, table):
    before, _, rest = document.partition(BEGIN)
    _, found, after = rest.partition(END)
    if not found:
        raise SystemExit(f"docs/architecture.md lacks the lines {BEGIN} and {END}")
    return f"{before}{BEGIN}\n{table}\n{END}{after}"


def self_test(arrows):
    cases = {  # file -> (its text, a piece of the problem that must be found, or None)
        "src/lancer/base/good.h": ("#include <string>\n", None),
        "src/lancer/app/good.cpp": ('#include "lancer/render/render.h"\n', None),
        "src/lancer/app/window/good.cpp": ("#include <SDL2/SDL.h>\n", None),
        "src/lancer/trace/good.cpp": ("#  include <embree3/rtcore.h>\n", None),
        "shaders/good.comp": ('#include "lancer/kernel/language.h"\n', None),
        "src/lancer/base/up.h": ('\n#include "lancer/image/image.h"\n', "up.h:2: base may not include"),
        "src/lancer/render/app.h": ('#include "lancer/app/cli/options.h"\n', "render may not include"),
        "src/lancer/film/angles.h": ("#include <lancer/film/film.h>\n", "our own header is written"),
        "src/lancer/film/short.h": ('#include "film.h"\n', "our own headers are written"),
        "src/lancer/device/rays.cpp": ("#include <embree3/rtcore.h>\n", "belongs in trace only"),
        "src/lancer/app/cli/view.cpp": ("#include <SDL2/SDL.h>\n", "belongs in app/window only"),
        "src/lancer/import/picture.cpp": ("#include <OpenImageIO/imageio.h>\n", "belongs in image only"),
        "src/lancer/device/cpu/gpu.cpp": ("#include <vulkan/vulkan.h>\n", "belongs in device/vulkan only"),
        "src/lancer/kernel/threads.h": ("#include <thread>\n", "kernel may not include <thread>"),
        "src/lancer/new/file.h": ("", "knows no folder new"),
        "src/lancer/file.h": ("", "knows no folder"),
        "shaders/world.comp": ('#include "lancer/world/world.h"\n', "shaders may not include"),
    }
    wrong = []
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, (text, _) in cases.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        count, problems = problems_in_tree(arrows, root)
        if count != len(cases):
            wrong.append(f"{count} of {len(cases)} files were read")
        for name, (_, piece) in cases.items():
            found = [p for p in problems if p.startswith(name + ":")]
            if piece is None and found:
                wrong.append(f"{name} is fine, but: {found[0]}")
            if piece is not None and not any(piece in p for p in found):
                wrong.append(f"{name}: not found: {piece}")
    if Arrows("folder a: b\nfolder b: a\n").cycles() != ["a", "b"]:
        wrong.append("a cycle was not found")
    return wrong


def main():
    root = pathlib.Path(__file__).resolve().parents[2]
    arrows = Arrows((root / "docs" / "arrows.txt").read_text(encoding="utf-8"))
    page = root / "docs" / "architecture.md"
    if "--self-test" in sys.argv:
        problems, said = self_test(arrows), "Each kind of violation is found."
    elif "--write" in sys.argv:
        page.write_text(with_table(page.read_text(encoding="utf-8"), arrows.table()), encoding="utf-8")
        return
    else:
        count, problems = problems_in_tree(arrows, root)
        document = page.read_text(encoding="utf-8")
        if with_table(document, arrows.table()) != document:
            problems.append("docs/architecture.md: its table is not that of docs/arrows.txt; run tests/architecture/arrows.py --write")
        said = f"The includes of {count} files are allowed."
        if count == 0:
            problems.append("no file was found to check")
    print("\n".join(problems) or said)
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
