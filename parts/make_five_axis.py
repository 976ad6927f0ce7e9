#!/usr/bin/env python3
"""Writes the programs and the nominal meshes of the five-axis sample parts.

Each part is chosen so that what the tool leaves has a closed form: the flank of a cylinder whose axis goes along a
cone leaves the parallel cone, and the axis of a cylinder that follows any ruled surface leaves the parallel of that
surface. The simulator has no part in it. `impeller/make_nominal.cpp` does the rest of the impeller.

Run without arguments; writes next to itself. Needs nothing but Python 3 and make_nominals.py beside it.
"""

import math
import os

from make_nominals import HERE, Solid, circle, segments

# ---- what the parts share -------------------------------------------------------------------------------------------


def word(letter, value, digits=4):
    """X12.5, and never X-0."""
    text = f"{value:.{digits}f}".rstrip("0").rstrip(".")
    return letter + ("0" if text in ("-0", "") else text)


def words(letters, values, digits=4):
    return " ".join(word(letter, value, digits) for letter, value in zip(letters, values))


def write_program(path, title, blocks):
    lines = ["%", title] + [f"N{10 * (k + 1)} {block}" for k, block in enumerate(blocks)] + ["%"]
    with open(os.path.join(HERE, path), "w", newline="\n") as out:
        out.write("\n".join(lines) + "\n")
    print(f"{path}: {len(blocks)} blocks")


def about_x(degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return lambda p: (p[0], c * p[1] - s * p[2], s * p[1] + c * p[2])


# ---- cone frustum: base radius 30, half angle 12 degrees, 24 mm high, by an end mill 16 ----------------------------


CONE_RADIUS, CONE_ANGLE, CONE_HEIGHT, CONE_TILT = 30.0, math.radians(12), 24.0, 10.0
CONE_BLANK = 33.0  # radius of the bar
CONE_TOOL = 8.0  # radius
CONE_TIP = -4.0  # the bottom of the tool, which leans, stays below the base


def revolved(radii, heights, place):
    """About Z, from below to above, with flat ends."""
    s = Solid()
    n = segments(max(radii), 2 * math.pi)
    unit = [(math.cos(2 * math.pi * i / n), math.sin(2 * math.pi * i / n)) for i in range(n)]
    ring = lambda k, i: place((radii[k] * unit[i % n][0], radii[k] * unit[i % n][1], heights[k]))
    low, high = place((0.0, 0.0, heights[0])), place((0.0, 0.0, heights[-1]))
    for i in range(n):
        s.triangles.append((low, ring(0, i + 1), ring(0, i)))
        s.triangles.append((high, ring(len(radii) - 1, i), ring(len(radii) - 1, i + 1)))
        for k in range(len(radii) - 1):
            a, b, c, d = ring(k, i), ring(k, i + 1), ring(k + 1, i + 1), ring(k + 1, i)
            s.triangles += [(a, b, c), (a, c, d)]
    return s


def cone_frustum():
    upright = lambda p: p
    top = CONE_RADIUS - CONE_HEIGHT * math.tan(CONE_ANGLE)
    volume = math.pi / 3 * CONE_HEIGHT * (CONE_RADIUS**2 + CONE_RADIUS * top + top**2)
    for name, place in (("upright", upright), ("tilted", about_x(CONE_TILT))):
        revolved([CONE_RADIUS, top], [0.0, CONE_HEIGHT], place).finish(
            f"cone_frustum/{name}.stl", volume, 4.0)
    revolved([CONE_BLANK] * 2, [0.0, CONE_HEIGHT], about_x(CONE_TILT)).finish(
        "cone_frustum/tilted-blank.stl", math.pi * CONE_BLANK**2 * CONE_HEIGHT, 4.0)

    # The axis lies on the parallel of the cone: through (radius + r cos, r sin), leaning inwards.
    c, s = math.cos(CONE_ANGLE), math.sin(CONE_ANGLE)
    way = CONE_RADIUS + CONE_TOOL * c + (CONE_TOOL * s - CONE_TIP) / c * s
    far = 62.0

    def lean(turn):
        q = math.radians(turn)
        return words("IJK", (-s * math.cos(q), -s * math.sin(q), c), 6)

    def arc(turn):
        q = math.radians(turn)
        return f"G3 {words('XY', (way * math.cos(q), way * math.sin(q)))} {word('R', way)} {lean(turn)}"

    def blocks(frame):
        out = ["G17 G21 G40 G49 G80 G90 G94 G54", "T1 M6", "S4000 M3", "G0 A0 C0"]
        out += frame
        out += [f"G43.5 P1 {words('XYZ', (far, 0, 60))} {lean(0)} H1", word("Z", CONE_TIP)]
        out += [f"G1 {word('X', way)} F600"]
        out += [arc(turn) for turn in (90, 180, 270, 360)]
        out += [f"G1 {word('X', far)} F2000", "G0 Z60"]
        return out

    end = ["G49 Z0", "M5", "M30"]
    write_program("cone_frustum/upright.nc", "O0251 (CONE FRUSTUM BY THE FLANK, MADE BY MAKE_FIVE_AXIS.PY)",
                  blocks([]) + end)
    write_program("cone_frustum/tilted.nc", "O0252 (THE SAME, TILTED BY 10 DEGREES, MADE BY MAKE_FIVE_AXIS.PY)",
                  blocks([f"G68.2 X0 Y0 Z0 I0 {word('J', CONE_TILT)} K0"]) + ["G69.1 G49"] + end[1:])


if __name__ == "__main__":
    cone_frustum()
