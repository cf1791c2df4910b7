#!/usr/bin/env python3
"""Opens a map of results in QGIS without a screen: layers valid, styles taken from the file, colours on the picture.

    qgis_opens_map.py PROGRAM CASE        ends with 77 (skipped) where QGIS for Python is not installed
"""

import os
import subprocess
import sys
import tempfile

os.environ["QT_QPA_PLATFORM"] = "offscreen"
try:
    from qgis.core import QgsApplication, QgsMapRendererSequentialJob, QgsMapSettings, QgsRectangle, QgsVectorLayer
    from qgis.PyQt.QtCore import QSize
    from qgis.PyQt.QtGui import QColor
except ImportError:
    print("skipped: QGIS is not here (Debian: python3-qgis qgis-providers)")
    sys.exit(77)

LAYERS = {"hazard_band": "singleSymbol", "section": "singleSymbol", "deposit": "singleSymbol",
          "thickness": "graduatedSymbol", "source": "singleSymbol", "runout_extent_line": "singleSymbol",
          "runout_extent": "singleSymbol"}


def make_map(program, case, folder):
    database, geopackage = os.path.join(folder, "q.db"), os.path.join(folder, "q.gpkg")
    subprocess.run([program, "run", case, "--where", "id in (4, 5)", "--resolution", "8", "--threads", "1",
                    "--db", database, "--quiet"], check=True)
    subprocess.run([program, "map", database, "-o", geopackage], check=True)
    return geopackage


def open_layer(geopackage, name):
    layer = QgsVectorLayer(f"{geopackage}|layername={name}", name, "ogr")
    assert layer.isValid() and layer.featureCount() > 0, name
    assert layer.crs().authid() == "EPSG:2326", layer.crs().authid()
    message, loaded = layer.loadDefaultStyle()
    assert loaded, f"{name}: {message}"
    assert layer.renderer().type() == LAYERS[name], f"{name} is drawn as {layer.renderer().type()}"
    return layer


def picture_of(layers):
    settings = QgsMapSettings()
    settings.setLayers(layers)
    settings.setDestinationCrs(layers[0].crs())
    settings.setBackgroundColor(QColor(255, 255, 255))
    settings.setOutputSize(QSize(600, 600))
    extent = QgsRectangle()
    for layer in layers:
        extent.combineExtentWith(layer.extent())
    settings.setExtent(extent)
    job = QgsMapRendererSequentialJob(settings)
    job.start()
    job.waitForFinished()
    return job.renderedImage()


def reds(image):
    """Pixels that are clearly red: the bars at the distal margins, by their style."""
    colours = (image.pixelColor(x, y) for x in range(image.width()) for y in range(image.height()))
    return sum(c.red() > 180 and c.green() < 90 and c.blue() < 90 for c in colours)


def main():
    program, case = sys.argv[1:3]
    application = QgsApplication([], False)
    application.initQgis()
    with tempfile.TemporaryDirectory() as folder:
        geopackage = make_map(program, case, folder)
        layers = [open_layer(geopackage, name) for name in LAYERS]
        count = reds(picture_of(list(reversed(layers))))
        assert count > 50, f"{count} red pixels"
        layers.clear()
    application.exitQgis()


main()
