#!/usr/bin/env python3
"""The aluminium column by Runout and by Gerris (Debian packages gerris and openmpi-bin), one beside the other.

    beside_gerris.py PROGRAM        such as build/release/src/runout

Prints, for some spacings and cells: CPU seconds, the misfit of the final surface with the experiment as a share of
the column's area, and the front 4 mm thick in lengths of the column. One thread each; Runout to rest, Gerris to 0.8 s.
"""

import csv
import os
import resource
import sqlite3
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
CASE = os.path.join(HERE, "..", "..", "cases", "aluminium-column")
LENGTH, HEIGHT, FRONT = 0.2, 0.1, 0.004  # of the column and of the front, m
BOX, BOXES = 0.15, 4  # of gerris_column.gfs


def cpu_seconds(command, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    # Open MPI, which Gerris links, refuses to start for root unless told.
    allowed = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                   env={**os.environ, **allowed})
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def measured_surface():
    with open(os.path.join(CASE, "expected.csv"), encoding="utf-8") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        points = [(float(row["x"]), float(row["y"])) for row in rows if row["line"] == "surface"]
    return points


def height(surface, x):
    """Of the surface at x; level up to its first point, nothing beyond its last."""
    if x < surface[0][0]:
        return surface[0][1]
    for (x0, y0), (x1, y1) in zip(surface, surface[1:]):
        if x0 <= x < x1:
            return y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    return 0.0


def misfit(surface):
    """Integral of |h - h measured| over the column's area."""
    measured, step = measured_surface(), 0.0005
    places = [(i + 0.5) * step for i in range(int(0.6 / step))]
    return sum(abs(height(surface, x) - height(measured, x)) for x in places) * step / (LENGTH * HEIGHT)


def front(surface):
    """Chainage up to which the surface stays above the front's thickness, in lengths of the column."""
    for (x0, y0), (x1, y1) in zip(surface, surface[1:]):
        if y1 < FRONT:
            return (x0 + (x1 - x0) * (y0 - FRONT) / (y0 - y1)) / LENGTH
    return surface[-1][0] / LENGTH


def run_runout(program, spacing, courant, folder):
    database = os.path.join(folder, f"{spacing}-{courant}.db")
    seconds = cpu_seconds([program, "run", os.path.join(CASE, "case.toml"), "--spacing", str(spacing), "--courant",
                           str(courant), "--threads", "1", "--no-pilots", "--frames", "0", "--quiet", "--db",
                           database], folder)
    with sqlite3.connect(database) as runs:
        particles, = runs.execute("SELECT particles FROM run").fetchone()
        by_top, by_mass = runs.execute("SELECT run_out_m, front_by_mass_m FROM measure").fetchone()
        surface = runs.execute("SELECT chainage_m, thickness_by_top_m FROM deposit_profile ORDER BY row_index").fetchall()
    return particles, seconds, misfit(surface), by_top / LENGTH, by_mass / LENGTH


def run_gerris(level, folder):
    seconds = cpu_seconds(["gerris2D", f"-DLEVEL={level}", os.path.join(HERE, "gerris_column.gfs")], folder)
    with open(os.path.join(folder, "end.txt"), encoding="ascii") as file:
        cells = [tuple(map(float, line.split())) for line in file if not line.startswith("#")]
    columns = BOXES * 2**level
    width = BOX / 2**level
    thickness = [0.0] * columns
    for x, _, _, soil, cell_level in cells:
        size = BOX / 2**cell_level
        first = round((x - size / 2) / width)
        for column in range(first, first + round(size / width)):
            thickness[column] += soil * size
    surface = [((i + 0.5) * width, h) for i, h in enumerate(thickness)]
    return len(cells), seconds, misfit(surface), front(surface)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    program = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        print("| code | particles or cells at the end | CPU, s | misfit, % | front by top, L0 | front by mass, L0 |")
        print("|---|---:|---:|---:|---:|---:|")
        for spacing, courant in ((0.008, 0.1), (0.005, 0.2), (0.005, 0.1), (0.004, 0.1), (0.002, 0.2), (0.002, 0.1)):
            count, seconds, off, by_top, by_mass = run_runout(program, spacing, courant, folder)
            print(f"| Runout, {1000 * spacing:g} mm, Courant number {courant} | {count} | {seconds:.2f} | "
                  f"{100 * off:.1f} | {by_top:.2f} | {by_mass:.2f} |", flush=True)
        for level in (4, 5, 6):
            count, seconds, off, by_mass = run_gerris(level, folder)
            print(f"| Gerris, {1000 * BOX / 2**level:.1f} mm | {count} | {seconds:.2f} | {100 * off:.1f} | | "
                  f"{by_mass:.2f} |", flush=True)


main()
