#!/usr/bin/env python3
"""Makes terrain.tif and sections.gpkg beside this file: a hillside that does not exist.

One square kilometre in the Hong Kong 1980 Grid (EPSG:2326): a natural slope of 18 deg with spurs and hollows, a road
cut into it in two places with batters of 60 deg and benches, a platform before the road. Ten section lines run from
the hillside across the cut and the road.

Needs Debian's python3-gdal:   /usr/bin/python3 profiles/terrain/make_terrain.py
"""

import math
import os

import numpy as np
from osgeo import gdal, ogr, osr

FOLDER = os.path.dirname(os.path.abspath(__file__))
EPSG = 2326
WEST, SOUTH, SIZE, CELL = 834000.0, 816000.0, 1000, 1.0

ROAD_ELEVATION = 60.0       # at the western edge
ROAD_GRADIENT = 0.01        # rising eastwards
NATURAL_SLOPE = math.tan(math.radians(18))
PLATFORM = 150.0            # level ground before the cut: the road and what stands beyond it
BATTER = math.tan(math.radians(60))
BATTER_HEIGHT, BENCH = 7.5, 1.5
STEP = 1 / 64               # elevations are rounded to this many metres, so that the file stays small

# Where the two cuts are: easting of the middle, half width, how far the road is set into the hill.
CUTS = [(834300.0, 110.0, 15.0, "11SW-D/C101"), (834700.0, 90.0, 10.0, "11SW-D/C102")]
SECTIONS = [(834240.0 + 24 * i, "11SW-D/C101") for i in range(6)] + [(834664.0 + 24 * i, "11SW-D/C102") for i in range(4)]
UPHILL, DOWNHILL = 95.0, 140.0


def edge_of_road(east):
    """Northing of the foot of the hill."""
    return SOUTH + 480 + 30 * np.sin((east - WEST) * 2 * math.pi / 900)


def set_back(east):
    """How much higher than the road the natural ground would stand at its edge."""
    depth = np.zeros_like(east)
    for middle, half, height, _ in CUTS:
        u = np.clip(np.abs(east - middle) / half, 0, 1)
        depth = np.maximum(depth, height * np.cos(u * math.pi / 2) ** 2)
    return depth


def height_of_cut(behind):
    """Of the excavated face at a distance behind its toe: batters and benches in turn."""
    run = BATTER_HEIGHT / BATTER
    whole = np.floor(behind / (run + BENCH))
    rest = behind - whole * (run + BENCH)
    return whole * BATTER_HEIGHT + np.minimum(rest, run) * BATTER


def elevation(east, north):
    road = ROAD_ELEVATION + ROAD_GRADIENT * (east - WEST)
    behind = north - edge_of_road(east)
    spurs = 6 * np.sin(east / 45) * np.sin(np.clip(behind / 400, 0, 1) * math.pi / 2) ** 2
    knoll = set_back(east) * np.exp(-(np.maximum(behind, 0) / 150) ** 2)
    natural = knoll + NATURAL_SLOPE * behind + spurs
    above = np.minimum(natural, height_of_cut(np.maximum(behind, 0)))
    below = -np.tan(math.radians(10)) * np.maximum(-behind - PLATFORM, 0)
    return road + np.where(behind > 0, above, below)


def reference():
    system = osr.SpatialReference()
    system.ImportFromEPSG(EPSG)
    system.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    return system


def write_raster(path):
    centres = (np.arange(SIZE) + 0.5) * CELL
    east, north = np.meshgrid(WEST + centres, SOUTH + SIZE * CELL - centres)
    values = np.round(elevation(east, north) / STEP) * STEP
    data = gdal.GetDriverByName("GTiff").Create(path, SIZE, SIZE, 1, gdal.GDT_Float32,
                                                ["COMPRESS=DEFLATE", "PREDICTOR=3", "ZLEVEL=9", "TILED=YES"])
    data.SetGeoTransform((WEST, CELL, 0, SOUTH + SIZE * CELL, 0, -CELL))
    data.SetSpatialRef(reference())
    band = data.GetRasterBand(1)
    band.SetNoDataValue(-9999)
    band.SetUnitType("m")
    band.WriteArray(values.astype(np.float32))


def section_line(east):
    """Square to the foot of the hill."""
    foot = float(edge_of_road(np.float64(east)))
    slope = float(edge_of_road(np.float64(east + 0.5)) - edge_of_road(np.float64(east - 0.5)))
    length = math.hypot(1, slope)
    across = (-slope / length, 1 / length)
    line = ogr.Geometry(ogr.wkbLineString)
    for distance in (UPHILL, -DOWNHILL):
        line.AddPoint_2D(round(east + distance * across[0], 3), round(foot + distance * across[1], 3))
    return line


def write_sections(path):
    gdal.SetConfigOption("OGR_CURRENT_DATE", "2000-01-01T00:00:00.000Z")  # the same bytes every time
    data = ogr.GetDriverByName("GPKG").CreateDataSource(path)
    layer = data.CreateLayer("sections", reference(), ogr.wkbLineString)
    layer.CreateField(ogr.FieldDefn("id", ogr.OFTInteger))
    layer.CreateField(ogr.FieldDefn("name", ogr.OFTString))
    layer.CreateField(ogr.FieldDefn("slope_no", ogr.OFTString))
    for number, (east, slope) in enumerate(SECTIONS, start=1):
        feature = ogr.Feature(layer.GetLayerDefn())
        feature.SetField("id", number)
        feature.SetField("name", f"{chr(64 + number)}-{chr(64 + number)}")
        feature.SetField("slope_no", slope)
        feature.SetGeometry(section_line(east))
        layer.CreateFeature(feature)


def main():
    gdal.UseExceptions()
    ogr.UseExceptions()
    for name, write in (("terrain.tif", write_raster), ("sections.gpkg", write_sections)):
        path = os.path.join(FOLDER, name)
        if os.path.exists(path):
            os.remove(path)
        write(path)


if __name__ == "__main__":
    main()
