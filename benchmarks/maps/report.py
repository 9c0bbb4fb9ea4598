"""The tables of a run: on the terminal, and as Markdown between two marks in docs/transfer.md."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.table import Table

from benchmarks.maps.bars import Faces, Run, Verdict, at_most, new_folds, per_hundred, rough, slow
from benchmarks.maps.figures import Figures, Worst
from benchmarks.maps.source import NOT_HUMAN
from benchmarks.maps.sums import SEEN

BEGIN = "<!-- figures: begin -->"
END = "<!-- figures: end -->"

Row = Sequence[str]
METHOD_HEAD = (
    "map", "folds per 100, people", "all", "folds per triple", "lids mean", "along", "lips mean", "along",
    "eyes, mm (95 %)", "teeth, mm", "bag, mm", "sockets, mm", "rough", "ms",
    "p95",
)  # fmt: skip
FACE_HEAD = (
    "face", "folds per 100", "per triple", "lids", "lips", "eyes, mm", "teeth, mm", "bag, mm", "sockets, mm", "rough",
    "ms p95",
)  # fmt: skip
SUM_HEAD = (
    "map", "folds per triple", "of these new", "lids and lips cross, mm", "triples that do, %", "eyes, mm",
)  # fmt: skip
BAR_HEAD = ("bar", "found", "allowed", "where", "met")


def method_rows(run: Run, triples: int) -> list[Row]:
    """One row a map, the worst face named where one figure is a face's."""
    return [(method, *_method_cells(faces, triples)) for method, faces in run.items()]


def _method_cells(faces: Faces, triples: int) -> Row:
    people = {name: figures for name, figures in faces.items() if name not in NOT_HUMAN}
    times = [time for figures in faces.values() for time in figures.times]
    most = max(figures.eyes_most.value for figures in faces.values())
    return (
        f"{per_hundred(people):.1f}",
        f"{per_hundred(faces):.1f}",
        f"{sum(f.sums.folds for f in faces.values()) / triples / len(faces):.2f}",
        _at_worst(faces, lambda f: f.lids[0], ".3f"),
        f"{max(f.lids[1].value for f in faces.values()):.3f}",
        _at_worst(faces, lambda f: f.lips[0], ".3f"),
        f"{max(f.lips[1].value for f in faces.values()):.3f}",
        f"{_at_worst(faces, lambda f: f.eyes, '.2f', 1e3)} ({1e3 * most:.2f})",
        f"{1e3 * max(f.teeth.value for f in faces.values()):.2f}",
        f"{1e3 * max(f.bag.value for f in faces.values()):.2f}",
        f"{1e3 * max(f.sockets.value for f in faces.values()):.2f}",
        f"{rough(faces):.3f}",
        f"{1e3 * float(np.mean(times)):.2f}",
        f"{1e3 * slow(faces):.2f}",
    )


def _at_worst(faces: Faces, of: Callable[[Figures], Worst], form: str, scale: float = 1.0) -> str:
    name = max(faces, key=lambda face: of(faces[face]).value)
    return f"{scale * of(faces[name]).value:{form}} {name}"


def face_rows(faces: Faces, triples: int) -> list[Row]:
    """One row a face; those that are no people carry a star."""
    return [
        (
            name + ("*" if name in NOT_HUMAN else ""),
            f"{100 * f.folds / f.units:.1f}",
            f"{f.sums.folds / triples:.2f}",
            f"{f.lids[0].value:.3f} / {f.lids[1].value:.3f}",
            f"{f.lips[0].value:.3f} / {f.lips[1].value:.3f}",
            f"{1e3 * f.eyes.value:.2f}",
            f"{1e3 * f.teeth.value:.2f}",
            f"{1e3 * f.bag.value:.2f}",
            f"{1e3 * f.sockets.value:.2f}",
            f"{f.rough:.3f}",
            f"{1e3 * float(np.quantile(f.times, 0.95)):.2f}",
        )
        for name, f in faces.items()
    ]


def sum_rows(run: Run) -> list[Row]:
    """One row a map: what sums of three do that no summand does alone."""
    return [(method, *_sum_cells(faces)) for method, faces in run.items()]


def _sum_cells(faces: Faces) -> Row:
    crossed = [value for f in faces.values() for value in f.sums.crossed]
    return (
        f"{sum(f.sums.folds for f in faces.values()) / max(sum(f.sums.triples for f in faces.values()), 1):.2f}",
        f"{new_folds(faces):.2f}",
        _at_worst(faces, lambda f: at_most(f.sums.crossed), ".2f", 1e3),
        f"{100 * float(np.mean([value > SEEN for value in crossed])):.1f}",
        _at_worst(faces, lambda f: at_most(f.sums.eyes), ".2f", 1e3),
    )


def bar_rows(found: Sequence[Verdict]) -> list[Row]:
    """One row a bar."""
    return [(bar.name, f"{bar.found:.3g}", f"{bar.bar:.3g}", bar.face, "yes" if bar.met else "**no**") for bar in found]


def show(console: Console, title: str, head: Row, rows: Sequence[Row]) -> None:
    """A table on the terminal."""
    table = Table(title=title, title_justify="left")
    for column, name in enumerate(head):
        table.add_column(name, justify="left" if column == 0 else "right")
    for row in rows:
        table.add_row(*(cell.replace("**no**", "NO") for cell in row))
    console.print(table)


def markdown(head: Row, rows: Sequence[Row]) -> str:
    """A table as Markdown."""
    lines = [head, ["---", *(["---:"] * (len(head) - 1))], *rows]
    return "\n".join("| " + " | ".join(cell.replace("|", "\\|") for cell in line) + " |" for line in lines)


def write_between(page: Path, text: str) -> None:
    """Puts text between the marks of a page. Raises ValueError where it has none."""
    before, begin, rest = page.read_text(encoding="utf-8").partition(BEGIN)
    _, end, after = rest.partition(END)
    if not begin or not end:
        raise ValueError(f"{page} has no line {BEGIN!r} followed by {END!r}; expected both, to write between them")
    page.write_text(f"{before}{begin}\n\n{text}\n\n{end}{after}", encoding="utf-8")
