#!/usr/bin/env python3
"""Writes the tables of keys in docs/scenes.md from the schema that `lancer schema` prints.

    docs/make_tables.py [LANCER]          rewrites them; LANCER is the program, build/release/lancer if not given
    docs/make_tables.py --check [LANCER]  changes nothing; the exit status is 1 when they are not up to date

A table stands between `<!-- keys: NAME -->` and `<!-- end of keys -->`, where NAME is one of the schema's definitions.
"""
import json
import os
import re
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
PAGE = os.path.join(HERE, "scenes.md")


def number(x):
    if isinstance(x, list):
        return "[" + ", ".join(number(i) for i in x) + "]"
    return json.dumps(int(x) if isinstance(x, float) and x == int(x) else x)


def kind(key):
    """What may be written, in words."""
    if "$ref" in key:
        name = key["$ref"].rsplit("/", 1)[1]
        words = {"color_text": None, "spectrum": "a spectrum", "curve": "a curve", "checker": "a checker", "image": "an image",
                 "vertex_color": None, "face_color": "colors of a mesh", "texture_value": "`{ texture, channel, scale, offset }`",
                 "abbe_glass": "`{ index, abbe_number }`",
                 "sellmeier_glass": "`{ b, c }`", "axis_rotation": "`{ axis, angle }`", "material": "a material"}
        return words.get(name, "a " + name.replace("_", " "))
    if "const" in key:
        return f'`"{key["const"]}"`'
    if "enum" in key:
        return " or ".join(f'`"{word}"`' for word in key["enum"])
    if "anyOf" in key and "properties" not in key:
        if any(option.get("$ref", "").endswith("color_text") for option in key["anyOf"]):
            rest = [kind(option) for option in key["anyOf"] if "$ref" in option]
            return ", ".join(["a color"] + [word for word in rest if word])
        return ", ".join(kind(option) for option in key["anyOf"])
    if key["type"] == "array":
        items, count = key["items"], key.get("minItems")
        if items.get("type") == "array":
            return f"a list of {items.get('minItems')} numbers each"
        return f"{count} numbers" if count == key.get("maxItems") and count else "a list"
    low = key.get("minimum", key.get("exclusiveMinimum"))
    high = key.get("maximum", key.get("exclusiveMaximum"))
    word = {"number": "a number", "integer": "a whole number", "string": "a text", "boolean": "true or false", "object": "a table"}[key["type"]]
    if "minimum" in key and high is not None:
        return f"{word} from {number(low)} to {number(high)}" if "maximum" in key else f"{word} from {number(low)}, below {number(high)}"
    if "exclusiveMinimum" in key and high is not None:
        return f"{word} above {number(low)}, " + (f"at most {number(high)}" if "maximum" in key else f"below {number(high)}")
    if low is not None:
        return f"{word}, {'at least' if 'minimum' in key else 'above'} {number(low)}"
    return word


def table(definition):
    lines = ["| key | takes | if not written | |", "|---|---|---|---|"]
    for name, key in definition["properties"].items():
        if "description" not in key:
            continue  # what a group contains
        preset = "must be written" if name in definition.get("required", []) else f"`{number(key['default'])}`" if "default" in key else ""
        text = re.sub(r" Unit: ([^.]*)\.$", r" In \1.", key["description"])
        lines.append(f"| `{name}` | {kind(key)} | {preset} | {text.replace(' In m.', ' In metres.').replace(' In 1/m.', ' Per metre.')} |")
    return "\n".join(lines)


def main():
    arguments = [word for word in sys.argv[1:] if word != "--check"]
    program = arguments[0] if arguments else os.path.join(HERE, "..", "build", "release", "lancer")
    schema = json.loads(subprocess.run([program, "schema"], check=True, capture_output=True, text=True).stdout)
    with open(PAGE, encoding="utf-8") as file:
        before = file.read()

    shown = set()

    def fill(match):
        shown.add(match.group(1))
        return f"<!-- keys: {match.group(1)} -->\n{table(schema['$defs'][match.group(1)])}\n<!-- end of keys -->"

    after = re.sub(r"<!-- keys: (\w+) -->\n.*?<!-- end of keys -->", fill, before, flags=re.S)
    missing = {name for name, definition in schema["$defs"].items() if definition.get("type") == "object"} - shown - {"named_camera", "group"}
    if missing:
        sys.exit(f"{PAGE} has no table for {', '.join(sorted(missing))}")
    if after == before:
        return
    if "--check" in sys.argv[1:]:
        sys.exit(f"The tables in {PAGE} are not those of the program: run docs/make_tables.py {program}")
    with open(PAGE, "w", encoding="utf-8") as file:
        file.write(after)


if __name__ == "__main__":
    main()
