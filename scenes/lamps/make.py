#!/usr/bin/env python3
"""Writes the photometric files (ANSI/IES LM-63) of this folder: lamps that nobody has built, by formulas.

    scenes/lamps/make.py
"""
import math
import os

HERE = os.path.dirname(os.path.abspath(__file__))


def write(name, what, vertical, horizontal, candela):
    rows = [[candela(math.radians(v), math.radians(h)) for v in vertical] for h in horizontal]
    numbers = lambda values: " ".join(f"{value:.6g}" for value in values)
    with open(os.path.join(HERE, name), "w", newline="\r\n") as out:
        out.write(f"IESNA:LM-63-2002\n[TEST] made by scenes/lamps/make.py\n[MANUFAC] lancer\n[LUMINAIRE] {what}\nTILT=NONE\n")
        out.write(f"1 -1 1 {len(vertical)} {len(horizontal)} 1 2 0 0 0\n1 1 10\n")
        for values in [vertical, horizontal] + rows:
            for i in range(0, len(values), 12):
                out.write(numbers(values[i:i + 12]) + "\n")


def steps(end, step):
    return [i * step for i in range(int(end / step) + 1)]


# A narrow beam within a faint wider one.
write("downlight.ies", "a downlight", steps(90, 2.5), [0],
      lambda v, h: 900 * math.exp(-(v / 0.3) ** 2) + 120 * max(math.cos(v), 0) ** 2 if v < 1.5 else 0)
# Wings to both sides along the street, little straight down, more to the front than to the back.
write("street.ies", "a street lamp", steps(90, 2.5), steps(180, 10),
      lambda v, h: max(0, 250 * math.cos(v) ** 0.3 * math.exp(-((v - 1.1) / 0.28) ** 2) * (0.25 + math.cos(h) ** 2)
                       + 90 * math.cos(v) * (1.2 + 0.8 * math.sin(h))) if v < 1.55 else 0)
# Light up and down a wall, none to the sides.
write("wall.ies", "a wall lamp", steps(180, 5), [0],
      lambda v, h: 500 * math.exp(-(math.sin(v) / 0.35) ** 2) if v < math.pi / 2 else 800 * math.exp(-(math.sin(v) / 0.5) ** 2))
# A ring of petals, to see which way round it stands.
write("petals.ies", "petals", steps(90, 2.5), steps(360, 5),
      lambda v, h: 100 * (1 + 0.9 * math.cos(5 * h)) * (1 + 0.5 * math.cos(h)) * math.exp(-((v - 0.7) / 0.2) ** 2))
