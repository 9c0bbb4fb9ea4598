"""The command `omote export`: faces with expressions into files of other programs, one or a whole folder of them."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omote.picture_commands import ShowOption
from omote.terminal import INTERRUPTED, complete_name, exit_on_refusal, fail, say

if TYPE_CHECKING:
    from omote.interchange.avatar.vrm_licence import Credit
    from omote.interchange.export_face import ExportContext
    from omote.interchange.exports.export_formats import Files
    from omote.model.cast import Cast
    from omote.server.farm.export_run import ExportRun, Finished, Pool, Report
    from omote.showfile.inspection import Inspection

MOST_JOBS = 256
STOPPED = "stopped; what is written stays, and the same command goes on from there."
ARKIT = "arkit"
NEUTRAL = "neutral"
OWN = "own"
KINDS = "all", OWN
"""Instead of the names of faces."""


def export(
    output: Annotated[
        Path,
        typer.Option("--output", "-o", help="The file: .glb, .vrm, .usdc (a, z), .obj, .npz, .csv; or a folder."),
    ],
    face: Annotated[str, typer.Argument(help="A face of the cast: kaori, dog; or none with --all or --faces.")] = "",
    expressions: Annotated[
        str,
        typer.Option(
            help="arkit, performed, makehuman, omote, own, all, neutral (the face alone), or names, by commas. "
            "Left out: arkit; for a single OBJ neutral."
        ),
    ] = "",
    hair: Annotated[bool, typer.Option("--hair/--no-hair", help="The face's hair, as ribbons.")] = True,
    figure: Annotated[bool, typer.Option("--figure", help="The head on the face's own body: GLB, VRM, USD.")] = False,
    body: Annotated[str, typer.Option(help="The head on this body: heavy, child.")] = "",
    author: Annotated[list[str] | None, typer.Option(help="Of a VRM: who made it; again for others.")] = None,
    licence: Annotated[
        list[str] | None,
        typer.Option(help="Of a VRM: cc0, strict, or VRM's terms: avatarPermission=everyone,modification=..."),
    ] = None,
    older: Annotated[bool, typer.Option("--vrm0", help="A VRM of version 0.x, for programs that want it.")] = False,
    show: ShowOption = None,
    force: Annotated[bool, typer.Option("--force", help="Replaces files that are there.")] = False,
    every: Annotated[bool, typer.Option("--all", help="Every face, into a folder.")] = False,
    faces: Annotated[str, typer.Option(help="These faces, by commas, into a folder.")] = "",
    form: Annotated[
        str, typer.Option("--format", help="Of a folder's files: glb, vrm, usd, usda, usdz, obj, npz or csv.")
    ] = "",
    jobs: Annotated[
        int, typer.Option("--jobs", "-j", min=0, max=MOST_JOBS, help="Processes at once; 0: one for each core.")
    ] = 0,
    on: Annotated[str, typer.Option("--on", metavar="ADDRESS", help="A Dask cluster: tcp://host:8786.")] = "",
) -> None:
    """Writes faces with expressions: as heads (GLB, VRM, USD, OBJ) or figures, or as what each moves (NPZ, CSV)."""
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy is loaded: each process has one core
    several = bool(every or faces or form or on)
    body = body or (OWN if figure else "")
    credit = read_credit(form if several else output.suffix, author or [], licence or [], older=older)
    if several:
        if bool(face) == bool(every or faces):
            fail("name one face (omote cast lists them), or --all, or some with --faces kaori,dog.")
        chosen = faces or face or "all"
        pool = on or jobs or count_cores()
        options = ExportOptions(expressions, hair, show, force, credit, body)
        finish_folder(export_folder(output, chosen, form, options, pool))
    elif not face:
        fail("name a face (omote cast lists them), or --all and a folder.")
    else:
        export_file(output, face, ExportOptions(expressions, hair, show, force, credit, body))


@dataclass(frozen=True)
class ExportOptions:
    """What a person said of an export, of one file and of a folder alike; body: of figures, "" for heads."""

    expressions: str
    hair: bool
    show: Path | None
    force: bool
    credit: Credit | None
    body: str = ""


def read_credit(kind: str, authors: Sequence[str], licence: Sequence[str], *, older: bool) -> Credit | None:
    """Who made a VRM and what others may do with it; None for other kinds; ends the command where it is not said.

    kind: the ending of the file; authors: who made it; licence: terms as they are typed; older: whether it is of
    version 0.x.
    """
    from omote.interchange.avatar.vrm_licence import Credit, parse_terms
    from omote.interchange.formats.file_names import VRM

    with exit_on_refusal():
        if f".{kind.lower().lstrip('.')}" == VRM:
            return Credit(tuple(authors), parse_terms(licence), "0.x" if older else "1.0")
        if authors or licence or older:
            raise ValueError(f"--author, --licence and --vrm0 are for a VRM alone; this is {kind or 'GLB'}")
    return None


def export_file(output: Path, face: str, options: ExportOptions) -> None:
    """Writes one face as one file, and the pictures that it names beside it.

    output: the path; options: what was said of it.
    """
    from omote.interchange.formats.file_names import NUMBERS, OBJ, VRM

    output = complete_name(output, ".glb")
    kind = output.suffix.lower()
    inspection = check_export(output, options.show, force=options.force)
    expressions = options.expressions or (NEUTRAL if kind == OBJ else ARKIT)
    check_names(inspection, face, expressions)
    from rich.console import Console  # what is heavy comes after what can be refused without it
    from rich.progress import track

    from omote.interchange.export_face import named_compound_meshes
    from omote.interchange.exports.export_formats import check_body, check_count, encode_face
    from omote.interchange.name_choices import choose_expressions
    from omote.stage_data.full_cast import find_face

    with exit_on_refusal():
        cast = load_full_cast(inspection)
        credit = label_credit(options.credit, inspection)
        face = find_face(cast, None if inspection is None else inspection.stored, face)
        names = choose_expressions(cast, expressions)
        check_count(kind, names)
        check_body(cast, kind, options.body)
        busy = track(names, f"omote: {face}", console=Console(stderr=True), transient=True)
        poses = ((name, named_compound_meshes(cast, face, name)) for name in busy)
        named = face, poses, kind, output.stem
        files = encode_face(shared_context(cast), *named, hair=options.hair, credit=credit, body=options.body)
        write_files(output, files, force=options.force)
    what = "expressions" if kind in (*NUMBERS, OBJ, VRM) else "morph targets"
    if credit is not None:
        say(credit.sentence(face))
    on = f" on the body {options.body}" if options.body not in ("", OWN) else " on its body" if options.body else ""
    say(f"{output}: {face}{on}, {what}: {len(names)}, {sum(map(len, files.values())) / 1e6:.1f} MB")


def check_export(output: Path, show: Path | None, *, force: bool) -> Inspection | None:
    """What the show file holds, if one is named; ends the command where the export could not be written.

    output: the path; force: whether a file there is replaced.
    """
    from omote.interchange.formats.atomic_file import check_writable, require_free
    from omote.interchange.formats.file_names import check_export_name
    from omote.showfile.inspection import inspect_show

    with exit_on_refusal():
        check_export_name(output)
        check_writable(output)
        require_free(output, force=force)
        check_library(output.suffix.lower())
        return None if show is None else inspect_show(show)


def check_names(inspection: Inspection | None, faces: str, expressions: str) -> None:
    """Ends the command where a face or an expression is none of the cast, before one is loaded.

    inspection: what the show file holds; faces: by commas, also `all` and `own`; expressions: names or kinds likewise.
    """
    from omote.interchange.name_choices import choose_expressions
    from omote.stage_data.cast_names import read_names

    with exit_on_refusal():
        if (names := read_names(None if inspection is None else inspection.stored)) is None:
            return
        for word in filter(None, (word.strip() for word in faces.split(","))):
            if word.lower() not in KINDS:
                names.find_face(word)
        choose_expressions(names, expressions)


def check_library(kind: str) -> None:
    """Raises ValueError where the library that a kind is written with is not installed."""
    from omote.interchange.formats.file_names import USD

    if kind in USD:
        from omote.interchange.exports.usd_writer import check_usd

        check_usd()


def write_files(output: Path, files: Files, *, force: bool) -> None:
    """Writes an export, its main file last, when all that it names is there; nothing where one of them is not free.

    output: the path of the main one; files: bytes by name; force: whether files there are replaced.
    """
    from omote.interchange.formats.atomic_file import require_free, write_whole

    main, *others = files
    paths = {output: files[main], **{output.with_name(name): files[name] for name in others}}
    for path in paths:
        require_free(path, force=force)
    for path, data in reversed(paths.items()):
        write_whole(path, data)


def export_folder(folder: Path, faces: str, form: str, options: ExportOptions, pool: str | int) -> Finished:
    """Writes several faces into a folder, and shows how far that is; pool: as `choose_pool` has it; form: of the files;
    options: what was said of them."""
    from omote.showfile.inspection import inspect_show

    with exit_on_refusal():
        if folder.exists() and not folder.is_dir():
            raise NotADirectoryError(f"{folder} is a file; give the name of a folder")
        inspection = None if options.show is None else inspect_show(options.show)
        check_names(inspection, faces, options.expressions or ARKIT)
        from omote.interchange.exports.export_formats import check_body, check_kind, find_kind
        from omote.interchange.name_choices import choose_expressions
        from omote.server.farm.export_run import ExportRun, run_export

        check_kind(kind := find_kind(form or "glb"), options.credit)
        cast = load_full_cast(inspection)
        check_body(cast, kind, options.body)
        chosen = choose_faces(cast, inspection, faces)
        names = choose_expressions(cast, options.expressions or ARKIT)
        context = shared_context(cast)
        hair = options.hair
        force = options.force
        credit = label_credit(options.credit, inspection)
        run = ExportRun(context, folder, kind, chosen, names, hair, force, credit, options.body)
        with shown_progress(run) as report:
            return run_export(run, choose_pool(pool), report)


def choose_faces(cast: Cast, inspection: Inspection | None, text: str) -> list[str]:
    """The faces that a person means: `all`, `own` (those of the show file), or names, by commas.

    cast: the full one; inspection: what the show file holds; text: as it is typed.
    """
    from omote.showfile.changes import playing_items
    from omote.stage_data.full_cast import find_face

    stored = None if inspection is None else inspection.stored
    own = [item.name for item, _ in playing_items(stored) if item.kind == "face"] if stored is not None else []
    chosen: dict[str, None] = {}
    for word in filter(None, (word.strip() for word in text.split(","))):
        matching = {"all": list(cast.faces), "own": [name for name in own if name in cast.faces]}.get(word.lower())
        chosen |= dict.fromkeys([find_face(cast, stored, word)] if matching is None else matching)
    if not chosen:
        raise ValueError(f"{text!r} names no face; give names by commas, all, or own with --show")
    return list(chosen)


def label_credit(credit: Credit | None, inspection: Inspection | None) -> Credit | None:
    """Who made a VRM, with what a show file calls its own faces, and which of them are CC0.

    credit: as it was said; inspection: what the show file holds.
    """
    from omote.stage_data.full_cast import face_labels, free_faces

    if credit is None or inspection is None:
        return credit
    stored = inspection.stored
    return replace(credit, labels=face_labels(stored), free=free_faces(stored, inspection.contents))


def choose_pool(pool: str | int) -> Pool:
    """Where a run is baked: on the cluster of an address, or in so many processes of this machine."""
    if isinstance(pool, str):
        from omote.server.farm.dask_pool import bake_on_cluster

        return bake_on_cluster(pool)
    from omote.server.farm.export_run import bake_in_processes

    return bake_in_processes(pool)


def count_cores() -> int:
    """The cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def load_full_cast(inspection: Inspection | None) -> Cast:
    """The built-in cast, with a show file's own work where one is named."""
    from omote.builtin import load_cast
    from omote.stage_data.full_cast import build_full_cast

    cast = load_cast()
    return cast if inspection is None else build_full_cast(cast, inspection.stored, inspection.contents, say)


