"""The expressions of avatars: presets and customs of VRM 1.0, groups of VRM 0.x, as sums of their morph targets."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import msgspec

from omote.interchange.formats.glb_reader import MOST_TARGETS
from omote.interchange.formats.gltf_accessors import Values
from omote.interchange.formats.gltf_document import Document
from omote.interchange.scans.scan_parts import refuse_many

FULL = 100.0
"""A weight of 1 in VRM 0.x."""
_LONGEST = 80


class Bind(msgspec.Struct, frozen=True):
    """A target and its weight: of a node's mesh in 1.0, of a mesh in 0.x."""

    index: int
    weight: float = 1.0
    node: int = -1
    mesh: int = -1


@dataclass(frozen=True)
class VrmExpressions:
    """binds: by node and by the name of an expression, targets and their weights; alone: targets (node, index) that are
    the whole of an expression at their node, and so have its name."""

    binds: Mapping[int, Mapping[str, Sequence[tuple[int, float]]]] = field(default_factory=dict)
    alone: frozenset[tuple[int, int]] = frozenset()

    def rename(self, node: int, names: Sequence[str], moves: Mapping[str, Values], /) -> dict[str, Values]:
        """What the targets of a node's mesh, by name, and its expressions do: the expressions under their own names,
        and the targets that none of them is the whole of."""
        bare = {names[index] for at, index in self.alone if at == node and index < len(names)}
        result = {name: move for name, move in moves.items() if name not in bare}
        for expression, binds in self.binds.get(node, {}).items():
            summed = [weight * moves[names[at]] for at, weight in binds if at < len(names) and names[at] in moves]
            if summed:
                result[expression] = sum(summed[1:], summed[0])
        return result


def read_vrm_expressions(document: Document, /) -> VrmExpressions:
    """The expressions that a document's extension declares; what it declares wrongly is left out."""
    found: dict[int, dict[str, list[tuple[int, float]]]] = {}
    alone = set[tuple[int, int]]()
    named = [*_of_version_1(document), *_of_version_0(document)]
    refuse_many(len(named), "expressions of an avatar", MOST_TARGETS)
    for name, binds in named:
        bound = [(node, bind) for bind in binds for node in _nodes(document, bind)]
        if all(bind.weight == 1.0 for bind in binds) and len({node for node, _ in bound}) == len(bound):
            alone |= {(node, bind.index) for node, bind in bound}
        for node, bind in bound:
            found.setdefault(node, {}).setdefault(name, []).append((bind.index, bind.weight))
    return VrmExpressions(found, frozenset(alone))


def _of_version_1(document: Document) -> Iterator[tuple[str, list[Bind]]]:
    expressions = _entry(_entry(document.extensions, "VRMC_vrm"), "expressions")
    for kind in ("preset", "custom"):
        for name, expression in _entry(expressions, kind).items():
            binds = _binds(_items(expression, "morphTargetBinds"), 1.0)
            if binds and _is_name(name):
                yield name, binds


def _of_version_0(document: Document) -> Iterator[tuple[str, list[Bind]]]:
    master = _entry(_entry(document.extensions, "VRM"), "blendShapeMaster")
    for group in _items(master, "blendShapeGroups"):
        preset, own = _text(group, "presetName"), _text(group, "name")
        name = own if preset.lower() in ("", "unknown") else preset
        binds = _binds(_items(group, "binds"), FULL)
        if binds and _is_name(name):
            yield name, binds


def _binds(given: list[Any], full: float) -> list[Bind]:
    """The binds that can be read, their weights from 0 to 1."""
    found = []
    for each in given[:MOST_TARGETS]:
        try:
            bind = msgspec.convert(each, Bind)
        except msgspec.ValidationError:
            continue
        share = min(bind.weight / full, 1.0)
        if bind.index >= 0 and share > 0.0:
            found.append(msgspec.structs.replace(bind, weight=share))
    return found


def _nodes(document: Document, bind: Bind) -> list[int]:
    """The nodes that show what is bound."""
    if bind.node >= 0:
        return [bind.node]
    return [at for at, node in enumerate(document.nodes) if bind.mesh >= 0 and node.mesh == bind.mesh]


def _is_name(name: str) -> bool:
    return bool(name.strip()) and name.isprintable() and len(name) <= _LONGEST


def _entry(values: object, key: str) -> dict[str, Any]:
    found = values.get(key) if isinstance(values, dict) else None
    return found if isinstance(found, dict) else {}


def _items(values: object, key: str) -> list[Any]:
    found = values.get(key) if isinstance(values, dict) else None
    return found if isinstance(found, list) else []


def _text(values: object, key: str) -> str:
    found = values.get(key) if isinstance(values, dict) else None
    return found if isinstance(found, str) else ""
