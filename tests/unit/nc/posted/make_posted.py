#!/usr/bin/env python3
"""Writes programs in the habits of posts and of people, with what their paths must be.

Every program is made from moves whose length and extent are known by closed forms here; posts only decide how they
are written. No interpreter has a part in it. Beside the programs stands posted.tsv: file, control, flavour, the extent
of all feed motions (x0 y0 z0 x1 y1 z1), their length, and the height of the end; '-' is not told.

Run without arguments; writes next to itself. Needs nothing but Python 3.
"""

import math
import os

HERE = os.path.dirname(os.path.abspath(__file__))
TOP = 200.0  # mm, the height of the start in the workpiece frame: machine zero in Z


class Truth:
    """Length and extent of what is cut."""

    def __init__(self):
        self.at = [0.0, 0.0, TOP]
        self.length = 0.0
        self.low = [math.inf] * 3
        self.high = [-math.inf] * 3
        self.told = True

    def see(self, p):
        for k in range(3):
            self.low[k] = min(self.low[k], p[k])
            self.high[k] = max(self.high[k], p[k])

    def rapid(self, x=None, y=None, z=None):
        self.at = [self.at[k] if v is None else v for k, v in enumerate((x, y, z))]

    def line(self, x=None, y=None, z=None):
        self.see(self.at)
        to = [self.at[k] if v is None else v for k, v in enumerate((x, y, z))]
        self.length += math.dist(self.at, to)
        self.at = to
        self.see(self.at)

    def arc(self, cw, x, y, i, j, z=None):
        """In the XY plane; a full circle where the end is the start."""
        self.see(self.at)
        cx, cy = self.at[0] + i, self.at[1] + j
        r = math.hypot(i, j)
        a0 = math.atan2(-j, -i)
        a1 = math.atan2(y - cy, x - cx)
        sweep = (a0 - a1 if cw else a1 - a0) % (2 * math.pi)
        if sweep < 1e-9:
            sweep = 2 * math.pi
        z = self.at[2] if z is None else z
        self.length += math.hypot(r * sweep, z - self.at[2])
        for quarter in range(-8, 9):
            a = quarter * math.pi / 2
            along = (a0 - a if cw else a - a0)
            if -1e-9 <= along <= sweep + 1e-9:
                self.see([cx + r * math.cos(a), cy + r * math.sin(a), self.at[2]])
        self.at = [x, y, z]
        self.see(self.at)


class Program:
    """A program with its truth. `point`: whole numbers get a point; `digits`: of fractions."""

    def __init__(self, name, control, flavour="", point=True, digits=3, number=0, step=0, unit=1.0, eob=""):
        self.name, self.control, self.flavour = name, control, flavour
        self.point, self.digits, self.number, self.step, self.unit, self.eob = point, digits, number, step, unit, eob
        self.lines = []
        self.truth = Truth()
        self.modal = None
        self.last = {}
        self.feed = None
        self.always = False  # every block names its G code
        self.end_z = TOP

    def num(self, v):
        text = f"{v / self.unit:.{self.digits}f}".rstrip("0")
        if text in ("-0.", "0."):
            text = "0."
        return text if self.point else text.rstrip(".")

    def raw(self, text, numbered=True):
        if self.step and numbered and text and text[0] not in "(%O;:/":
            text = f"N{self.number} {text}"
            self.number += self.step
        if self.eob and text and text[0] not in "%(":
            text += self.eob
        self.lines.append(text)

    def text(self, block):
        for line in block.strip("\n").split("\n"):
            self.raw(line.strip())

    def words(self, **axes):
        out = ""
        for key, value in axes.items():
            if value is None:
                continue
            value = round(value, 6)
            if key in "XYZ" and self.last.get(key) == value:
                continue
            if key in "XYZ":
                self.last[key] = value
            out += f" {key}{self.num(value)}"
        return out

    def code(self, g):
        if self.modal == g and not self.always:
            return ""
        self.modal = g
        return f" {g}"

    def forget(self):
        self.modal, self.last, self.feed = None, {}, None

    def f(self, feed):
        if feed is None or feed == self.feed:
            return ""
        self.feed = feed
        return f" F{self.num(feed)}"

    def rapid(self, x=None, y=None, z=None, tail="", head=""):
        self.truth.rapid(x, y, z)
        w = self.words(X=x, Y=y, Z=z)
        if w or tail or head:
            self.raw((head + self.code("G0") + w + tail).strip())

    def line(self, x=None, y=None, z=None, f=None, head="", tail=""):
        self.truth.line(x, y, z)
        w = self.words(X=x, Y=y, Z=z)
        if w:
            self.raw((head + self.code("G1") + w + tail + self.f(f)).strip())

    def arc(self, cw, x, y, i, j, z=None, f=None, as_r=False):
        full = math.dist(self.truth.at[:2], (x, y)) < 1e-9
        self.truth.arc(cw, x, y, i, j, z)
        w = self.words(X=x, Y=y, Z=z) if not full else self.words(Z=z)
        if as_r and not full:
            r = math.hypot(i, j)
            w += f" R{self.num(r)}"
        else:
            w += (f" I{self.num(i)}" if abs(i) > 1e-9 or full else "") + (f" J{self.num(j)}" if abs(j) > 1e-9 else "")
        self.raw((self.code("G2" if cw else "G3") + w + self.f(f)).strip())

    def drilled(self, x, y, r, z, steps=1, again=0.0, out=False):
        """What a cycle cuts in one hole: `again` is fed twice before each step but the first."""
        t = self.truth
        t.rapid(x, y)
        t.rapid(z=r)
        t.line(z=z)
        t.length += (steps - 1) * again + (r - z if out else 0.0)
        t.rapid(z=r)

    def row(self):
        t = self.truth
        box = [f"{v:.4f}" for v in t.low + t.high] if t.told else ["-"] * 6
        length = f"{t.length:.4f}" if t.told else "-"
        end = "-" if self.end_z is None else f"{self.end_z:.4f}"
        return "\t".join([self.name, self.control, self.flavour or "-"] + box + [length, end])


PROGRAMS = []


def add(program):
    PROGRAMS.append(program)
    return program


# ---- heads and ends of posts ------------------------------------------------------------------------------------------