def shared_context(cast: Cast) -> ExportContext:
    """What all exports of a cast share."""
    from omote.builtin import load_mask, load_meshes
    from omote.interchange.export_face import ExportContext

    return ExportContext(cast, load_meshes(), load_mask())


@contextmanager
def shown_progress(run: ExportRun) -> Iterator[Report]:
    """Shows how far a run is: a bar with the time that is left on a terminal, else a line for each face."""
    try:
        if not sys.stderr.isatty():
            yield tell_face
            return
        from rich.console import Console
        from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

        columns = TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn(compact=True)
        # No thread of its own: processes are forked meanwhile.
        with Progress(*columns, console=Console(stderr=True), transient=True, auto_refresh=False) as bar:
            task = bar.add_task(str(run.folder), total=len(run.faces))

            def report(done: int, _: int, face: str, failure: str) -> None:
                if failure:
                    tell_face(done, len(run.faces), face, failure)
                bar.update(task, completed=done, description=face, refresh=True)

            yield report
    except KeyboardInterrupt:
        say(STOPPED)
        raise typer.Exit(INTERRUPTED) from None


def tell_face(done: int, total: int, face: str, failure: str) -> None:
    """Says that a face is done, or why not. total: how many there are; failure: why not, or ""."""
    say(f"{done} of {total}: {face}{f' failed: {failure}' if failure else ''}")


def finish_folder(finished: Finished) -> None:
    """Says what a run did; ends the command with status 1 where faces failed, which are named."""
    written = finished.exported
    current = finished.current
    failed = finished.failed
    there = f"; there already, whole and current: {len(current)}" if current else ""
    say(f"faces written: {len(written)}{there}{f'; failed: {len(failed)}' if failed else ''}")
    for face, why in failed.items():
        say(f"{face}: {why}")
    if failed:
        raise typer.Exit(1)
