"""The command `omote face`: scans become own faces of a show file; what is doubtful is stored only if asked.

And faces of nobody (`omote cast --random`), which are stored alike.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omote.file_commands import add_items, print_rows, read_own_work
from omote.model.known_names import GENERIC
from omote.terminal import complete_show, escape_controls, exit_on_refusal, fail, say

Landmarks = dict[str, tuple[float, float, float]]
SHOW = ".omote"
NO_TABLE = "none"
EXPRESSIONS = "neutral,joy,angry,surprise,eyeBlinkLeft+eyeBlinkRight,jawOpen"
"""At rest, three feelings, eyes shut, jaw open."""

if TYPE_CHECKING:
    from omote.edit.store.import_items import ImportedItem
    from omote.interchange.scan_face import ScanFace
    from omote.model.cast import Cast, Look
    from omote.model.fitting.doubt import Doubt
    from omote.showfile.changes import Stored


@dataclass(frozen=True, eq=False)
class ScanOutcome:
    """What came of a scan: what was made of it, None where no face was; trouble: why not; read: whether the file was,
    so that only a face is missing."""

    path: Path
    label: str
    made: ScanFace | None
    trouble: str = ""
    read: bool = True

    @property
    def doubts(self) -> tuple[Doubt, ...]:
        """What should be looked at."""
        return () if self.made is None else self.made.doubts

    @property
    def state(self) -> str:
        """What the table and the sheet call it."""
        return "failed" if self.made is None else "doubtful" if self.doubts else "good"

    @property
    def sentences(self) -> tuple[str, ...]:
        """All that is to be said of it."""
        said = (self.trouble, *self.doubts, *(() if self.made is None else self.made.notes))
        return tuple(sentence for sentence in said if sentence)


def face(
    scans: Annotated[
        list[Path], typer.Argument(help="Scans or meshes of heads: .ply, .obj, .stl, .glb, .vrm, .xyz and others.")
    ],
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", callback=complete_show, help="The show file (.omote) that gets the faces."),
    ] = None,
    name: Annotated[str, typer.Option(help="What the face is called; else as its file.")] = "",
    landmarks: Annotated[
        list[str] | None, typer.Option(help="Where a point is, nose_tip=x,y,z, again for each; or a JSON file of them.")
    ] = None,
    look: Annotated[str, typer.Option(help="A face of the cast whose colours and hair it gets; else the scan's.")] = "",
    hair: Annotated[
        str,
        typer.Option(
            help="Its hair: bob, bowl, bun, crop, long, mop, pigtails, pixie, ponytail, quiff, short, swept, "
            "thin, waves, wreath or none; else the look's."
        ),
    ] = "",
    shut: Annotated[
        bool | None, typer.Option("--shut/--open", help="Whether the eyes of the scans are shut; else it is seen.")
    ] = None,
    accept: Annotated[bool, typer.Option("--accept", help="Store faces in spite of doubts.")] = False,
    keep_both: Annotated[
        bool, typer.Option("--keep-both", help="Adds a copy of what is there already, exactly the same.")
    ] = False,
    report: Annotated[
        Path | None, typer.Option(help="A folder for a table and pictures of how far each face is from its scan.")
    ] = None,
    expressions: Annotated[
        str, typer.Option(help="What the people of a report wear, by commas; none: no such picture.")
    ] = EXPRESSIONS,
) -> None:
    """Makes faces of scans: found, fitted to our head, stored in a show file that no show plays.

    Scans are read on this machine alone, and are not stored: only the face is.
    """
    with exit_on_refusal():
        check_request(scans, output, name, landmarks or [], report)
        own = None if output is None else read_own_work(output)
        check_names(own and own[0], look, hair, NO_TABLE if report is None else expressions)
        from omote.builtin import load_cast
        from omote.interchange.name_choices import choose_hair
        from omote.server.headless.people_table import check_people
        from omote.stage_data.full_cast import build_full_cast, find_face

        cast = load_cast() if own is None else build_full_cast(load_cast(), *own, say)
        worn = cast.looks[find_face(cast, None if own is None else own[0], look)] if look else None
        style = choose_hair(cast.hair, hair)
        if report is not None and expressions != NO_TABLE:
            check_people(expressions)
        outcomes = [dress(outcome, worn, style) for outcome in fit_all(cast, scans, name, landmarks or [], shut)]
        tell(outcomes, accept)
        good = [outcome for outcome in outcomes if outcome.made is not None and (accept or not outcome.doubts)]
        if output is not None and good:
            store(output, cast, good, keep_both=keep_both)
        if report is not None:
            write_report(report, cast, outcomes)
            write_people(report / "people.png", outcomes, expressions)
    if len(good) < len(outcomes):
        raise typer.Exit(1)


def check_request(
    scans: list[Path], output: Path | None, name: str, landmarks: list[str], report: Path | None
) -> None:  # fmt: skip
    """Ends the command where the options cannot mean anything, before a scan is read.

    scans, output, name, landmarks, report: as the command has them.
    """
    if output is not None and output.suffix.lower() != SHOW and not output.exists():
        fail(f"{output} does not end as a show file does; write -o {output.with_suffix(SHOW)}.")
    if report is not None and report.exists() and not report.is_dir():
        fail(f"{report} is a file; give the name of a folder for the report.")
    if output is None and report is None:
        fail("say where the faces go: -o show.omote, or --report FOLDER to try what the scans are like.")
    if len(scans) > 1 and name:
        fail(
            f"--name {name} is of one face, and {len(scans)} scans are given; leave it out: each is called as its file."
        )
    if len(scans) > 1 and any("=" in word for word in landmarks):
        fail("landmarks on the line are of one scan; give a JSON file of them by the names of the scans.")
    missing = [path for path in scans if not path.exists()]
    if missing:
        fail(f"there is no file {missing[0]}; name scans that are there.")
    if landmarks:
        from omote.interchange.landmark_points import parse_point, require_enough

        require_enough(dict(parse_point(word) for word in landmarks if "=" in word))


def check_names(stored: Stored | None, look: str, hair: str, expressions: str) -> None:
    """Rejects, by ValueError, a face, a hair or an expression that is none, before the cast is loaded.

    stored: what the show file lists; look, hair, expressions: as the command has them.
    """
    from omote.interchange.name_choices import choose_hair
    from omote.stage_data.cast_names import read_names

    if (names := read_names(stored)) is None:
        return
    choose_hair(names.hair, hair)
    if look:
        names.find_face(look)
    if expressions != NO_TABLE:
        from omote.stage_data import picture_request

        table = picture_request.GridRequest(faces=GENERIC, expressions=expressions)
        picture_request.check_names(table, names)


def fit_all(cast: Cast, scans: list[Path], name: str, landmarks: list[str], shut: bool | None) -> list[ScanOutcome]:
    """Reads and fits each scan; what fails is told and stops no other.

    cast: the built-in one; scans: files; name: of the only face, "" for those of the files; landmarks: words and files
    of them; shut: whether eyes are, None: look.
    """
    from omote.interchange.landmark_points import read_landmarks

    outcomes = []
    points = {path: read_landmarks(landmarks, path, scans) for path in scans}
    with shown_progress(len(scans)) as step:
        for number, path in enumerate(scans):
            label = name or path.stem
            step(number, f"{path.name}: reading")
            outcomes.append(fit_one(cast, path, label, points[path], shut, partial(step, number)))
    return outcomes


def fit_one(
    cast: Cast, path: Path, label: str, points: Landmarks, shut: bool | None, step: Callable[[str], None]
) -> ScanOutcome:  # fmt: skip
    """Reads and fits one scan.

    cast: the built-in one; path: the scan; label: the face's name; points: landmarks (3,) by name; shut: whether eyes
    are, None: look; step: told what is done.
    """
    from omote.server.sandbox.scan_faces import fit_in_child
    from omote.server.sandbox.scan_files import read_scan_in_sandbox

    read = False
    try:
        scan_file = read_scan_in_sandbox(path)
        read = True
        for note in scan_file.notes:
            say(f"{path.name}: {note}.")
        step(f"{path.name}: fitting")
        made = fit_in_child(cast, scan_file.scan, name=label, landmarks=points, shut=shut)
        return ScanOutcome(path, label, made if made.fit else None, made.failure)
    except (ValueError, OSError) as error:
        from omote.showfile.database_errors import describe_error

        return ScanOutcome(path, label, None, describe_error(error).removeprefix(f"{path.name}: "), read)


def dress(outcome: ScanOutcome, look: Look | None, hair: str | None) -> ScanOutcome:
    """What came of a scan with the look and the hair that a person chose; says which hair was chosen for them.

    outcome: of a scan; look: None for the scan's; hair: a style, "" for none, None for the look's.
    """
    from omote.model.appearance.look_suggestion import wear_hair

    made = outcome.made
    if made is None or made.look is None:
        return outcome
    worn = look or made.look
    if hair is not None:
        worn = wear_hair(worn, hair)
    elif look is None and worn.albedo is None and worn.hair_style:
        note = f"it shows no colours, so it gets {worn.hair_style} hair; --hair chooses another, or none"
        made = replace(made, notes=(*made.notes, note))
    return replace(outcome, made=replace(made, look=worn))


@contextmanager
def shown_progress(count: int) -> Iterator[Callable[[int, str], None]]:
    """Shows which scan is worked at: a bar on a terminal, else a line for each step."""
    if not sys.stderr.isatty():
        yield lambda number, what: say(f"{number + 1} of {count}: {what}")
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

    columns = SpinnerColumn(), TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn()
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("", total=count)
        yield lambda number, what: bar.update(task, completed=number, description=escape_controls(what))


def tell(outcomes: list[ScanOutcome], accept: bool) -> None:
    """Says what came of the scans: sentences, below a table for several.

    outcomes: of all scans; accept: whether doubtful faces are stored.
    """
    if len(outcomes) > 1:
        print_rows([row_of(outcome) for outcome in outcomes], json=False, none="")
    for outcome in outcomes:
        if outcome.made is not None and len(outcomes) == 1:
            say(f"{outcome.path.name}: {outcome.made.describe()}.")
        for sentence in outcome.sentences:
            say(f"{outcome.path.name}: {sentence}")
    advise(outcomes, accept)
    if any(outcome.doubts for outcome in outcomes) and not accept:
        say("What is doubtful is not stored; --accept stores it as it is.")


def advise(outcomes: list[ScanOutcome], accept: bool) -> None:
    """Says what ends the doubts.

    outcomes: of all scans; accept: whether doubtful faces are stored.
    """
    from omote.interchange.landmark_points import explain_landmarks
    from omote.model.fitting.doubt import EYES

    asked = {doubt.kind for outcome in outcomes for doubt in outcome.doubts if not accept}
    if EYES in asked:
        say("--shut says that the eyes of the scan are shut, --open that they are not.")
    if asked - {EYES} or any(outcome.made is None and outcome.read for outcome in outcomes):
        say(explain_landmarks(accepted=accept))


def row_of(outcome: ScanOutcome) -> dict[str, object]:
    """What a table says of a scan: in how many millimetres half of the face lies, and 95 of 100 points."""
    from omote.interchange.fit_report import describe_distances

    near = ("", "") if outcome.made is None else describe_distances(outcome.made.residual)
    row: dict[str, object] = {"scan": outcome.path.name, "face": outcome.label, "state": outcome.state}
    return row | {"median mm": near[0], "95 % mm": near[1]}


def items_of(outcomes: list[ScanOutcome]) -> list[ImportedItem]:
    """The fitted faces as items that a show file can keep."""
    from omote.edit.store.import_items import ImportedItem

    return [
        ImportedItem(outcome.label, outcome.made.worn, note=f"from {outcome.path.name}"[:200])
        for outcome in outcomes
        if outcome.made is not None
    ]


def store(output: Path, cast: Cast, good: list[ScanOutcome], *, keep_both: bool) -> None:
    """Stores faces as items of a show file, as `omote file import --as face` does.

    output: the show file; cast: with its own work; good: what is stored; keep_both: whether copies of what is there are
    added.
    """
    tell_added(output, add_items(output, cast, items_of(good), keep_both=keep_both))


def tell_added(output: Path, labels: list[str]) -> None:
    """Says which faces a show file got.

    output: the show file; labels: of what was added.
    """
    added = ", ".join(map(repr, labels))
    say(f"added to {output}: {added}." if added else f"nothing was added to {output}.")


def draw_random(output: Path | None, count: int, seed: int, *, json: bool) -> None:
    """Draws new faces of nobody and stores them in a show file that no show plays.

    output: the show file, None where none is named; count: how many; seed: which; json: whether that was asked for.
    """
    if output is None or json:
        fail("new faces go into a show file; write omote cast --random 50 --seed 3 -o people.omote.")
    if output.suffix.lower() != SHOW and not output.exists():
        fail(f"{output} does not end as a show file does; write -o {output.with_suffix(SHOW)}.")
    with exit_on_refusal():
        read_own_work(output)
        from omote.builtin import load_cast
        from omote.builtin.random_faces import draw_random_faces
        from omote.edit.store.import_items import ImportedItem

        people = []
        with shown_progress(count) as step:
            step(0, "the first")
            for number, (face, look) in enumerate(draw_random_faces(count, seed), start=1):
                people.append(ImportedItem(face.name, (face, look), note=f"drawn at random, seed {seed}"))
                step(number - 1, face.name)
        tell_added(output, add_items(output, load_cast(), people, keep_both=False))


def write_report(folder: Path, cast: Cast, outcomes: list[ScanOutcome]) -> None:
    """Writes a table of all scans and a sheet of pictures of them.

    folder: that gets it; cast: the built-in one; outcomes: of all scans.
    """
    from omote.interchange.fit_report import SheetRow, contact_sheet, table_of
    from omote.interchange.formats.atomic_file import write_whole
    from omote.interchange.formats.png import png_bytes

    folder.mkdir(parents=True, exist_ok=True)
    write_whole(
        folder / "scans.csv",
        table_of([row_of(outcome) | {"what": " ".join(outcome.sentences)} for outcome in outcomes]),
    )
    rows = [
        SheetRow(
            outcome.label, outcome.state,
            *(() if outcome.made is None else (outcome.made.worn[0].positions, outcome.made.residual)),
        )
        for outcome in outcomes
    ]  # fmt: skip
    write_whole(folder / "scans.png", png_bytes(contact_sheet(cast.space.triangles, rows)))
    fitted = sum(outcome.made is not None for outcome in outcomes)
    say(f"{folder} has scans.csv and scans.png: {fitted} of {len(outcomes)} were fitted.")


def write_people(path: Path, outcomes: list[ScanOutcome], expressions: str) -> None:
    """Draws all people that were fitted by expressions; says why not where no browser is there to draw them.

    path: of the picture; outcomes: of all scans; expressions: names by commas.
    """
    from omote.server.headless.devtools import BrowserError
    from omote.server.headless.people_table import draw_people

    people = items_of(outcomes)
    if not people or expressions == NO_TABLE:
        return
    try:
        draw_people(path, people, expressions, lambda drawn: say(f"{path.name}: {drawn} of {len(people)} drawn"))
    except (BrowserError, FileNotFoundError) as error:
        say(f"{path.name} is not drawn: {error}")
