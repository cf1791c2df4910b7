#!/usr/bin/env python3
"""How much faster two threads are than one, phase by phase.

    tests/bench/thread_gain.py build/release/src/runout [ROUNDS]

Runs the start of the aluminium column's collapse at 10,000, 30,000 and 100,000 particles with one thread and
with two by turns, ROUNDS times (default 6), and prints the least seconds of each phase, with two threads, and
how many times as long one thread took. The least, because what disturbs a machine only ever adds time. In
the last column two runs go side by side, each on one thread: 2 would be two cores of which neither slows the
other down, and is the most that two threads can gain.
"""

import re
import subprocess
import sys

CASE = "cases/aluminium-column/case.toml"
PHASES = ["equilibrium", "neighbours", "friction", "pressure", "motion", "judgement"]
SIZES = {10000: ("0.001414", "0.1"), 30000: ("0.000816", "0.02"), 100000: ("0.000447", "0.003")}


def start(program, size, threads):
    spacing, end = SIZES[size]
    return subprocess.Popen(
        [program, "run", CASE, "--spacing", spacing, "--time-limit", end, "--threads", str(threads),
         "--no-store", "--no-pilots"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)


def seconds(process):
    text = process.communicate()[0]
    found = {phase: float(re.search(rf"^{phase}\s+([\d.]+)", text, re.M).group(1)) for phase in PHASES}
    found["all"] = sum(found.values())
    return found


def least(best, found):
    for phase, value in found.items():
        best[phase] = min(best.get(phase, value), value)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    program = sys.argv[1]
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 6
    print("particles   " + "".join(f"{phase:>19}" for phase in PHASES + ["all"]) + "  side by side")
    for size in SIZES:
        one, two, pair = {}, {}, {}
        for _ in range(rounds):
            least(one, seconds(start(program, size, 1)))
            least(two, seconds(start(program, size, 2)))
            both = [start(program, size, 1), start(program, size, 1)]
            found = [seconds(process) for process in both]
            least(pair, max(found, key=lambda f: f["all"]))
        cells = "".join(f"{two[p]:11.3f} s x{one[p] / two[p]:5.2f}" for p in PHASES + ["all"])
        print(f"{size:9}   {cells}  {2 * one['all'] / pair['all']:12.2f}", flush=True)


main()