def fusion_fanuc(name, title, number=1001, control="fanuc-mill", flavour="", inch=False):
    p = add(Program(name, control, flavour, number=10, step=5, unit=25.4 if inch else 1.0, digits=4 if inch else 3))
    p.text(f"%\nO{number} ({title})")
    p.text("(USING HIGH FEED G1 F5000. INSTEAD OF G0.)\n(T1 D=10. CR=0. - ZMIN=-12. - FLAT END MILL)")
    p.text(f"G90 G94 G17 G49 G40 G80\n{'G20' if inch else 'G21'}\nG28 G91 Z0.\nG90")
    return p


def fusion_tool(p, n, speed, x, y, z, m6="M6"):
    p.forget()
    p.text(f"(TOOL {n})\nT{n} {m6}\nS{speed} M3\nG54\nM8")
    p.rapid(x, y, head="")
    p.truth.rapid(z=z)
    p.last["Z"] = z
    p.raw(f"G43 Z{p.num(z)} H{n:02d}")


def fusion_end(p):
    p.text("M9\nM5\nG28 G91 Z0.\nG90\nG28 G91 X0. Y0.\nG90\nM30\n%")


def fusion_haas(name, title, number=1010, inch=False):
    p = add(Program(name, "fanuc-mill", "haas", number=10, step=5, unit=25.4 if inch else 1.0, digits=4 if inch else 3))
    p.text(f"%\nO{number:05d} ({title})")
    p.text("(MACHINE)\n(  VENDOR: HAAS AUTOMATION)\n(  MODEL: VF-2)\n(T1 D=10. CR=0. - ZMIN=-12. - FLAT END MILL)")
    p.text(f"G90 G94 G17\n{'G20' if inch else 'G21'}\nG53 G0 Z0.")
    return p


def haas_end(p):
    p.text("M9\nM5\nG53 G0 Z0.\nG53 G0 Y0.\nM30\n%")


def mastercam(name, title, number=100):
    p = add(Program(name, "fanuc-mill", number=100, step=2))
    p.text(f"%\nO{number:04d}({title})\n(DATE=DD-MM-YY - 12-03-24 TIME=HH:MM - 10:15)\n(MCX FILE - C:\\PARTS\\PART.MCAM)")
    p.text("(MATERIAL - ALUMINUM MM - 2024)\n( T1 | 10. FLAT ENDMILL | H1 )")
    p.text("G21\nG0 G17 G40 G49 G80 G90")
    return p


def mastercam_tool(p, n, speed, x, y, z):
    p.forget()
    p.raw(f"T{n} M6")
    p.truth.rapid(x, y)
    p.truth.rapid(z=z)
    p.last.update({"X": x, "Y": y, "Z": z})
    p.modal = "G0"
    p.raw(f"G0 G90 G54 X{p.num(x)} Y{p.num(y)} S{speed} M3")
    p.raw(f"G43 H{n} Z{p.num(z)}")


def mastercam_end(p):
    p.text("M5\nG91 G28 Z0.\nG28 X0. Y0.\nM30\n%")


def fusion_linuxcnc(name, title):
    p = add(Program(name, "linuxcnc", number=10, step=5))
    p.text(f"%\n({title})\n(T1  D=6. CR=0. - ZMIN=-5. - FLAT END MILL)")
    p.text("G90 G94 G17 G91.1\nG21\nG53 G0 Z0.")
    return p


def linuxcnc_end(p):
    p.text("M9\nM5\nG53 G0 Z0.\nM30\n%")


def freecad(name, post, control, flavour=""):
    p = add(Program(name, control, flavour, point=True, digits=3))
    p.always = True
    p.text(f"(Exported by FreeCAD)\n(Post Processor: {post})\n(Output Time:2024-03-12 10:15:00.000000)")
    p.text("(begin preamble)\nG17 G54 G40 G49 G80 G90\nG21" if flavour != "grbl" else "(Begin preamble)\nG17 G90\nG21")
    return p


def fusion_mach3(name, title):
    p = add(Program(name, "linuxcnc", "mach3", number=10, step=5))
    p.text(f"({title})\n(T1  D=6. CR=0. - ZMIN=-5. - FLAT END MILL)")
    p.text("G90 G94 G91.1 G40 G49 G17\nG21\nG28 G91 Z0.\nG90")
    return p


def fusion_grbl(name, title):
    p = add(Program(name, "linuxcnc", "grbl", point=False))
    p.text(f"({title})\n(T1 D=6 CR=0 - ZMIN=-5 - FLAT END MILL)\nG90 G94\nG17\nG21\nG28 G91 Z0\nG90\n")
    return p


# ---- what is cut ------------------------------------------------------------------------------------------------------


def rectangle(p, x0, y0, x1, y1, z, f, r=0.0, cw=False):
    """From (x0 + r, y0) around, counter-clockwise."""
    p.line(x1 - r, y0, f=f)
    if r:
        p.arc(False, x1, y0 + r, 0.0, r)
    p.line(x1, y1 - r)
    if r:
        p.arc(False, x1 - r, y1, -r, 0.0)
    p.line(x0 + r, y1)
    if r:
        p.arc(False, x0, y1 - r, 0.0, -r)
    p.line(x0, y0 + r)
    if r:
        p.arc(False, x0 + r, y0, r, 0.0)


def helix_pocket(p, cx, cy, radii, depth, pitch, f):
    """Down a helix of the first radius, then full circles outwards."""
    r = radii[0]
    p.line(cx + r, cy, f=f)
    z = p.truth.at[2]
    while z > depth + 1e-9:
        z = max(depth, z - pitch)
        p.arc(False, cx + r, cy, -r, 0.0, z=z, f=f)
    for radius in radii:
        if radius != r:
            p.line(cx + radius, cy)
        p.arc(False, cx + radius, cy, -radius, 0.0)


def dome(p, radius, height_r, step, f, top=0.0):
    """Lines over a dome z = sqrt(R^2 - x^2 - y^2) - R, zigzag in X."""
    n = int(round(2 * radius / step))
    for row in range(n + 1):
        y = -radius + row * step
        xs = [-radius + k * step for k in range(n + 1)]
        if row % 2:
            xs.reverse()
        for k, x in enumerate(xs):
            z = math.sqrt(height_r**2 - x * x - y * y) - height_r + top
            if row == 0 and k == 0:
                p.rapid(x, y)
                p.line(z=round(z, 3), f=f / 2)
            else:
                p.line(x, y, round(z, 3), f=f)


