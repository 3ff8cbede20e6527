# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flights on the Earth: GeoJSON (RFC 7946) and KML 2.2 of paths, dropped waypoints and hits."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any
from xml.etree import ElementTree

import numpy as np
from numpy.typing import ArrayLike

from ltp.world import World

from .record import FlightRecord

KML = "http://www.opengis.net/kml/2.2"


@dataclass(frozen=True)
class _Feature:
    name: str
    points: list[list[float]]  # (n, 3) longitude, latitude [deg], altitude [m]
    facts: dict[str, Any]  # JSON values

    @property
    def is_point(self) -> bool:
        return len(self.points) == 1


def to_geojson(world: World, records: Sequence[FlightRecord]) -> dict[str, Any]:
    """Flights as a GeoJSON FeatureCollection.

    A flown path and a global path are LineStrings; a dropped waypoint and a hit are Points, with
    what was measured of them as properties. Positions are longitude and latitude [deg, WGS 84], and
    the altitude [m] above the world's height datum (not the ellipsoid).

    Args:
        world: that was flown over; its datum says where on the Earth it lies.
        records: of the flights.

    Raises:
        ImportError: if pyproj is not installed.
        ValueError: if the world has no CRS, or a record is of another world.
    """
    return {
        "type": "FeatureCollection",
        "features": [
            {
                "type": "Feature",
                "properties": {"name": feature.name, **feature.facts},
                "geometry": {
                    "type": "Point" if feature.is_point else "LineString",
                    "coordinates": feature.points[0] if feature.is_point else feature.points,
                },
            }
            for feature in _features(world, records)
        ],
    }


def to_kml(world: World, records: Sequence[FlightRecord]) -> str:
    """The same as a KML document, for Google Earth and other globes; altitudes are absolute.

    Args:
        world: that was flown over; its datum says where on the Earth it lies.
        records: of the flights.

    Raises:
        ImportError: if pyproj is not installed.
        ValueError: if the world has no CRS, or a record is of another world.
    """
    root = ElementTree.Element("kml", xmlns=KML)
    document = ElementTree.SubElement(root, "Document")
    ElementTree.SubElement(document, "name").text = world.name
    if world.attribution:
        ElementTree.SubElement(document, "description").text = world.attribution
    for feature in _features(world, records):
        mark = ElementTree.SubElement(document, "Placemark")
        ElementTree.SubElement(mark, "name").text = feature.name
        data = ElementTree.SubElement(mark, "ExtendedData")
        for name, value in feature.facts.items():
            item = ElementTree.SubElement(data, "Data", name=name)
            ElementTree.SubElement(item, "value").text = str(value)
        shape = ElementTree.SubElement(mark, "Point" if feature.is_point else "LineString")
        ElementTree.SubElement(shape, "altitudeMode").text = "absolute"
        text = " ".join(",".join(f"{value:.9f}" for value in point) for point in feature.points)
        ElementTree.SubElement(shape, "coordinates").text = text
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="unicode", xml_declaration=True) + "\n"


def _features(world: World, records: Sequence[FlightRecord]) -> Iterator[_Feature]:
    for record in records:
        if record.world_name != world.name:
            raise ValueError(f"the flight was over {record.world_name}, not over {world.name}")
        planner = record.config.planner
        yield _Feature(
            f"flown with {planner}",
            _on_earth(world, record.positions),
            {
                "kind": "flown path",
                "planner": planner,
                "outcome": record.outcome.value,
                "length": record.length,
                "length_ratio": record.length_ratio,
                "mean_priority": record.mean_priority,
                "duration": record.duration,
                "min_clearance": record.min_clearance,
            },
        )
        yield _Feature("global path", _on_earth(world, record.global_path), {"kind": "global path"})
        for entry in record.waypoints:
            if entry.outcome == "reached":
                continue
            kind = f"{entry.outcome} waypoint"
            facts = {"kind": kind, "reason": entry.reason, "time": entry.time}
            name = f"waypoint {entry.index + 1} {entry.outcome} by {planner}"
            yield _Feature(name, _on_earth(world, [entry.goal]), facts)
        if record.collision is not None:
            facts = {"kind": "hit", "planner": planner, "time": record.duration}
            yield _Feature(f"hit by {planner}", _on_earth(world, [record.collision]), facts)


def _on_earth(world: World, points: ArrayLike) -> list[list[float]]:
    latitude, longitude, altitude = np.transpose(world.to_map(points))
    places = np.column_stack([longitude.round(9), latitude.round(9), altitude.round(3)])
    return [[float(value) for value in place] for place in places]
