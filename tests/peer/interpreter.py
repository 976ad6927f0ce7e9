#!/usr/bin/python3
"""Programs in LinuxCNC's interpreter, by its module `gcode`: the canonical commands in full precision, inches.

Usage: interpreter.py TOOLS < PATHS. TOOLS is a tool table of LinuxCNC with X Z D I J Q, inches and degrees. For each path on the standard input: a line `PROGRAM path`, the commands as `NAME(numbers)`, then
`ERROR text` or `END`. Each program runs in a process of its own, as the interpreter may crash or not end.
"""
import ctypes
import os
import re
import signal
import sys
import tempfile

TOOLDATA = ctypes.CDLL("libtooldata.so.0", mode=ctypes.RTLD_GLOBAL)
import gcode  # needs the library above

SECONDS = 20
NO_TOOL = (-1,) + (0.0,) * 12 + (0,)


def load_tools(path):
    """The book of the interpreter, which its finder of tools reads, and the same tools for the canon."""
    TOOLDATA["_Z17tool_mmap_creatorPK13EMC_TOOL_STATi"](None, 0)
    TOOLDATA["_Z13tooldata_initb"](False)
    TOOLDATA["_Z13tooldata_loadPKcPPc"](path.encode(), None)
    pockets = [NO_TOOL]
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            words = {letter: float(value) for letter, value in re.findall(r"([A-Z])([-+.0-9]+)", line.upper())}
            if "T" not in words:
                continue
            pockets.append((int(words["T"]), words.get("X", 0.0), 0.0, words.get("Z", 0.0)) + (0.0,) * 6 + (
                words.get("D", 0.0), words.get("I", 0.0), words.get("J", 0.0), int(words.get("Q", 0))))
    return pockets


class Canon:
    """Prints what the interpreter says."""

    def __init__(self, tools, parameter_file):
        self.pockets = load_tools(tools)
        self.parameter_file = parameter_file

    def say(self, name, *numbers):
        print(f"{name}({', '.join(repr(n) for n in numbers)})")

    def straight_traverse(self, *words): self.say("STRAIGHT_TRAVERSE", *words)
    def straight_feed(self, *words): self.say("STRAIGHT_FEED", *words)
    def straight_probe(self, *words): self.say("STRAIGHT_PROBE", *words)
    def rigid_tap(self, *words): self.say("RIGID_TAP", *words)
    def arc_feed(self, x, y, cx, cy, turns, z, *others): self.say("ARC_FEED", x, y, cx, cy, turns, z)
    def set_g5x_offset(self, *words): self.say("SET_G5X_OFFSET", *words)
    def set_g92_offset(self, *words): self.say("SET_G92_OFFSET", *words)
    def set_xy_rotation(self, angle): self.say("SET_XY_ROTATION", angle)
    def set_plane(self, plane): self.say("SELECT_PLANE", plane)
    def tool_offset(self, *words): self.say("USE_TOOL_LENGTH_OFFSET", *words)

    def get_tool(self, pocket):
        return self.pockets[pocket] if 0 <= pocket < len(self.pockets) else NO_TOOL

    def change_tool(self, pocket):
        self.pockets[0] = self.pockets[pocket] if 0 <= pocket < len(self.pockets) else NO_TOOL

    def get_external_length_units(self): return 1.0 / 25.4
    def get_external_angular_units(self): return 1.0
    def get_axis_mask(self): return 0x3f
    def get_block_delete(self): return False
    def check_abort(self): return False

    def next_line(self, state): pass
    def set_feed_rate(self, rate): pass
    def set_traverse_rate(self, rate): pass
    def dwell(self, seconds): pass
    def comment(self, text): pass
    def message(self, text): pass
    def user_defined_function(self, number, p, q): pass


def run(path, tools):
    parameters = os.path.join(os.environ["HOME"], "kept.var")
    open(parameters, "w", encoding="utf-8").close()
    os.chdir(os.path.dirname(os.path.abspath(path)))
    result, _ = gcode.parse(path, Canon(tools, parameters))
    if result > gcode.MIN_ERROR:
        print("ERROR", gcode.strerror(result))
    else:
        print("END")


def main():
    tools = os.path.abspath(sys.argv[1])
    os.environ["HOME"] = tempfile.mkdtemp()  # the book of tools is a file there
    for line in sys.stdin:
        path = os.path.abspath(line.strip())
        print("PROGRAM", path, flush=True)
        child = os.fork()
        if child == 0:
            signal.signal(signal.SIGALRM, signal.SIG_DFL)
            signal.alarm(SECONDS)
            os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
            try:
                run(path, tools)
            except Exception as error:  # a fault of the canon here must not read as motions
                print("ERROR of this script:", error)
            sys.stdout.flush()
            os._exit(0)
        _, status = os.waitpid(child, 0)
        if status != 0:
            print("ERROR the interpreter ended by signal", os.WTERMSIG(status), flush=True)


main()