def bolt_circle(n, r, cx=0.0, cy=0.0, start=0.0):
    return [
        (round(cx + r * math.cos(math.radians(start + 360 * k / n)), 3), round(cy + r * math.sin(math.radians(start + 360 * k / n)), 3))
        for k in range(n)
    ]


def holes(p, cycle, places, r, z, words, ret="G98", steps=1, again=0.0, out=False, close="G80", f=100.0):
    for k, (x, y) in enumerate(places):
        p.drilled(x, y, r, z, steps, again, out)
        if k == 0:
            p.raw(f"{ret} {cycle} X{p.num(x)} Y{p.num(y)} Z{p.num(z)} R{p.num(r)}{words} F{p.num(f)}")
            p.last.update({"X": x, "Y": y})
        else:
            p.raw(p.words(X=x, Y=y).strip())
    p.raw(close)
    p.forget()


# ---- Fanuc mills ------------------------------------------------------------------------------------------------------

p = fusion_fanuc("fusion-fanuc-drill.nc", "DRILL PLATE")
fusion_tool(p, 1, 2500, 10.0, 10.0, 15.0)
grid = [(10.0, 10.0), (70.0, 10.0), (70.0, 50.0), (10.0, 50.0)]
holes(p, "G81", grid, 5.0, -3.0, "", f=200.0)
p.text("M5\nM9\nG28 G91 Z0.\nG90\nM1")
fusion_tool(p, 2, 1800, 10.0, 10.0, 15.0)
holes(p, "G83", grid, 5.0, -22.0, " Q6.", steps=5, again=0.5, f=180.0)
p.text("M5\nM9\nG28 G91 Z0.\nG90\nM1")
fusion_tool(p, 3, 900, 40.0, 30.0, 15.0)
holes(p, "G82", [(40.0, 30.0)], 5.0, -4.5, " P500", f=90.0)
fusion_end(p)

p = fusion_fanuc("fusion-fanuc-tap.nc", "TAP M6", 1002)
fusion_tool(p, 4, 500, -15.0, 0.0, 20.0)
p.raw("M29 S500")
holes(p, "G84", [(-15.0, 0.0), (15.0, 0.0)], 5.0, -14.0, "", out=True, f=500.0)
fusion_end(p)

p = fusion_fanuc("fusion-fanuc-threadmill.nc", "THREAD MILL M20X1.5", 1003)
fusion_tool(p, 5, 3000, 0.0, 0.0, 15.0)
p.rapid(z=2.0)
p.line(z=-10.5, f=800.0)
p.line(4.0, 0.0, f=240.0)  # the middle of the tool, r of the path 4
z = -10.5
for _ in range(7):
    z += 1.5
    p.arc(False, 4.0, 0.0, -4.0, 0.0, z=z)
p.line(0.0, 0.0)
p.rapid(z=15.0)
fusion_end(p)

p = fusion_fanuc("fusion-fanuc-pocket.nc", "POCKET", 1004)
fusion_tool(p, 1, 6000, 30.0, 20.0, 15.0)
p.rapid(z=5.0)
p.line(z=1.0, f=1000.0)
helix_pocket(p, 30.0, 20.0, [3.0, 6.0, 9.0], -4.0, 1.0, 900.0)
p.line(30.0, 20.0)
p.rapid(z=15.0)
fusion_end(p)

# Cutter compensation: the outline 60 x 40, D row 1 is 5 (the job's), lead in and out along +Y and -X.
p = fusion_fanuc("fusion-fanuc-comp.nc", "CONTOUR WITH COMPENSATION", 1005)
fusion_tool(p, 1, 4000, -20.0, -20.0, 15.0)
p.rapid(z=5.0)
p.line(z=-6.0, f=300.0)
p.text("G41 G1 X0. Y-10. D01 F600.\nY40.\nX60.\nY0.\nX-10.\nG40 Y-20.")
t = p.truth
for x, y in [(-5.0, -10.0), (-5.0, 45.0), (65.0, 45.0), (65.0, -5.0), (-10.0, -5.0), (-10.0, -20.0)]:
    t.line(x, y)
p.forget()
p.rapid(z=15.0)
fusion_end(p)

p = mastercam("mastercam-fanuc-slots.nc", "SLOTS BY SUBPROGRAM")
mastercam_tool(p, 1, 3500, 0.0, 0.0, 25.0)
for k in range(3):
    p.rapid(0.0, 12.0 * k)
    p.text("M98 P1001")
    p.forget()
    t = p.truth
    t.rapid(z=2.0)
    t.line(z=-2.0)
    t.line(x=30.0)
    t.rapid(z=2.0)
p.rapid(z=25.0)
p.text("M5\nG91 G28 Z0.\nG28 X0. Y0.\nM30\nO1001\nG90 G0 Z2.\nG1 Z-2. F150.\nX30. F400.\nG0 Z2.\nM99\n%")

p = mastercam("mastercam-fanuc-ramp.nc", "RAMP CONTOUR", 200)
mastercam_tool(p, 2, 4000, 8.0, 0.0, 25.0)
p.rapid(z=2.0)
p.line(z=0.0, f=300.0)
for k in range(1, 5):
    p.line(52.0, 0.0, -1.5 * k + 0.75, f=700.0)
    p.arc(False, 60.0, 8.0, 0.0, 8.0)
    p.line(60.0, 32.0)
    p.arc(False, 52.0, 40.0, -8.0, 0.0)
    p.line(8.0, 40.0)
    p.arc(False, 0.0, 32.0, 0.0, -8.0)
    p.line(0.0, 8.0)
    p.arc(False, 8.0, 0.0, 8.0, 0.0, z=-1.5 * k)
p.rapid(z=25.0)
mastercam_end(p)

