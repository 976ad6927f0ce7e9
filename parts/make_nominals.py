#!/usr/bin/env python3
"""Builds the nominal meshes of the sample parts, and the program of the free-form patch.

The solids are made from their drawings: horizontal faces with holes, vertical walls, cones of drill points. No
simulation is involved, so that the samples check the simulator against an independent truth. Every solid is
checked here: closed (each edge once in each direction) and, against the closed form, its volume.

Run without arguments; writes next to itself. Needs nothing but Python 3.
"""

import math
import os
import struct
from collections import Counter

HERE = os.path.dirname(os.path.abspath(__file__))
CHORD_ERROR = 0.0008  # mm, of the facets of curved walls


# ---- plane loops, counter-clockwise ---------------------------------------------------------------------------------


def segments(radius, sweep):
    """Number of chords so that the chord error stays below CHORD_ERROR."""
    return max(2, math.ceil(sweep / (2 * math.acos(1 - CHORD_ERROR / radius))))


def arc(cx, cy, radius, start, sweep, last=True):
    n = segments(radius, abs(sweep))
    return [
        (cx + radius * math.cos(start + sweep * i / n), cy + radius * math.sin(start + sweep * i / n))
        for i in range(n + 1 if last else n)
    ]


def circle(cx, cy, radius):
    return arc(cx, cy, radius, 0.0, 2 * math.pi, last=False)


def rectangle(x0, y0, x1, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def rounded_rectangle(x0, y0, x1, y1, radius):
    q = math.pi / 2
    return (
        arc(x1 - radius, y0 + radius, radius, -q, q)
        + arc(x1 - radius, y1 - radius, radius, 0.0, q)
        + arc(x0 + radius, y1 - radius, radius, q, q)
        + arc(x0 + radius, y0 + radius, radius, 2 * q, q)
    )


def stadium(x0, x1, y, radius):
    """Slot along x between the centres (x0, y) and (x1, y)."""
    return arc(x1, y, radius, -math.pi / 2, math.pi) + arc(x0, y, radius, math.pi / 2, math.pi)


def rounded_polygon(points, radius):
    """Convex polygon, counter-clockwise, with all corners rounded."""
    loop = []
    for i, p in enumerate(points):
        before, after = points[i - 1], points[(i + 1) % len(points)]
        start = math.atan2(p[1] - before[1], p[0] - before[0]) - math.pi / 2
        turn = (math.atan2(after[1] - p[1], after[0] - p[0]) - math.pi / 2 - start) % (2 * math.pi)
        back = math.dist(before, p)
        tangent = radius * math.tan(turn / 2)
        cx = p[0] + (before[0] - p[0]) * tangent / back - radius * math.cos(start)
        cy = p[1] + (before[1] - p[1]) * tangent / back - radius * math.sin(start)
        loop += arc(cx, cy, radius, start, turn)
    return loop


def rounded_polygon_area(points, radius):
    area = sum(cross((0, 0), points[i - 1], p) for i, p in enumerate(points)) / 2
    for i, p in enumerate(points):
        a, b = points[i - 1], points[(i + 1) % len(points)]
        cosine = ((a[0] - p[0]) * (b[0] - p[0]) + (a[1] - p[1]) * (b[1] - p[1])) / (math.dist(a, p) * math.dist(b, p))
        angle = math.acos(cosine)
        area -= radius * radius * (1 / math.tan(angle / 2) - (math.pi - angle) / 2)
    return area


# ---- triangulation of a loop with holes by ear clipping -------------------------------------------------------------


def cross(o, a, b):
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])


def inside(p, a, b, c):
    return cross(a, b, p) >= 0 and cross(b, c, p) >= 0 and cross(c, a, p) >= 0


def sees(prev, v, after, target):
    """True if the direction from vertex v of a counter-clockwise loop to target points into the loop."""
    if cross(prev, v, after) > 0:
        return cross(v, after, target) >= 0 and cross(v, target, prev) >= 0
    return not (cross(v, prev, target) > 0 and cross(v, target, after) > 0)


