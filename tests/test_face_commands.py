"""`omote face`: sure fits are stored, doubtful ones only if asked, and what fails stops no other scan."""

import csv
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from typer.testing import CliRunner

from omote.builtin import load_cast
from omote.builtin.own_face import NoFaceError
from omote.cli import app
from omote.face_commands import EXPRESSIONS
from omote.interchange import scan_face
from omote.interchange.formats.png import read_png
from omote.model.cast import Look
from omote.model.fitting.doubt import EYES, PLACE, Doubt
from omote.model.fitting.find_head import HeadPlacement
from omote.model.fitting.fit_face import Fit
from omote.model.space.face import Face
from omote.server.headless import people_table
from omote.server.headless.devtools import BrowserError
from omote.showfile.contents import unpack_face
from omote.showfile.inspection import Inspection, inspect_show
from tests.interchange.scans import scan_samples as samples
from tests.server.sandbox.test_scan_faces import double

drawn: list[tuple[Path, list[str], str]] = []
"""What a browser was asked to draw: where to, who, in which expressions."""


@pytest.fixture
def doubts(monkeypatch: pytest.MonkeyPatch) -> list[Doubt]:
    """What the double of `fit_scan` doubts; a scan named `nobody` has no head."""
    found: list[Doubt] = []

    def fit(*_: object, name: str, landmarks: object, **__: object) -> tuple[HeadPlacement, Fit]:
        if name == "nobody":
            raise NoFaceError("there is no head in it", None, ())
        return double(*([] if landmarks else found), face="old" if name == "bo" else "kaori")

    monkeypatch.setattr(scan_face, "fit_scan", fit)
    monkeypatch.setattr(
        people_table,
        "draw_people",
        lambda path, people, worn, _: drawn.append((path, [each.label for each in people], worn)),
    )
    drawn.clear()
    return found


def scan(folder: Path, name: str) -> Path:
    """A scan in a file."""
    path = folder / name
    path.write_bytes(samples.write_ply())
    return path


def said(*arguments: object, status: int = 0, columns: int = 160) -> str:
    """What the command prints."""
    result = CliRunner().invoke(app, ["face", *map(str, arguments)], env={"COLUMNS": str(columns)})
    assert result.exit_code == status, result.output
    return result.output


def kept(show: Path) -> Inspection:
    """What is in a show file."""
    return inspect_show(show)


def test_a_face_is_stored_with_where_it_came_from(tmp_path: Path, doubts: list[Doubt]) -> None:
    show = tmp_path / "a.omote"
    text = said(scan(tmp_path, "a.ply"), "-o", show, "--name", "Ann", "--look", "dog")
    assert "a.ply: 0.25 mm from the scan" in text
    assert "added to" in text
    assert "'Ann'." in text
    found = kept(show)
    (item,) = found.stored.items
    (revision,) = found.stored.revisions
    assert (item.kind, item.label, revision.note) == ("face", "Ann", "from a.ply")
    face, look = unpack_face(found.contents[revision.content], "Ann")
    assert look == load_cast().looks["dog"]
    assert (face.positions == load_cast().faces["kaori"].positions).all()


def test_what_is_doubtful_is_stored_only_if_asked(tmp_path: Path, doubts: list[Doubt]) -> None:
    doubts.append(Doubt("The head is strange."))
    show = tmp_path / "a.omote"
    path = scan(tmp_path, "a.ply")
    text = said(path, "-o", show, status=1)
    assert "The head is strange." in text
    assert "--landmarks nose_tip=" in text
    assert "--accept stores it" in text
    assert not show.exists()
    assert "added to" in said(path, "-o", show, "--accept")
    assert len(kept(show).stored.items) == 1


def test_where_no_face_was_fitted_there_is_none_to_accept(tmp_path: Path, doubts: list[Doubt]) -> None:
    text = said(scan(tmp_path, "nobody.ply"), "-o", tmp_path / "a.omote", "--accept", status=1)
    assert "there is none that --accept could store" in text
    assert not (tmp_path / "a.omote").exists()


def test_landmarks_take_a_doubt_away(tmp_path: Path, doubts: list[Doubt]) -> None:
    doubts.append(Doubt("Where is it?", PLACE))
    points = [f"--landmarks={name}=1,2,3" for name in ("nose_tip", "mouth_left", "mouth_right")]
    assert "added to" in said(scan(tmp_path, "a.ply"), "-o", tmp_path / "a.omote", *points)
    (tmp_path / "points.json").write_text('{"b.ply": {"nose_tip": [1, 2, 3]}}')
    both = (scan(tmp_path, "b.ply"), scan(tmp_path, "c.ply"))
    text = said(*both, "-o", tmp_path / "b.omote", "--landmarks", tmp_path / "points.json", status=1)
    assert "c.ply: Where is it?" in text
    assert "b.ply: Where is it?" not in text