p = add(Program("hand-fanuc-macro.nc", "fanuc-mill"))
p.text("""
%
O2000(BOLT CIRCLE BY MACRO)
N10 G21 G17 G40 G49 G80 G90
N20 T3 M06
N30 G54 G90 G00 X0. Y0. S1200 M03
N40 G43 Z50. H03 M08
N50 G65 P9100 X10. Y0 Z-5. R2. I40. A0 H6
N60 G00 Z50. M09
N70 G91 G28 Z0. M05
N80 G90
N90 M30
O9100(HOLES ON A CIRCLE)
#2=0
WHILE[#2LT#11]DO1
#3=#1+#2*360/#11
G81X[#24+#4*COS[#3]]Y[#25+#4*SIN[#3]]Z#26R#18F100.
#2=#2+1
END1
G80
M99
%
""")
for x, y in [(10 + 40 * math.cos(math.radians(60 * k)), 40 * math.sin(math.radians(60 * k))) for k in range(6)]:
    p.drilled(x, y, 2.0, -5.0)

p = fusion_fanuc("fusion-fanuc-dome.nc", "PARALLEL FINISHING", 1009)
fusion_tool(p, 6, 12000, -12.0, -12.0, 15.0)
dome(p, 12.0, 40.0, 3.0, 1500.0)
p.rapid(z=15.0)
fusion_end(p)

p = add(Program("hand-fanuc-incremental.nc", "fanuc-mill"))
p.text("""
%
O0012 (ROW OF GROOVES, G91 AND REPEATS IN P)
G21 G90 G40 G80 G49 G17
T01 M06
G54 G00 G90 X0. Y0. S2000 M03
G43 H01 Z10. M08
G04 X1.5
G01 Z0. F200.
M98 P40013
G90 G00 Z10. M09
G91 G28 Z0. M05
G90
M30
O0013
G91 G01 Z-1. F100.
X20.
Y5.
X-20.
G00 Y-5.
M99
%
""")
t = p.truth
t.rapid(z=10.0)
t.line(z=0.0)
for k in range(1, 5):
    t.line(z=-float(k))
    t.line(x=20.0)
    t.line(y=5.0)
    t.line(x=0.0)
    t.rapid(y=0.0)

# ---- Haas mills -------------------------------------------------------------------------------------------------------

p = fusion_haas("fusion-haas-drill-tap.nc", "DRILL AND TAP")
fusion_tool(p, 1, 3000, 20.0, 15.0, 15.0)
places = [(20.0, 15.0), (40.0, 15.0), (60.0, 15.0)]
holes(p, "G83", places, 3.0, -15.0, " Q4.5", steps=4, again=2.54, f=300.0)
p.text("M5\nM9\nG53 G0 Z0.\nM1")
fusion_tool(p, 2, 600, 20.0, 15.0, 15.0)
holes(p, "G84", places, 5.0, -12.0, "", out=True, f=600.0)
haas_end(p)

p = fusion_haas("hsmworks-haas-contour.nc", "2D CONTOUR", 1011)
fusion_tool(p, 1, 5000, 48.0, -8.0, 15.0)
p.rapid(z=5.0)
p.line(z=-3.0, f=400.0)
p.arc(False, 40.0, 0.0, -8.0, 0.0, f=900.0)
p.line(-40.0, 0.0)
p.arc(True, -48.0, 8.0, 0.0, 8.0)
p.line(-48.0, 30.0)
p.arc(True, -40.0, 38.0, 8.0, 0.0, as_r=True)
p.line(40.0, 38.0)
p.rapid(z=15.0)
haas_end(p)

p = add(Program("hand-haas-circles.nc", "fanuc-mill", "haas"))
p.text("""
%
O01012 (HAAS CIRCLE POCKET AND BOLT CIRCLE)
T1 M06 (12 MM END MILL)
G00 G90 G17 G40 G49 G54 X0. Y0.
G21
S3500 M03
G43 H01 Z10. M08
G00 Z1.
G13 I14. Z-3. D00 F500.
G00 Z25. M09
G53 G49 Z0. M05
T2 M06 (6 MM DRILL)
G00 G90 G54 X0. Y0.
S2000 M03
G43 H02 Z25. M08
G81 G99 Z-8. R2. F150. L0
G70 I30. J90. L4
G80
G00 Z25. M09
G53 G49 Z0. M05
M30
%
""")
t = p.truth
t.rapid(0.0, 0.0, 1.0)
t.line(z=-3.0)
t.arc(False, 14.0, 0.0, 7.0, 0.0)
t.arc(False, 14.0, 0.0, -14.0, 0.0)
t.arc(False, 0.0, 0.0, -7.0, 0.0)
for x, y in [(0.0, 30.0), (-30.0, 0.0), (0.0, -30.0), (30.0, 0.0)]:
    p.drilled(x, y, 2.0, -8.0)

p = add(Program("hand-haas-local-sub.nc", "fanuc-mill", "haas", eob=";"))
p.text("""
%
O00123 (POCKETS BY LOCAL SUBPROGRAM)
G21 G17 G90 G40 G80
G28
T5 M06
G00 G90 G54 X0. Y0. S4000 M03
G43 H05 Z20. M08
M97 P1000
G00 X25. Y0.
M97 P1000
G00 X50. Y0.
M97 P1000
G00 Z20. M09
G28 G91 Z0. M05
G90
M30
N1000 G91 G00 Z-18.
G01 Z-4. F120.
X15. F400.
Y10.
X-15.
Y-10.
G00 Z22.
G90
M99
%
""")
t = p.truth
for x in (0.0, 25.0, 50.0):
    t.rapid(x, 0.0, 2.0)
    t.line(z=-2.0)
    for dx, dy in ((15, 0), (0, 10), (-15, 0), (0, -10)):
        t.line(t.at[0] + dx, t.at[1] + dy)

p = fusion_haas("hand-haas-peck.nc", "DEEP HOLES WITH SHORTER PECKS", 1013)
fusion_tool(p, 3, 1500, 5.0, 5.0, 20.0)
for x, y in [(5.0, 5.0), (25.0, 5.0)]:
    p.drilled(x, y, 0.0, -10.0, 5, 2.54)
p.text("G99 G83 X5. Y5. Z-10. R0. I3. J0.5 K1.5 F120.\nX25.\nG80")
p.forget()
haas_end(p)

