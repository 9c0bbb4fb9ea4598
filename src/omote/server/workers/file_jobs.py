"""The jobs that pages ask of files: an import (a file of a stranger as items), an export (an expression, a face)."""

from __future__ import annotations

import sqlite3
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import msgspec

from omote.builtin import load_cast, load_mask, load_meshes
from omote.edit.store.import_items import changes_to_import, distinguish, export_document
from omote.inputs.voices.spoken_text import Voice, WantedSpeech
from omote.interchange.avatar.vrm_licence import Credit, parse_terms
from omote.interchange.export_face import ExportContext, choose_expressions, named_compound_meshes
from omote.interchange.exports.export_formats import check_count, check_kind, encode_face, pack_files
from omote.interchange.formats.expression_json import encode as encode_document
from omote.interchange.formats.file_names import GLB, VRM
from omote.model.cast import Cast
from omote.server.sandbox.import_files import Brought, expressions_from, faces_from
from omote.server.sandbox.scan_files import read_photograph_in_sandbox
from omote.server.sandbox.voices import list_voices, speak
from omote.server.workers.job_server import Follow
from omote.server.workers.scan_jobs import (
    FitPhotographs,
    FitScan,
    ShowPhotograph,
    TakeScan,
    face_to_take,
    run_fit,
    run_photograph_fit,
)
from omote.showfile.changes import BroughtItem, Change, Content, Item, Kind, Revision
from omote.showfile.database_errors import describe_error
from omote.showfile.inspection import Inspection, inspect_show
from omote.showfile.schema import ShowFileError
from omote.stage_data.full_cast import build_full_cast, face_labels, free_faces


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


class BuildTouchoscLayout(msgspec.Struct, frozen=True, tag=True):
    """The file of a layout for TouchOSC (`.tosc`), of these names. pads: the dimensions of each."""

    faces: tuple[str, ...]
    expressions: tuple[str, ...]
    characters: tuple[str, ...]
    pads: dict[str, int]


class ListVoices(msgspec.Struct, frozen=True, tag=True):
    """The synthetic voices of this machine. Made: a list of `Voice`, encoded."""


class SpeakText(msgspec.Struct, frozen=True, tag=True):
    """What a synthetic voice is asked to say. Made: a `SpokenText`, encoded."""

    wanted: WantedSpeech


@dataclass(frozen=True)
class NamedCast:
    """Names that can be called, without what stands for them."""

    faces: Mapping[str, Any]
    expressions: Mapping[str, Any]
    titles: Mapping[str, Any] = field(default_factory=dict)
    face_labels: Mapping[str, str] = field(default_factory=dict)
    poses: Mapping[str, Any] = field(default_factory=dict)
    bones: tuple[str, ...] = ()
    bodies: Mapping[str, Any] = field(default_factory=dict)
    digest: str = ""


FileJob = (
    ImportFile | ExportExpression | ExportFace | BuildTouchoscLayout | FitScan | FitPhotographs | ShowPhotograph
    | TakeScan | ListVoices | SpeakText
)  # fmt: skip


class Imported(msgspec.Struct, frozen=True):
    """What a file brought, and a sentence about each item."""

    items: list[BroughtItem]
    said: list[str]


_job: msgspec.msgpack.Decoder[FileJob] = msgspec.msgpack.Decoder(FileJob)


def run_file_job(job: bytes, follow: Follow, /) -> bytes:
    """Does an encoded job and returns what it makes; ValueError with a sentence for what cannot be done.

    job: a `FileJob`, MessagePack; follow: told of steps done, all steps and what is done now.
    """
    wanted = _job.decode(job)
    try:
        if isinstance(wanted, ExportExpression | ExportFace):
            return _export(wanted, follow)
        if isinstance(wanted, ShowPhotograph):
            return read_photograph_in_sandbox(Path(wanted.path), wanted.longest)
        if isinstance(wanted, BuildTouchoscLayout):
            return _build_layout(wanted)
        return msgspec.msgpack.encode(_answer(wanted, follow))
    except (ShowFileError, OSError, OverflowError, sqlite3.Error) as error:
        raise ValueError(describe_error(error)) from error


def _answer(
    wanted: ImportFile | TakeScan | FitScan | FitPhotographs | ListVoices | SpeakText, follow: Follow
) -> msgspec.Struct | list[Voice]:
    """What is encoded as an answer."""
    if isinstance(wanted, FitScan):
        return run_fit(wanted, follow)
    if isinstance(wanted, FitPhotographs):
        return run_photograph_fit(wanted, follow)
    if isinstance(wanted, ListVoices):
        return list_voices()
    if isinstance(wanted, SpeakText):
        return speak(wanted.wanted.text, voice=wanted.wanted.voice, speed=wanted.wanted.speed)
    return _import_file(wanted, follow)


def _build_layout(wanted: BuildTouchoscLayout) -> bytes:
    from omote.inputs.presets.touchosc_layout import build_touchosc_layout  # a tenth of a second that a start saves

    cast = NamedCast(dict.fromkeys(wanted.faces), dict.fromkeys(wanted.expressions))
    return build_touchosc_layout(cast, wanted.characters, wanted.pads)


def _import_file(wanted: ImportFile | TakeScan, follow: Follow) -> Imported:
    inspection = inspect_show(Path(wanted.show))
    left_out = list[str]()
    cast = build_full_cast(load_cast(), inspection.stored, inspection.contents, left_out.append)
    brought = list(face_to_take(wanted) if isinstance(wanted, TakeScan) else _read_file(cast, wanted, follow))
    distinct = distinguish(load_cast(), inspection.stored, [arrival for arrival, _ in brought])
    arrivals = [arrival for arrival, _ in distinct]
    said = [
        f"{sentence}; {twin}" if twin else sentence for (_, sentence), (_, twin) in zip(brought, distinct, strict=True)
    ]
    changes = changes_to_import(cast, inspection.stored, arrivals, wall=wanted.wall)
    return Imported(list(bring_items(changes)), [*said, *left_out])


def _read_file(cast: Cast, wanted: ImportFile, follow: Follow) -> Iterator[Brought]:
    path = Path(wanted.path)
    return faces_from(cast, [path]) if wanted.kind == "face" else expressions_from(cast, [path], follow=follow)


def _export(wanted: ExportExpression | ExportFace, follow: Follow) -> bytes:
    inspection = inspect_show(Path(wanted.show))
    if isinstance(wanted, ExportExpression):
        return encode_document(export_document(load_cast(), inspection.stored, inspection.contents, wanted.name))
    return _export_face(inspection, wanted, follow)


def _export_face(inspection: Inspection, wanted: ExportFace, follow: Follow) -> bytes:
    left_out = list[str]()  # not told: a download has no room for it, and import and the show's notices do
    cast = build_full_cast(load_cast(), inspection.stored, inspection.contents, left_out.append)
    names = choose_expressions(cast, wanted.expressions)
    credit = None
    if wanted.kind == VRM:
        labels = face_labels(inspection.stored)
        free = free_faces(inspection.stored, inspection.contents)
        credit = Credit(wanted.authors, parse_terms([wanted.licence]), labels=labels, free=free)
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
    contents = dict[str, bytes]()
    items = dict[int, Item]()
    for change in changes:
        match change:
            case Content(key, data):
                contents[key] = data
            case Item():
                items[change.id] = change
            case Revision():
                yield BroughtItem(items[change.item], change, contents[change.content])
