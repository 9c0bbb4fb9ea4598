"""Exports expressions on a face as numbers: what each moves, vertex by vertex (NPZ for NumPy, CSV for everything)."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from omote.interchange.export_face import NOTICE, REST, SKIN, Meshes
from omote.interchange.formats.file_names import NUMBERS
from omote.model.action_units import action_units
from omote.model.cast import Cast
from omote.model.space.face_fit import fit

COLUMNS = ("expression", "facs", "mesh", "vertex", "x", "y", "z", "dx", "dy", "dz")


@dataclass(frozen=True, eq=False)
class Deltas:
    """Expressions on a face: what each adds to the face at rest, metres.

    rest: the vertices of skin and parts, (n, 3); moves: by mesh, (expressions, n, 3); triangles: by mesh, (f, 3).
    """

    face: str
    digest: str
    expressions: Sequence[str]
    labels: Sequence[str]
    rest: dict[str, NDArray[np.float32]]
    moves: dict[str, NDArray[np.float32]]
    triangles: dict[str, NDArray[np.int32]]

    @property
    def facs(self) -> list[str]:
        """The nearest action units of each expression, "L1+L2"."""
        return ["+".join(action_units(name)) for name in self.expressions]


def measure_deltas(cast: Cast, face: str, poses: Iterable[tuple[str, Meshes]], /) -> Deltas:
    """What expressions move on a face of the cast; poses: `named_compound_meshes` of each, by its name."""
    posed = dict(poses)
    fitted = fit(cast.space, cast.faces[face])
    rest = {SKIN: fitted.positions, **fitted.parts}
    moves = {
        mesh: np.array([meshes[mesh] - points for meshes in posed.values()], np.float32).reshape(-1, *points.shape)
        for mesh, points in rest.items()
    }
    for moved in moves.values():
        moved[np.abs(moved).max(axis=2) < REST] = 0.0
    triangles = {SKIN: cast.space.triangles, **{name: part.triangles for name, part in cast.space.parts.items()}}
    return Deltas(
        face, cast.digest, [*posed], [cast.titles[name].label for name in posed],
        {mesh: np.asarray(points, np.float32) for mesh, points in rest.items()}, moves, triangles,
    )  # fmt: skip


def encode_deltas(deltas: Deltas, path: Path, /) -> bytes:
    """The file for a path's ending, .npz or .csv; ValueError for another.

    deltas: what expressions move; path: for its ending alone.
    """
    if path.suffix.lower() not in NUMBERS:
        raise ValueError(f"{path.name!r} is no name of a table of deltas; end it with {' or '.join(NUMBERS)}")
    return _npz(deltas) if path.suffix.lower() == ".npz" else _csv(deltas)


def _npz(deltas: Deltas) -> bytes:
    """Arrays by name; those of the skin without a prefix, of a part as `teeth_upper/deltas`."""
    arrays: dict[str, NDArray[np.generic]] = {
        "face": np.array(deltas.face), "cast": np.array(deltas.digest), "notice": np.array(NOTICE),
        "expressions": np.array(deltas.expressions, str), "labels": np.array(deltas.labels, str),
        "facs": np.array(deltas.facs, str),
    }  # fmt: skip
    for mesh, rest in deltas.rest.items():
        place = "" if mesh == SKIN else f"{mesh}/"
        arrays |= {f"{place}rest": rest, f"{place}deltas": deltas.moves[mesh]}
        arrays[f"{place}triangles"] = deltas.triangles[mesh]
    file = io.BytesIO()
    np.savez_compressed(file, allow_pickle=False, **arrays)
    return file.getvalue()


def _csv(deltas: Deltas) -> bytes:
    """A line for each vertex that an expression moves, metres: where it is at rest, and what is added."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(COLUMNS)
    for number, (name, facs) in enumerate(zip(deltas.expressions, deltas.facs, strict=True)):
        for mesh, rest in deltas.rest.items():
            moves = deltas.moves[mesh][number]
            for row in np.flatnonzero(moves.any(axis=1)):
                values = (f"{value:.9g}" for value in (*rest[row].tolist(), *moves[row].tolist()))
                table.writerow([name, facs, mesh, row, *values])
    return text.getvalue().encode()