def test_several_scans_make_a_table_and_one_that_fails_stops_no_other(tmp_path: Path, doubts: list[Doubt]) -> None:
    (tmp_path / "text.ply").write_bytes(b"hello")
    paths = [scan(tmp_path, "ann.ply"), scan(tmp_path, "nobody.ply"), tmp_path / "text.ply", scan(tmp_path, "bo.obj")]
    show = tmp_path / "a.omote"
    folder = tmp_path / "report"
    text = said(*paths, "-o", show, "--report", folder, status=1)
    assert "nobody.ply: there is no head in it" in text
    assert "text.ply: the file is no PLY, but text" in text
    assert [item.label for item in kept(show).stored.items] == ["ann", "bo"]
    rows = list(csv.DictReader((folder / "scans.csv").read_text().splitlines()))
    assert [(row["scan"], row["state"]) for row in rows] == [
        ("ann.ply", "good"), ("nobody.ply", "failed"), ("text.ply", "failed"), ("bo.obj", "good"),
    ]  # fmt: skip
    assert "there is no head in it" in rows[1]["what"]
    assert [(path, people) for path, people, _ in drawn] == [(folder / "people.png", ["ann", "bo"])]
    assert read_png((folder / "scans.png").read_bytes()).shape[2] == 3
    assert "MeshLab" in text, "a head that is not found is shown by points"


def test_the_table_of_many_scans_fits_a_terminal_and_whole_sentences_come_once_below_it(
    tmp_path: Path, doubts: list[Doubt]
) -> None:
    doubts += [Doubt(f"Doubt {number} is a sentence {'as long as they are ' * 5}.") for number in range(3)]
    text = said(scan(tmp_path, "ann.ply"), scan(tmp_path, "nobody.ply"), "--report", tmp_path / "r", status=1)
    table = [line for line in text.splitlines() if not line.startswith("omote: ")]
    assert [line.split()[:3] for line in table[1:]] == [
        ["ann.ply", "ann", "doubtful"],
        ["nobody.ply", "nobody", "failed"],
    ]
    assert max(map(len, table)) <= 80
    assert [text.count(doubt) for doubt in doubts] == [1, 1, 1]
    assert text.index(doubts[0]) > text.index(table[-1])


def test_a_scan_that_could_not_be_read_gets_no_advice_on_points(tmp_path: Path, doubts: list[Doubt]) -> None:
    (tmp_path / "text.ply").write_bytes(b"hello")
    assert "MeshLab" not in said(tmp_path / "text.ply", "--report", tmp_path / "r", status=1)


def test_hair_that_was_chosen_for_a_scan_is_told_and_another_is_chosen(tmp_path: Path, doubts: list[Doubt]) -> None:
    plain = scan(tmp_path, "a.ply")
    show = tmp_path / "a.omote"
    assert "it shows no colours, so it gets short hair; --hair chooses another" in said(plain, "-o", show)
    for hair, style in (("bob", "bob"), ("none", "")):
        assert "--hair" not in said(plain, "-o", show, "--hair", hair, "--keep-both")
        found = kept(show)
        _, look = unpack_face(found.contents[found.stored.revisions[-1].content], "a")
        assert (look.hair_style, look.scalp) == (style, 1.0 if style else 0.0)
    helped = said("--help", columns=240)
    assert all(style in helped for style in (*load_cast().hair, "none"))


def test_people_of_a_report_wear_what_is_asked_for(
    tmp_path: Path, doubts: list[Doubt], monkeypatch: pytest.MonkeyPatch
) -> None:
    plain = scan(tmp_path, "a.ply")
    said(plain, "--report", tmp_path / "r")
    said(plain, "--report", tmp_path / "r", "--expressions", "smile,joy")
    said(plain, "--report", tmp_path / "r", "--expressions", "none")
    assert [worn for _, _, worn in drawn] == [EXPRESSIONS, "smile,joy"]

    def refuse(*_: object) -> None:
        raise BrowserError("there is no browser")

    monkeypatch.setattr(people_table, "draw_people", refuse)
    assert "people.png is not drawn: there is no browser" in said(plain, "--report", tmp_path / "r")