def bridge(outer, hole):
    """Joins a hole (counter-clockwise as given) to the outer loop by a double edge."""
    h = max(range(len(hole)), key=lambda i: (hole[i][0], hole[i][1]))
    hx, hy = hole[h]
    best = None
    n = len(outer)
    for i in range(n):  # the edge that a ray to the right meets first
        a, b = outer[i], outer[(i + 1) % n]
        if not a[1] <= hy < b[1]:  # the ray leaves the loop through upward edges only
            continue
        x = a[0] + (hy - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
        if x >= hx and (best is None or x < best[0]):
            best = (x, i if a[0] > b[0] else (i + 1) % n)
    x, target = best
    m, p = (x, hy), outer[target]
    # A reflex vertex in the triangle may hide the target; take the one at the smallest angle.
    tri = (m, p, (hx, hy)) if cross((hx, hy), m, p) < 0 else ((hx, hy), m, p)
    choice = None
    for i, v in enumerate(outer):
        if v == p or cross(outer[i - 1], v, outer[(i + 1) % n]) > 0:
            continue
        if v[0] > hx and inside(v, *tri) and sees(outer[i - 1], v, outer[(i + 1) % n], (hx, hy)):
            key = (abs(v[1] - hy) / (v[0] - hx), v[0] - hx)
            if choice is None or key < choice[0]:
                choice = (key, i)
    if choice is not None:
        target = choice[1]
    clockwise = [hole[(h - k) % len(hole)] for k in range(len(hole) + 1)]
    return outer[: target + 1] + clockwise + outer[target:]


def triangulate(outer, holes):
    loop = list(outer)
    for hole in sorted(holes, key=lambda h: -max(p[0] for p in h)):
        loop = bridge(loop, hole)
    index = list(range(len(loop)))
    reflex = {i for i in index if cross(loop[i - 1], loop[i], loop[(i + 1) % len(loop)]) <= 0}
    triangles = []
    at, misses = 0, 0
    while len(index) > 3:
        n = len(index)
        ia, ib, ic = index[at % n - 1], index[at % n], index[(at + 1) % n]
        a, b, c = loop[ia], loop[ib], loop[ic]
        ear = cross(a, b, c) > 1e-12 and not any(
            loop[r] not in (a, b, c) and inside(loop[r], a, b, c) for r in reflex if r not in (ia, ib, ic)
        )
        if not ear:
            at, misses = at + 1, misses + 1
            if misses > 2 * n:
                raise RuntimeError("no ear left: the loops cross")
            continue
        misses = 0
        triangles.append((a, b, c))
        index.pop(at % n)
        n -= 1
        at = (at % (n + 1)) % n + 1  # go on behind the ear, so that fans stay short
        for k in (index.index(ia), index.index(ic)):
            v = index[k]
            if v in reflex and cross(loop[index[k - 1]], loop[v], loop[index[(k + 1) % n]]) > 0:
                reflex.discard(v)
    triangles.append(tuple(loop[i] for i in index))
    return triangles


# ---- solids ---------------------------------------------------------------------------------------------------------


class Solid:
    def __init__(self):
        self.triangles = []

    def face(self, outer, holes, z, up):
        for a, b, c in triangulate(outer, holes):
            t = tuple((p[0], p[1], z) for p in (a, b, c))
            self.triangles.append(t if up else t[::-1])

    def wall(self, loop, low, high, material_inside):
        for i, a in enumerate(loop):
            b = loop[(i + 1) % len(loop)]
            if a == b:
                continue
            quad = [(a[0], a[1], low), (b[0], b[1], low), (b[0], b[1], high), (a[0], a[1], high)]
            if not material_inside:
                quad = [quad[1], quad[0], quad[3], quad[2]]
            self.triangles += [(quad[0], quad[1], quad[2]), (quad[0], quad[2], quad[3])]

    def ruled_wall(self, lower, upper, low, high, material_inside, levels=1):
        """Between loops with as many points each: straight lines join equal numbers."""
        def at(k):
            w = k / levels
            return [tuple((1 - w) * p + w * q for p, q in zip(a, b)) for a, b in zip(lower, upper)]

        for k in range(levels):
            below, above = at(k), at(k + 1)
            z0, z1 = (low + (high - low) * j / levels for j in (k, k + 1))
            for i in range(len(below)):
                j = (i + 1) % len(below)
                quad = [(*below[i], z0), (*below[j], z0), (*above[j], z1), (*above[i], z1)]
                if not material_inside:
                    quad = [quad[1], quad[0], quad[3], quad[2]]
                self.triangles += [(quad[0], quad[1], quad[2]), (quad[0], quad[2], quad[3])]

    def drill_point(self, loop, z, tip):
        for i, a in enumerate(loop):
            b = loop[(i + 1) % len(loop)]
            self.triangles.append(((a[0], a[1], z), (b[0], b[1], z), tip))

    def finish(self, path, volume, tolerance):
        """Checks the solid and writes it as binary STL. A volume of None has no closed form."""
        rounded = [tuple(tuple(struct.unpack("<f", struct.pack("<f", x))[0] + 0.0 for x in p) for p in t)
                   for t in self.triangles]
        rounded = [t for t in rounded if len(set(t)) == 3]
        edges = Counter((t[i], t[(i + 1) % 3]) for t in rounded for i in range(3))
        open_edges = [e for e, n in edges.items() if n != 1 or edges[(e[1], e[0])] != 1]
        if open_edges:
            raise RuntimeError(f"{path}: {len(open_edges)} bad edges, first {open_edges[0]}")
        enclosed = sum(
            a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
            for a, b, c in rounded
        ) / 6.0
        if volume is not None and abs(enclosed - volume) > tolerance:
            raise RuntimeError(f"{path}: volume {enclosed:.4f}, closed form {volume:.4f}")
        with open(os.path.join(HERE, path), "wb") as out:
            out.write(os.path.basename(path).encode().ljust(80, b"\0"))
            out.write(struct.pack("<I", len(rounded)))
            for t in rounded:
                out.write(struct.pack("<12fH", 0, 0, 0, *t[0], *t[1], *t[2], 0))
        told = "" if volume is None else f" (closed form {volume:.3f})"
        print(f"{path}: {len(rounded)} triangles, {enclosed:.3f} mm3{told}")


def rounded_area(width, height, radius):
    return width * height - (4 - math.pi) * radius * radius


def tip_length(diameter, point_angle=118.0):
    return 0.5 * diameter / math.tan(math.radians(0.5 * point_angle))


def bracket():
    s = Solid()
    stock, outline = rectangle(0, 0, 80, 60), rounded_rectangle(4, 4, 76, 56, 8)
    pocket = rounded_rectangle(14, 14, 46, 46, 6)
    counterbore, bore = circle(61, 30, 10), circle(61, 30, 5)
    slot = stadium(54, 68, 11, 3)
    blind = [circle(x, 51, 2) for x in (10, 30, 50, 70)]
    through = [circle(52, 42, 3), circle(70, 42, 3)]
    s.face(outline, [pocket, counterbore, slot] + blind + through, 0, True)
    s.wall(outline, -12, 0, True)
    s.face(stock, [outline], -12, True)
    s.wall(stock, -20, -12, True)
    s.face(stock, [bore] + through, -20, False)
    s.wall(pocket, -8, 0, False)
    s.face(pocket, [], -8, True)
    s.wall(counterbore, -6, 0, False)
    s.face(counterbore, [bore], -6, True)
    s.wall(bore, -20, -6, False)
    s.wall(slot, -5, 0, False)
    s.face(slot, [], -5, True)
    shoulder = -15 + tip_length(4)
    for x, loop in zip((10, 30, 50, 70), blind):
        s.wall(loop, shoulder, 0, False)
        s.drill_point(loop, shoulder, (x, 51, -15.0))
    for loop in through:
        s.wall(loop, -20, 0, False)
    volume = 80 * 60 * 8 + 12 * rounded_area(72, 52, 8) - 8 * rounded_area(32, 32, 6)
    volume -= math.pi * (100 * 6 + 25 * 14) + 5 * (14 * 6 + math.pi * 9)
    volume -= 4 * math.pi * 4 * (15 - tip_length(4) * 2 / 3) + 2 * math.pi * 9 * 20
    s.finish("bracket/bracket.stl", volume, 3.0)


def gouged_plate():
    s = Solid()
    stock, pocket = rectangle(0, 0, 60, 40), rounded_rectangle(10, 10, 50, 30, 5)
    holes = [circle(5, 20, 2), circle(55, 20, 2)]
    s.face(stock, [pocket] + holes, 0, True)
    s.wall(stock, -12, 0, True)
    s.face(stock, holes, -12, False)
    s.wall(pocket, -6, 0, False)
    s.face(pocket, [], -6, True)
    for loop in holes:
        s.wall(loop, -12, 0, False)
    volume = 60 * 40 * 12 - 6 * rounded_area(40, 20, 5) - 2 * math.pi * 4 * 12
    s.finish("gouged_plate/plate.stl", volume, 1.0)


def fanuc_plate():
    s = Solid()
    stock, outline = rectangle(0, 0, 90, 70), rounded_rectangle(4, 4, 86, 66, 8)
    pocket = rounded_rectangle(27, 23, 63, 47, 6)
    corners = [(14, 14), (76, 14), (76, 56), (14, 56)]
    bores, holes = [circle(x, y, 5) for x, y in corners], [circle(x, y, 3) for x, y in corners]
    around = [(45 + 8 * math.cos(math.radians(90 + 72 * k)), 35 + 8 * math.sin(math.radians(90 + 72 * k))) for k in range(5)]
    blind = [circle(x, y, 2) for x, y in around]
    s.face(outline, [pocket] + bores, 0, True)
    s.wall(outline, -9, 0, True)
    s.face(stock, [outline], -9, True)
    s.wall(stock, -18, -9, True)
    s.face(stock, holes, -18, False)
    s.wall(pocket, -6, 0, False)
    s.face(pocket, blind, -6, True)
    for bore, hole in zip(bores, holes):
        s.wall(bore, -4, 0, False)
        s.face(bore, [hole], -4, True)
        s.wall(hole, -18, -4, False)
    shoulder = -12 + tip_length(4)
    for (x, y), loop in zip(around, blind):
        s.wall(loop, shoulder, -6, False)
        s.drill_point(loop, shoulder, (x, y, -12.0))
    volume = 90 * 70 * 9 + 9 * rounded_area(82, 62, 8) - 6 * rounded_area(36, 24, 6)
    volume -= 4 * math.pi * (25 * 4 + 9 * 14)
    volume -= 5 * math.pi * 4 * (6 - tip_length(4) * 2 / 3)
    s.finish("fanuc_plate/plate.stl", volume, 3.0)


def linuxcnc_plate():
    s = Solid()
    stock, outline = rectangle(0, 0, 70, 50), rounded_rectangle(3, 3, 67, 47, 6)
    large, small = circle(22, 25, 10), circle(48, 25, 8)
    through = [circle(x, y, 2) for x, y in ((10, 10), (60, 10), (60, 40), (10, 40))]
    around = [(22 + 6 * math.cos(math.radians(60 * k)), 25 + 6 * math.sin(math.radians(60 * k))) for k in range(6)]
    blind = [circle(x, y, 2) for x, y in around]
    s.face(outline, [large, small] + through, 0, True)
    s.wall(outline, -5, 0, True)
    s.face(stock, [outline], -5, True)
    s.wall(stock, -12, -5, True)
    s.face(stock, through, -12, False)
    s.wall(large, -4, 0, False)
    s.face(large, blind, -4, True)
    s.wall(small, -3, 0, False)
    s.face(small, [], -3, True)
    for loop in through:
        s.wall(loop, -12, 0, False)
    shoulder = -8 + tip_length(4)
    for (x, y), loop in zip(around, blind):
        s.wall(loop, shoulder, -4, False)
        s.drill_point(loop, shoulder, (x, y, -8.0))
    volume = 70 * 50 * 7 + 5 * rounded_area(64, 44, 6) - math.pi * (100 * 4 + 64 * 3)
    volume -= 4 * math.pi * 4 * 12 + 6 * math.pi * 4 * (4 - tip_length(4) * 2 / 3)
    s.finish("linuxcnc_plate/plate.stl", volume, 3.0)


def wire_punch():
    s = Solid()
    outline = rounded_rectangle(-10, -6, 10, 6, 2)
    s.face(outline, [], 20, True)
    s.wall(outline, 0, 20, True)
    s.face(outline, [], 0, False)
    s.finish("wire_punch/punch.stl", 20 * rounded_area(20, 12, 2), 1.0)


def wire_die():
    """The opening is that of the punch at the top, 2 degrees wider below."""
    s = Solid()
    q = 20 * math.tan(math.radians(2))
    n = segments(2 + q, math.pi / 2)

    def opening(radius):
        return [
            (cx + radius * math.cos(start + math.pi / 2 * i / n), cy + radius * math.sin(start + math.pi / 2 * i / n))
            for cx, cy, start in ((8, -4, -math.pi / 2), (8, 4, 0), (-8, 4, math.pi / 2), (-8, -4, math.pi))
            for i in range(n + 1)
        ]

    plate, top, bottom = rectangle(-20, -15, 20, 15), opening(2), opening(2 + q)
    s.face(plate, [top], 20, True)
    s.wall(plate, 0, 20, True)
    s.ruled_wall(bottom, top, 0, 20, False)
    s.face(plate, [bottom], 0, False)

    def area(w):
        return rounded_area(20 + 2 * w * q, 12 + 2 * w * q, 2 + w * q)

    s.finish("wire_die/die.stl", 20 * 40 * 30 - 20 / 6 * (area(0) + 4 * area(0.5) + area(1)), 1.0)


def wire_ruled():
    """A circle below, a square above; equal shares of arcs and lines belong together."""
    s = Solid()
    n = segments(8, math.pi / 4) * 2
    circle_points, square_points = [], []
    for k in range(8):
        a, b = (((x > 1e-9) - (x < -1e-9), (y > 1e-9) - (y < -1e-9)) for x, y in (
            (math.cos(math.pi / 4 * j), math.sin(math.pi / 4 * j)) for j in (k, k + 1)))
        for i in range(n):
            angle = math.pi / 4 * (k + i / n)
            circle_points.append((8 * math.cos(angle), 8 * math.sin(angle)))
            square_points.append(tuple(8 * (p + (q - p) * i / n) for p, q in zip(a, b)))
    s.face(square_points, [], 20, True)
    s.ruled_wall(circle_points, square_points, 0, 20, True, 32)
    s.face(circle_points, [], 0, False)

    def middle(t):
        """Of the section half way, 0 <= t <= 1 from the middle of the side x = 8 to its corner."""
        return (4 * math.cos(math.pi / 4 * t) + 4, 4 * math.sin(math.pi / 4 * t) + 4 * t)

    steps = 20000
    half = 8 * sum(cross((0, 0), middle(i / steps), middle((i + 1) / steps)) / 2 for i in range(steps))
    s.finish("wire_ruled/ruled.stl", 20 / 6 * (64 * math.pi + 4 * half + 256), 0.5)


def circle_diamond_square():
    s = Solid()
    stock, square = rectangle(-40, -40, 40, 40), rectangle(-38, -38, 38, 38)
    diamond = [(37, 0), (0, 37), (-37, 0), (0, -37)]
    disc, bore = circle(0, 0, 25), circle(0, 0, 10)
    s.face(disc, [bore], 0, True)
    s.wall(disc, -6, 0, True)
    s.face(diamond, [disc], -6, True)
    s.wall(diamond, -12, -6, True)
    s.face(square, [diamond], -12, True)
    s.wall(square, -18, -12, True)
    s.face(stock, [square], -18, True)
    s.wall(stock, -25, -18, True)
    s.face(stock, [bore], -25, False)
    s.wall(bore, -25, 0, False)
    volume = 6 * math.pi * 625 + 6 * 2 * 37 * 37 + 6 * 76 * 76 + 7 * 80 * 80 - 25 * math.pi * 100
    s.finish("circle_diamond_square/circle_diamond_square.stl", volume, 2.0)


def two_sides():
    """In the second clamping: the round pocket is on top, the first pocket below."""
    s = Solid()
    stock, first = rectangle(0, 0, 60, 40), rounded_rectangle(8, 12, 48, 32, 5)
    second, hole = circle(28, 22, 12), circle(28, 22, 3)
    s.face(stock, [second], 0, True)
    s.wall(second, -8, 0, False)
    s.face(second, [hole], -8, True)
    s.wall(hole, -14, -8, False)
    s.face(first, [hole], -14, False)
    s.wall(first, -20, -14, False)
    s.face(stock, [first], -20, False)
    s.wall(stock, -20, 0, True)
    volume = 60 * 40 * 20 - 8 * math.pi * 144 - 6 * rounded_area(40, 20, 5) - 6 * math.pi * 9
    s.finish("two_sides/two_sides.stl", volume, 1.0)


def macro_plate():
    s = Solid()
    stock, outline = rectangle(-50, -40, 50, 40), rounded_rectangle(-46, -36, 46, 36, 10)
    pocket = rounded_rectangle(-12, -8, 12, 8, 5)
    c, t = math.cos(math.radians(20)), math.sin(math.radians(20))
    corners = [(-30 + x * c - y * t, x * t + y * c) for x, y in ((-9, -17), (9, -17), (-9, 17))]
    left = rounded_polygon(corners, 5)
    right = [(-x, y) for x, y in reversed(left)]
    through = [circle(22 * math.cos(math.radians(a)), 22 * math.sin(math.radians(a)), 2)
               for a in (60, 90, 120, 240, 270, 300)]
    places = [(sx * x, sy * 28) for sx in (1, -1) for sy in (1, -1) for x in (38, 28)]
    blind = [circle(x, y, 2.5) for x, y in places]
    s.face(outline, [pocket, left, right] + through + blind, 0, True)
    s.wall(outline, -8, 0, True)
    s.face(stock, [outline], -8, True)
    s.wall(stock, -20, -8, True)
    s.face(stock, through, -20, False)
    for loop, depth in ((pocket, 5), (left, 4), (right, 4)):
        s.wall(loop, -depth, 0, False)
        s.face(loop, [], -depth, True)
    for loop in through:
        s.wall(loop, -20, 0, False)
    shoulder = -10 + tip_length(5)
    for (x, y), loop in zip(places, blind):
        s.wall(loop, shoulder, 0, False)
        s.drill_point(loop, shoulder, (x, y, -10.0))
    volume = 100 * 80 * 12 + 8 * rounded_area(92, 72, 10) - 5 * rounded_area(24, 16, 5)
    volume -= 2 * 4 * rounded_polygon_area(corners, 5) + 6 * math.pi * 4 * 20
    volume -= 8 * math.pi * 6.25 * (10 - tip_length(5) * 2 / 3)
    s.finish("macro_plate/macro_plate.stl", volume, 3.0)


def polar_boss():
    s = Solid()
    bar, square = circle(0, 0, 30), rounded_rectangle(-12, -12, 12, 12, 5)
    around = 42 / math.sqrt(3)
    corners = [(around * math.cos(math.pi * k / 3), around * math.sin(math.pi * k / 3)) for k in range(6)]
    hexagon, slot = rounded_polygon(corners, 3), stadium(-4, 4, 0, 4)
    places = [(26 * math.cos(math.radians(a)), 26 * math.sin(math.radians(a))) for a in range(30, 360, 60)]
    holes = [circle(x, y, 2) for x, y in places]
    s.face(square, [slot], 0, True)
    s.wall(square, -5, 0, True)
    s.wall(slot, -6, 0, False)
    s.face(slot, [], -6, True)
    s.face(hexagon, [square], -5, True)
    s.wall(hexagon, -12, -5, True)
    s.face(bar, [hexagon] + holes, -12, True)
    s.wall(bar, -40, -12, True)
    s.face(bar, [], -40, False)
    shoulder = -20 + tip_length(4)
    for (x, y), loop in zip(places, holes):
        s.wall(loop, shoulder, -12, False)
        s.drill_point(loop, shoulder, (x, y, -20.0))
    volume = math.pi * 900 * 28 + 7 * rounded_polygon_area(corners, 3) + 5 * rounded_area(24, 24, 5)
    volume -= 6 * (8 * 8 + math.pi * 16) + 6 * math.pi * 4 * (8 - tip_length(4) * 2 / 3)
    s.finish("polar_boss/polar_boss.stl", volume, 3.0)


# ---- free-form patch: z = -4 + 1.5 sin(pi x / 20) cos(pi y / 15) over 40 x 30 mm ------------------------------------


# ---- turned parts ---------------------------------------------------------------------------------------------------


def sphere_arc(cx, cz, radius, start, sweep, steps=12):
    """Points (r, z) of an arc, angles from +r towards +z."""
    return [(cx + radius * math.cos(start + sweep * i / steps), cz + radius * math.sin(start + sweep * i / steps))
            for i in range(steps + 1)]


def section_volume(points):
    """Of the solid of revolution of a section from the axis to the axis, z falling."""
    return sum(math.pi / 3 * (a[1] - b[1]) * (a[0] * a[0] + a[0] * b[0] + b[0] * b[0])
               for a, b in zip(points, points[1:]))


def zip_sections(solid, sections, angles, shift):
    """Triangles between sections at angles about Z. A section is a list of (label, (r, z)) from the axis to the axis;
    equal labels are joined, of others the shorter way is taken. `shift` gives the labels of the first section the names
    that they have a turn later."""
    count = len(sections)

    def place(k, p):
        angle = angles[k % count]
        return (p[0] * math.cos(angle), p[0] * math.sin(angle), p[1])

    for k in range(count):
        a = sections[k]
        b = sections[k + 1] if k + 1 < count else [(shift(label), p) for label, p in sections[0]]
        in_a, in_b = {label for label, _ in a}, {label for label, _ in b}
        i = j = 0
        while i + 1 < len(a) or j + 1 < len(b):
            if j + 1 == len(b):
                first = True
            elif i + 1 == len(a):
                first = False
            elif a[i][0] == b[j + 1][0] or b[j][0] == a[i + 1][0]:
                first = b[j][0] == a[i + 1][0]
            elif (a[i + 1][0] in in_b) != (b[j + 1][0] in in_a):
                first = a[i + 1][0] not in in_b
            else:
                first = math.dist(a[i + 1][1], b[j][1]) < math.dist(a[i][1], b[j + 1][1])
            if first:
                solid.triangles.append((place(k, a[i][1]), place(k, a[i + 1][1]), place(k + 1, b[j][1])))
                i += 1
            else:
                solid.triangles.append((place(k, a[i][1]), place(k + 1, b[j + 1][1]), place(k + 1, b[j][1])))
                j += 1


def threaded(lines, corners, top, bottom, angle, pitch, start, root, flat):
    """The stretch from z = top down to bottom of the least of the lines r = p + q z, which meet at `corners`, at an angle about
    Z, less a right-handed thread of 60 degrees whose groove is at z = start for angle 0: tip `flat` wide on the radius
    `root`. Labelled points."""
    slope = 1 / math.tan(math.radians(30))

    def groove(z):
        off = (z - start - pitch * angle / (2 * math.pi)) % pitch
        off = min(off, pitch - off)
        return root + max(0.0, off - flat / 2) * slope

    def plain(z):
        return min(p + q * z for p, q in lines)

    def cut(z):
        return min(groove(z), plain(z))

    points = [("top", top), ("bottom", bottom)]
    points += [(("corner", z), z) for z in corners if plain(z) <= groove(z)]
    # Corners of the grooves' tips, and where flanks meet the lines.
    first = math.floor((bottom - start) / pitch - angle / (2 * math.pi)) - 1
    for k in range(first, math.ceil((top - start) / pitch) + 2):
        z = start + pitch * (k + angle / (2 * math.pi))
        for n, (p, q) in enumerate(lines):
            if q != 0 and abs((root - p) / q - z) <= flat / 2 and abs(plain((root - p) / q) - root) < 1e-9:
                points.append((("meet", k, 0, n), (root - p) / q))
        for side in (-1, 1):
            tip = z + side * flat / 2
            if root <= plain(tip):
                points.append((("tip", k, side), tip))
            for n, (p, q) in enumerate(lines):
                # root + (side (meet - z) - flat / 2) slope = p + q meet
                meet = (p - root + (side * z + flat / 2) * slope) / (side * slope - q)
                if abs(p + q * meet - plain(meet)) < 1e-9 and abs(groove(meet) - plain(meet)) < 1e-9:
                    points.append((("meet", k, side, n), meet))
    inner = [(label, z) for label, z in points if bottom < z < top or label in ("top", "bottom")]
    return [(label, (cut(z), z)) for label, z in sorted(inner, key=lambda point: -point[1])]


def thread_angles(pitch, start, corners, count=192):
    """Angles of sections: where corners of the groove come and go, at the heights and distances from the middle of the
    groove in `corners`, there is a section on either side of it."""
    events = [(z - start + side * off) / pitch % 1.0 * 2 * math.pi
              for z, offs in corners for off in offs for side in (-1, 1)]
    angles = [2 * math.pi * k / count for k in range(count)]
    angles = [a for a in angles if all(abs(a - e) > 1e-3 for e in events)]
    return sorted(angles + [e + side * 2e-5 for e in events for side in (-1, 1)])


def finish_threaded(sections, angles, path):
    """Writes the solid of sections (labelled points) at angles about Z; its volume against that of the sections, with and
    without what the chords between them cut off."""
    s = Solid()
    # At angle 2 pi the groove k of angle 0 is the one that is k - 1 there.
    zip_sections(s, sections, angles,
                 lambda label: (label[0], label[1] - 1) + label[2:] if label[0] in ("tip", "meet") else label)
    volumes = [section_volume([p for _, p in section]) for section in sections]
    steps = [(b - a) % (2 * math.pi) for a, b in zip(angles, angles[1:] + angles[:1])]
    means = [(a + b) / 2 for a, b in zip(volumes, volumes[1:] + volumes[:1])]
    inscribed = sum(v * math.sin(step) / (2 * math.pi) for v, step in zip(means, steps))
    s.finish(path, inscribed, 1.0)
    print(f"  without facets: {sum(v * step for v, step in zip(means, steps)) / (2 * math.pi):.2f} mm3")


def rest_of(points):
    return [(("rest", i), p) for i, p in enumerate(points)]


def wl4_shaft():
    q = math.pi / 2
    rest = [(8.2, -26.0)] + sphere_arc(8.2, -26.2, 0.2, q, q, 6)[1:] + sphere_arc(8.2, -29.8, 0.2, 2 * q, q, 6)
    rest += [(12.0, -30.0), (16.0, -50.0)] + sphere_arc(20.0, -62.0, 4.0, 2 * q, q, 24)
    rest += sphere_arc(20.5, -68.0, 2.0, q, -q, 18) + [(22.5, -100.0), (0.0, -100.0)]
    meet = 0.2 + 1.5 * math.tan(math.radians(30))
    angles = thread_angles(2.5, 8.0, ((-0.5, (0.2,)), (-2.0, (meet,)), (-26.0, (0.2, meet))))
    lines, corners = [(10.0, 0.0), (8.0, -1.0)], [-2.0]
    sections = [
        [("front", (0.0, 0.0))]
        + threaded(lines, corners, 0.0, -26.0, angle, 2.5, 8.0, 8.5, 0.4) + rest_of(rest)
        for angle in angles
    ]
    finish_threaded(sections, angles, "wl4_shaft/shaft.stl")


def fanuc_shaft():
    """Chamfer 1, cylinder 20, radius 2, cone of 45 degrees to cylinder 30, radius 3, collar 40 up to the
    bar, where the nose of 0.4 leaves its radius."""
    q = math.pi / 2
    t = 2 * math.tan(math.radians(22.5))  # of the radius of 2 from its corner
    points = [(0.0, 0.0), (9.0, 0.0), (10.0, -1.0)]
    points += sphere_arc(12.0, -20.0 + t, 2.0, math.pi, q / 2, 16)
    points += [(15.0, -25.0)] + sphere_arc(18.0, -37.0, 3.0, math.pi, q, 24)
    points += [(20.0, -40.0)] + sphere_arc(20.4, -61.6, 0.4, math.pi, q, 12)  # the nose, at the bar's shoulder
    points += [(22.0, -62.0), (22.0, -90.0), (0.0, -90.0)]
    angles = [2 * math.pi * k / 192 for k in range(192)]
    finish_threaded([rest_of(points) for _ in angles], angles, "fanuc_shaft/shaft.stl")


def flexnc_shaft():
    """Chamfer, cylinder 20 with M20 x 1.5 up to a groove, root radius 3 and cone of 30 degrees, cylinder, radii 2 and 3."""
    q, thirty = math.pi / 2, math.radians(30)
    # Corners of the blade in the groove, 16 in diameter and 5 wide.
    rest = [(8.2, -18.0)] + sphere_arc(8.2, -18.2, 0.2, q, q, 6)[1:] + sphere_arc(8.2, -22.8, 0.2, 2 * q, q, 6)
    rest += [(10.0, -23.0)] + sphere_arc(13.0, -26.5, 3.0, math.pi, thirty, 12)
    neck = 10.0 + math.tan(thirty) * (15 - 3 * math.sin(thirty)) + 3 * (1 - math.cos(thirty))
    rest += [(neck, -41.5)]
    rise = 22.0 - neck
    apart = math.sqrt(25.0 - rise * rise)  # of the centres of both radii, along Z
    meet = math.atan2(apart, rise)
    # The nose of 0.4 between cylinder and radius.
    nose = -53.5 + math.sqrt(2.4**2 - 0.4**2)
    angle = math.atan2(nose + 53.5, 0.4)
    rest += sphere_arc(neck + 0.4, nose, 0.4, math.pi, angle, 10)
    rest += sphere_arc(neck, -53.5, 2.0, angle, meet - angle, 16)[1:]
    rest += sphere_arc(22.0, -53.5 + apart, 3.0, math.pi + meet, q - meet, 24)[1:]
    rest += [(22.0, -80.0), (0.0, -80.0)]
    meet = 0.15 + 0.92 * math.tan(thirty)
    angles = thread_angles(1.5, 4.0, ((-0.58, (0.15,)), (-1.5, (meet,)), (-18.0, (0.15, meet))))
    lines, corners = [(10.0, 0.0), (8.5, -1.0)], [-1.5]
    sections = [
        [("front", (0.0, 0.0))] + threaded(lines, corners, 0.0, -18.0, angle, 1.5, 4.0, 9.08, 0.3) + rest_of(rest)
        for angle in angles
    ]
    finish_threaded(sections, angles, "flexnc_shaft/shaft.stl")


def flexnc_bore():
    """A ring: from the face a chamfer, cylinder 40 with a thread of major diameter 41.8 up to a groove, a radius of 11 down to
    18; a ring groove in the face."""
    q = math.pi / 2
    ring = [(27.0, 0.0)] + sphere_arc(27.1, -2.9, 0.1, 2 * q, q, 6) + sphere_arc(30.9, -2.9, 0.1, -q, q, 6)
    # The nose of 0.4 between cylinder and radius.
    nose = -31.0 + math.sqrt(11.4**2 - 0.4**2)
    angle = math.atan2(nose + 31.0, -0.4)
    bottom = [(31.0, 0.0), (35.0, 0.0), (35.0, -40.0), (9.0, -40.0)]
    bottom += sphere_arc(20.0, -31.0, 11.0, math.pi, angle - math.pi, 60)
    bottom += sphere_arc(19.6, nose, 0.4, angle - math.pi, math.pi - angle, 10)
    bottom += [(20.0, -17.0)] + sphere_arc(21.0, -16.8, 0.2, -q, q, 6) + sphere_arc(21.0, -13.2, 0.2, 0.0, q, 6)
    meet = 0.1 + 0.9 * math.tan(math.radians(30))
    angles = thread_angles(1.5, 4.0, ((-0.6, (0.1,)), (-1.5, (meet,)), (-13.0, (0.1, meet))))
    lines, corners = [(-20.0, 0.0), (-21.5, -1.0)], [-1.5]

    def section(angle):
        # The thread inside is one outside with the radius counted the other way.
        inside = threaded(lines, corners, 0.0, -13.0, angle, 1.5, 4.0, -20.9, 0.2)
        points = rest_of(bottom) + [(label, (-r, z)) for label, (r, z) in reversed(inside)]
        return points + [(("ring", i), p) for i, p in enumerate(ring + [(31.0, 0.0)])]

    finish_threaded([section(angle) for angle in angles], angles, "flexnc_bore/bore.stl")


def height(x, y):
    return -4 + 1.5 * math.sin(math.pi * x / 20) * math.cos(math.pi * y / 15)


def unit_normal(x, y):
    dx = 1.5 * math.pi / 20 * math.cos(math.pi * x / 20) * math.cos(math.pi * y / 15)
    dy = -1.5 * math.pi / 15 * math.sin(math.pi * x / 20) * math.sin(math.pi * y / 15)
    length = math.sqrt(dx * dx + dy * dy + 1)
    return -dx / length, -dy / length, 1 / length


def patch_mesh():
    s = Solid()
    nx, ny = 64, 48
    xs, ys = [40 * i / nx for i in range(nx + 1)], [30 * j / ny for j in range(ny + 1)]
    point = lambda i, j: (xs[i], ys[j], height(xs[i], ys[j]))
    for i in range(nx):
        for j in range(ny):
            a, b, c, d = point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)
            s.triangles += [(a, b, c), (a, c, d)]
    rim = [(i, 0) for i in range(nx)] + [(nx, j) for j in range(ny)]
    rim += [(i, ny) for i in range(nx, 0, -1)] + [(0, j) for j in range(ny, 0, -1)]
    for k, (i, j) in enumerate(rim):
        a, b = point(i, j), point(*rim[(k + 1) % len(rim)])
        c, d = (b[0], b[1], -12), (a[0], a[1], -12)
        s.triangles += [(a, d, c), (a, c, b), (d, (20, 15, -12), c)]
    # The sine and cosine integrate to zero over whole waves.
    s.finish("freeform_patch/patch.stl", 40 * 30 * 8.0, 3.0)


