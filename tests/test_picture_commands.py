"""`omote render`, `grid` and `redraw`, as they are typed; a browser that only speaks stands for the one that draws."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner, Result

from omote.cli import app
from omote.model.cast import Cast
from omote.server.headless.devtools import BrowserError
from omote.server.headless.picture_run import PictureRun, PictureStudio, Progress, write_picture
from omote.showfile.changes import PutContent, PutItem, PutRevision
from omote.showfile.contents import content_key, pack_expression
from omote.showfile.show_file import open_show
from tests.server.synthetic_server import MASK, PAGES, meshes
from tests.showfile.authored_work import item, revision

runner = CliRunner()
RECIPE = b'{"kind":"expression","net":[],"vectors":[]}'


PICTURES = {".png": b"\x89PNG\r\n\x1a\npicture", ".jpg": b"\xff\xd8\xff\xe0picture"}


@pytest.fixture
def small_cast(cast: Cast, monkeypatch: pytest.MonkeyPatch) -> Cast:
    """The synthetic cast in place of the built-in one."""
    for name, made in (("load_cast", cast), ("load_meshes", meshes(cast)), ("load_mask", MASK), ("read_pages", PAGES)):
        monkeypatch.setattr(f"omote.server.headless.picture_run.{name}", lambda made=made: made)
    return cast


@pytest.fixture
def runs(small_cast: Cast, monkeypatch: pytest.MonkeyPatch) -> list[PictureRun]:
    """What would be drawn; every picture is the same small file, written as it would be."""
    asked: list[PictureRun] = []

    def draw(studio: PictureStudio, run: PictureRun, report: Callable[[Progress], None], *, jobs: int) -> None:
        asked.append(run)
        done = len(run.pictures) - len(run.waiting)
        for number, file in enumerate([*run.waiting, *([run.table] if run.table else [])], done + 1):
            file.path.parent.mkdir(exist_ok=True)
            write_picture(file, PICTURES[file.path.suffix])
            if file is not run.table:
                report(Progress(file.path, 0.5, number, len(run.pictures)))

    monkeypatch.setattr("omote.server.headless.picture_run.draw_run", draw)
    return asked


def typed(*words: str, status: int = 0) -> Result:
    """What a command says."""
    done = runner.invoke(app, words)
    assert done.exit_code == status, done.output
    return done


def test_a_picture_is_drawn_as_it_is_asked_for(tmp_path: Path, runs: list[PictureRun]) -> None:
    path = tmp_path / "a.png"
    words = "--expression smile=0.5 --channel jawOpen=0.25 --turn -30,5 --gaze 10 --size 64x48 --light portrait"
    typed("render", "-o", str(path), *words.split(), "--transparent", "--quality", "low")
    assert path.read_bytes() == PICTURES[".png"]
    [run] = runs
    assert (run.setting.width, run.setting.height, run.setting.transparent, run.setting.quality) == (
        64,
        48,
        True,
        "low",
    )
    [[pose]] = run.pictures[0].sheet.poses
    assert pose["expressions"] == {"smile": 0.5, "neutral": 0.5}
    assert pose["light"] == {"portrait": 1.0}
    assert pose["channels"] == {"jawOpen": 0.25}
    assert pose["head"][0] < 0 < pose["head"][1]


def test_names_are_found_however_they_are_written(tmp_path: Path, runs: list[PictureRun]) -> None:
    typed("render", "-o", str(tmp_path / "a.png"), "--expression", "SMILE", "--channel", "jaw open=0.5")
    [[pose]] = runs[0].pictures[0].sheet.poses
    assert pose["expressions"] == {"smile": 1.0}
    assert pose["channels"] == {"jawOpen": 0.5}


def test_a_mix_is_two_faces(tmp_path: Path, small_cast: Cast, runs: list[PictureRun]) -> None:
    one, other = list(small_cast.faces)[:2]
    typed("render", "-o", str(tmp_path / "a.png"), "--face", f"{one}=0.25", "--face", other)
    assert runs[0].pictures[0].sheet.poses[0][0]["faces"] == {one: 0.25, other: 0.75}


def test_a_grid_has_names_or_none_and_its_pictures_beside_it(
    tmp_path: Path, small_cast: Cast, runs: list[PictureRun]
) -> None:
    words = ["grid", "-o", str(tmp_path / "a.jpg"), "--faces", ",".join(small_cast.faces), "--expressions", "smile"]
    typed(*words)
    typed(*words, "--no-labels")
    tables = [run.table.sheet for run in runs if run.table is not None]
    assert [list(sheet.rows) for sheet in tables] == [list(small_cast.faces), []]
    assert {sheet.kind for sheet in tables} == {"image/jpeg"}
    names = {path.name for path in (tmp_path / "a.pictures").iterdir()}
    assert names == {f"{face}-smile.png{end}" for face in small_cast.faces for end in ("", ".json")}


def test_what_is_drawn_is_not_drawn_again(tmp_path: Path, small_cast: Cast, runs: list[PictureRun]) -> None:
    words = ["grid", "-o", str(tmp_path / "a.png"), "--faces", ",".join(small_cast.faces)]
    typed(*words)
    assert "is there already" in typed(*words).stderr
    assert "is there already" in typed(*words).stderr
    typed(*words, "--fresh")
    more = typed(*words, "--expressions", "neutral,smile").stderr
    assert [len(run.waiting) for run in runs] == [3, 3, 3]
    assert "3 of 6 pictures are there already; going on." in more


def test_another_parameter_draws_again_under_the_same_name(tmp_path: Path, runs: list[PictureRun]) -> None:
    words = ["render", "-o", str(tmp_path / "a.png")]
    typed(*words)
    typed(*words, "--turn", "10")
    (tmp_path / "a.png").write_bytes(PICTURES[".png"] + b" of somebody else")
    typed(*words, "--turn", "10")
    assert len(runs) == 3


def test_what_is_no_picture_is_not_replaced_by_one(tmp_path: Path, runs: list[PictureRun]) -> None:
    (tmp_path / "a.png").write_text("a diary")
    assert "no PNG picture" in typed("render", "-o", str(tmp_path / "a.png"), status=1).stderr
    assert runs == []
    assert [path.read_text() for path in tmp_path.iterdir()] == ["a diary"]


def test_a_sidecar_draws_its_picture_again(tmp_path: Path, small_cast: Cast, runs: list[PictureRun]) -> None:
    one, other = list(small_cast.faces)[:2]
    words = ["--morph", f"{one}:{other}:3", "--expressions", "smile", "--light", "flat", "--size", "32x36"]
    typed("grid", "-o", str(tmp_path / "a.png"), *words)
    typed("redraw", str(tmp_path / "a.png.json"))
    typed("redraw", str(tmp_path / "a.png.json"), "-o", str(tmp_path / "b.png"))
    sheets = [run.table.sheet for run in runs if run.table is not None]
    assert sheets == [sheets[0]] * 3
    assert (tmp_path / "b.png.json").read_bytes() == (tmp_path / "a.png.json").read_bytes()
    cell = sorted((tmp_path / "a.pictures").glob("*.json"))[1]
    typed("redraw", str(cell), "-o", str(tmp_path / "c.png"))
    assert runs[-1].pictures[0].sheet.poses == [[sheets[0].poses[0][1]]]


def test_a_sidecar_of_another_cast_says_so(tmp_path: Path, runs: list[PictureRun]) -> None:
    typed("render", "-o", str(tmp_path / "a.png"))
    sidecar = tmp_path / "a.png.json"
    sidecar.write_text(json.dumps(json.loads(sidecar.read_text()) | {"cast": "another"}))
    assert "another cast" in typed("redraw", str(sidecar)).stderr
    assert len(runs) == 2


def test_own_work_of_a_show_is_drawn(tmp_path: Path, small_cast: Cast, runs: list[PictureRun]) -> None:
    data = pack_expression(small_cast.expressions["smile"])
    key = content_key(data)
    show = open_show(tmp_path / "a.omote")
    kept = item(1, name="crooked_smile", label="Crooked smile", head=1)
    show.apply([PutContent(key, data), PutItem(kept), PutRevision(revision(1, 1, content=key, recipe=RECIPE))])
    show.close()
    words = ["render", "-o", str(tmp_path / "a.png"), "--expression", "crooked-smile"]
    assert "no expression 'crooked-smile'" in typed(*words, status=1).stderr
    typed(*words, "--show", str(tmp_path / "a.omote"))
    assert runs[0].pictures[0].sheet.poses[0][0]["expressions"] == {"crooked_smile": 1.0}
    assert json.loads((tmp_path / "a.png.json").read_text())["request"]["show"] == str(tmp_path / "a.omote")


def test_piped_progress_is_plain_lines(tmp_path: Path, small_cast: Cast, runs: list[PictureRun]) -> None:
    said = typed("grid", "-o", str(tmp_path / "a.png"), "--faces", ",".join(small_cast.faces)).stderr.splitlines()
    assert [line.split(":")[1].strip() for line in said[:-1]] == ["1 of 3", "2 of 3", "3 of 3"]
    assert "s left" in said[0]
    assert "left" not in said[2]
    assert said[-1].endswith("a.png: 3 pictures.")
    assert not any("\x1b" in line or "\r" in line for line in said)
    assert len(runs) == 1


def test_a_run_that_is_stopped_says_how_it_goes_on(
    tmp_path: Path, small_cast: Cast, monkeypatch: pytest.MonkeyPatch
) -> None:
    def stopped(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("omote.server.headless.picture_run.draw_run", stopped)
    done = typed("render", "-o", str(tmp_path / "a.png"), "--face", next(iter(small_cast.faces)), status=130)
    assert done.stderr == "omote: stopped; what is drawn stays, and the same command goes on from there.\n"


@pytest.mark.parametrize(
    ("words", "named"),
    [
        ("--face nobody", "no face 'nobody'"),
        ("--expression grin", "no expression 'grin'"),
        ("--light noon", "no light 'noon'"),
        ("--size huge", "the size 'huge'"),
        ("--size 1x1", "1x1 pixels"),
        ("--quality best", "no quality 'best'"),
        ("--turn up", "'up' is no number"),
        ("-o a.gif", "'a.gif' is no name of a picture"),
        ("-o nowhere/a.png", "there is no folder"),
        ("-o a.jpg --transparent", "a JPEG cannot be transparent"),
        ("--show none.omote", "there is no show file none.omote"),
    ],
)
def test_a_picture_that_cannot_be_drawn_is_one_sentence_and_no_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, runs: list[PictureRun], words: str, named: str
) -> None:
    monkeypatch.chdir(tmp_path)
    done = typed("render", *(["-o", "a.png"] if "-o" not in words else []), *words.split(), status=1)
    assert runs == []
    assert named in done.stderr
    assert done.stderr.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("words", [["grid"], ["grid", "--faces", "generic", "--morph", "generic:round:3"]])
def test_a_grid_wants_faces_or_a_morph(tmp_path: Path, runs: list[PictureRun], words: list[str]) -> None:
    assert "one of the two" in typed(*words, "-o", str(tmp_path / "a.png"), status=1).stderr
    assert (runs, list(tmp_path.iterdir())) == ([], [])


@pytest.mark.parametrize(("text", "named"), [("{}", "`omote`"), ('{"format": "gltf"}', "gltf")])
def test_what_is_no_sidecar_is_one_sentence(tmp_path: Path, text: str, named: str) -> None:
    (tmp_path / "a.png.json").write_text(text)
    done = typed("redraw", str(tmp_path / "a.png.json"), status=1)
    assert "is no sidecar of a picture" in done.stderr
    assert named in done.stderr
    assert done.stderr.count("\n") == 1


def test_a_browser_that_does_not_draw_is_one_sentence_and_no_file(
    tmp_path: Path, small_cast: Cast, monkeypatch: pytest.MonkeyPatch
) -> None:
    def missing(*_: Any, **__: Any) -> None:
        raise BrowserError("the browser ended before it had drawn; try again")

    monkeypatch.setattr("omote.server.headless.picture_run.draw_run", missing)
    done = typed("render", "-o", str(tmp_path / "a.png"), "--face", next(iter(small_cast.faces)), status=1)
    assert done.stderr == "omote: the browser ended before it had drawn; try again\n"
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("command", ["render", "grid", "redraw"])
def test_help_holds_no_picture_that_a_terminal_made_of_a_name(command: str) -> None:
    """Between colons some names are emoji to the library that prints help: `:man:`."""
    assert max(map(ord, runner.invoke(app, [command, "--help"], env={"COLUMNS": "200"}).stdout)) < 0x2600