def test_a_report_alone_stores_nothing(tmp_path: Path, doubts: list[Doubt]) -> None:
    said(scan(tmp_path, "a.ply"), "--report", tmp_path / "report")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.ply", "report"]


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["a.ply"], "say where the faces go"),
        (["a.ply", "b.ply", "-o", "x.omote", "--name", "Ann"], "is of one face, and 2 scans are given"),
        (["a.ply", "b.ply", "-o", "x.omote", "--landmarks", "nose_tip=1,2,3"], "landmarks on the line are of one scan"),
        (["a.ply", "-o", "b.ply.new"], "b.ply.new does not end as a show file does; write -o b.ply.omote"),
        (["a.ply", "-o", "x.omote", "--hair", "wig"], "there is no hair 'wig'; choose one of bob, bowl, bun, crop"),
        (["a.ply", "--report", "r", "--expressions", "neutral,grin"], "grin"),
        (["gone.ply", "-o", "x.omote"], "there is no file gone.ply"),
        (["a.ply", "-o", "x.omote", "--landmarks", "nose=1,2,3"], "is no landmark; expected one of"),
        (["a.ply", "-o", "x.omote", "--landmarks", "nose_tip=1,2,3"], "1 landmarks are given; expected at least 3"),
        (["a.ply", "-o", "x.omote", "--landmarks", "gone.json"], "there is no file of landmarks gone.json"),
        (["a.ply", "-o", "x.omote", "--look", "nobody"], "nobody"),
    ],
)
def test_what_cannot_be_meant_is_refused(
    arguments: list[str], sentence: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, doubts: list[Doubt]
) -> None:
    monkeypatch.chdir(tmp_path)
    scan(tmp_path, "a.ply")
    scan(tmp_path, "b.ply")
    assert sentence in said(*arguments, status=1)
    assert not (tmp_path / "x.omote").exists()
    assert not (tmp_path / "r").exists()


def test_the_same_scan_is_added_again_only_where_that_is_asked_for(tmp_path: Path, doubts: list[Doubt]) -> None:
    show = tmp_path / "a.omote"
    path = scan(tmp_path, "a.ply")
    said(path, "-o", show)
    again = said(path, "-o", show)
    assert "--keep-both adds a copy" in again
    assert "nothing was added to" in again
    said(path, "-o", show, "--keep-both")
    assert len(kept(show).stored.items) == 2


def test_a_doubt_about_eyes_is_answered_by_an_option_not_by_points(tmp_path: Path, doubts: list[Doubt]) -> None:
    doubts.append(Doubt("Its lids were opened.", EYES))
    text = said(scan(tmp_path, "a.ply"), "-o", tmp_path / "a.omote", status=1)
    assert "--shut says that the eyes of the scan are shut" in text
    assert "MeshLab" not in text


def test_a_report_that_is_a_file_is_refused_before_a_scan_is_read(tmp_path: Path, doubts: list[Doubt]) -> None:
    path = scan(tmp_path, "a.ply")
    text = said(path, "--report", path, status=1)
    assert "is a file; give the name of a folder" in text
    assert "reading" not in text


def test_landmarks_of_other_scans_alone_are_refused_before_a_scan_is_read(tmp_path: Path, doubts: list[Doubt]) -> None:
    (tmp_path / "points.json").write_text('{"b.ply": {"nose_tip": [1, 2, 3]}}')
    show = tmp_path / "a.omote"
    text = said(scan(tmp_path, "a.ply"), "-o", show, "--landmarks", tmp_path / "points.json", status=1)
    assert "the landmarks have none for a.ply; they name b.ply" in text
    assert "reading" not in text
    assert not show.exists()


def test_faces_of_nobody_go_into_a_show_file_under_the_names_that_python_gives_them(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def drawn(count: int, seed: int) -> Iterator[tuple[Face, Look]]:
        kaori = load_cast().faces["kaori"]
        yield from ((replace(kaori, name=f"random_{seed}_{number:03d}"), Look()) for number in range(1, count + 1))

    monkeypatch.setattr("omote.builtin.random_faces.draw_random_faces", drawn)
    show = tmp_path / "a.omote"
    done = CliRunner().invoke(app, ["cast", "--random", "1", "--seed", "3", "-o", str(show)])
    assert done.exit_code == 0, done.output
    assert [(item.name, item.label) for item in kept(show).stored.items] == [("random_3_001", "random_3_001")]


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("--random", "2"), "write omote cast --random 50 --seed 3 -o people.omote"),
        (("--seed", "1"), "add --random COUNT"),
    ],
)
def test_faces_of_nobody_that_cannot_be_are_refused(
    arguments: tuple[str, ...], sentence: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    done = CliRunner().invoke(app, ["cast", *arguments])
    assert done.exit_code == 1
    assert sentence in done.output
    assert list(tmp_path.iterdir()) == []
