#!/usr/bin/env python3
"""What a step costs by size, as a table and a picture (Debian package python3-matplotlib).

    build/release/tests/engine_bench --benchmark_filter='Step/.*/threads:1/real_time$' \\
        --benchmark_repetitions=5 --benchmark_enable_random_interleaving=true --benchmark_min_time=0.3 |
        tests/bench/scaling_plot.py docs/performance/by-size.svg

Of the repetitions of a size the fastest counts: what disturbs a machine only ever adds time.
"""

import math
import re
import sys

PHASES = ["neighbours", "friction", "pressure", "motion"]


def fastest(lines):
    """Counters of the fastest repetition, by size. Times in ns per particle and step."""
    best = {}
    for line in lines:
        match = re.match(r"Step/particles:(\d+)/threads:1/real_time\s", line)
        if not match:
            continue
        found = {name: float(value) for name, value in re.findall(r"(\w+)=([\d.]+)", line)}
        size = int(match.group(1))
        if size not in best or found["per_particle"] < best[size]["per_particle"]:
            best[size] = found
    return dict(sorted(best.items()))


def print_table(best):
    first = min(best)
    print("| particles | per particle and step, us | growth per tenfold since the first | pressure iterations a step |"
          " neighbours, friction, pressure, motion, ns |\n|---:|---:|---:|---:|---|")
    for size, c in best.items():
        decades = math.log10(size / first)
        ratio = c["per_particle"] / best[first]["per_particle"]
        growth = f"{100 * (ratio ** (1 / decades) - 1):.0f} %" if size > first else ""
        phases = ", ".join(f"{c[phase]:.0f}" for phase in PHASES)
        print(f"| {size:,} | {c['per_particle'] / 1e3:.3f} | {growth} | {c['iterations']:.1f} | {phases} |")


def draw(best, path):
    import matplotlib

    matplotlib.use("svg")
    matplotlib.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "runout", "font.size": 11})
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(7, 4.2))
    sizes = list(best)
    axes.plot(sizes, [best[s]["per_particle"] for s in sizes], "k-o", label="whole step")
    first = best[sizes[0]]["per_particle"]
    axes.plot(sizes, [first * 1.15 ** math.log10(s / sizes[0]) for s in sizes], "k:", label="15 % per tenfold")
    for phase in PHASES:
        axes.plot(sizes, [best[s][phase] for s in sizes], "-o", label=phase)
    axes.set_xscale("log")
    axes.set_ylim(bottom=0)
    axes.set_xlabel("particles")
    axes.set_ylabel("ns per particle and step, one thread")
    axes.grid(alpha=0.3)
    axes.legend(ncol=2, frameon=False)
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    best = fastest(sys.stdin)
    if not best:
        sys.exit("scaling_plot.py: no line of the benchmark Step on one thread in the input")
    print_table(best)
    draw(best, sys.argv[1])


main()
