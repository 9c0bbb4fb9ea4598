"""The command `omote face`: scans become own faces of a show file; what is doubtful is stored only if asked."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omote.file_commands import drop_known, print_rows, read_own_work
from omote.terminal import complete_show, escape_controls, exit_on_refusal, fail, say

Landmarks = dict[str, tuple[float, float, float]]
SHOW = ".omote"
NO_TABLE = "none"
EXPRESSIONS = "neutral,joy,angry,surprise,eyeBlinkLeft+eyeBlinkRight,jawOpen"
"""At rest, three feelings, eyes shut, jaw open."""

if TYPE_CHECKING:
    from omote.edit.store.import_items import ImportedItem
    from omote.model.cast import Cast, Look
    from omote.model.fitting.doubt import Doubt
    from omote.server.sandbox.scan_fits import ScanFit


@dataclass(frozen=True, eq=False)
class Outcome:
    """What came of a scan: a fit, or why there is none; read: whether the file was, so that only a face is missing."""

    path: Path
    label: str
    fit: ScanFit | None
    trouble: str = ""
    read: bool = True

    @property
    def doubts(self) -> tuple[Doubt, ...]:
        """What should be looked at."""
        return () if self.fit is None else self.fit.doubts

    @property
    def state(self) -> str:
        """What the table and the sheet call it."""
        return "failed" if self.fit is None else "doubtful" if self.doubts else "good"

    @property
    def sentences(self) -> tuple[str, ...]:
        """All that is to be said of it."""
        found = (self.trouble, *self.doubts, *(() if self.fit is None else self.fit.notes))
        return tuple(sentence for sentence in found if sentence)


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
        str, typer.Option(help="Its hair: bob, bun, crop, mop, short, swept, thin or none; else the look's.")
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
        from omote.builtin import load_cast
        from omote.interchange.scan_look import choose_hair
        from omote.server.headless.people_table import check_people
        from omote.stage_data.full_cast import build_full_cast, find_face

        cast = load_cast() if own is None else build_full_cast(load_cast(), *own, say)
        worn = cast.looks[find_face(cast, None if own is None else own[0], look)] if look else None
        style = choose_hair(cast, hair)
        if report is not None and expressions != NO_TABLE:
            check_people(expressions)
        outcomes = [dress(each, worn, style) for each in fit_all(cast, scans, name, landmarks or [], shut)]
        tell(outcomes, accept)
        good = [each for each in outcomes if each.fit is not None and (accept or not each.doubts)]
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
    """Ends the command where the options cannot mean anything, before a scan is read."""
    from omote.interchange.landmark_points import parse_point, require_enough

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
    require_enough(dict(parse_point(word) for word in landmarks if "=" in word))


def fit_all(cast: Cast, scans: list[Path], name: str, landmarks: list[str], shut: bool | None) -> list[Outcome]:
    """Reads and fits each scan; what fails is told and stops no other."""
    from omote.interchange.landmark_points import read_landmarks

    outcomes, points = [], {path: read_landmarks(landmarks, path, scans) for path in scans}
    with shown_progress(len(scans)) as step:
        for number, path in enumerate(scans):
            label = name or path.stem
            step(number, f"{path.name}: reading")
            outcomes.append(fit_one(cast, path, label, points[path], shut, partial(step, number)))
    return outcomes


def fit_one(
    cast: Cast, path: Path, label: str, points: Landmarks, shut: bool | None, step: Callable[[str], None]
) -> Outcome:  # fmt: skip
    """Reads and fits one scan."""
    from omote.server.sandbox.scan_files import read_scan_in_sandbox
    from omote.server.sandbox.scan_fits import fit_in_child

    read = False
    try:
        found = read_scan_in_sandbox(path)
        read = True
        for note in found.notes:
            say(f"{path.name}: {note}.")
        step(f"{path.name}: fitting")
        return Outcome(path, label, fit_in_child(cast, found.scan, name=label, landmarks=points or None, shut=shut))
    except (ValueError, OSError) as error:
        from omote.showfile.database_errors import describe_error

        return Outcome(path, label, None, describe_error(error).removeprefix(f"{path.name}: "), read)


def dress(outcome: Outcome, look: Look | None, hair: str | None) -> Outcome:
    """What came of a scan with the look and the hair that a person chose; says which hair was chosen for them."""
    from omote.model.appearance.look_suggestion import wear_hair

    fit = outcome.fit
    if fit is None:
        return outcome
    worn = look or fit.look
    if hair is not None:
        worn = wear_hair(worn, hair)
    elif look is None and worn.albedo is None and worn.hair_style:
        note = f"it shows no colours, so it gets {worn.hair_style} hair; --hair chooses another, or none"
        fit = replace(fit, notes=(*fit.notes, note))
    return replace(outcome, fit=replace(fit, look=worn))


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


def tell(outcomes: list[Outcome], accept: bool) -> None:
    """Says what came of the scans: sentences, below a table for several."""
    if len(outcomes) > 1:
        print_rows([row_of(each) for each in outcomes], json=False, none="")
    for each in outcomes:
        if each.fit is not None and len(outcomes) == 1:
            say(f"{each.path.name}: {each.fit.describe()}.")
        for sentence in each.sentences:
            say(f"{each.path.name}: {sentence}")
    advise(outcomes, accept)
    if any(each.doubts for each in outcomes) and not accept:
        say("What is doubtful is not stored; --accept stores it as it is.")


def advise(outcomes: list[Outcome], accept: bool) -> None:
    """Says what ends the doubts."""
    from omote.interchange.landmark_points import explain_landmarks
    from omote.model.fitting.doubt import EYES

    asked = {doubt.kind for each in outcomes for doubt in each.doubts if not accept}
    if EYES in asked:
        say("--shut says that the eyes of the scan are shut, --open that they are not.")
    if asked - {EYES} or any(each.fit is None and each.read for each in outcomes):
        say(explain_landmarks(accepted=accept))


def row_of(outcome: Outcome) -> dict[str, object]:
    """What a table says of a scan: in how many millimetres half of the face lies, and 95 of 100 points."""
    from omote.interchange.fit_report import describe_distances

    near = ("", "") if outcome.fit is None else describe_distances(outcome.fit.residual)
    found: dict[str, object] = {"scan": outcome.path.name, "face": outcome.label, "state": outcome.state}
    return found | {"median mm": near[0], "95 % mm": near[1]}


def items_of(outcomes: list[Outcome]) -> list[ImportedItem]:
    """The fitted faces as items that a show file can keep."""
    from omote.edit.store.import_items import ImportedItem

    return [
        ImportedItem(each.label, (each.fit.face, each.fit.look), note=f"from {each.path.name}"[:200])
        for each in outcomes
        if each.fit is not None
    ]


def store(output: Path, cast: Cast, good: list[Outcome], *, keep_both: bool) -> None:
    """Stores faces as items of a show file, as `omote file import --as face` does."""
    from omote.builtin import load_cast
    from omote.edit.store.import_items import changes_to_import, distinguish
    from omote.server.persistence.offline_show import open_offline_show, wall_clock

    arrivals = items_of(good)
    with open_offline_show(output, new=True) as show:
        stored = show.stored()
        distinct = distinguish(load_cast(), stored, arrivals if keep_both else drop_known(stored, arrivals))
        show.apply(changes_to_import(cast, stored, [each for each, _ in distinct], wall=wall_clock()))
    for _, twin in distinct:
        if twin:
            say(twin)
    names = ", ".join(repr(each.label) for each, _ in distinct)
    say(f"added to {output}: {names}." if names else f"nothing was added to {output}.")


def write_report(folder: Path, cast: Cast, outcomes: list[Outcome]) -> None:
    """Writes a table of all scans and a sheet of pictures of them."""
    from omote.interchange.fit_report import SheetRow, contact_sheet, table_of
    from omote.interchange.formats.atomic_file import write_whole
    from omote.interchange.formats.png import png_bytes

    folder.mkdir(parents=True, exist_ok=True)
    write_whole(
        folder / "scans.csv", table_of([row_of(each) | {"what": " ".join(each.sentences)} for each in outcomes])
    )
    rows = [
        SheetRow(each.label, each.state, *(() if each.fit is None else (each.fit.face.positions, each.fit.residual)))
        for each in outcomes
    ]
    write_whole(folder / "scans.png", png_bytes(contact_sheet(cast.space.triangles, rows)))
    fitted = sum(each.fit is not None for each in outcomes)
    say(f"{folder} has scans.csv and scans.png: {fitted} of {len(outcomes)} were fitted.")


def write_people(path: Path, outcomes: list[Outcome], expressions: str) -> None:
    """Draws all people that were fitted by expressions; says why not where no browser is there to draw them."""
    from omote.server.headless.devtools import BrowserError
    from omote.server.headless.people_table import draw_people

    people = items_of(outcomes)
    if not people or expressions == NO_TABLE:
        return
    try:
        draw_people(path, people, expressions, lambda drawn: say(f"{path.name}: {drawn} of {len(people)} drawn"))
    except (BrowserError, FileNotFoundError) as error:
        say(f"{path.name} is not drawn: {error}")