p = add(Program("hand-haas-offsets.nc", "fanuc-mill", "haas"))
p.text("""
%
O01014 (TWO PARTS BY G154)
G90 G94 G17 G21 G40 G80
G53 G0 Z0.
G10 L20 P1 X-300. Y-200. Z-200.
G10 L20 P2 X-250. Y-200. Z-200.
T1 M6
G187 P2
G154 P1 G0 X0. Y0. S5000 M3
G43 Z10. H01
G1 Z-1. F200.
X20. F800.
G0 Z10.
G154 P2
X0. Y0.
G1 Z-1. F200.
X20. F800.
G0 Z10.
G53 G0 Z0. M5
M33
M30
%
""")
t = p.truth
for x in (0.0, 50.0):
    t.rapid(x, 0.0, 10.0)
    t.line(z=-1.0)
    t.line(x=x + 20.0)

p = fusion_haas("fusion-haas-dome-inch.nc", "PARALLEL FINISHING IN INCHES", 1015, inch=True)
fusion_tool(p, 4, 10000, -25.4, -25.4, 25.4)
t = p.truth
n = 8
for row in range(n + 1):
    y = round(-1 + row * 0.25, 4)
    xs = [round(-1 + k * 0.25, 4) for k in range(n + 1)]
    if row % 2:
        xs.reverse()
    for k, x in enumerate(xs):
        z = round(math.sqrt(9 - x * x - y * y) - 3, 4)
        if row == 0 and k == 0:
            p.line(z=z * 25.4, f=20 * 25.4)
        else:
            p.line(x * 25.4, y * 25.4, z * 25.4, f=60 * 25.4)
p.rapid(z=25.4)
haas_end(p)

# ---- lathes: X of the truth is a radius -------------------------------------------------------------------------------


class Turned(Program):
    def __init__(self, name, flavour="", **more):
        super().__init__(name, "fanuc-lathe", flavour, **more)
        self.end_z = None

    def go(self, x=None, z=None, f=None, rapid=False, head=""):
        """X is a diameter."""
        if rapid:
            self.truth.rapid(x=None if x is None else x / 2, z=z)
        else:
            self.truth.line(x=None if x is None else x / 2, z=z)
        w = self.words(X=x, Z=z)
        self.raw((head + self.code("G0" if rapid else "G1") + w + self.f(f)).strip())

    def bow(self, cw, x, z, i, k, f=None):
        """An arc in the plane Z-X seen from +Y: G2 turns from +Z to +X there with the X axis up and Z to the right,
        which is clockwise seen on paper with X up. I is a radius value."""
        t = self.truth
        z0, x0 = t.at[2], t.at[0]
        cz, cx = z0 + k, x0 + i
        r = math.hypot(i, k)
        a0, a1 = math.atan2(x0 - cx, z0 - cz), math.atan2(x / 2 - cx, z - cz)
        sweep = (a0 - a1 if cw else a1 - a0) % (2 * math.pi)
        t.see(t.at)
        t.length += r * sweep
        t.at = [x / 2, t.at[1], z]
        t.see(t.at)
        w = self.words(X=x, Z=z)
        w += (f" I{self.num(i)}" if abs(i) > 1e-9 else "") + (f" K{self.num(k)}" if abs(k) > 1e-9 else "")
        self.raw((self.code("G2" if cw else "G3") + w + self.f(f)).strip())


def roughed(p, start, contour, depth, du, dw):
    """Type I roughing outside: `contour` of (diameter, z) falls in z; levels of `depth`, radius. Truth alone."""
    t = p.truth
    x0, z0 = start[0] / 2, start[1]
    xc, zc = x0 + du / 2, z0 + dw
    shifted = [(x / 2 + du / 2, z + dw) for x, z in contour]
    k = 1
    while True:
        x = xc - k * depth
        if x <= shifted[0][0] + 1e-9:
            break
        reach = None
        for (xa, za), (xb, zb) in zip(shifted, shifted[1:]):
            if xa < x <= xb + 1e-12:
                reach = za + (zb - za) * (x - xa) / (xb - xa)
                break
        t.rapid(x=x, z=zc)
        t.line(z=reach)
        k += 1
    t.rapid(x=shifted[0][0], z=zc)
    for x, z in shifted:
        t.line(x=x, z=z)
    t.rapid(x=x0, z=z0)


p = add(Turned("fusion-fanuc-turning.nc", number=10, step=5))
p.text("%\nO1101 (TURNING)\n(T1 - OD ROUGH)\nG98 G18\nG21\nG50 S3000\nG28 U0.\nG28 W0.\nT0101\nG97 S500 M3\nG54")
p.go(54.0, 5.0, rapid=True)
p.text("G99\nG96 S180")
for x in (46.0, 42.0):
    p.go(x, rapid=True)
    p.go(z=-40.0, f=0.25)
    p.go(x + 2.0, -39.0)
    p.go(z=5.0, rapid=True)
p.go(36.0, rapid=True)
p.go(z=0.0, f=0.15)
p.go(40.0, -2.0)
p.go(z=-30.0)
p.bow(True, 44.0, -32.0, 2.0, 0.0)
p.go(54.0)
p.text("G97 S500\nM9\nM5\nG28 U0.\nG28 W0.\nM30\n%")

p = add(Turned("mastercam-fanuc-g71.nc"))
p.text("""
%
O1102(ROUGH AND FINISH BY CYCLES)
(DATE=DD-MM-YY - 12-03-24 TIME=HH:MM - 10:15)
(TOOL - 1 OFFSET - 1)
G21
G0 T0101
G18
G97 S800 M03
G0 G54 X44. Z2. M8
G50 S3000
G96 S150
G71 U2. R1.
G71 P100 Q110 U0.4 W0.1 F0.25
N100 G0 X20.
G1 Z-20. F0.12
X30. Z-30.
Z-40.
N110 X44.
G70 P100 Q110
M9
G28 U0. W0. M05
T0100
M30
%
""")
t = p.truth
t.rapid(x=22.0, z=2.0)
contour = [(20.0, 2.0), (20.0, -20.0), (30.0, -30.0), (30.0, -40.0), (44.0, -40.0)]
roughed(p, (44.0, 2.0), contour, 2.0, 0.4, 0.1)
t.rapid(x=10.0, z=2.0)
for x, z in contour:
    t.line(x=x / 2, z=z)

