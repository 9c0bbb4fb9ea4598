"""The jobs that pages ask of files: an import (a file of a stranger as items), an export (an expression, a face)."""

from __future__ import annotations

import sqlite3
from collections.abc import Iterable, Iterator
from pathlib import Path

import msgspec

from omote.builtin import load_cast, load_mask, load_meshes
from omote.edit.store.import_items import changes_to_import, distinguish, export_document
from omote.interchange.avatar.vrm_licence import Credit, parse_terms
from omote.interchange.export_face import ExportContext, choose_expressions, named_compound_meshes
from omote.interchange.exports.export_formats import check_count, check_kind, encode_face, pack_files
from omote.interchange.formats.expression_json import encode as encode_document
from omote.interchange.formats.file_names import GLB, VRM
from omote.model.cast import Cast
from omote.server.sandbox.import_files import Brought, expressions_from, faces_from
from omote.server.workers.job_server import Follow
from omote.server.workers.photograph_jobs import FitPhotographs, run_photograph_fit
from omote.server.workers.scan_jobs import FitScan, TakeScan, face_to_take, run_fit
from omote.showfile.changes import BroughtItem, Change, Item, Kind, PutContent, PutItem, PutRevision
from omote.showfile.database_errors import describe_error
from omote.showfile.inspection import Inspection, inspect_show
from omote.showfile.schema import ShowFileError
from omote.stage_data.full_cast import build_full_cast, face_labels


class ImportFile(msgspec.Struct, frozen=True, tag=True):
    """A file as items beside those of a show file; wall: seconds since 1970. Made: `Imported`, encoded."""

    show: str
    path: str
    kind: Kind
    wall: float


class ExportExpression(msgspec.Struct, frozen=True, tag=True):
    """An expression of a show file, or of the cast, as a document (JSON)."""

    show: str
    name: str


class ExportFace(msgspec.Struct, frozen=True, tag=True):
    """A face with expressions (`arkit`, names by commas) in a kind of file; what is several files is a ZIP of them.

    authors, licence: of a VRM, who made it and who may use it (`strict`, `cc0`, or terms by commas).
    """

    show: str
    face: str
    expressions: str
    kind: str = GLB
    authors: tuple[str, ...] = ()
    licence: str = ""


FileJob = ImportFile | ExportExpression | ExportFace | FitScan | FitPhotographs | TakeScan


class Imported(msgspec.Struct, frozen=True):
    """What a file brought, and a sentence about each item."""

    items: list[BroughtItem]
    said: list[str]


_job: msgspec.msgpack.Decoder[FileJob] = msgspec.msgpack.Decoder(FileJob)


def run_file_job(job: bytes, follow: Follow, /) -> bytes:
    """Does an encoded job and returns what it makes; ValueError with a sentence for what cannot be done."""
    wanted = _job.decode(job)
    try:
        if isinstance(wanted, FitScan):
            return msgspec.msgpack.encode(run_fit(wanted, follow))
        if isinstance(wanted, FitPhotographs):
            return msgspec.msgpack.encode(run_photograph_fit(wanted, follow))
        if isinstance(wanted, ImportFile | TakeScan):
            return msgspec.msgpack.encode(_import_file(wanted, follow))
        found = inspect_show(Path(wanted.show))
        if isinstance(wanted, ExportExpression):
            return encode_document(export_document(load_cast(), found.stored, found.contents, wanted.name))
        return _export_face(found, wanted, follow)
    except (ShowFileError, OSError, OverflowError, sqlite3.Error) as error:
        raise ValueError(describe_error(error)) from error


def _import_file(wanted: ImportFile | TakeScan, follow: Follow) -> Imported:
    found, left_out = inspect_show(Path(wanted.show)), list[str]()
    cast = build_full_cast(load_cast(), found.stored, found.contents, left_out.append)
    brought = list(face_to_take(wanted) if isinstance(wanted, TakeScan) else _read_file(cast, wanted, follow))
    distinct = distinguish(load_cast(), found.stored, [arrival for arrival, _ in brought])
    arrivals = [arrival for arrival, _ in distinct]
    said = [f"{told}; {twin}" if twin else told for (_, told), (_, twin) in zip(brought, distinct, strict=True)]
    changes = changes_to_import(cast, found.stored, arrivals, wall=wanted.wall)
    return Imported(list(bring_items(changes)), [*said, *left_out])


def _read_file(cast: Cast, wanted: ImportFile, follow: Follow) -> Iterator[Brought]:
    path = Path(wanted.path)
    return faces_from(cast, [path]) if wanted.kind == "face" else expressions_from(cast, [path], follow=follow)


def _export_face(found: Inspection, wanted: ExportFace, follow: Follow) -> bytes:
    left_out = list[str]()  # not told: a download has no room for it, and import and the show's notices do
    cast = build_full_cast(load_cast(), found.stored, found.contents, left_out.append)
    names = choose_expressions(cast, wanted.expressions)
    credit = None
    if wanted.kind == VRM:
        credit = Credit(wanted.authors, parse_terms([wanted.licence]), labels=face_labels(found.stored))
    check_kind(wanted.kind, credit)
    check_count(wanted.kind, names)
    poses = ((name, named_compound_meshes(cast, wanted.face, name)) for name in _followed(names, follow))
    context = ExportContext(cast, load_meshes(), load_mask())
    return pack_files(encode_face(context, wanted.face, poses, wanted.kind, wanted.face, credit=credit))


def _followed(names: list[str], follow: Follow) -> Iterator[str]:
    for done, name in enumerate(names):
        follow(done, len(names), name)
        yield name
    follow(len(names), len(names), "the file is written")


def bring_items(changes: Iterable[Change]) -> Iterator[BroughtItem]:
    """The items that changes add, each with its revision and the bytes of its content."""
    contents, items = dict[str, bytes](), dict[int, Item]()
    for change in changes:
        match change:
            case PutContent(key, data):
                contents[key] = data
            case PutItem(item):
                items[item.id] = item
            case PutRevision(revision):
                yield BroughtItem(items[revision.item], revision, contents[revision.content])
