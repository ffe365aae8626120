#!/usr/bin/env python3
"""The meshes of prm/meshes are what their .geo files say they are.

The header of a .geo file lists commands of gmsh with the counts of their
meshes. Each command is run again: with the version of gmsh named there the mesh
must be the same, with another one of about the same size. Counts, altitudes,
orientation and volume of the mesh in the repository are checked as well.
"""

import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

folder = pathlib.Path(os.environ["MPM_SOURCE_DIR"]) / "prm" / "meshes"

COMMAND = re.compile(r"//\s+(gmsh .*-o (\S+)\.msh.*)")
COUNTS = re.compile(r"//\s+(\d+) nodes, (\d+) (?:tetrahedra|triangles), altitude "
                    r"(\S+) m \(smallest\), (\S+) m \(mean\), hull (\S+) ")
TRIANGLE, TETRAHEDRON = 2, 4  # gmsh's numbers of these shapes


def read_mesh(path):
    """Coordinates and cells of an ASCII file of format 4.1."""
    sections = {}
    for match in re.finditer(r"^\$(\w+)\n(.*?)^\$End\1", path.read_text(),
                             re.MULTILINE | re.DOTALL):
        sections[match[1]] = match[2].splitlines()

    points = {}
    lines = iter(sections["Nodes"])
    for _ in range(int(next(lines).split()[0])):
        n_nodes = int(next(lines).split()[3])
        tags = [int(next(lines)) for _ in range(n_nodes)]
        for tag in tags:
            points[tag] = tuple(float(word) for word in next(lines).split())

    cells = {TRIANGLE: [], TETRAHEDRON: []}
    lines = iter(sections["Elements"])
    for _ in range(int(next(lines).split()[0])):
        _, _, shape, n_elements = (int(word) for word in next(lines).split())
        for _ in range(n_elements):
            element = tuple(int(word) for word in next(lines).split())
            cells.setdefault(shape, []).append(element[1:])
    return points, cells[TETRAHEDRON] or cells[TRIANGLE]


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0])


def size_and_altitude(corners):
    """Signed area or volume, and smallest altitude, of a simplex."""
    if len(corners) == 3:
        size = cross(minus(corners[1], corners[0]),
                     minus(corners[2], corners[0]))[2] / 2
        faces = [math.dist(corners[i], corners[j]) for i, j in ((0, 1), (1, 2), (2, 0))]
        return size, 2 * abs(size) / max(faces)
    edges = [minus(corner, corners[0]) for corner in corners[1:]]
    size = sum(x * y for x, y in zip(cross(edges[0], edges[1]), edges[2])) / 6
    faces = [math.hypot(*cross(minus(b, a), minus(c, a))) / 2
             for a, b, c in ((corners[i], corners[j], corners[k]) for i, j, k in
                             ((0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3)))]
    return size, 3 * abs(size) / max(faces)


def check_header(counts, points, cells):
    """Differences between a mesh and the line of counts in the .geo file."""
    n_nodes, n_cells = int(counts[1]), int(counts[2])
    smallest, mean, hull = (float(counts[i]) for i in (3, 4, 5))
    sizes, altitudes = zip(*(size_and_altitude([points[tag] for tag in cell])
                             for cell in cells))
    n_used = len({tag for cell in cells for tag in cell})
    if (n_used, len(cells)) != (n_nodes, n_cells) or n_used != len(points):
        yield f"{len(points)} nodes, {n_used} used, {len(cells)} cells"
    if min(sizes) <= 0:
        yield f"{sum(size <= 0 for size in sizes)} cells are inverted or flat"
    if abs(sum(sizes) - hull) > 1e-10 * hull:
        yield f"the cells fill {sum(sizes)}, the hull is {hull}"
    found = min(altitudes), sum(altitudes) / len(altitudes)
    if any(abs(a - b) > 1e-5 for a, b in zip(found, (smallest, mean))):
        yield f"altitudes {found[0]:.5f} (smallest) and {found[1]:.5f} (mean)"


def compare(old, new, same_version):
    """Differences between the mesh in the repository and a new one."""
    if not same_version:
        if any(abs(len(a) / len(b) - 1) > 0.1 for a, b in zip(old, new)):
            yield (f"made again by another gmsh: {len(new[0])} nodes and "
                   f"{len(new[1])} cells, were {len(old[0])} and {len(old[1])}")
    elif old[1] != new[1] or old[0].keys() != new[0].keys():
        yield "made again: nodes or cells differ"
    elif any(math.dist(old[0][tag], new[0][tag]) > 1e-9 for tag in old[0]):
        yield "made again: coordinates differ"


def check_geometry(geo, gmsh_version):
    text = geo.read_text()
    version = re.search(r"gmsh (\d+\.\d+\.\d+)", text)[1]
    lines = text.splitlines()
    commands = [i for i, line in enumerate(lines) if COMMAND.match(line)]
    if not commands:
        yield f"{geo.name}: no command in its header"
    for i in commands:
        command, name = COMMAND.match(lines[i]).groups()
        counts = COUNTS.match(lines[i + 1])
        mesh = read_mesh(folder / f"{name}.msh")
        with tempfile.TemporaryDirectory() as work:
            shutil.copy(geo, work)
            subprocess.run(command.split(), cwd=work, check=True,
                           capture_output=True)
            again = read_mesh(pathlib.Path(work) / f"{name}.msh")
        problems = list(check_header(counts, *mesh))
        problems += compare(mesh, again, version == gmsh_version)
        print(f"{name}: {len(mesh[1])} cells, {len(problems)} problems")
        yield from (f"{name}: {problem}" for problem in problems)


answer = subprocess.run(["gmsh", "--version"], capture_output=True, text=True, check=True)
installed = (answer.stdout + answer.stderr).strip()
print(f"gmsh {installed}")
all_problems = []
made = set()
for geo_file in sorted(folder.glob("*.geo")):
    all_problems += check_geometry(geo_file, installed)
    made |= set(re.findall(r"-o (\S+\.msh)", geo_file.read_text()))
all_problems += [f"{path.name}: no .geo file makes it"
                 for path in folder.glob("*.msh") if path.name not in made]
for problem in all_problems:
    print(problem)
sys.exit(1 if all_problems else 0)
