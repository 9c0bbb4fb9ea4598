"""Imports expressions and faces from files (JSON, GLB, OBJ) and reports how well each one fits."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from omote.builtin import load_meshes
from omote.edit.store.import_items import ImportedItem, import_document
from omote.interchange.formats import expression_json
from omote.interchange.formats.file_names import DOCUMENT, GLB, VRM, require_imports
from omote.interchange.import_meshes import Follow, ignore_progress, import_expressions, import_face
from omote.model.cast import Cast
from omote.perform.name_lookup import find_name
from omote.server.sandbox.child_reader import read_in_sandbox
from omote.server.sandbox.foreign_heads import foreign_expressions, is_foreign

FAR = 5e-5
"""Metres; a larger error of an imported expression against its source shape is reported."""

Brought = tuple[ImportedItem, str]


def expressions_from(
    cast: Cast, paths: Sequence[Path], *, face: str = "", follow: Follow = ignore_progress
) -> Iterator[Brought]:
    """Yields each expression in the files with a report about it; face: the face of the cast that shapes start from;
    follow: told of shapes done, all shapes, and the one that is next.

    ValueError for files without expressions; OSError where one cannot be read.
    """
    require_imports(paths)
    documents = [path for path in paths if path.suffix.lower() == DOCUMENT]
    for path in documents:
        if path.stat().st_size > expression_json.LARGEST:
            raise ValueError(f"{path.name} has {path.stat().st_size} bytes; expected {expression_json.LARGEST} at most")
        try:
            arrival = import_document(cast.space, expression_json.decode(path.read_bytes()), note=path.name)
        except ValueError as error:
            raise ValueError(f"{path.name}: {error}") from error
        yield arrival, f"{arrival.label}, from {path.name}"
    shapes = {path.stem: read_in_sandbox(path) for path in paths if path not in documents}
    for path in (path for path in paths if path.suffix.lower() in (GLB, VRM) and is_foreign(cast, shapes[path.stem])):
        del shapes[path.stem]
        yield from foreign_expressions(cast, path)
    if not shapes:
        return
    for each in import_expressions(cast, load_meshes(), shapes, face=face, follow=follow):
        off = f"; it misses its shape by up to {1000 * each.error:.2f} mm" if each.error > FAR else ""
        note = f"from {', '.join(path.name for path in paths)}"[:200]
        doubt = f"; {each.doubt}" if each.doubt else ""
        yield ImportedItem(each.label, each.expression, note=note), f"{each.label}, taken from {each.face}{off}{doubt}"


def faces_from(cast: Cast, paths: Sequence[Path], *, look: str = "") -> Iterator[Brought]:
    """Yields each head at rest in the files as a face; look: the cast's face whose colours it gets, "" for its own.

    Errors as `expressions_from`.
    """
    require_imports(paths)
    for path in paths:
        face, own = import_face(cast, load_meshes(), path.stem, read_in_sandbox(path))
        worn = cast.looks[find_name(look, cast.faces, "face")] if look else own
        yield ImportedItem(path.stem, (face, worn), note=f"from {path.name}"), f"{path.stem}, a face"
