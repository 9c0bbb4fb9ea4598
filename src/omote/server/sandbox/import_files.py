"""Imports expressions and faces from files (`file_kinds`), heads of any topology among them, with a report on each.

Untrusted files are parsed in a child process with limits; what it sends back is validated again here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from omote.builtin import load_meshes
from omote.edit.store.import_items import ImportedItem, import_document
from omote.inputs.shape_names import ShapeMeaning, read_shape_name
from omote.interchange.export_face import SKIN
from omote.interchange.formats import expression_json, glb_reader, gltf_document
from omote.interchange.formats.file_kinds import advise, suffixes_of
from omote.interchange.formats.file_names import DOCUMENT, require_imports
from omote.interchange.formats.glb_reader import Piece
from omote.interchange.formats.gltf_scene import Find, Note, note_nothing
from omote.interchange.import_meshes import Follow, ignore_progress, import_expressions, import_face
from omote.interchange.landmark_points import read_landmarks
from omote.interchange.mesh_correspondence import match_head
from omote.interchange.scans.companions import Companions
from omote.interchange.scans.ply_reader import read_ply
from omote.interchange.scans.vrm_expressions import VrmExpressions, read_vrm_expressions
from omote.interchange.scans.wavefront_reader import read_obj_pieces
from omote.model.cast import Cast, Look
from omote.model.space.expression import Expression
from omote.perform.name_lookup import find_name
from omote.server.sandbox.child_task import Limits, Tell, run_limited
from omote.server.sandbox.scan_faces import take_in_child
from omote.server.sandbox.scan_files import find_beside, read_scan_in_sandbox

LIMITS = Limits(seconds=60, patience=900.0, memory=2 * 2**30)
_TOO_MUCH = "reading it needs more time or memory than any face; export a smaller one"
POINTS_HELP = (
    "Say where the head is, with --landmarks as of omote face; or export the head alone, without body and hair, or "
    "take its shapes in Python (omote.fit with landmarks, omote.take_expressions)"
)
PLAIN = (
    "its shape is taken, and its colours, pictures and hair are not: choose a look for it in the editor, or with "
    "--face that of a face of the cast; a show file (omote file export NAME -o NAME.omote) keeps all of a face"
)
STILL = 1e-6
"""Radians; eyeballs that turn less are at rest."""


def _read_avatar(data: bytes, note: Note, find: Find) -> tuple[Piece, ...]:
    def naming(document: gltf_document.Document) -> VrmExpressions:
        named = read_vrm_expressions(document)
        for sentence in named.notes:
            note(sentence)
        return named

    return glb_reader.read_glb(data, naming=naming, find=find, note=note)


def _read_ply_piece(data: bytes, _: Note, __: Find) -> tuple[Piece, ...]:
    return (Piece(SKIN, read_ply(data, Companions()).positions),)


_ONE_SHAPE: Mapping[str, Callable[[bytes, Note, Find], tuple[Piece, ...]]] = {
    ".obj": lambda data, _, __: read_obj_pieces(data),
    ".ply": _read_ply_piece,
}
READERS = {suffix: _ONE_SHAPE.get(suffix, _read_avatar) for suffix in suffixes_of("shape")}
"""Parsers by file name suffix; all others than these hold one shape."""


@dataclass(frozen=True, eq=False)
class HeadFile:
    """The pieces of a file with sentences about what of it is left out."""

    pieces: tuple[Piece, ...]
    notes: tuple[str, ...] = ()


FAR = 5e-5
"""Metres; a larger error of an imported expression against its source shape is reported."""

Brought = tuple[ImportedItem, str]


def expressions_from(
    cast: Cast,
    paths: Sequence[Path],
    *,
    face: str = "",
    landmarks: Sequence[str] = (),
    follow: Follow = ignore_progress,
) -> Iterator[Brought]:
    """Yields each expression in the files (paths) with a report about it.

    cast: what the expressions are for; face: the face of it that shapes start from; landmarks: words and files of them,
    of heads of another topology; follow: told of shapes done, all shapes, and the one that is next.

    ValueError for files without expressions; OSError where one cannot be read.
    """
    require_imports(paths)
    _refuse_same_names(paths)
    documents = [path for path in paths if path.suffix.lower() == DOCUMENT]
    for path in documents:
        if path.stat().st_size > expression_json.LARGEST:
            raise ValueError(f"{path.name} has {path.stat().st_size} bytes; expected {expression_json.LARGEST} at most")
        try:
            arrival = import_document(cast.space, expression_json.decode(path.read_bytes()), note=path.name)
        except ValueError as error:
            raise ValueError(f"{path.name}: {error}") from error
        yield arrival, f"{arrival.label}, from {path.name}"
    notes: dict[str, list[str]] = {path.stem: [] for path in paths if path not in documents}
    shapes = {path.stem: read_in_sandbox(path, note=notes[path.stem].append) for path in paths if path.stem in notes}
    for path in [
        path for path in paths if path not in documents and _has_targets(path) and is_foreign(cast, shapes[path.stem])
    ]:
        del shapes[path.stem], notes[path.stem]
        yield from foreign_expressions(cast, path, landmarks=read_landmarks(landmarks, path, paths))
    if not shapes:
        return
    for taken in import_expressions(cast, load_meshes(), shapes, face=face, follow=follow):
        off = f"; it misses its shape by up to {1000 * taken.error:.2f} mm" if taken.error > FAR else ""
        note = f"from {', '.join(path.name for path in paths)}"[:200]
        doubt = f"; {taken.doubt}" if taken.doubt else ""
        tags = read_shape_name(taken.label).tags
        yield (
            ImportedItem(taken.label, taken.expression, tags, note),
            f"{taken.label}, taken from {taken.face}{off}{doubt}{_said_once(notes)}",
        )


def faces_from(cast: Cast, paths: Sequence[Path], *, look: str = "") -> Iterator[Brought]:
    """Yields each head at rest in the files (paths) as a face; cast: whose topology they have; look: its face whose
    colours they get, "" for their own.

    Errors as `expressions_from`.
    """
    require_imports(paths, "face")
    for path in paths:
        notes: dict[str, list[str]] = {path.name: []}
        face, own = import_face(cast, load_meshes(), path.stem, read_in_sandbox(path, note=notes[path.name].append))
        worn = cast.looks[find_name(look, cast.faces, "face")] if look else own
        if worn == Look():
            notes[path.name].append(PLAIN)
        yield ImportedItem(path.stem, (face, worn), note=f"from {path.name}"), f"{path.stem}, a face{_said_once(notes)}"


def _refuse_same_names(paths: Sequence[Path]) -> None:
    """Raises ValueError where two shapes would get one name: one of them would be lost."""
    named: dict[str, Path] = {}
    for path in paths:
        if path.suffix.lower() != DOCUMENT and (other := named.setdefault(path.stem, path)) is not path:
            raise ValueError(f"{other} and {path} would both be called {path.stem!r}; rename one, or take in one alone")


def _has_targets(path: Path) -> bool:
    """Whether files of this kind have morph targets, which are carried over from other heads."""
    return path.suffix.lower() not in _ONE_SHAPE


def _said_once(notes: dict[str, list[str]]) -> str:
    """What was left out of files, by their names, as the end of a sentence; forgets it, for the first item says it."""
    said = "".join(f"; {name}: {sentence}" for name, sentences in notes.items() for sentence in sentences)
    notes.clear()
    return said


def is_foreign(cast: Cast, pieces: Sequence[Piece], /) -> bool:
    """Whether none of a file's pieces is a head of the cast's topology."""
    try:
        match_head(cast, load_meshes(), pieces)
    except ValueError:
        return True
    return False


def foreign_expressions(
    cast: Cast, path: Path, /, *, landmarks: Mapping[str, ArrayLike] | None = None
) -> Iterator[Brought]:
    """Yields each expression of a stranger's head with a report about it; ValueError where there is none.

    path: a scan with shapes; landmarks: (3,) by name in its frame, where its shape alone does not say where the head
    is, or that it is an animal's. A shape whose name is known (`shape_names`) is tagged with the cast's units that do
    the same; it takes no unit's place, for all other faces and trackers play those.
    """
    read = read_scan_in_sandbox(path)
    scan = read.scan
    if not scan.shapes:
        raise ValueError(
            f"{path.name}: the head has no shapes that can be read; export it with its morph targets, or make a face "
            f"of it: omote face {path.name} -o show.omote"
        )
    try:
        taken = take_in_child(cast, scan, name=path.stem, landmarks=landmarks or {}, advice=POINTS_HELP)
    except ValueError as error:
        raise ValueError(f"{path.name}: {error}") from error
    notes = " ".join([*(f"{note}." for note in read.notes), *taken.notes])
    if not taken.expressions:
        raise ValueError(f"{path.name}: no shape is an expression. {notes}")
    for number, (name, (expression, doubt)) in enumerate(taken.expressions.items()):
        meaning = read_shape_name(name)
        sentence = f"{name}, taken from the head in {path.name}"
        sentence += f", as {' and '.join(meaning.units) or meaning.named}" if meaning.part else ""
        sentence += f"; {doubt}" if doubt else ""
        sentence += f". {notes}" if notes and number == len(taken.expressions) - 1 else ""
        turned = _with_gaze(cast, meaning, expression)
        yield ImportedItem(name, turned, tags=meaning.tags, note=f"from {path.name}"[:200]), sentence


def _with_gaze(cast: Cast, meaning: ShapeMeaning, expression: Expression) -> Expression:
    """The expression; where it is a look and the head's own eyeballs stay, for bones turn them, with the turn of the
    cast's."""
    if not meaning.is_gaze or abs(expression.eyes).max() > STILL:
        return expression
    turns = [cast.expressions[unit].eyes for unit in meaning.units if unit in cast.expressions]
    return replace(expression, eyes=np.sum(turns, axis=0)) if turns else expression


def read_in_sandbox(path: Path, /, *, note: Note = note_nothing) -> tuple[Piece, ...]:
    """Parses a file that has one shape or several into its pieces; ValueError for an invalid one, OSError where it
    cannot be read.

    path: the file; note: takes a sentence about what of it is left out.
    """
    reader = READERS.get(path.suffix.lower())
    if reader is None:
        raise ValueError(f"{path.name}: the file is no head with shapes: {advise(path.name, 'shape')}")
    if path.stat().st_size > gltf_document.LARGEST:
        raise ValueError(f"{path.name} has {path.stat().st_size} bytes; expected {gltf_document.LARGEST} at most")
    data = path.read_bytes()

    def work(_: Tell) -> HeadFile:
        notes = list[str]()
        return HeadFile(reader(data, notes.append, lambda name: find_beside(path, name)), tuple(dict.fromkeys(notes)))

    try:
        read = run_limited(work, HeadFile, LIMITS, exhausted=_TOO_MUCH)
    except ValueError as error:
        raise ValueError(f"{path.name}: {error}") from error
    for sentence in read.notes:
        note(sentence)
    return read.pieces
