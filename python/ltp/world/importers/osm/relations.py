# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What relations say: areas of many ways, tagged here or on the ways, and buildings in pieces."""

from collections.abc import Iterable
from dataclasses import dataclass, field

from .cover import area_cover, is_area
from .source import Relation, Source, Way
from .tags import Tags, building, buried, part

# Keys that say nothing about what an area is.
_ASIDE = frozenset(
    (
        *("type", "source", "source:date", "note", "fixme", "FIXME", "created_by", "attribution"),
        *("description", "comment", "name", "start_date", "wikidata", "wikipedia", "website"),
    )
)


@dataclass(frozen=True)
class Area:
    """An area made of ways."""

    key: str  # "r12"
    tags: dict[str, str]
    ways: tuple[int, ...]  # of its rings, each once; those that the file holds
    missing: int  # ways that the file lacks
    spent: frozenset[int] = frozenset()  # ways that are no area of their own beside it


@dataclass
class Meaning:
    """What the relations of a file come to."""

    areas: list[Area] = field(default_factory=list)
    tags: dict[int, dict[str, str]] = field(default_factory=dict)  # of ways, where they change


def understand(source: Source) -> Meaning:
    """Say which areas the relations make, and what they change about the ways."""
    meaning = Meaning()
    inherited: dict[int, dict[str, str]] = {}
    for relation in source.relations.values():
        if relation.tags["type"] == "building" and not buried(relation.tags):
            _building(source, relation, meaning, inherited)
    for relation in source.relations.values():
        if relation.tags["type"] == "multipolygon":
            given = {**inherited.get(relation.number, {}), **relation.tags}
            _multipolygon(source, relation, given, meaning)
    return meaning


def _multipolygon(source: Source, relation: Relation, given: Tags, meaning: Meaning) -> None:
    """Tags come from the relation; from its outer ways, if it has none (as of old)."""
    rings = _ways(relation)
    outer = _ways(relation, {"outer", ""}) or rings
    tags = dict(given)
    theirs = {ref: _tags_of(source, meaning, ref) for ref in outer if ref in source.ways}
    bare = all(key in _ASIDE for key in tags)
    same: list[int] = []
    for ref, way_tags in theirs.items():
        if is_area(way_tags) if bare and not same else _same_thing(way_tags, tags):
            tags = {**way_tags, **tags}
            same.append(ref)
    spent = {ref for ref in same if _adds_nothing(source.ways[ref], theirs[ref], tags)}
    if not buried(tags):
        meaning.areas.append(_area(source, relation, tags, rings, spent))


def _tags_of(source: Source, meaning: Meaning, ref: int) -> dict[str, str]:
    return meaning.tags.get(ref, source.ways[ref].tags)


def _adds_nothing(way: Way, own: Tags, tags: Tags) -> bool:
    """Whether a way of an area is no area of its own: an arc, or a ring that says the same."""
    return not _closed(way) or all(tags.get(k) == v for k, v in own.items() if k not in _ASIDE)


def _same_thing(one: Tags, other: Tags) -> bool:
    """Whether two sets of tags name the same thing, such as a building."""
    if building(one) or part(one):
        return building(one) == building(other) and part(one) == part(other)
    return area_cover(one) is not None and area_cover(one) == area_cover(other)


def _building(
    source: Source, relation: Relation, meaning: Meaning, inherited: dict[int, dict[str, str]]
) -> None:
    """The relation's tags count for its outline, unless the outline has its own."""
    tags = {key: value for key, value in relation.tags.items() if key != "type"}
    tags.setdefault("building", "yes")
    outline = _ways(relation, {"outline", "outer", ""})
    held = [source.ways[ref] for ref in outline if ref in source.ways]
    if held and all(_closed(way) or way.lacks_nodes for way in held):
        for way in held:
            _give(meaning, way.number, {**tags, **way.tags})
    elif held:
        own = {k: v for way in held if building(way.tags) for k, v in way.tags.items()}
        meaning.areas.append(_area(source, relation, {**tags, **own}, outline, set(outline)))
    for kind, ref, role in relation.members:
        if kind == "r" and role != "part":
            inherited[ref] = tags
        elif role == "part" and kind == "r":
            inherited.setdefault(ref, {"building:part": "yes"})
        elif role == "part" and kind == "w" and ref in source.ways:
            own = source.ways[ref].tags
            if not (building(own) or part(own)):
                _give(meaning, ref, {"building:part": "yes", **own})


def _give(meaning: Meaning, ref: int, tags: dict[str, str]) -> None:
    meaning.tags[ref] = {**meaning.tags.get(ref, {}), **tags}


def _ways(relation: Relation, roles: Iterable[str] | None = None) -> tuple[int, ...]:
    """The member ways with one of these roles, each once; by default with any."""
    wanted = None if roles is None else set(roles)
    members = ((ref, role) for kind, ref, role in relation.members if kind == "w")
    return tuple(dict.fromkeys(ref for ref, role in members if wanted is None or role in wanted))


def _area(
    source: Source,
    relation: Relation,
    tags: dict[str, str],
    refs: tuple[int, ...],
    spent: set[int],
) -> Area:
    held = tuple(ref for ref in refs if ref in source.ways)
    return Area(f"r{relation.number}", tags, held, len(refs) - len(held), frozenset(spent))


def _closed(way: Way) -> bool:
    return len(way.places) > 3 and bool((way.places[0] == way.places[-1]).all())
