"""The expressions of avatars: presets and customs of VRM 1.0, groups of VRM 0.x, as sums of their morph targets."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeVar

import msgspec

from omote.arrays import Values
from omote.interchange.formats.gltf_document import Document
from omote.interchange.formats.gltf_scene import MOST_TARGETS
from omote.interchange.scans.scan_parts import refuse_many

T = TypeVar("T")
FULL = 100.0
"""A weight of 1 in VRM 0.x."""
_LONGEST = 80


class TargetBind(msgspec.Struct, frozen=True):
    """A target and its weight: of a node's mesh in 1.0, of a mesh in 0.x."""

    index: int
    weight: float = 1.0
    node: int = -1
    mesh: int = -1


@dataclass(frozen=True)
class VrmExpressions:
    """binds: by node and by the name of an expression, targets and their weights; alone: targets (node, index) that are
    the whole of an expression at their node, and so have its name; notes: sentences about what is called otherwise or
    left out."""

    binds: Mapping[int, Mapping[str, Sequence[tuple[int, float]]]] = field(default_factory=dict)
    alone: frozenset[tuple[int, int]] = frozenset()
    notes: tuple[str, ...] = field(default=(), compare=False)

    def rename(self, node: int, names: Sequence[str], moves: Mapping[str, Values], /) -> dict[str, Values]:
        """What the targets of a node's mesh, by name, and its expressions do: the expressions under their own names,
        and the targets that none of them is the whole of.

        node: its number; names: of its targets; moves (n, 3): by those names, metres.
        """
        bare = {names[index] for at, index in self.alone if at == node and index < len(names)}
        result = {name: move for name, move in moves.items() if name not in bare}
        for expression, binds in self.binds.get(node, {}).items():
            if expression in result:  # a target of this name is not what the expression does
                result[_numbered(expression, {*result, *self.binds[node]})] = result.pop(expression)
            summed = [weight * moves[names[at]] for at, weight in binds if at < len(names) and names[at] in moves]
            if summed:
                result[expression] = sum(summed[1:], summed[0])
        return result


def read_vrm_expressions(document: Document, /) -> VrmExpressions:
    """The expressions that a document's extension declares; what it declares wrongly is left out, the second of two of
    one name is numbered."""
    binds_of: dict[int, dict[str, list[tuple[int, float]]]] = {}
    alone = set[tuple[int, int]]()
    notes = list[str]()
    named = [*_of_version_1(document), *_of_version_0(document)]
    refuse_many(len(named), "expressions of an avatar", MOST_TARGETS)
    taken = set[str]()
    for given, binds in named:
        name = _numbered(given, taken | {other for other, _ in named}) if given in taken else given
        if not _is_name(given):
            notes.append(f"its expression {given[:_LONGEST]!r} is left out: its name is none that people can read")
            continue
        if name != given:
            notes.append(f"two of its expressions are named {given!r}: the second is read as {name!r}")
        taken.add(name)
        bound = [(node, bind) for bind in binds for node in _nodes(document, bind)]
        if all(bind.weight == 1.0 for bind in binds) and len({node for node, _ in bound}) == len(bound):
            alone |= {(node, bind.index) for node, bind in bound}
        for node, bind in bound:
            binds_of.setdefault(node, {}).setdefault(name, []).append((bind.index, bind.weight))
    return VrmExpressions(binds_of, frozenset(alone), tuple(notes))


def _numbered(name: str, taken: Collection[str]) -> str:
    """A name with the first number that makes it another one than those that are taken."""
    number = 2
    while f"{name} {number}" in taken:
        number += 1
    return f"{name} {number}"


def _of_version_1(document: Document) -> Iterator[tuple[str, list[TargetBind]]]:
    expressions = _read(_read(document.extensions, "VRMC_vrm", dict), "expressions", dict)
    for kind in ("preset", "custom"):
        for name, expression in _read(expressions, kind, dict).items():
            binds = _binds(_read(expression, "morphTargetBinds", list), 1.0)
            if binds:
                yield name, binds


def _of_version_0(document: Document) -> Iterator[tuple[str, list[TargetBind]]]:
    master = _read(_read(document.extensions, "VRM", dict), "blendShapeMaster", dict)
    for group in _read(master, "blendShapeGroups", list):
        preset = _read(group, "presetName", str)
        own = _read(group, "name", str)
        name = own if preset.lower() in ("", "unknown") else preset
        binds = _binds(_read(group, "binds", list), FULL)
        if binds:
            yield name, binds


def _binds(entries: list[Any], full: float) -> list[TargetBind]:
    """The binds that can be read, their weights from 0 to 1."""
    binds = []
    for entry in entries[:MOST_TARGETS]:
        try:
            bind = msgspec.convert(entry, TargetBind)
        except msgspec.ValidationError:
            continue
        share = min(bind.weight / full, 1.0)
        if bind.index >= 0 and share > 0.0:
            binds.append(msgspec.structs.replace(bind, weight=share))
    return binds


def _nodes(document: Document, bind: TargetBind) -> list[int]:
    """The nodes that show what is bound."""
    if bind.node >= 0:
        return [bind.node]
    return [at for at, node in enumerate(document.nodes) if bind.mesh >= 0 and node.mesh == bind.mesh]


def _is_name(name: str) -> bool:
    return bool(name.strip()) and name.isprintable() and len(name) <= _LONGEST


def _read(values: object, key: str, kind: type[T]) -> T:
    """What stands under a key, where that is of its kind; else an empty one."""
    read = values.get(key) if isinstance(values, dict) else None
    return read if isinstance(read, kind) else kind()
