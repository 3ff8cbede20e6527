# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every reader of the package, with a small sound file of its kind: add to `READERS`."""

import dataclasses
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ltp._core import ObstacleMap, ObstacleMapOptions, OctreeSurface, Raster
from ltp.cli.waypoints import read_waypoints
from ltp.config import MissionConfig
from ltp.evaluation.campaign.campaign import FlightJournal
from ltp.evaluation.campaign.rows import read_rows, write_rows
from ltp.evaluation.gap.queries import QuerySet, RecordedQuery
from ltp.evaluation.gap.rows import PLANS, GapRow, read_gaps
from ltp.evaluation.regret.rows import REGRETS, read_regrets
from ltp.evaluation.sensed import CellMap
from ltp.sim import FlightRecord
from ltp.world import World, boxes, read_priority, save_priority
from tests.python.scenes import event, record, regret_row, row


@dataclass(frozen=True)
class Reader:
    """A function that reads a file, and how to make a sound file for it."""

    name: str  # of the file
    read: Callable[[Path], object]
    write: Callable[[Path], object]
    needs: tuple[str, ...] = ()  # libraries


def _queries(path: Path) -> None:
    from ltp._core import GridFrame, OccupancyGrid, Raster

    frame = GridFrame((0.0, 0.0, 0.0), (1.0, 1.0, 1.0), (4, 3, 5))
    blocked = CellMap.of(OccupancyGrid(frame))
    query = RecordedQuery(
        0, 1.5, 1, np.array([0.5, 0.5, 0.5]), np.array([3.5, 2.5, 0.5]), (0.0, 0.0), -0.1, blocked
    )
    raster = Raster(np.zeros((4, 3)), origin=(0.0, 0.0), cell=1.0)
    maps = {0: {"binary": raster, "lpf": raster}}
    QuerySet("boxes", "nobody", "made up", [query, query], maps).save(path)


def _world(path: Path) -> None:
    ground = np.arange(12.0).reshape(4, 3)
    World("boxes", ground, ground + 1.0, np.zeros((4, 3), np.uint8), 1.0, report=("so",)).save(path)


def _priority(path: Path) -> None:
    values = np.linspace(0.0, 1.0, 12).reshape(4, 3)
    save_priority(Raster(values, origin=(-1.0, 2.0), cell=2.0), path)


def _read_priority(path: Path) -> None:
    read_priority(path, boxes([], extent=(-3.0, 0.0, 9.0, 12.0)))


def _journal(path: Path) -> None:
    with FlightJournal(path) as journal:
        for number in range(3):
            journal.append(row(key=f"k{number}"))


def _read_journal(path: Path) -> None:
    with FlightJournal(path):
        pass


def _gaps(path: Path) -> None:
    values: dict[str, Any] = {"str": "planar", "int": 3, "float": 1.5, "bool": True}
    kinds = {field.name: str(getattr(field.type, "__name__", field.type)) for field in
             dataclasses.fields(GapRow)}  # fmt: skip
    made = {name: values[kind.partition(" ")[0]] for name, kind in kinds.items()}
    PLANS.write(path, [GapRow(**made)] * 2)


def _window() -> ObstacleMap:
    return ObstacleMap(ObstacleMapOptions(dims=[10, 10, 5]))


def _map(path: Path) -> None:
    known = _window()
    known.insert((0.0, 0.0, 0.0), np.array([[5.0, 5.0, 5.0], [9.0, -3.0, 1.0]]))
    known.save(path)


def _load_map(path: Path) -> None:
    _window().load(path)


def _geotiff(path: Path) -> None:
    import rasterio

    profile = {"driver": "GTiff", "width": 6, "height": 5, "count": 1, "dtype": "float32"}
    place = {"crs": "EPSG:32618", "transform": rasterio.Affine(2.0, 0.0, 1e5, 0.0, -2.0, 4.5e6)}
    with rasterio.open(path, "w", **profile, **place, compress="deflate") as dataset:
        dataset.write(np.arange(30, dtype=np.float32).reshape(5, 6), 1)