p = add(Turned("mastercam-fanuc-thread.nc"))
p.text("""
%
O1103(THREAD M20 X 2.5)
G21
G0 T0303
G97 S600 M03
G0 G54 X24. Z5.
G76 P010060 Q100 R0.05
G76 X16.932 Z-25. P1534 Q500 F2.5
G28 U0. W0. M05
T0300
M30
%
""")
p.truth.told = False

p = add(Turned("hand-fanuc-face-drill.nc"))
p.text("""
%
O1104 (FACE, CENTRE DRILL AND PECK)
G21 G40 G99
G28 U0 W0
T0202
G97 S1200 M03
G00 X42. Z0. M08
G01 X-1.6 F0.15
G00 Z2.
G28 U0 W0 M05
T0404
G97 S900 M03
G00 X0. Z2.
G74 R1.
G74 Z-20. Q8000 F0.1
G28 U0 W0 M05
M30
%
""")
t = p.truth
t.rapid(x=21.0, z=0.0)
t.line(x=-0.8)
t.rapid(z=2.0)
t.rapid(x=0.0, z=2.0)
t.line(z=-6.0)
t.rapid(z=-5.0)
t.line(z=-14.0)
t.rapid(z=-13.0)
t.line(z=-20.0)

p = add(Turned("hand-fanuc-single-cycles.nc"))
p.text("""
%
O1105 (G90, G94 AND G92)
G21 G99 G40
T0101
G97 S800 M03
G00 X50. Z2.
G90 X46. Z-30. F0.2
X42.
X40.
G00 X50. Z2.
G94 X20. Z-1. F0.1
Z-2.
G00 X100. Z50.
M30
%
""")
t = p.truth
for x in (46.0, 42.0, 40.0):
    t.rapid(x=x / 2, z=2.0)
    t.line(z=-30.0)
    t.line(x=25.0)
    t.rapid(z=2.0)
for z in (-1.0, -2.0):
    t.rapid(x=25.0, z=z)
    t.line(x=10.0)
    t.line(z=2.0)
    t.rapid(x=25.0)

p = add(Turned("hand-haas-g71.nc", "haas"))
p.text("""
%
O01201 (HAAS LATHE, ONE LINE CYCLES)
G21 G18 G40 G80 G99
G28
T101 (CNMG 12 04 08)
G54 G00 X44. Z2. M08
G50 S3000
G96 S180 M03
G71 P1 Q2 U0.4 W0.1 D2. F0.25
N1 G00 X20.
G01 Z-20. F0.12
X30. Z-30.
Z-40.
N2 X44.
G70 P1 Q2
G97 S500
G28
M30
%
""")
t = p.truth
t.rapid(x=22.0, z=2.0)
roughed(p, (44.0, 2.0), contour, 2.0, 0.4, 0.1)
t.rapid(x=10.0, z=2.0)
for x, z in contour:
    t.line(x=x / 2, z=z)

p = add(Turned("hand-haas-thread.nc", "haas"))
p.text("""
%
O01202 (HAAS LATHE THREAD M20 X 2.5)
G21 G18 G40 G80 G99
G28
T303
G97 S600 M03
G54 G00 X24. Z5.
G76 X16.932 Z-25. K1.534 D0.5 F2.5
G28
M30
%
""")
p.truth.told = False

p = add(Turned("fusion-haas-turning.nc", "haas", number=10, step=5))
p.text("%\nO01203 (TURNING)\n(MACHINE)\n(  VENDOR: HAAS)\n(  MODEL: ST-20)\nG98 G18\nG21\nG50 S4000\nM31\nG53 G0 X0.\nG53 G0 Z0.")
p.text("T0202\nG97 S600 M3\nG54\nM8")
p.go(60.0, 5.0, rapid=True)
p.text("G99")
p.go(z=0.0, rapid=True)
p.go(-1.6, f=0.2)
p.go(z=3.0, rapid=True)
p.go(50.0, rapid=True)
p.go(z=-25.0, f=0.2)
p.bow(False, 56.0, -28.0, 0.0, -3.0)
p.go(62.0)
p.text("M9\nM5\nG53 G0 X0.\nG53 G0 Z0.\nM33\nM30\n%")

p = add(Turned("hand-haas-drill-tap.nc", "haas"))
p.text("""
%
O01204 (DRILL AND TAP ON THE FACE)
G21 G18 G40 G80 G99
G28
T505
G97 S1200 M03
G54 G00 X0. Z5. M08
G83 Z-24. R2. Q8. F0.15
G80
G28
T606
G97 S400 M03
G00 X0. Z10.
G84 Z-16. R4. F1.25
G80
G28
M30
%
""")
p.truth.told = False

# ---- LinuxCNC ---------------------------------------------------------------------------------------------------------

p = fusion_linuxcnc("fusion-linuxcnc-pocket.ngc", "POCKET")
p.text("T1 M6\nG43\nS12000 M3\nG54")
p.rapid(20.0, 15.0)
p.truth.rapid(z=15.0)
p.last["Z"] = 15.0
p.raw("G0 Z15.")
p.rapid(z=2.0)
p.line(z=0.5, f=500.0)
helix_pocket(p, 20.0, 15.0, [2.0, 4.0, 6.0, 8.0], -3.0, 0.875, 700.0)
p.rapid(z=15.0)
linuxcnc_end(p)

p = freecad("freecad-linuxcnc-profile.ngc", "linuxcnc_post", "linuxcnc")
p.text("(begin operation: T1: EM6)\n(machine units: mm/min)\nM5\nT1 M6\nG43 H1\nM3 S8000\n(finish operation: T1: EM6)\n(begin operation: Profile)")
p.rapid(z=5.0)
p.rapid(-3.0, 5.0)
p.line(z=-2.0, f=200.0)
rectangle(p, -3.0, -3.0, 43.0, 33.0, -2.0, 600.0, r=8.0)
p.rapid(z=5.0)
p.text("(finish operation: Profile)\n(begin postamble)\nM05\nG17 G54 G90 G80 G40\nM2")
p.end_z = 5.0

