#!/usr/bin/env python3
"""How far each setting may be turned before stability is lost: the table of docs/stability.md.

    tests/hard/edge_map.py [--runout build/release/src/runout] [--jobs 2]

One knob at a time, all others at their defaults: forty random scenes of about 100 particles, and the shipped scenes at
sqrt(S)/dl = 32 and 64. Half an hour of one core.
"""

import argparse
import concurrent.futures
import pathlib
import sqlite3
import subprocess
import tempfile
from collections import Counter

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = ["aluminium-column", "box-45", "box-70", "soil-cut-60", "fig15"]
RESOLUTIONS = [32, 64]
SETTINGS = [
    None,
    *[("courant", v) for v in (0.1, 0.3, 0.4)],
    *[("friction_iterations", v) for v in (1, 3, 12)],
    *[("smoothing_ratio", v) for v in (1.15, 1.5, 2)],
    *[("pressure_tolerance", v) for v in (0.001, 0.1)],
]
# What is dear at 64: only what may lose stability.
COARSE_ONLY = [("courant", 0.1), ("friction_iterations", 3), ("friction_iterations", 12), ("smoothing_ratio", 1.5),
               ("pressure_tolerance", 0.001)]


def settings_at(place):
    return [s for s in SETTINGS if place != 64 or s not in COARSE_ONLY]


def set_options(setting):
    return [] if setting is None else ["--set", f"run.{setting[0]}={setting[1]}"]


def run_stress(runout, setting, database):
    return [runout, "stress", "--scenes", "40", "--seed", "2", "--range", "base_friction_share=0.3:3", "--range",
            "friction_angle_deg=15:60", "--jobs", "1", "--quiet", "--db", database, *set_options(setting)]


def run_case(runout, name, resolution, setting, database):
    return [runout, "run", str(ROOT / "cases" / name / "case.toml"), "--no-pilots", "--quiet", "--db", database,
            "--set", f"run.resolution={resolution}", "--set", "run.threads=1", *set_options(setting)]


def read(database):
    """Endings, greatest rise of energy, greatest excess of density, and run-out by name."""
    with sqlite3.connect(database) as stored:
        endings = Counter(row[0] for row in stored.execute("SELECT status FROM run"))
        worst = dict(stored.execute("SELECT invariant, max(worst) FROM invariant GROUP BY invariant"))
        run_out = dict(stored.execute("SELECT run.name, run_out_m FROM run JOIN result USING (run_id)"))
    return endings, worst["energy_rise"], worst["density"], run_out


def measure(runout, setting, place):
    """Of one setting: what `read` gives of the random scenes and of the shipped ones at each resolution."""
    with tempfile.TemporaryDirectory() as folder:
        database = str(pathlib.Path(folder) / "edge.db")
        if place == "random":
            commands = [run_stress(runout, setting, database)]
        else:
            commands = [run_case(runout, name, place, setting, database) for name in SCENES]
        for command in commands:  # runs that end otherwise than at rest give other codes, and are counted
            subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        return read(database)


def change(run_out, base):
    """Greatest change of a run-out against the defaults, in %."""
    shares = [100 * (run_out[n] / base[n] - 1) for n in base if run_out.get(n) is not None and base[n]]
    return f"{max(shares, key=abs):+.1f}" if shares else "-"


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--runout", default=str(ROOT / "build/release/src/runout"))
    options.add_argument("--jobs", type=int, default=2)
    asked = options.parse_args()
    places = ["random", *RESOLUTIONS]
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        found = {(s, p): pool.submit(measure, asked.runout, s, p) for p in places for s in settings_at(p)}
        for place in places:
            print(f"\n{'Random scenes' if place == 'random' else f'Shipped scenes at {place}'}\n")
            print("| setting | how the runs ended | rise of energy / (M g H) | excess of density | run-out, % |")
            print("|---|---|---:|---:|---:|")
            base = found[None, place].result()[3]
            for setting in settings_at(place):
                endings, energy, density, run_out = found[setting, place].result()
                name = "the defaults" if setting is None else f"`{setting[0]} = {setting[1]}`"
                ended = ", ".join(f"{word} {count}" for word, count in sorted(endings.items()))
                moved = "-" if place == "random" else change(run_out, base)
                print(f"| {name} | {ended} | {energy:.2g} | {density:.2g} | {moved} |", flush=True)


if __name__ == "__main__":
    main()
