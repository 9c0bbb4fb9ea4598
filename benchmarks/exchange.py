"""Faces as GLB files: every face of the cast with its 52 ARKit blendshapes, validated, read again, imported again.

validator: errors and warnings. three: how many targets three.js finds by name on every mesh. read: how far what is read
lies from our compounds. taken: how far the same face, wearing what was taken in from the file, lies from them. strange:
the same where the file does not tell the targets' names, so that all is measured by the paper's extraction; only for
STRANGERS and HARD shapes, since a shape takes seconds. time: export against numpy's own writing of the same arrays.
"""

from __future__ import annotations

import io
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.progress import track
from rich.table import Table

from omote.builtin import load_cast, load_mask, load_meshes
from omote.interchange.export_face import (
    ExportContext,
    Meshes,
    build_scene,
    choose_expressions,
    compound_meshes,
    named_compound_meshes,
)
from omote.interchange.formats.glb_reader import Piece, read_glb
from omote.interchange.formats.glb_writer import glb_bytes
from omote.interchange.import_meshes import import_expressions
from omote.model.cast import Cast
from tools.gltf import inspect

BAR = 0.05
"""Millimetres that a face may lie from its compound when it comes back."""
STRANGERS = ("generic", "kaori", "dog")
HARD = ("eyeBlinkRight", "jawOpen", "mouthClose", "mouthFunnel", "mouthSmileLeft", "tongueOut")


@dataclass
class Found:
    """What one face's file is like: bytes, seconds of export and of numpy, the worst distances, millimetres."""

    size: int
    seconds: float
    peer: float
    read: float
    back: float
    strange: float


def numpy_save(scene_bytes: bytes, pieces: Sequence[Piece]) -> float:
    """Seconds in which numpy writes the arrays of a file."""
    arrays = [moved for piece in pieces for moved in piece.moves.values()]
    begun = time.perf_counter()
    np.savez(io.BytesIO(), np.frombuffer(scene_bytes, np.uint8), *arrays)
    return time.perf_counter() - begun


def worst(one: Meshes, other: Meshes) -> float:
    """Millimetres between the same vertices, the largest."""
    return 1000 * max(float(np.abs(one[name] - other[name]).max()) for name in one)


def came_back(cast: Cast, face: str, pieces: Sequence[Piece], compounds: dict[str, Meshes], *, strange: bool) -> float:
    """Millimetres by which the face, wearing what was taken in, is not where its compounds are."""
    if strange:
        kept = [{f"strange {name}": piece.moves[name] for name in HARD if piece.moves} for piece in pieces]
        pieces = [replace(piece, moves=moves) for piece, moves in zip(pieces, kept, strict=True)]
    found = import_expressions(cast, load_meshes(), {face: pieces})
    space = cast.space
    return max(
        worst(compound_meshes(space, cast.faces[face], each.expression), compounds[each.label.removeprefix("strange ")])
        for each in found
    )


def measure(context: ExportContext, face: str, folder: Path) -> Found:
    """Exports one face, reads it and takes it in."""
    cast = context.cast
    names = choose_expressions(context.cast, "arkit")
    compounds = {name: named_compound_meshes(cast, face, name) for name in names}
    begun = time.perf_counter()
    data = glb_bytes(build_scene(context, face, compounds.items()))
    seconds = time.perf_counter() - begun
    (folder / f"{face}.glb").write_bytes(data)
    pieces = [piece for piece in read_glb(data) if piece.rows is not None]
    off = [
        float(np.abs(piece.points + moved - compounds[name][piece.name][piece.rows]).max())
        for piece in pieces
        for name, moved in piece.moves.items()
    ]
    back = came_back(cast, face, pieces, compounds, strange=False)
    strange = came_back(cast, face, pieces, compounds, strange=True) if face in STRANGERS else float("nan")
    return Found(len(data), seconds, numpy_save(data, pieces), 1000 * max(off), back, strange)


def main() -> int:
    """Prints the table; 0 when every bar is held."""
    cast = load_cast()
    console = Console(width=120)
    context = ExportContext(cast, load_meshes(), load_mask())
    assert context.canvas.hair.any()  # painted once, for all faces
    shapes = len(choose_expressions(cast, "arkit"))
    table = Table(title=f"GLB of {len(cast.faces)} faces with {shapes} ARKit shapes (errors in mm)")
    for column in ("face", "MB", "errors", "warnings", "three", "read", "taken", "strange", "time / numpy", "held"):
        table.add_column(column, justify="left" if column == "face" else "right")
    held = True
    with tempfile.TemporaryDirectory() as folder:
        found = {face: measure(context, face, Path(folder)) for face in track(cast.faces, "faces", console=console)}
        seen = inspect(Path(folder) / f"{face}.glb" for face in found)
    for (face, each), others in zip(found.items(), seen, strict=True):
        judged = others["validator"]
        named = min(len(mesh["targets"]) for mesh in others["three"]["meshes"].values())
        clean = not judged["errors"] and not judged["warnings"] and named == shapes
        good = clean and max(each.read, each.back) <= BAR
        held &= good
        figures = f"{each.read:.4f}", f"{each.back:.4f}", f"{each.strange:.4f}", f"{each.seconds / each.peer:.1f}"
        said = str(judged["errors"]), str(judged["warnings"]), str(named)
        table.add_row(face, f"{each.size / 1e6:.1f}", *said, *figures, "yes" if good else "NO")
    console.print(table)
    console.print(
        f"bars: no error, no warning, 52 shapes by name, read and taken <= {BAR} mm; strange is told, not judged"
    )
    return 0 if held else 1


if __name__ == "__main__":
    sys.exit(main())