p = freecad("freecad-linuxcnc-drill.ngc", "linuxcnc_post", "linuxcnc")
p.text("(begin operation: T2: Drill)\nM5\nT2 M6\nG43 H2\nM3 S2500\n(finish operation: T2: Drill)\n(begin operation: Drilling)")
p.rapid(z=10.0)
p.raw("G90\nG98")
for x, y in [(5.0, 5.0), (35.0, 5.0), (35.0, 25.0), (5.0, 25.0)]:
    p.drilled(x, y, 2.0, -12.0, 4, 0.254)
    p.truth.rapid(z=10.0)
    p.raw(f"G83 X{p.num(x)} Y{p.num(y)} Z-12. R2. Q3.5 F120.")
p.text("G80\n(finish operation: Drilling)\n(begin postamble)\nM05\nG17 G54 G90 G80 G40\nM2")
p.end_z = 10.0

p = add(Program("hand-linuxcnc-owords.ngc", "linuxcnc"))
p.text("""
; bolt circle and slots with O-words
g21 g90 g17 g40 g49 g64 p0.01
#<_depth> = -6
o<hole> sub
  (#1 x, #2 y)
  g0 x#1 y#2
  g0 z2
  g1 z#<_depth> f150
  g0 z10
o<hole> endsub
t1 m6 g43
m3 s2000
g0 z10
#<k> = 0
o100 while [#<k> lt 5]
  o<hole> call [25*cos[72*#<k>]] [25*sin[72*#<k>]]
  #<k> = [#<k>+1]
o100 endwhile
o200 if [exists[#<nope>]]
  g1 z-50 f100
o200 else
  g0 x0 y0
  g1 z-1 f100
  g1 x20
  g0 z10
o200 endif
m5
m2
""")
t = p.truth
for k in range(5):
    t.rapid(25 * math.cos(math.radians(72 * k)), 25 * math.sin(math.radians(72 * k)), 2.0)
    t.line(z=-6.0)
t.rapid(0.0, 0.0, 10.0)
t.line(z=-1.0)
t.line(x=20.0)
p.end_z = 10.0

p = add(Program("hand-linuxcnc-lathe.ngc", "linuxcnc"))
p.text("""
; lathe, diameters, thread with G76
g21 g18 g90 g40 g7
t1 m6 g43
g97 s600 m3
g95
g0 x44 z2
g1 x40 f0.2
g1 z-30
g1 x44 z-32
g0 z2
g1 x36
z-20
g2 x40 z-22 i2 k0
g0 x44
g0 z2
m5
m2
""")
t = p.truth
t.rapid(x=22.0, z=2.0)
t.line(x=20.0)
t.line(z=-30.0)
t.line(x=22.0, z=-32.0)
t.rapid(z=2.0)
t.line(x=18.0)
t.line(z=-20.0)
t.length += math.pi
t.at = [20.0, 0.0, -22.0]
t.see(t.at)
p.end_z = 2.0

p = add(Program("fusion-linuxcnc-dome.ngc", "linuxcnc", number=10, step=5))
p.text("%\n(DOME)\nG90 G94 G17 G91.1\nG21\nG64 P0.02\nG53 G0 Z0.\nT3 M6\nG43\nS18000 M3\nG54")
p.rapid(-10.0, -10.0)
p.truth.rapid(z=15.0)
p.last["Z"] = 15.0
p.raw("G0 Z15.")
dome(p, 10.0, 30.0, 2.5, 1200.0)
p.rapid(z=15.0)
linuxcnc_end(p)

p = add(Program("hand-linuxcnc-comp.ngc", "linuxcnc"))
p.text("""
(outline with G41.1, tool diameter 6)
g21 g17 g90 g40
t1 m6
m3 s5000
g0 x-20 y-20 z5
g1 z-3 f300
g42.1 d6 g1 x0 y-10
g1 x0 y0
x50
y30
x0
y0
g40
g0 z5
m5
m2
""")
# The path is 3 right of the outline, with arcs about its corners; the entry ends square to itself and rolls round its
# corner (points by a run of rs274).
t = p.truth
t.rapid(-20.0, -20.0, 5.0)
t.line(z=-3.0)
t.line(1.3416, -12.6833)
t.arc(False, 3.0, -10.0, -1.3416, 2.6833)
t.line(y=-3.0)
t.line(x=50.0)
t.arc(False, 53.0, 0.0, 0.0, 3.0)
t.line(y=30.0)
t.arc(False, 50.0, 33.0, -3.0, 0.0)
t.line(x=0.0)
t.arc(False, -3.0, 30.0, 0.0, -3.0)
t.line(y=0.0)
p.end_z = 5.0

# ---- GRBL -------------------------------------------------------------------------------------------------------------

p = fusion_grbl("fusion-grbl-contour.gcode", "2D CONTOUR")
p.text("S12000 M3\nG54")
p.rapid(-3.0, 0.0)
p.truth.rapid(z=15.0)
p.last["Z"] = 15.0
p.raw("G0 Z15")
p.rapid(z=5.0)
p.line(z=-2.5, f=300.0)
p.line(-3.0, 25.0, f=900.0)
p.arc(True, 2.0, 30.0, 5.0, 0.0)
p.line(45.0, 30.0)
p.arc(True, 50.0, 25.0, 0.0, -5.0)
p.line(50.0, 0.0)
p.arc(True, 45.0, -5.0, -5.0, 0.0)
p.line(2.0, -5.0)
p.arc(True, -3.0, 0.0, 0.0, 5.0)
p.rapid(z=15.0)
p.text("M5\nG28 G91 Z0\nG90\nG28 G91 X0 Y0\nG90\nM30")
p.end_z = None

p = freecad("freecad-grbl-engrave.gcode", "grbl_post", "linuxcnc", "grbl")
p.text("(Begin operation: Engrave)\nM3 S10000")
p.rapid(z=3.0)
p.rapid(0.0, 0.0)
p.line(z=-0.3, f=200.0)
for x, y in [(4.0, 10.0), (8.0, 0.0), (6.0, 5.0), (2.0, 5.0)]:
    p.line(x, y, f=500.0)
p.rapid(z=3.0)
p.text("(Finish operation: Engrave)\n(Begin postamble)\nM5\nG17 G90\nM2")
p.end_z = 3.0

