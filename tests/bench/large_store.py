#!/usr/bin/env python3
"""Fills a copy of a database of runs with copies of its runs, and times what reads one study of 10,000 of them.

    large_store.py PROGRAM DATABASE RUNS        such as build/release/src/runout sweep.db 1000000
"""

import os
import resource
import shutil
import sqlite3
import subprocess
import sys
import tempfile
import time

STUDY = 10_000
# Tables whose rows belong to a run or a scenario, with the columns that carry an id.
COPIED = {"scenario": {"scenario_id": "scenario"}, "run": {"run_id": "run", "scenario_id": "scenario"},
          "measure": {"run_id": "run"}, "deposit_profile": {"run_id": "run"}, "invariant": {"run_id": "run"}}


def copy_sql(database, table, steps):
    columns, values = [], []
    for row in database.execute(f"PRAGMA table_info({table})"):
        name = row[1]
        columns.append(name)
        if name in COPIED[table]:
            values.append(f"{name} + :k * {steps[COPIED[table][name]]}")
        else:
            values.append(f"{name} || '-' || :k" if name == "scenario_hash" else name)
    key = "run_id" if "run_id" in columns else "scenario_id"
    limit = steps["run" if key == "run_id" else "scenario"]
    return f"INSERT INTO {table} ({', '.join(columns)}) SELECT {', '.join(values)} FROM {table} WHERE {key} <= {limit}"


def fill(path, runs):
    database = sqlite3.connect(path, isolation_level=None)
    database.execute("PRAGMA journal_mode = OFF")
    database.execute("PRAGMA synchronous = OFF")
    steps = {name: database.execute(f"SELECT max({name}_id) FROM {name}").fetchone()[0] for name in ("run", "scenario")}
    statements = [copy_sql(database, table, steps) for table in COPIED]
    count = database.execute("SELECT count(*) FROM run").fetchone()[0]
    database.execute("BEGIN")
    for k in range(1, -(-runs // count)):
        for statement in statements:
            database.execute(statement, {"k": k})
    database.execute("INSERT INTO study (name, text) VALUES ('large', '')")
    database.execute("INSERT INTO study_scenario SELECT last_insert_rowid(), row_number() OVER () - 1, scenario_hash,"
                     " json_object('material.friction_angle_deg', friction_angle_deg), ''"
                     f" FROM (SELECT * FROM scenario ORDER BY scenario_id DESC LIMIT {STUDY})")
    database.execute("COMMIT")
    return database.execute("SELECT count(*) FROM run").fetchone()[0]


def timed(arguments):
    before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    subprocess.run(arguments, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return f"{cpu:.2f} s of CPU time, {time.monotonic() - begin:.2f} s"


def main():
    program, source, runs = sys.argv[1], sys.argv[2], int(sys.argv[3])
    with tempfile.TemporaryDirectory(dir=os.path.dirname(os.path.abspath(source))) as folder:
        path = os.path.join(folder, "large.db")
        shutil.copyfile(source, path)
        count = fill(path, runs)
        print(f"{count} runs, {os.path.getsize(path) / count:.0f} bytes a run")
        for what in (["table", path, "--study", "large"], ["estimate", path, "--study", "large", "--check"]):
            print(f"runout {what[0]} of a study of {STUDY}: {timed([program, *what])}")


main()
