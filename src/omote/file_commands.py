"""The commands `omote file ...`: list, check, history, import, forget and export of a show file; all but `import` and
`forget` only read, also while a show plays it."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from omote.terminal import complete_name, complete_show, escape_controls, exit_on_refusal, fail, say

if TYPE_CHECKING:
    from omote.edit.store.import_items import ImportedItem
    from omote.model.cast import Cast
    from omote.show.cues.cue_book import CueBook
    from omote.showfile.changes import Stored
    from omote.showfile.inspection import Inspection

WIDEST = 4000
"""Characters of a line of a table at most."""
ShowFileArgument = Annotated[Path, typer.Argument(callback=complete_show, help="The show file (.omote).")]
JsonOption = Annotated[bool, typer.Option("--json", help="Print it for programs.")]

file_app = typer.Typer(help="Looks into show files.", no_args_is_help=True)


CueListOption = Annotated[str, typer.Option("--list", help="Of several lists of cues: its name.")]
DocumentsOption = Annotated[str, typer.Option("--documents", help="Stored documents of a kind instead: layout, sound.")]


@file_app.command("list")
def list_items(file: ShowFileArgument, json: JsonOption = False, documents: DocumentsOption = "") -> None:
    """Lists the own faces and expressions of a show file, or its documents of a kind."""
    from omote.showfile.inspection import inspect_show

    with exit_on_refusal():
        inspection = inspect_show(file)
        stored = inspection.stored
    if documents:
        named = stored.documents.get(documents, {})
        sizes = [
            {"kind": documents, "name": name, "bytes": size_of_document(inspection, documents, named[name])}
            for name in sorted(named)
        ]
        print_rows(sizes, json=json, none=f"{file} has no documents of kind {documents}; omote file check counts all.")
        return
    rows = [
        {
            "kind": item.kind,
            "name": item.name,
            "label": item.label,
            "revision": item.head,
            "revisions": sum(revision.item == item.id for revision in stored.revisions),
            "drafts": sum(draft.item == item.id for draft in stored.drafts),
            "tags": " ".join(item.tags),
            "deleted": item.deleted,
        }
        for item in sorted(stored.items, key=lambda item: (item.kind, item.place, item.id))
    ]
    print_rows(rows, json=json, none=f"{file} has no own faces or expressions yet.")


def size_of_document(inspection: Inspection, kind: str, body: bytes) -> int:
    """How many bytes a document of a kind takes, with the contents that it needs. inspection: of its file; body: its
    JSON."""
    from omote.show.objects.documents import contents_of

    needed = (inspection.contents.get(key, b"") for key in contents_of(kind, body))
    return len(body) + sum(map(len, needed))


@file_app.command()
def check(file: ShowFileArgument) -> None:
    """Says what is in a show file, and whether all of it is right."""
    from omote.showfile.identification import identify
    from omote.showfile.inspection import holds_nothing, verdicts, what_opens
    from omote.showfile.recovery import explain_missing

    good = True
    with exit_on_refusal():
        identity = identify(file)
        if identity.kind == "foreign":
            fail(
                f"{file} is {identity.noun} and never was a show; it stays as it is. Name a show file, such as "
                "show.omote."
            )
        if holds_nothing(file):
            fail(explain_missing(file))
        for right, sentence in verdicts(file):
            good = good and right
            typer.echo(f"{'good' if right else 'BAD '}  {escape_controls(sentence)}")
        if not good:
            fail(f"{file} is not all right. {what_opens(file)}")


@file_app.command()
def history(
    file: ShowFileArgument,
    name: Annotated[str, typer.Argument(help="The name of an own face or expression (omote file list).")],
    kind: Annotated[
        Literal["expression", "face"] | None, typer.Option(help="Which, where both have this name.")
    ] = None,
    json: JsonOption = False,
) -> None:
    """Lists the revisions of an own face or expression, oldest first."""
    from omote.showfile.inspection import inspect_show, item_named, revisions_of

    with exit_on_refusal():
        stored = inspect_show(file).stored
        item = item_named(stored, name, kind)
    rows = [
        {
            "revision": revision.number,
            "of": revision.parent,
            "written": format_time(revision.written),
            "by": revision.editor,
            "note": revision.note,
            "state": "plays" if revision.number == item.head else "aside" if revision.aside else "",
            "content": revision.content,
        }
        for revision in revisions_of(stored, item)
    ]
    print_rows(rows, json=json, none=f"{name} has never been saved.")


@file_app.command("import")
def take_in(
    file: ShowFileArgument,
    things: Annotated[
        list[Path],
        typer.Argument(
            help="Expressions (.json), heads with morph targets (.glb, .gltf, .vrm), shapes (.obj, .ply), "
            "shows (.omote), lists of cues (.toml)."
        ),
    ],
    face: Annotated[str, typer.Option(help="The face of the cast that shapes start from; else it is seen.")] = "",
    kind: Annotated[
        Literal["expression", "face"], typer.Option("--as", help="What the files are: expressions, or faces at rest.")
    ] = "expression",
    landmarks: Annotated[
        list[str] | None,
        typer.Option(help="Of a head of another program: where a point is, nose_tip=x,y,z, again for each; or a JSON."),
    ] = None,
    keep_both: Annotated[
        bool, typer.Option("--keep-both", help="Adds a copy of what is there already, exactly the same.")
    ] = False,
    cue_list: CueListOption = "",
) -> None:
    """Takes expressions or faces made elsewhere, all of other show files, or lists of cues, into a show file that no
    show plays; what is there already is not added again."""
    from omote.interchange.formats.file_names import CUES, SHOW, require_imports
    from omote.stage_data.cast_names import read_names

    shows = [thing for thing in things if thing.suffix.lower() == SHOW]
    texts = [thing for thing in things if thing.suffix.lower() == CUES]
    things = [thing for thing in things if thing not in (*shows, *texts)]
    with exit_on_refusal():
        if texts:
            take_in_cues(file, texts, cue_list)
            if not things and not shows:
                return
        own = read_own_work(file)
        require_imports(things, kind)
        if shows:
            take_in_shows(file, shows)
            if not things:
                return
            own = read_own_work(file)
        if face and (names := read_names(own and own[0])):
            names.find_face(face)
        from omote.builtin import load_cast  # what is heavy comes after what can be refused without it
        from omote.stage_data.full_cast import build_full_cast, find_face

        cast = load_cast() if own is None else build_full_cast(load_cast(), *own, say)
        face = find_face(cast, None if own is None else own[0], face) if face else ""
        arrivals = read_arrivals(cast, things, face, kind, landmarks or [])
        new = add_items(file, cast, arrivals, keep_both=keep_both)
    say(f"{file} has {f'{len(new)} {kind}' if new else 'nothing'}{'s' if len(new) > 1 else ''} more.")


def take_in_shows(file: Path, shows: Sequence[Path]) -> None:
    """Adds all of other show files to one that no show plays; what is called otherwise or stays out is told.

    file: the show file, made where there is none; shows: the others, which are only read.
    """
    from omote.builtin import load_cast
    from omote.edit.store.whole_items import merge_show
    from omote.server.persistence.offline_show import open_offline_show
    from omote.showfile.inspection import inspect_show, refuse_wrong

    others = [inspect_show(other) for other in shows]
    for other, inspection in zip(shows, others, strict=True):
        refuse_wrong(other, inspection)
    with open_offline_show(file, new=True) as show:
        for other, inspection in zip(shows, others, strict=True):
            merged = merge_show(load_cast(), show.stored(), inspection.stored, inspection.contents)
            show.apply(merged.changes)
            for note in merged.notes:
                say(escape_controls(f"{note}."))
            count = len(merged.labels)
            named = f": {', '.join(merged.labels)}" if count else ""
            say(escape_controls(f"{file} has {count or 'nothing'} of {other.name} more{named}."))


def take_in_cues(file: Path, texts: Sequence[Path], name: str) -> None:
    """Takes lists of cues (TOML) into a show file that no show plays, each in the place of the list of its name.

    file: the show file, made where there is none; texts: the lists; name: of the list that one text becomes, "" for the
    one that the file begins with.
    """
    from omote.interchange.formats.cue_toml import CueFileError, read_cues
    from omote.server.persistence.offline_show import open_offline_show
    from omote.show.cues.cue_book import changes_between, take_in_list

    if len(texts) > 1:
        raise ValueError("one list of cues is taken in at a time: the next would take its place")
    try:
        cues = read_cues(texts[0])
    except CueFileError as error:
        for line in str(error).splitlines():
            say(line)
        raise typer.Exit(1) from error
    with open_offline_show(file, new=True) as show:
        before = read_cue_book(show.stored())
        chosen = name or next(iter(before.orders))
        show.apply(changes_between(before, take_in_list(before, chosen, cues, "omote file import")))
    say(f"{file} has the list {chosen}, cues: {len(cues)}.")


def read_cue_book(stored: Stored) -> CueBook:
    """The cues of a show file; ValueError where one of them cannot be read. stored: what the file holds."""
    from omote.show.cues.cue_book import read_book

    book, lost = read_book(lambda kind: stored.documents.get(kind, {}))
    if lost:
        raise ValueError(" ".join(lost))
    return book


def give_out_cues(file: Path, name: str, output: Path, *, force: bool) -> None:
    """Writes a list of cues as text (TOML), or as a running order (CSV).

    file: the show file; name: of the list, "" for its first; output: what to write; force: whether a file there is
    replaced.
    """
    from omote.interchange.formats.atomic_file import check_writable, require_free, write_whole
    from omote.interchange.formats.cue_toml import format_cues, format_running_order
    from omote.interchange.formats.file_names import CUES
    from omote.perform.limits import check_known
    from omote.showfile.inspection import inspect_show

    with exit_on_refusal():
        check_writable(output)
        require_free(output, force=force)
        book = read_cue_book(inspect_show(file).stored)
        chosen = check_known(name, book.orders, "list of cues") if name else next(iter(book.orders))
        cues = book.cues_of(chosen)
        if not cues:
            fail(f"{file} has no cues in the list {chosen}.")
        text = format_cues(cues) if output.suffix.lower() == CUES else format_running_order(cues)
        write_whole(output, text.encode())
    say(f"{output} holds the list {chosen}, cues: {len(cues)}.")


@file_app.command()
def forget(
    file: ShowFileArgument,
    names: Annotated[
        list[str], typer.Argument(help="Own faces (omote file list) and all that are made of them; sounds.")
    ],
    copies: Annotated[
        bool, typer.Option("--copies", help="Removes damaged copies beside the file too, where one is in them.")
    ] = False,
) -> None:
    """Removes own faces, with all revisions and drafts, and sounds for good, from the file and from its good copies."""
    from omote.server.persistence.forget_face import forget_faces

    with exit_on_refusal():
        forgotten = forget_faces(file, names, copies=copies)
        for sentence in forgotten.notes:
            say(sentence)
    say(f"{file} has nothing of {', '.join(forgotten.labels)} any more, nor have its good copies.")


def add_items(file: Path, cast: Cast, arrivals: Sequence[ImportedItem], *, keep_both: bool) -> list[str]:
    """Adds items to a show file that no show plays, made where there is none; returns their labels. What resembles
    another item is told.

    cast: the full one; arrivals: the items; keep_both: whether those that are there already are added too.
    """
    from omote.builtin import load_cast
    from omote.edit.store.import_items import changes_to_import, distinguish
    from omote.server.persistence.offline_show import open_offline_show, wall_clock

    with open_offline_show(file, new=True) as show:
        stored = show.stored()
        distinct = distinguish(load_cast(), stored, arrivals if keep_both else drop_known(stored, arrivals))
        show.apply(changes_to_import(cast, stored, [item for item, _ in distinct], wall=wall_clock()))
    for _, twin in distinct:
        if twin:
            say(twin)
    return [item.label for item, _ in distinct]


def drop_known(stored: Stored, arrivals: Sequence[ImportedItem]) -> list[ImportedItem]:
    """The arrivals that are new; of each other one it is said what it is already. stored: what the show file holds."""
    from omote.edit.store.import_items import find_known

    twins = find_known(stored, arrivals)
    for arrival, item in zip(arrivals, twins, strict=True):
        if item is not None:
            where = f"as {item.name} ({item.label})" if item.name else "among what these files bring"
            say(
                f"{arrival.label!r} is there already, exactly the same, {where}: it is not added again; --keep-both "
                "adds a copy."
            )
    return [arrival for arrival, item in zip(arrivals, twins, strict=True) if item is None]


def read_arrivals(
    cast: Cast, things: Sequence[Path], face: str, kind: Literal["expression", "face"], landmarks: Sequence[str]
) -> list[ImportedItem]:
    """What files (things) bring of a kind; each is told as soon as it is read.

    cast, face: what shapes start from; landmarks: words and files of them, of heads of another topology.
    """
    from omote.server.sandbox.import_files import expressions_from, faces_from

    arrivals = []
    brought = (
        faces_from(cast, things, look=face)
        if kind == "face"
        else expressions_from(cast, things, face=face, landmarks=landmarks)
    )
    for arrival, sentence in brought:
        typer.echo(f"omote: {escape_controls(sentence)}", err=True)
        arrivals.append(arrival)
    return arrivals


def read_own_work(file: Path) -> tuple[Stored, Mapping[str, bytes]] | None:
    """What a show file holds that no show plays, None where it will be made; errors of what cannot be one."""
    from omote.server.persistence.offline_show import open_offline_show
    from omote.showfile.identification import require_folder

    require_folder(file)
    if not file.exists():
        return None
    with open_offline_show(file) as show:
        return show.stored(), show.contents()


@file_app.command("export")
def give_out(
    file: ShowFileArgument,
    name: Annotated[
        str,
        typer.Argument(help="The name of an own face or expression (omote file list), one of the cast, a document's."),
    ],
    output: Annotated[Path, typer.Option("--output", "-o", help="What to write: smile.json, or my_face.omote.")],
    force: Annotated[bool, typer.Option("--force", help="Replaces a document that is there.")] = False,
    documents: DocumentsOption = "",
    kind: Annotated[
        Literal["expression", "face"] | None, typer.Option(help="Which goes into a show file, where both are so named.")
    ] = None,
    cue_list: CueListOption = "",
) -> None:
    """Writes an expression as a document that any crew can take in, a stored document as it is (JSON), an own face or
    expression whole, with recipe, look and history, as a show file of its own (.omote), or `cues` as text (.toml) and
    as a running order (.csv)."""
    from omote.interchange.formats.atomic_file import check_writable, require_free, write_whole
    from omote.interchange.formats.file_names import CUES, RUNNING_ORDER, SHOW, check_document_name
    from omote.showfile.inspection import inspect_show
    from omote.stage_data.cast_names import find_exported, read_names

    if output.suffix.lower() == SHOW:
        give_out_whole(file, name, kind, output)
        return
    if output.suffix.lower() in (CUES, RUNNING_ORDER):
        if name != "cues":
            fail(f"{output.suffix} holds a list of cues: write omote file export {file} cues -o {output}.")
        give_out_cues(file, cue_list, output, force=force)
        return
    output = complete_name(output, ".json")
    with exit_on_refusal():
        check_writable(output)
        require_free(output, force=force)
        check_document_name(output)
        inspection = inspect_show(file)
        if documents:
            named = inspection.stored.documents.get(documents, {})
            if name not in named:
                fail(f"{file} has no {documents} {name!r}; there are: {', '.join(sorted(named)) or 'none'}.")
            write_whole(output, named[name])
            typer.echo(f"omote: {output} holds {name}.", err=True)
            return
        if (names := read_names()) is not None:
            find_exported(names, inspection.stored, name)
        from omote.builtin import load_cast  # what is heavy comes after what can be refused without it
        from omote.edit.store.import_items import export_document
        from omote.interchange.formats.expression_json import encode

        write_whole(output, encode(export_document(load_cast(), inspection.stored, inspection.contents, name)))
    typer.echo(f"omote: {output} holds {name}.", err=True)


def give_out_whole(file: Path, name: str, kind: Literal["expression", "face"] | None, output: Path) -> None:
    """Writes an own face or expression as a show file of its own.

    file: the show file that has it; name: as a person types it; kind: where both are so named; output: a new file.
    """
    from omote.edit.store.whole_items import whole_item
    from omote.interchange.formats.atomic_file import check_writable
    from omote.showfile.inspection import inspect_show, item_named, revisions_of
    from omote.showfile.show_file import write_new_show

    if output.is_file():
        fail(
            f"{output} is there already, and a show file is never written over: give another name, or delete it first."
        )
    with exit_on_refusal():
        check_writable(output)
        inspection = inspect_show(file)
        item = item_named(inspection.stored, name, kind)
        write_new_show(output, whole_item(inspection.stored, inspection.contents, item))
    count = len(revisions_of(inspection.stored, item))
    say(f"{output} holds the {item.kind} {item.name} whole, revisions: {count}.")


def format_time(seconds: float) -> str:
    """Formats a time (seconds since 1970) as local date and time; "?" for one out of range."""
    try:
        return time.strftime("%Y-%m-%d %H:%M:%S", time.localtime(seconds))
    except (OverflowError, ValueError, OSError):
        return "?"


def print_rows(rows: list[dict[str, Any]], *, json: bool, none: str) -> None:
    """Prints rows as a table, or as JSON; a sentence where there are none.

    json: whether as JSON; none: that sentence.
    """
    if json:
        import msgspec

        typer.echo(msgspec.json.format(msgspec.json.encode(rows), indent=2).decode())
        return
    if not rows:
        typer.echo(none)
        return
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    table = Table(box=None, pad_edge=False)
    for heading in rows[0]:
        table.add_column(heading, no_wrap=True)
    for row in rows:
        table.add_row(*(Text("yes" if value is True else escape_controls(str(value or ""))) for value in row.values()))
    # Every column as wide as its longest word: what is to be typed is never cut; a narrow terminal breaks the lines.
    Console(width=WIDEST).print(table)