def _read_geotiff(path: Path) -> object:
    from ltp.world.importers import geotiff

    return geotiff.read(dsm=path, dem=path)


def _las(path: Path) -> None:
    import laspy
    import pyproj

    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales, header.offsets = [0.001] * 3, [292000.0, 6832000.0, 0.0]
    header.add_crs(pyproj.CRS("EPSG:2154"))
    cloud = laspy.LasData(header)
    east, north = (axis.ravel() for axis in np.mgrid[0.5:6.0, 0.5:6.0])
    cloud.x, cloud.y, cloud.z = 292000.0 + east, 6832000.0 + north, 40.0 + 0.1 * east
    cloud.classification = np.full(len(east), 2, np.uint8)
    cloud.write(path)


def _read_las(path: Path) -> object:
    from ltp.world.importers import las

    return las.read(path, cell=2.0)


_MAP = """<?xml version="1.0" encoding="UTF-8"?>
<osm version="0.6" generator="hand">
 <node id="1" lat="48.7500" lon="9.0000"/><node id="2" lat="48.7500" lon="9.0003"/>
 <node id="3" lat="48.7502" lon="9.0003"/><node id="4" lat="48.7502" lon="9.0000"/>
 <node id="5" lat="48.7501" lon="9.0001"><tag k="natural" v="tree"/><tag k="height" v="7 m"/></node>
 <way id="1"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="4"/><nd ref="1"/>
  <tag k="building" v="yes"/><tag k="height" v="12.5"/></way>
 <way id="2"><nd ref="1"/><nd ref="3"/><tag k="highway" v="footway"/></way>
 <relation id="1"><member type="way" ref="1" role="outer"/>
  <tag k="type" v="multipolygon"/><tag k="landuse" v="grass"/></relation>
</osm>
"""


def _osm(path: Path) -> None:
    path.write_text(_MAP)


def _pbf(path: Path) -> None:
    import osmium

    source = path.with_name("source.osm")
    source.write_text(_MAP)
    with osmium.SimpleWriter(str(path)) as writer:
        for item in osmium.FileProcessor(str(source)):
            writer.add(item)


def _read_osm(path: Path) -> object:
    from ltp.world.importers import osm

    return osm.read(path, bounds=(499990.0, 5399550.0, 500030.0, 5399590.0), crs="EPSG:32632")


READERS = (
    Reader("world.npz", World.load, _world),
    Reader("flight.npz", FlightRecord.load, lambda path: record([event(1)]).save(path)),
    Reader("queries.npz", QuerySet.load, _queries),
    Reader("priority.npz", _read_priority, _priority),
    Reader(
        "tree.bt",
        OctreeSurface,
        lambda path: path.write_bytes(
            b"# Octomap OcTree binary file\nid OcTree\nsize 17\nres 0.5\ndata\n"
            + b"\3\0" * 15 + b"\2\0"
        ),
    ),
    Reader("map.bt", _load_map, _map),
    Reader("map.ot", _load_map, _map),
    Reader("mission.toml", MissionConfig.load, lambda path: MissionConfig().save(path)),
    Reader(
        "path.csv", read_waypoints, lambda path: path.write_text("# x,y,z\n0,0,50\n30,4.5,50\n")
    ),
    Reader("journal.jsonl", _read_journal, _journal),
    Reader("flights.csv", read_rows, lambda path: write_rows(path, [row(), row(key="k1")])),
    Reader("gaps.csv", read_gaps, _gaps),
    Reader("regret.csv", read_regrets, lambda path: REGRETS.write(path, [regret_row()])),
    Reader("city.tif", _read_geotiff, _geotiff, ("rasterio", "scipy")),
    Reader("city.las", _read_las, _las, ("laspy", "pyproj", "scipy")),
    Reader("city.laz", _read_las, _las, ("laspy", "lazrs", "pyproj", "scipy")),
    Reader("city.osm", _read_osm, _osm, ("osmium", "pyproj", "rasterio", "shapely")),
    Reader("city.osm.pbf", _read_osm, _pbf, ("osmium", "pyproj", "rasterio", "shapely")),
)  # fmt: skip