p = add(Program("estlcam-grbl-pocket.nc", "linuxcnc", "grbl", digits=4))
p.text("(Project pocket)\n(Created by Estlcam version 11 build 11.245)\n(Machining time about 00:01:10 hours)\n(Required tools:)\n(End mill 3mm)\nG90\nM03 S24000")
p.always = True
p.rapid(z=5.0)
p.rapid(10.0, 10.0)
p.rapid(z=0.5)
p.line(z=-1.0, f=300.0)
for k in range(5):
    y = 10.0 + 2.0 * k
    p.line(30.0 if k % 2 == 0 else 10.0, y, f=1200.0)
    if k < 4:
        p.line(p.truth.at[0], y + 2.0)
p.rapid(z=5.0)
p.text("M05\nM30")
p.end_z = 5.0

p = add(Program("carbide-grbl-rings.nc", "linuxcnc", "grbl", digits=3))
p.text("(stockMin:0.00mm, 0.00mm, -10.00mm)\n(stockMax:50.00mm, 50.00mm, 0.00mm)\n(Shapeoko, carbide motion)\nG90\nG21\nM05\nM03S18000")
p.rapid(z=5.0)
for r in (5.0, 10.0):
    p.rapid(25.0 + r, 25.0)
    p.rapid(z=0.5)
    p.line(z=-0.8, f=254.0)
    p.arc(False, 25.0 - r, 25.0, -r, 0.0, f=1016.0)
    p.arc(False, 25.0 + r, 25.0, r, 0.0)
    p.rapid(z=5.0)
p.text("M05\nM02")
p.end_z = 5.0

p = add(Program("easel-grbl-lines.nc", "linuxcnc", "grbl", digits=5))
p.always = True
p.text("(Easel)\nG21\nG90\nM3 S12000")
p.rapid(z=3.81)
p.rapid(12.7, 12.7)
p.line(z=-1.5, f=228.6)
p.line(38.1, 12.7, f=762.0)
p.line(38.1, 25.4)
p.line(12.7, 25.4)
p.line(12.7, 12.7)
p.rapid(z=3.81)
p.rapid(0.0, 0.0)
p.text("M5")
p.end_z = 3.81

# ---- Mach3 ------------------------------------------------------------------------------------------------------------

p = fusion_mach3("fusion-mach3-drill.tap", "DRILL")
p.text("T2 M6\nS2000 M3\nG54")
p.rapid(10.0, 10.0)
p.truth.rapid(z=15.0)
p.last["Z"] = 15.0
p.raw("G43 Z15. H2")
for k, (x, y) in enumerate([(10.0, 10.0), (40.0, 10.0), (40.0, 30.0)]):
    p.drilled(x, y, 5.0, -6.0)
    if k == 0:
        p.raw("G98 G81 X10. Y10. Z-6. R5. F150.")
    else:
        p.raw(p.words(X=x, Y=y).strip() if k != 0 else "")
    p.truth.rapid(z=15.0)
    p.last.update({"X": x, "Y": y})
p.raw("G80")
p.text("M5\nG28 G91 Z0.\nG90\nM30")
p.end_z = None

p = add(Program("vectric-mach3-profile.tap", "linuxcnc", "mach3", digits=4))
p.always = True
p.text("( Profile 1 )\n( File created: Tuesday March 12 2024 - 10:15 AM)\n( for Mach2/3 from Vectric )\n( Material Size)\n( X= 100.000, Y= 80.000, Z= 12.000)\nG00G21G17G90G40G49G80\nG71G91.1\nT1M06\n(End mill 6 mm)\nG00G43Z20.000H1\nS16000M03\n(Toolpath:- Profile 1)\nG94")
p.truth.rapid(z=20.0)
p.rapid(0.0, 5.0)
p.rapid(z=2.0)
p.line(z=-3.0, f=500.0)
p.arc(False, 5.0, 0.0, 5.0, 0.0, f=1500.0)
p.line(55.0, 0.0)
p.arc(False, 60.0, 5.0, 0.0, 5.0)
p.line(60.0, 40.0)
p.line(0.0, 40.0)
p.line(0.0, 5.0)
p.rapid(z=20.0)
p.text("M09\nM30\n%")
p.end_z = 20.0

p = add(Program("hand-mach3-sub.tap", "linuxcnc", "mach3"))
p.text("""
(MACH3, THREE PASSES BY A SUBPROGRAM)
G21 G90 G91.1 G17 G40 G49 G80
T1 M6
S8000 M3
G0 Z10
X0 Y0
G0 Z1
M98 P1234 L3
G90 G0 Z10
M5
M30
O1234
G91 G1 Z-1 F200
G1 X30 F600
Y10
X-30
Y-10
G90
M99
""")
t = p.truth
t.rapid(0.0, 0.0, 1.0)
for k in range(3):
    t.line(z=-float(k))
    t.line(x=30.0)
    t.line(y=10.0)
    t.line(x=0.0)
    t.line(y=0.0)
p.end_z = 10.0

p = add(Program("hand-mach3-circle.tap", "linuxcnc", "mach3"))
p.text("""
(MACH3, CIRCLES BY G12 AND A TURNED SLOT BY G68)
G21 G90 G91.1 G17 G40 G49 G80
T1 M6
S8000 M3
G0 Z10
X20 Y20
G1 Z-1 F200
G13 I5 F400
G0 Z10
G68 A0 B0 R90
G0 X10 Y0
G1 Z-1 F200
X30 F500
G69
G0 Z10
M5
M30
""")
t = p.truth
t.rapid(20.0, 20.0, 10.0)
t.line(z=-1.0)
t.line(x=25.0)
t.arc(False, 25.0, 20.0, -5.0, 0.0)
t.line(x=20.0)
t.rapid(z=10.0)
t.rapid(0.0, 10.0)
t.line(z=-1.0)
t.line(y=30.0)
p.end_z = 10.0


def main():
    rows = []
    for program in PROGRAMS:
        with open(os.path.join(HERE, program.name), "w", encoding="ascii") as out:
            out.write("\n".join(program.lines) + "\n")
        rows.append(program.row())
    with open(os.path.join(HERE, "posted.tsv"), "w", encoding="ascii") as out:
        out.write("\n".join(rows) + "\n")
    print(f"{len(rows)} programs")


if __name__ == "__main__":
    main()
