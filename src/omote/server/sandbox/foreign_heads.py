"""Takes expressions from the blendshapes of heads of any topology, in a child process; what comes back is validated."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import msgspec
import numpy as np

from omote.builtin import load_meshes
from omote.builtin.own_face import fit
from omote.edit.store.import_items import ImportedItem
from omote.inputs.shape_names import ShapeMeaning, read_shape_name
from omote.interchange.formats.glb_reader import Piece
from omote.interchange.mesh_correspondence import match_head
from omote.model.cast import Cast
from omote.model.extraction.extracted_expression import describe_uncertainty
from omote.model.fitting.foreign.take_expressions import take_expressions
from omote.model.fitting.scan import Scan
from omote.model.space.expression import Expression
from omote.model.transfer.paper_map import refuse_foreign
from omote.server.sandbox.child_task import Tell, run_limited
from omote.server.sandbox.scan_files import read_scan_in_sandbox
from omote.server.sandbox.scan_fits import LIMITS
from omote.showfile.contents import ContentError, pack_expression, unpack_expression

_TOO_MUCH = "fitting a face to it needs more time or memory than any head; export the head alone, with its shapes"

STILL = 1e-6
"""Radians; eyeballs that turn less are at rest."""


class _PlainTaken(msgspec.Struct, frozen=True, array_like=True):
    expressions: dict[str, tuple[bytes, str]]
    notes: list[str]


def is_foreign(cast: Cast, pieces: Sequence[Piece], /) -> bool:
    """Whether a file's pieces bring shapes of a head that has not the cast's topology."""
    if not any(piece.moves for piece in pieces):
        return False
    try:
        match_head(cast, load_meshes(), pieces)
    except ValueError:
        return True
    return False


def foreign_expressions(cast: Cast, path: Path, /) -> Iterator[tuple[ImportedItem, str]]:
    """Yields each expression of a stranger's head with a report about it; ValueError where there is none.

    A shape whose name is known (`shape_names`) is tagged with the cast's units that do the same; it takes no unit's
    place, for all other faces and trackers play those.
    """
    scan = read_scan_in_sandbox(path).scan
    if not scan.shapes:
        raise ValueError(f"{path.name}: the head has no shapes that can be read; export it with its morph targets")
    try:
        found = _take_in_child(cast, scan, path.stem)
    except ValueError as error:
        raise ValueError(f"{path.name}: {error}") from error
    notes = " ".join(found.notes)
    if not found.expressions:
        raise ValueError(f"{path.name}: no shape is an expression. {notes}")
    for number, (name, (packed, doubt)) in enumerate(found.expressions.items()):
        meaning = read_shape_name(name)
        made = _with_gaze(cast, meaning, _unpack(cast, packed))
        told = f"{name}, taken from the head in {path.name}"
        told += f", as {' and '.join(meaning.units) or meaning.named}" if meaning.part else ""
        told += f"; {doubt}" if doubt else ""
        told += f". {notes}" if notes and number == len(found.expressions) - 1 else ""
        yield ImportedItem(name, made, tags=meaning.tags, note=f"from {path.name}"[:200]), told


def _take_in_child(cast: Cast, scan: Scan, name: str) -> _PlainTaken:
    def work(_: Tell) -> bytes:
        fitted = fit(cast.space, scan.positions, scan.triangles, colours=scan.colours, name=name[:80])
        taken = take_expressions(cast.space, fitted, scan)
        packed = {
            name: (pack_expression(each), describe_uncertainty(cast.space, each))
            for name, each in taken.expressions.items()
        }
        return msgspec.msgpack.encode(_PlainTaken(packed, [*fitted.doubts, *taken.notes]))

    try:
        answer = run_limited(work, LIMITS, exhausted=_TOO_MUCH)
        return msgspec.msgpack.decode(answer, type=_PlainTaken)
    except msgspec.MsgspecError as error:
        raise ValueError(_TOO_MUCH) from error


def _unpack(cast: Cast, packed: bytes) -> Expression:
    try:
        made = unpack_expression(packed)
    except ContentError as error:
        raise ValueError(_TOO_MUCH) from error
    refuse_foreign(cast.space, made)
    return made


def _with_gaze(cast: Cast, meaning: ShapeMeaning, made: Expression) -> Expression:
    """The expression; where it is a look and the head's own eyeballs stay, for bones turn them, with the turn of the
    cast's."""
    if not meaning.is_gaze or abs(made.eyes).max() > STILL:
        return made
    turns = [cast.expressions[unit].eyes for unit in meaning.units if unit in cast.expressions]
    return replace(made, eyes=np.sum(turns, axis=0)) if turns else made
