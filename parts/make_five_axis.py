#!/usr/bin/env python3
"""Writes the programs and the nominal meshes of the five-axis sample parts.

Each part is chosen so that what the tool leaves has a closed form: the flank of a cylinder whose axis goes along a
cone leaves the parallel cone, and the axis of a cylinder that follows any ruled surface leaves the parallel of that
surface. The simulator has no part in it. `impeller/make_nominal.cpp` does the rest of the impeller.

Run without arguments; writes next to itself. Needs nothing but Python 3 and make_nominals.py beside it.
"""

import math
import os

from make_nominals import HERE, Solid, arc, circle, rectangle, segments, stadium, triangulate

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


# ---- relief on a cylinder: eight flats of a bar 40 with figures on them, A at multiples of 45 degrees --------------


RELIEF_LENGTH, RELIEF_FLAT, RELIEF_DEPTH = 50.0, 17.5, 1.5  # along X; from the axis to a flat; of the figures below it
RELIEF_GROOVE = 2.0  # half of the width


def plus(x, half_x, half_y, r):
    """Outline of two slots across each other, of half the width r, about (x, 0)."""
    q = math.pi / 2
    return (arc(x + half_x, 0, r, -q, 2 * q) + [(x + r, r)] + arc(x, half_y, r, 0.0, 2 * q) + [(x - r, r)]
            + arc(x - half_x, 0, r, q, 2 * q) + [(x - r, -r)] + arc(x, -half_y, r, 2 * q, 2 * q) + [(x + r, -r)])


def relief_cylinder():
    s = Solid()
    d, low, r = RELIEF_FLAT, RELIEF_FLAT - RELIEF_DEPTH, RELIEF_GROOVE
    half = d * math.tan(math.pi / 8)
    slot, cross, discs = stadium(10, 40, 0, r), plus(25, 10, 3, r), [12.0, 25.0, 38.0]
    volume = 8 * d * half * RELIEF_LENGTH
    for k in range(8):
        flat = Solid()
        sheet = rectangle(0, -half, RELIEF_LENGTH, half)
        islands = []
        if k % 2:
            figures, islands = [circle(x, 0, 5.5) for x in discs], [circle(x, 0, 5.5 - 2 * r) for x in discs]
            area = 3 * math.pi * (5.5**2 - (5.5 - 2 * r) ** 2)
        elif k % 4:
            figures, area = [cross], 4 * r * (10 + 3) - 4 * r * r + 2 * math.pi * r * r
        else:
            figures, area = [slot], 30 * 2 * r + math.pi * r * r
        volume -= RELIEF_DEPTH * area
        flat.face(sheet, figures, d, True)
        for i, loop in enumerate(figures):
            flat.wall(loop, low, d, False)
            flat.face(loop, islands[i:i + 1], low, True)
        for loop in islands:
            flat.wall(loop, low, d, True)
            flat.face(loop, [], d, True)
        turned = about_x(45 * k)
        place = lambda p: tuple(round(v, 6) for v in turned(p))
        s.triangles += [tuple(place(p) for p in t) for t in flat.triangles]
        for x, a, b in ((0.0, -half, half), (RELIEF_LENGTH, half, -half)):
            s.triangles.append((place((x, a, d)), place((x, b, d)), (x, 0.0, 0.0)))
    s.finish("relief_cylinder/relief.stl", volume, 1.0)

    out = ["G17 G21 G40 G49 G80 G90 G94 G54", "T1 M6", "S4000 M3", "G0 A0 X-12 Y0", "G43 Z30 H1"]
    for k in range(8):
        out += [f"G0 A{45 * k}", word("Z", d), f"G1 {word('X', 62 if k % 2 == 0 else -12)} F800", "G0 Z30"]
    out += ["G49 Z100", "T2 M6", "S8000 M3", "G0 A0 X10 Y0", "G43 Z30 H2"]
    down = [f"{word('Z', d + 1)}", f"G1 {word('Z', low)} F200"]
    for k in range(8):
        out.append(f"G0 A{45 * k}")
        if k % 2:
            for x in discs:
                ring = 5.5 - r
                out += [f"G0 {words('XY', (x + ring, 0))}"] + down + [f"G3 {word('I', -ring)} F400", "G0 Z30"]
        elif k % 4:
            out += ["X15 Y0"] + down + ["X35 F400", "G0 Z30", "X25 Y-3"] + down + ["Y3 F400", "G0 Z30"]
        else:
            out += ["X10 Y0"] + down + ["X40 F400", "G0 Z30"]
    write_program("relief_cylinder/relief.nc", "O0256 (RELIEF ON A CYLINDER, MADE BY MAKE_FIVE_AXIS.PY)",
                  out + ["G49 Z100", "M5", "M30"])