def patch_program():
    """Raster with a ball 6: the centre runs on the offset surface, the tip 3 mm below it."""
    lines = ["%", "O0400 (FREE-FORM PATCH, BALL 6, MADE BY MAKE_NOMINALS.PY)", "N10 G17 G21 G40 G49 G80 G90 G94",
             "N20 T1 M6", "N30 S12000 M3", "N40 G0 X-4 Y-1 Z5", "N50 G43 Z3 H1"]
    radius, number = 3.0, 60
    rows = 57
    for row in range(rows):
        y0 = -1 + 32 * row / (rows - 1)
        xs = [-1 + 0.5 * i for i in range(85)]
        for k, x0 in enumerate(xs if row % 2 == 0 else xs[::-1]):
            n = unit_normal(x0, y0)
            x, y = x0 + radius * n[0], y0 + radius * n[1]
            z = height(x0, y0) + radius * n[2] - radius
            words = f"X{x:.4f} Y{y:.4f} Z{z:.4f}"
            if row == 0 and k == 0:
                lines.append(f"N{number} G0 X{x:.4f} Y{y:.4f}")
                lines.append(f"N{number + 10} G1 Z{z:.4f} F800")
                number += 20
            elif k == 0:
                lines.append(f"N{number} {words} F1200")
                number += 10
            else:
                lines.append(words)
    lines += [f"N{number} G0 Z20", f"N{number + 10} M5", f"N{number + 20} M30", "%"]
    with open(os.path.join(HERE, "freeform_patch/patch.nc"), "w", newline="\n") as out:
        out.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    bracket()
    gouged_plate()
    fanuc_plate()
    linuxcnc_plate()
    wire_punch()
    wire_die()
    wire_ruled()
    circle_diamond_square()
    two_sides()
    macro_plate()
    polar_boss()
    wl4_shaft()
    fanuc_shaft()
    flexnc_shaft()
    flexnc_bore()
    patch_mesh()
    patch_program()
