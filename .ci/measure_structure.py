#!/usr/bin/env python3
"""Figures of the source tree, without tests: files, knots of includes, fullest folders, assertions, comments.

    .ci/measure_structure.py [ROOT]

A room is a source with its header. A knot is a strongly connected part of the include graph. What may not grow is
kept by tests/unit/base/include_graph_test.cpp; this prints where it stands.
"""
import collections
import os
import re
import sys

FOLDERS = ("core", "removal", "io", "render", "app")


def read(root):
    files = {}
    for folder in FOLDERS:
        for at, _, names in os.walk(os.path.join(root, folder)):
            for name in names:
                if name.endswith((".h", ".cpp")):
                    path = os.path.join(at, name)
                    with open(path, encoding="utf-8") as file:
                        files[os.path.relpath(path, root)] = file.read()
    return files


def knots(graph):
    """Sizes of the strongly connected parts of more than one node, the largest first (R. Tarjan, 1972)."""
    number, low, open_, is_open, sizes = {}, {}, [], set(), []

    def visit(at):
        number[at] = low[at] = len(number)
        open_.append(at)
        is_open.add(at)
        for other in graph[at]:
            if other not in number:
                visit(other)
            if other in is_open:
                low[at] = min(low[at], low[other])
        if low[at] == number[at]:
            size = 0
            while True:
                size += 1
                last = open_.pop()
                is_open.discard(last)
                if last == at:
                    break
            if size > 1:
                sizes.append(size)

    sys.setrecursionlimit(100000)
    for node in graph:
        if node not in number:
            visit(node)
    return sorted(sizes, reverse=True)


def condensed(includes, place):
    graph = {place(file): set() for file in includes}
    for file, others in includes.items():
        graph[place(file)] |= {place(other) for other in others} - {place(file)}
    return graph


def share_of_comments(files):
    lines = [line.strip() for text in files for line in text.split("\n")]
    return 100 * sum(line.startswith("//") for line in lines) / max(1, len(lines))


def main():
    files = read(sys.argv[1] if len(sys.argv) > 1 else ".")
    lines = sum(text.count("\n") for text in files.values())
    includes = {file: {name for name in re.findall(r'^#include "([^"]+)"', text, re.M) if name in files}
                for file, text in files.items()}
    full = collections.Counter(os.path.dirname(file) for file in files).most_common(6)
    asserts = sum(len(re.findall(r"^\s*PROVEOUT_ASSERT(?:_DEAR)?\(", text, re.M)) for text in files.values())
    wall = sum(len(re.findall(r"ProcessKind|TurnedShape|setup\.turned", text)) for file, text in files.items()
               if file.startswith("app/") and "session/process/" not in file and "session/run/process." not in file)
    print(f"files / lines               {len(files)} / {lines}")
    print(f"largest knots of rooms      {knots(condensed(includes, lambda f: f.rsplit('.', 1)[0]))[:6]}")
    print(f"largest knots of folders    {knots(condensed(includes, os.path.dirname))[:6]}")
    print(f"header cycles               {len(knots({f: {o for o in i if o.endswith('.h')} for f, i in includes.items() if f.endswith('.h')}))}")
    print(f"fullest folders             {', '.join(f'{folder} {count}' for folder, count in full)}")
    print(f"assertions, a 1,000 lines   {asserts}, {1000 * asserts / lines:.2f}")
    print(f"mentions of the process     {wall}")
    print(f"comment lines, .h / .cpp    {share_of_comments([t for f, t in files.items() if f.endswith('.h')]):.1f} % / "
          f"{share_of_comments([t for f, t in files.items() if f.endswith('.cpp')]):.1f} %")


if __name__ == "__main__":
    main()
