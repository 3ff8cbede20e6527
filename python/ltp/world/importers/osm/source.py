# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The objects of an OpenStreetMap file as they stand last, in whatever order they come."""

import mmap
import re
from array import array
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from xml.parsers import expat

import numpy as np
from numpy.typing import NDArray

from ..optional import require
from .pbf import check_frames

Box = tuple[float, float, float, float]
_SUFFIXES = (".osm", ".pbf")
_UNIT = 1e7  # of osmium's whole-number coordinates [1/degree]
_NOWHERE = 2**31 - 1  # a coordinate that is not known
_CHUNK = 100_000  # references looked up at a time
_RELATIONS = frozenset({"multipolygon", "building"})
_LAST_WORDS = 4096  # bytes at the end of an answer in which the server says why it broke off
_PURPOSE = "reading OpenStreetMap files"


@dataclass(frozen=True)
class Node:
    """A tagged point."""

    number: int
    tags: dict[str, str]
    place: NDArray[np.int64]  # (2,) longitude and latitude [1e-7 degrees]


@dataclass(frozen=True)
class Way:
    """A line of nodes."""

    number: int
    tags: dict[str, str]
    places: NDArray[np.int64]  # (n, 2) of the nodes that the file holds [1e-7 degrees]
    breaks: tuple[int, ...]  # before which of them others are missing

    @property
    def lacks_nodes(self) -> bool:
        """Whether the file lacks some of its nodes."""
        return bool(self.breaks)


@dataclass(frozen=True)
class Relation:
    """A multipolygon or a building in pieces."""

    number: int
    tags: dict[str, str]
    members: tuple[tuple[str, int, str], ...]  # "n", "w" or "r", number, role


@dataclass
class Source:
    """What a file holds near a box; member ways of relations from anywhere."""

    nodes: dict[int, Node] = field(default_factory=dict)
    ways: dict[int, Way] = field(default_factory=dict)
    relations: dict[int, Relation] = field(default_factory=dict)
    near: set[int] = field(default_factory=set)  # the ways that come near the box
    extent: Box | None = None  # where the file's ways lie
    deleted: int = 0  # objects that the file says are deleted
    repeated: int = 0  # older versions of objects, and repetitions
    empty: int = 0  # ways without two nodes that the file holds


def read_source(path: Path, near: Box) -> Source:
    """Read what lies within `near` (lon_min, lat_min, lon_max, lat_max).

    Of an object that comes in several versions the newest counts. Deleted objects (visible=false,
    and action=delete in files of the editor JOSM) are left out.

    Raises:
        ImportError: if osmium is not installed.
        OSError: if the file cannot be opened.
        ValueError: naming the file, if it cannot be read to its end.
    """
    osmium = require("osmium", _PURPOSE)
    if not path.is_file():  # also keeps osmium from taking the name for a URL
        raise FileNotFoundError(f"{path} is not a file")
    if path.suffix not in _SUFFIXES:
        raise ValueError(f"{path} must end in .osm or .osm.pbf")
    with path.open("rb"):
        pass  # a file that may not be read is told as such
    try:
        if path.suffix == ".pbf":
            check_frames(path)
        else:
            _check_answer(path)
        reading = _Reading(osmium, path, near)
        reading.relations()
        reading.nodes()
        reading.ways()
        return reading.source
    except Exception as error:  # osmium's own errors share no better base
        raise ValueError(f"{path} cannot be read as an OpenStreetMap file: {error}") from error


