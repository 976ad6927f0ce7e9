#!/usr/bin/env python3
"""Hashes of all that a program computes: sample parts, real programs and random jobs.

    .ci/output_hashes.py PROVEOUT [--programs FOLDER] [--random N] [--out FILE]

A change that is meant to change nothing gives the same lines before and after. Left out of a report are its
`performance` and the names of its version. Random jobs come from fixed seeds, of every control.
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import random
import re
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def without_time(value):
    if isinstance(value, dict):
        left_out = ("performance", "version", "created", "program_version")
        return {k: without_time(v) for k, v in value.items() if k not in left_out}
    if isinstance(value, list):
        return [without_time(v) for v in value]
    return value


def digest(folder):
    """One hash over the report and all other files of a run."""
    total = hashlib.sha256()
    for at, folders, names in os.walk(folder):
        folders.sort()
        for name in sorted(names):
            if name.endswith((".html", ".vdb", ".png")):
                continue
            with open(os.path.join(at, name), "rb") as file:
                data = file.read()
            if name.endswith("report.json"):
                data = json.dumps(without_time(json.loads(data)), sort_keys=True).encode()
            elif name == "junit.xml":
                data = re.sub(rb' time="[^"]*"', b"", data)
            total.update(os.path.relpath(os.path.join(at, name), folder).encode() + b"\0" + data)
    return total.hexdigest()[:24]


def run(binary, arguments, folder):
    out = os.path.join(folder, "out")
    ended = subprocess.run([binary, "run", *arguments, "--no-render", "--threads", "1", "--out", out], cwd=folder,
                           capture_output=True, timeout=1200)
    text = ended.stderr.decode(errors="replace").replace(folder, "")
    told = hashlib.sha256(text.encode()).hexdigest()[:8]
    return f"{ended.returncode} {digest(out) if os.path.isdir(out) else '-'} {told}"


def number(value):
    return f"{value:.3f}".rstrip("0").rstrip(".")


class Jobs:
    """Writes the random jobs: a folder with job.toml and its program."""

    def __init__(self, seed):
        self.r = random.Random(seed)

    def between(self, low, high):
        return number(self.r.uniform(low, high))

    def mill_tool(self, k):
        diameter = self.r.choice((2, 3, 4, 6, 8, 10))
        kind = self.r.choice(("flat", "ball", "bull", "drill", "cone", "flat"))
        more = {"bull": f"corner_radius = {diameter / 8}\n", "drill": "point_angle = 118\n",
                "cone": "tip_diameter = 0.5\ncone_angle = 60\n"}.get(kind, "")
        return f'[[tool]]\nnumber = {k}\ntype = "{kind}"\ndiameter = {diameter}\n{more}'

    def mill_program(self, control):
        lines = ["%", "O1"] if control == "nct" else []
        lines += ["G17 G21 G90 G94 G40 G80" if control == "nct" else "N5 G17 G90 G40"]
        for k in (1, 2):
            lines += [f"T{k} M6", "S4000 M3", "G54 G0 X-10 Y-10", "Z20"]
            for _ in range(self.r.randint(2, 7)):
                x, y, z = self.between(0, 30), self.between(0, 20), self.between(-5, -0.3)
                kind = self.r.randint(0, 3)
                if kind == 0:
                    lines += [f"G0 X{x} Y{y}", "Z1", f"G1 Z{z} F200", f"X{self.between(0, 30)} Y{self.between(0, 20)} F500"]
                elif kind == 1:
                    lines += [f"G0 X{x} Y{y}", "Z1", f"G1 Z{z} F200",
                              f"G1 X{self.between(0, 30)} Y{self.between(0, 20)} Z{self.between(-5, -0.3)}"]
                elif kind == 2:
                    lines += [f"G0 X{x} Y{y}", "Z1", f"G1 Z{z} F200", f"G{self.r.choice((2, 3))} I{self.between(1, 4)} J0"]
                elif control == "nct":
                    lines += [f"G0 X{x} Y{y}", "Z3", f"G81 X{x} Y{y} Z{z} R2 F100", "G80"]
                lines += ["G0 Z20"]
        return "\n".join(lines + ["M5", "M30", ""])

    def mill(self, control, grid):
        job = f'control = "{control}"\nprogram = "p.nc"\n[simulation]\nresolution = {grid}\n'
        job += '[stock]\nshape = "box"\nmin = [0, 0, -8]\nmax = [30, 20, 0]\n'
        return job + self.mill_tool(1) + self.mill_tool(2), self.mill_program(control)

    def turn(self):
        r0 = self.r.uniform(8, 14)
        lines = ["G0 X32 Z2"]
        for _ in range(self.r.randint(2, 6)):
            r0 -= self.r.uniform(0.2, 1.0)
            z = self.r.uniform(-30, -4)
            lines += [f"G0 X{number(2 * r0)}", f"G1 Z{number(z)} F0.2", f"X{number(2 * r0 + 2)} Z{number(z - 1)}", "G0 X32", "Z2"]
        job = 'control = "wl4-lathe"\nprogram = "p.nc"\n[stock]\nshape = "cylinder"\nbase = [0, 0, -40]\ndiameter = 30\nlength = 40\n'
        job += f'[[tool]]\nnumber = 1\ntype = "insert"\ninsert_angle = 55\nlead_angle = 93\nedge_length = 11\nnose_radius = {self.r.choice((0.4, 0.8))}\norientation = 3\n'
        body = ["N10 G90 G95", "N20 T1", "N30 S800 M3"] + [f"N{40 + 10 * k} {line}" for k, line in enumerate(lines)]
        return job, "\n".join(body + ["N9990 M30", ""])

    def flexnc(self):
        job = ('control = "flexnc"\nprogram = "p.nc"\n[stock]\nshape = "cylinder"\nbase = [0, 0, -40]\ndiameter = 30\n'
               'length = 40\n[[tool]]\nnumber = 1\ntype = "insert"\ninsert_angle = 55\nlead_angle = 93\nedge_length = 11\nnose_radius = 0.4\norientation = 3\n')
        lines = ["T1M06D1", "S800M03", "G99F0.2", "G90G00X32Z2"]
        radius = 14.0
        for _ in range(self.r.randint(2, 6)):
            radius -= self.r.uniform(0.2, 1.2)
            lines += [f"G00X{number(2 * radius)}", f"G01Z{self.between(-30, -4)}", "G00X32", "Z2"]
        return job, "\n".join(lines + ["M02", ""])

    def wire(self):
        job = ('control = "wedm"\nprogram = "p.nc"\n[stock]\nshape = "box"\nmin = [-20, -15, 0]\nmax = [20, 15, 20]\n'
               '[[tool]]\nnumber = 1\ntype = "wire"\ndiameter = 0.25\n')
        x, y, a = self.between(4, 12), self.between(3, 9), self.r.choice((0, 0, 1, 2, 5))
        taper = "" if a == 0 else f"G{self.r.choice((51, 52))} A{a}. "
        lines = ["H001=135;", "N1 T84 T86;", "N2 C001;", "N3 G92 X0 Y0;", f"N4 {taper}G42 H001 G01 X{x};", f"N5 Y{y};",
                 f"N6 X-{x};", f"N7 Y-{y};", f"N8 X{x};", "N9 Y0;", "N10 G40 X0;" if a == 0 else "N10 G50 A0 G40 X0;",
                 "N11 T85 T87;", "N12 M02;", ""]
        return job, "\n".join(lines)

    def write(self, folder):
        kind = self.r.choice(("nct", "nct", "wl4-mill", "turn", "flexnc", "wire"))
        job, program = (self.mill(kind, self.r.choice((0.25, 0.5))) if kind in ("nct", "wl4-mill")
                        else getattr(self, kind)())
        with open(os.path.join(folder, "job.toml"), "w") as file:
            file.write('schema = "proveout.job/1"\n' + job)
        with open(os.path.join(folder, "p.nc"), "w") as file:
            file.write(program)
        return kind


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("binary")
    parser.add_argument("--programs", help="folder of real programs; bear.nc and flower_mold.nc are run")
    parser.add_argument("--random", type=int, default=200)
    parser.add_argument("--out")
    options = parser.parse_args()
    binary = os.path.abspath(options.binary)
    tasks = []
    for part in sorted(os.listdir(os.path.join(ROOT, "parts"))):
        folder = os.path.join(ROOT, "parts", part)
        if os.path.isdir(folder):
            tasks += [(f"{part}/{name}", [os.path.join(folder, name)]) for name in sorted(os.listdir(folder))
                      if name.endswith(".toml")]
    if options.programs:
        of_program = {"bear": ("0,0,-20:80,80,0", "ball:2"),
                      "flower_mold": ("-3.92956,-3.92829,-9.95121:61.0796,61.0529,0", "flat:1")}
        for name, (box, tool) in of_program.items():
            tasks.append((name, [os.path.join(os.path.abspath(options.programs), name + ".nc"), "--control", "nct", "--stock",
                                 "box:" + box, "--tool", "1=" + tool, "--resolution", "0.25"]))
    tasks += [(seed, None) for seed in range(options.random)]

    def do(task):
        name, arguments = task
        with tempfile.TemporaryDirectory() as folder:
            if arguments is None:
                name = f"random {name} {Jobs(name).write(folder)}"
                arguments = ["job.toml"]
            return f"{name}: {run(binary, arguments, folder)}"

    with concurrent.futures.ThreadPoolExecutor(max(1, (os.cpu_count() or 2) - 1)) as pool:
        lines = list(pool.map(do, tasks))
    text = "\n".join(lines) + "\n"
    if options.out:
        with open(options.out, "w") as file:
            file.write(text)
    else:
        sys.stdout.write(text)


if __name__ == "__main__":
    main()