# ---- ruled wall: the parallel, at the radius of a ball-end cutter 12, of the surface that its axis goes along -------

WALL_RADIUS = 6.0  # of the cutter
WALL_BLANK, WALL_WIDTH = (0.0, 80.0), 20.0  # along X; across
WALL_TOP, WALL_BASE, WALL_MIDDLE = 24.0, -8.0, 6.0  # heights; the middle of the ball is at about 6
WALL_BLOCKS = 24  # of the S
WALL_SAMPLES, WALL_CORNER, WALL_LINES, WALL_ROUND = 6, 5, 6, 32  # facets: of a block, a corner, up the wall, of the ball


def add(a, b, k=1.0):
    return tuple(p + k * q for p, q in zip(a, b))


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def cross3(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    k = math.sqrt(dot(a, a))
    return tuple(p / k for p in a)


def between(a, b, share):
    """Unit vector in the plane of two unit vectors, at a share of the angle from a to b."""
    angle = math.atan2(math.sqrt(dot(cross3(a, b), cross3(a, b))), dot(a, b))
    if angle < 1e-12:
        return a
    return unit(add(tuple(math.sin((1 - share) * angle) * p for p in a), b, math.sin(share * angle)))


def crossing(value, low, high):
    """Where a value that grows passes 0 (false position, each end held back once at most)."""
    at_low, at_high = value(low), value(high)
    if at_low > 0 or at_high < 0:
        raise RuntimeError("nothing crosses here")
    for _ in range(40):
        if high - low < 1e-13 or at_high == at_low:
            break
        middle = high - at_high * (high - low) / (at_high - at_low)
        at = value(middle)
        if abs(at) < 1e-10:
            return middle
        if at > 0:
            high, at_high, at_low = middle, at, at_low / 2
        else:
            low, at_low, at_high = middle, at, at_high / 2
    return (low + high) / 2


def wall_middle(x):
    """The S, which begins and ends along X: height over X and slope."""
    q = 2 * math.pi * min(max((x - 4) / 72, 0.0), 1.0)
    return 4 * (math.sin(q) - 0.5 * math.sin(2 * q)), 4 * 2 * math.pi / 72 * (math.cos(q) - math.cos(2 * q))


def wall_foot(x):
    """Front of the blank: beside the middle of the ball, so that the deepest of the groove lies outside."""
    return wall_middle(x)[0] + 0.4


def along_wall(p, t, n, row):
    """Where a row of the wall lies along the tool, for a normal."""
    top = (WALL_TOP - p[2] - WALL_RADIUS * n[2]) / t[2]
    return top + (WALL_RADIUS - top) * row / WALL_LINES


class WallBlock:
    """A line of the tip, during which the direction turns in the plane of its ends (25.16)."""

    def __init__(self, start, end):
        (self.p0, self.t0), (self.p1, self.t1) = start, end
        turn = cross3(self.t0, self.t1)
        size = math.sqrt(dot(turn, turn))
        rate = math.atan2(size, dot(self.t0, self.t1))
        self.rate = tuple(rate * q / size for q in turn) if size > 1e-12 else (0.0, 0.0, 0.0)

    def pose(self, share):
        return add(self.p0, add(self.p1, self.p0, -1), share), between(self.t0, self.t1, share)

    def contact(self, row, share):
        """(middle of the tool, normal from there to the wall) of a row: 0 is the top of the wall, WALL_LINES where the
        ball begins, WALL_LINES + WALL_ROUND the foot. The normal is at right angles to the tool's axis and to the
        speed of its point (on the ball: to the speed of its middle alone)."""
        p, t = self.pose(share)
        forward, turning = add(self.p1, self.p0, -1), cross3(self.rate, t)

        def normal(u):
            return unit(cross3(t, add(forward, turning, u)))

        if row > WALL_LINES:
            speed = unit(add(forward, turning, WALL_RADIUS))
            down, n = unit(add((0.0, 0.0, -1.0), speed, speed[2])), normal(WALL_RADIUS)
            middle = add(p, t, WALL_RADIUS)

            def inside(share):
                """By how much a point of the ball lies before the foot of the wall."""
                q = add(middle, between(n, down, share), WALL_RADIUS)
                return wall_foot(q[0]) - q[1]

            return middle, between(n, down, crossing(inside, 0.5, 1.0) * (row - WALL_LINES) / WALL_ROUND)
        u = 20.0
        for _ in range(8):  # of the top of the wall
            u = along_wall(p, t, normal(u), 0)
        u += (WALL_RADIUS - u) * row / WALL_LINES
        return add(p, t, u), normal(u)

    def point(self, row, share):
        middle, n = self.contact(row, share)
        return add(middle, n, WALL_RADIUS)


def wall_row(blocks, row):
    """Points along the wall. Towards the wall the parallels of two blocks cross; away from it the tool stands at the corner
    and leaves its own radius."""
    first = [crossing(lambda s: blocks[0].point(row, s)[0] - WALL_BLANK[0], 0.0, 1.0)]
    last, corners = [], []
    for a, b in zip(blocks, blocks[1:]):
        (middle, n0), n1 = a.contact(row, 1.0), b.contact(row, 0.0)[1]
        if cross3(n0, n1)[2] > 1e-12:
            along = unit(cross3(unit(add(n0, n1)), a.t1))
            if row > WALL_LINES:  # of the ball: half way between both directions of its middle
                speeds = [unit(add(add(c.p1, c.p0, -1), cross3(c.rate, t), WALL_RADIUS))
                          for c, t in ((a, a.t1), (b, b.t0))]
                along = unit(add(*speeds))
            side = lambda block, s: dot(add(block.point(row, s), middle, -1), along)
            last.append(crossing(lambda s: side(a, s), 0.5, 1.0))
            first.append(crossing(lambda s: side(b, s), 0.0, 0.5))
            corners.append([])
        else:
            last.append(1.0)
            first.append(0.0)
            corners.append([])
            for k in range(1, WALL_CORNER):
                n = between(n0, n1, k / WALL_CORNER)
                q = middle if row > WALL_LINES else add(a.p1, a.t1, along_wall(a.p1, a.t1, n, row))
                corners[-1].append(add(q, n, WALL_RADIUS))
    last.append(crossing(lambda s: blocks[-1].point(row, s)[0] - WALL_BLANK[1], 0.0, 1.0))
    points = []
    for k, block in enumerate(blocks):
        own = [block.point(row, first[k] + (last[k] - first[k]) * i / WALL_SAMPLES) for i in range(WALL_SAMPLES + 1)]
        if k > 0 and not corners[k - 1]:
            own[0] = points[-1]
        points += own
        if k < len(corners):
            points += corners[k] or [own[-1]] * (WALL_CORNER - 1)
    return points


def taken_depth(blocks, point):
    """How deep a point lies in what the tool sweeps: by trying poses."""
    best = 1e9
    for block in blocks:
        def off(share):
            p, t = block.pose(share)
            d = add(point, p, -1)
            along = max(dot(d, t), WALL_RADIUS)
            return math.sqrt(max(0.0, dot(add(d, t, -along), add(d, t, -along)))) - WALL_RADIUS

        at = min((off(k / 40), k / 40) for k in range(41))[1]
        low, high = max(0.0, at - 1 / 40), min(1.0, at + 1 / 40)
        for _ in range(40):
            a, b = low + (high - low) / 3, high - (high - low) / 3
            low, high = (low, b) if off(a) < off(b) else (a, high)
        best = min(best, off(low), off(high))
    return -best


def ruled_wall():
    def place(share):
        """Middle of the ball, and the direction, which leans to the left by 4 to 12 degrees."""
        x = 4 + 72 * share
        y, slope = wall_middle(x)
        heading, lean = math.atan(slope), math.radians(8 - 4 * math.cos(2 * math.pi * share))
        t = (-math.sin(lean) * math.sin(heading), math.sin(lean) * math.cos(heading), math.cos(lean))
        return (x, y, WALL_MIDDLE), t

    places = [place(k / WALL_BLOCKS) for k in range(WALL_BLOCKS + 1)]
    places = [((-14.0, 0.0, WALL_MIDDLE), places[0][1])] + places + [((94.0, 0.0, WALL_MIDDLE), places[-1][1])]
    # As the program says: the tip, 4 digits; directions, 6 digits.
    said = [(tuple(round(v, 4) for v in add(c, t, -WALL_RADIUS)), tuple(round(v, 6) for v in t)) for c, t in places]
    poses = [(p, unit(t)) for p, t in said]
    blocks = [WallBlock(a, b) for a, b in zip(poses, poses[1:])]

    # Out of the ends of the blank X is what it is, to the last digit.
    def cut_off(row):
        row[0], row[-1] = (WALL_BLANK[0], *row[0][1:]), (WALL_BLANK[1], *row[-1][1:])
        return row

    rows = [cut_off(wall_row(blocks, row)) for row in range(WALL_LINES + WALL_ROUND + 1)]
    rows[0] = [(p[0], p[1], WALL_TOP) for p in rows[0]]
    worst = max(abs(taken_depth(blocks, p)) for row in rows[::6] for p in row[::7])
    print(f"ruled_wall: rows lie within {worst:.6f} mm of what the tool sweeps")
    if worst > 0.001:  # where the parallels of twisted blocks cross
        raise RuntimeError("the parallel is not what the tool leaves")
    outer = rows[-1]
    back = [(p[0], p[1] + WALL_WIDTH) for p in outer]
    at = lambda points, z: [(p[0], p[1], z) for p in points]

    def solid(front):
        s = Solid()
        around = front + [at(outer, WALL_BASE), at(back, WALL_BASE), at(back, WALL_TOP), front[0]]
        for a, b in zip(around, around[1:]):
            for i in range(len(a) - 1):
                s.triangles += [(a[i], b[i], b[i + 1]), (a[i], b[i + 1], a[i + 1])]
        for end, x in ((0, WALL_BLANK[0]), (-1, WALL_BLANK[1])):
            loop = [(row[end][1], row[end][2]) for row in around[:-1]]
            for tri in triangulate(loop, []):
                points = tuple((x, *p) for p in tri)
                s.triangles.append(points[::-1] if end == 0 else points)
        return s

    length = WALL_BLANK[1] - WALL_BLANK[0]
    solid([at(outer, WALL_TOP)]).finish("ruled_wall/blank.stl", length * WALL_WIDTH * (WALL_TOP - WALL_BASE), 0.1)
    solid(rows).finish("ruled_wall/wall.stl", None, 0.0)

    def move(p, t):
        return f"{words('XYZ', p)} {words('IJK', t, 6)}"

    high = (said[0][0][0], said[0][0][1], 50.0)
    out = ["G17 G21 G40 G49 G80 G90 G94 G54", "T1 M6", "S6000 M3", "G0 B0 C90", f"G43.5 P1 {move(high, said[0][1])} H1",
           word("Z", said[0][0][2]), f"G1 {move(*said[1])} F800"]
    out += [move(*s) for s in said[2:]] + ["G0 Z50", "G49 Z200", "M5", "M30"]
    write_program("ruled_wall/wall.nc", "O0253 (RULED WALL BY THE FLANK, MADE BY MAKE_FIVE_AXIS.PY)", out)


# ---- impeller: five blades whose sides are cones about upright lines; see impeller/make_nominal.cpp ----------------


IMPELLER_BLADES, IMPELLER_MIDDLE, IMPELLER_ARC, IMPELLER_ASIDE = 5, 24.0, 20.0, 4.2
IMPELLER_LEAN, IMPELLER_RADIUS, IMPELLER_FLOOR, IMPELLER_BALL = math.radians(12), 3.0, 8.0, 11.0
IMPELLER_IN, IMPELLER_OUT, IMPELLER_FLAT_IN, IMPELLER_FLAT_OUT = 10.5, 30.0, 14.5, 29.0


def blade_turn(k, radius, away):
    """Angle about the middle of blade k's arc where the circle about it is `away` from the axis."""
    cosine = (IMPELLER_MIDDLE**2 + radius**2 - away**2) / (2 * IMPELLER_MIDDLE * radius)
    return math.pi - math.acos(cosine) + 2 * math.pi / IMPELLER_BLADES * k


def about_blade(k, radius, turn):
    middle = 2 * math.pi / IMPELLER_BLADES * k
    return (IMPELLER_MIDDLE * math.cos(middle) + radius * math.cos(turn),
            IMPELLER_MIDDLE * math.sin(middle) + radius * math.sin(turn))


def impeller():
    out_way, in_way = IMPELLER_ARC + IMPELLER_ASIDE, IMPELLER_ARC - IMPELLER_ASIDE
    way = lambda k, radius, away: about_blade(k, radius, blade_turn(k, radius, away))
    xy = lambda p: words("XY", p)

    def floor(k):
        """With the end mill between blade k and the one before it: along that one to the hub, to the rim and back in the
        middle, along blade k to the rim."""
        wide, narrow = out_way + IMPELLER_RADIUS, in_way - IMPELLER_RADIUS

        def within(share, away):
            return xy(tuple(p + share * (q - p) for p, q in zip(way(k - 1, out_way, away), way(k, in_way, away))))

        blocks = [f"G0 {xy(way(k - 1, wide, IMPELLER_FLAT_OUT))}", word("Z", IMPELLER_FLOOR),
                  f"G3 {xy(way(k - 1, wide, IMPELLER_FLAT_IN))} {word('R', wide)} F900", f"G1 {within(0.5, 12.3)}"]
        blocks += [within(share, away) for share, away in (
            (0.4, 18.0), (0.33, IMPELLER_FLAT_OUT), (0.67, IMPELLER_FLAT_OUT), (0.6, 18.0))]
        blocks += [xy(way(k, narrow, IMPELLER_FLAT_IN)),
                   f"G2 {xy(way(k, narrow, IMPELLER_FLAT_OUT))} {word('R', narrow)}", "G0 Z40"]
        return blocks

    s, c = math.sin(IMPELLER_LEAN), math.cos(IMPELLER_LEAN)

    def side(k, radius, direction):
        """With the ball along a side of blade k, rim to hub; `direction` gives the words of a direction."""
        tip_way, z = radius + IMPELLER_RADIUS * s, IMPELLER_BALL - IMPELLER_RADIUS * c
        start, end = blade_turn(k, radius, IMPELLER_OUT), blade_turn(k, radius, IMPELLER_IN)
        lean = lambda turn: (-s * math.cos(turn), -s * math.sin(turn), c)
        first, last = (*about_blade(k, tip_way, start), z), (*about_blade(k, tip_way, end), z)
        back = lambda p, t, far: words("XYZ", tuple(a + far * b for a, b in zip(p, t)))
        return [f"G0 {back(first, lean(start), 40)} {direction(lean(start))}", back(first, lean(start), 0),
                f"G3 {xy(last)} {word('R', tip_way)} {direction(lean(end))} F600",
                f"G1 {back(last, lean(end), 40)} F3000"]

    def program(path, title, call, direction):
        out = ["G17 G21 G40 G49 G80 G90 G94 G54", "T1 M6", "S8000 M3", "G0 A0 C0 X40 Y0", "G43 Z60 H1"]
        for k in range(IMPELLER_BLADES):
            out += floor(k)
        out += ["G49 Z100", "T2 M6", "S8000 M3"]
        for k in range(IMPELLER_BLADES):
            for radius in (out_way, in_way):
                blocks = side(k, radius, direction)
                if k == 0 and radius == out_way:
                    blocks[0] = f"G0 {call} {blocks[0][3:]} H2"
                out += blocks
        write_program(path, title, out + ["G0 G49 Z100", "M5", "M30"])

    program("impeller/impeller.nc", "O0254 (IMPELLER, MADE BY MAKE_FIVE_AXIS.PY)", "G43.5",
            lambda t: words("IJK", t, 6))

    class Posted:
        """Directions as A and C of a trunnion whose tables turn left-handed: C goes on from where it is. One is given by
        the other pair of angles."""

        def __init__(self, flipped):
            self.c, self.count, self.flipped = 0.0, 0, flipped

        def __call__(self, t):
            a, turn = math.degrees(math.acos(t[2])), math.degrees(math.atan2(t[0], -t[1]))
            self.c += (turn - self.c + 180) % 360 - 180
            self.count += 1
            if self.count == self.flipped:
                return words("AC", (-a, self.c + 180))
            return words("AC", (a, self.c))

    # 4 directions a blade: the eighth ends the inner side of the second blade.
    program("impeller/flipped.nc", "O0255 (IMPELLER, POSTED FOR A TRUNNION, ONE PAIR FLIPPED)", "G43.4", Posted(8))


if __name__ == "__main__":
    cone_frustum()
    relief_cylinder()
    ruled_wall()
    impeller()