class _Reading:
    """One file while it is read, in three passes, so that the order within it does not matter."""

    def __init__(self, osmium: Any, path: Path, near: Box) -> None:
        self.osmium = osmium
        self.path = path
        self.low = np.floor(np.array(near[:2]) * _UNIT).astype(np.int64)
        self.high = np.ceil(np.array(near[2:]) * _UNIT).astype(np.int64)
        self.source = Source()
        self.struck = _struck_out(path) if path.suffix == ".osm" else set()
        self.removed: dict[str, set[int]] = {"w": set(), "r": set()}

    def relations(self) -> None:
        """Multipolygons and buildings, wherever they lie."""
        found = self.source.relations
        for item in self._newest("r", self.osmium.osm.RELATION):
            found.pop(item.id, None)
            tags = {} if self._gone("r", item) else _tags(item)
            if tags.get("type") in _RELATIONS:
                members = tuple((m.type, m.ref, m.role) for m in item.members)
                found[item.id] = Relation(item.id, tags, members)

    def nodes(self) -> None:
        """Where all nodes lie, and the tagged ones near the box."""
        numbers, versions, lon, lat = array("q"), array("q"), array("q"), array("q")
        tagged: dict[int, dict[str, str]] = {}
        gone: list[int] = []
        for index, item in enumerate(self._read(self.osmium.osm.NODE)):
            place, number = item.location, item.id
            numbers.append(number)
            versions.append(item.version)
            deleted = item.deleted or (self.struck and ("n", number) in self.struck)
            if deleted:
                gone.append(index)
            known = not deleted and place.valid()
            lon.append(place.x if known else _NOWHERE)
            lat.append(place.y if known else _NOWHERE)
            if known and len(item.tags):
                tagged[index] = _tags(item)
        order = np.lexsort((np.array(versions), np.array(numbers)))
        ids = np.array(numbers)[order]
        last = order[np.append(ids[1:] != ids[:-1], True)] if len(ids) else order
        self.numbers = np.array(numbers)[last]
        self.places = np.column_stack([np.array(lon), np.array(lat)])[last].astype(np.int64)
        self.source.repeated += len(ids) - len(last)
        self.source.deleted += len(np.intersect1d(last, gone))
        for row, index in enumerate(last.tolist()):
            if index in tagged and self._within(self.places[row], self.places[row]):
                number = int(self.numbers[row])
                self.source.nodes[number] = Node(number, tagged[index], self.places[row])

    def ways(self) -> None:
        """The ways near the box, and members of relations, with the places of their nodes."""
        relations = self.source.relations.values()
        members = {ref for r in relations for kind, ref, _ in r.members if kind == "w"}
        low, high = np.full(2, _NOWHERE), np.full(2, -_NOWHERE)
        for number, tags, places, breaks in self._placed_ways():
            self.source.ways.pop(number, None)
            self.source.near.discard(number)
            if tags is None:
                continue
            if len(places) == 0:
                self.source.empty += bool(tags)
                continue
            first, last = places.min(axis=0), places.max(axis=0)
            low, high = np.minimum(low, first), np.maximum(high, last)
            if within := self._within(first, last):
                self.source.near.add(number)
            if within or number in members:
                self.source.ways[number] = Way(number, tags, places, breaks)
        if (low <= high).all():
            x0, y0, x1, y1 = (float(value) / _UNIT for value in (*low, *high))
            self.source.extent = x0, y0, x1, y1

    def _placed_ways(self) -> Iterator[tuple[int, dict[str, str] | None, Any, tuple[int, ...]]]:
        """Number, tags (None: deleted), places and gaps of each way; looked up many at a time."""
        waiting: list[tuple[int, dict[str, str] | None, int]] = []
        refs = array("q")
        for item in self._newest("w", self.osmium.osm.WAY):
            gone = self._gone("w", item)
            before = len(refs)
            if not gone:
                refs.extend(node.ref for node in item.nodes)
            waiting.append((item.id, None if gone else _tags(item), len(refs) - before))
            if len(refs) > _CHUNK:
                yield from self._placed(waiting, refs)
                waiting, refs = [], array("q")
        yield from self._placed(waiting, refs)

    def _placed(
        self, waiting: list[tuple[int, dict[str, str] | None, int]], refs: "array[int]"
    ) -> Iterator[tuple[int, dict[str, str] | None, Any, tuple[int, ...]]]:
        wanted = np.array(refs, dtype=np.int64)
        rows = np.searchsorted(self.numbers, wanted)
        places = np.full((len(wanted), 2), _NOWHERE, dtype=np.int64)
        if len(self.numbers):
            rows = np.minimum(rows, len(self.numbers) - 1)
            hit = self.numbers[rows] == wanted
            places[hit] = self.places[rows[hit]]
        known = places[:, 0] != _NOWHERE
        start = 0
        for number, tags, length in waiting:
            mine, there = places[start : start + length], known[start : start + length]
            start += length
            gaps = np.diff(np.flatnonzero(there), prepend=-1, append=length) > 1
            yield number, tags, mine[there], tuple(np.flatnonzero(gaps).tolist())

    def _within(self, first: Any, last: Any) -> bool:
        return bool((last >= self.low).all() and (first <= self.high).all())

    def _newest(self, kind: str, entity: Any) -> Iterator[Any]:
        """Objects of that kind that are not older than one of the same number before them."""
        versions: dict[int, int] = {}
        for item in self._read(entity):
            before = versions.get(item.id)
            self.source.repeated += before is not None
            if before is None or item.version >= before:
                versions[item.id] = item.version
                yield item
        self.source.deleted += len(self.removed[kind])

    def _gone(self, kind: str, item: Any) -> bool:
        gone = item.deleted or (kind, item.id) in self.struck
        (self.removed[kind].add if gone else self.removed[kind].discard)(item.id)
        return gone

    def _read(self, entity: Any) -> Iterator[Any]:
        yield from self.osmium.FileProcessor(str(self.path.resolve()), entity)


def _tags(item: Any) -> dict[str, str]:
    return {tag.k: tag.v for tag in item.tags}


def _check_answer(path: Path) -> None:
    """Refuse what an Overpass server sent before it ran out of time or memory.

    Raises:
        ValueError: with what the server says.
    """
    with path.open("rb") as file:
        file.seek(max(path.stat().st_size - _LAST_WORDS, 0))
        found = re.search(rb"<remark>\s*(runtime error[^<]*)", file.read())
    if found is not None:
        text = found.group(1).decode("utf-8", "replace").strip()
        raise ValueError(f"the server broke off its answer: {text}")


def _struck_out(path: Path) -> set[tuple[str, int]]:
    """The objects that the editor JOSM has marked action="delete", which osmium does not tell."""
    struck: set[tuple[str, int]] = set()
    if path.stat().st_size == 0:
        return struck
    with (
        path.open("rb") as file,
        mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as text,
    ):
        if re.search(rb"action\s*=\s*[\"']\s*delete", text) is None:
            return struck
        parser = expat.ParserCreate()
        kinds = {"node": "n", "way": "w", "relation": "r"}

        def start(name: str, attributes: dict[str, str]) -> None:
            if name in kinds and attributes.get("action") == "delete":
                struck.add((kinds[name], int(attributes["id"])))

        def entity(*_: Any) -> None:
            raise ValueError("it declares entities")

        parser.StartElementHandler = start
        parser.EntityDeclHandler = entity
        parser.ParseFile(file)
    return struck
