#!/usr/bin/env python3
"""Opens the exported particles with VTK's own reader, and holds points, fields and values against the database.

    vtk_reads_particles.py PROGRAM CASE        ends with 77 (skipped) where VTK for Python is not installed
"""

import os
import sqlite3
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

try:
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError:
    print("skipped: VTK is not here (Debian: python3-vtk9)")
    sys.exit(77)

INSTANTS = [0.5, 1.5]


def export_of(program, case, folder):
    database = os.path.join(folder, "v.db")
    subprocess.run([program, "run", case, "--resolution", "8", "--threads", "1", "--db", database, "--quiet",
                    "--set", f"run.snapshot_times_s={INSTANTS}"], check=True)
    subprocess.run([program, "export", database, "--vtk", folder], check=True)
    return database


def read(path):
    reader = vtkXMLPolyDataReader()
    assert reader.CanReadFile(path), f"{path} is no VTK PolyData"
    reader.SetFileName(path)
    reader.Update()
    assert reader.GetErrorCode() == 0, path
    return reader.GetOutput()


def floats(blob):
    return struct.unpack(f"<{len(blob) // 4}f", blob)


def check_instant(cloud, row):
    x, y, vx, vy, pressure = (floats(blob) for blob in row)
    count = cloud.GetNumberOfPoints()
    assert count == len(x) > 50, (count, len(x))
    assert cloud.GetNumberOfVerts() == count, "without a vertex each, nothing is drawn"
    fields = cloud.GetPointData()
    names = [fields.GetArrayName(k) for k in range(fields.GetNumberOfArrays())]
    assert names == ["speed_m_s", "pressure_pa", "velocity_m_s"], names
    for i in range(count):
        # Not one bit may be lost: the text of a float reads back as the same float.
        assert cloud.GetPoint(i) == (x[i], y[i], 0), i
        assert fields.GetArray("velocity_m_s").GetTuple(i) == (vx[i], vy[i], 0), i
        assert fields.GetArray("pressure_pa").GetValue(i) == pressure[i], i
        speed = (vx[i] ** 2 + vy[i] ** 2) ** 0.5
        assert abs(fields.GetArray("speed_m_s").GetValue(i) - speed) <= 1e-6 * speed, i
    assert max(pressure) > 0 and max(map(abs, vx)) > 0, "an instant of motion"


def main():
    program, case = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        database = export_of(program, case, folder)
        listed = ElementTree.parse(os.path.join(folder, "particles.pvd")).getroot().findall(".//DataSet")
        rows = sqlite3.connect(database).execute(
            "SELECT time_s, x_m, y_m, vx_m_s, vy_m_s, pressure_pa FROM snapshot ORDER BY row_index").fetchall()
        assert len(listed) == len(rows) == len(INSTANTS), (len(listed), len(rows))
        for entry, row in zip(listed, rows):
            assert float(entry.get("timestep")) == row[0]
            check_instant(read(os.path.join(folder, entry.get("file"))), row[1:])
        print(f"{len(rows)} instants of {len(row[1]) // 4} particles read back to the bit")


main()
