"""`omote render`, `grid` and `redraw`, as they are typed; a browser that only speaks stands for the one that draws."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec
import pytest
from typer.testing import CliRunner, Result

from omote.cli import app
from omote.model.cast import Cast
from omote.server.headless.devtools import BrowserError
from omote.server.headless.picture_run import PictureProgress, PictureRun, PictureStudio, write_picture
from omote.showfile.changes import Content, content_key
from omote.showfile.contents import pack_expression
from omote.showfile.show_file import open_show
from omote.stage_data.picture_setting import Clipped
from omote.stage_data.picture_sidecar import checksum_of, encode_sidecar, read_sidecar
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
    monkeypatch.setattr("omote.stage_data.cast_names.read_names", lambda _: None)
    return cast


@pytest.fixture
def runs(small_cast: Cast, monkeypatch: pytest.MonkeyPatch) -> list[PictureRun]:
    """What would be drawn; every picture is the same small file, written as it would be."""
    asked: list[PictureRun] = []

    def draw(studio: PictureStudio, run: PictureRun, report: Callable[[PictureProgress], None], *, jobs: int) -> None:
        asked.append(run)
        done = len(run.pictures) - len(run.waiting)
        for number, file in enumerate([*run.waiting, *([run.table] if run.table else [])], done + 1):
            file.path.parent.mkdir(exist_ok=True)
            wanted = run.whole.sidecar.setting["contrast"]
            cut = None if wanted is None else Clipped(0.1 * wanted, 0.0)
            write_picture(file, PICTURES[file.path.suffix], cut)
            if file is not run.table:
                report(PictureProgress(file.path, 0.5, number, len(run.pictures)))

    monkeypatch.setattr("omote.server.headless.picture_run.draw_run", draw)
    return asked


def test_what_was_cut_off_for_a_contrast_is_said(runs: list[PictureRun], tmp_path: Path) -> None:
    path = str(tmp_path / "a.png")
    said = typed("render", "--contrast", "0.5", "-o", path).output
    assert "in 1 of 1 the contrast is more than the face has room for: of a.png 5.0 % is cut off to black" in said
    assert "cut off" not in typed("render", "--contrast", "0.04", "-o", path).output
    assert "cut off" not in typed("render", "-o", path).output


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


def test_hair_mask_and_luminance_are_of_the_setting_and_of_the_sidecar(
    tmp_path: Path, runs: list[PictureRun]
) -> None:  # fmt: skip
    words = ("--no-hair", "--mask", "oval", "--background", "grey", "--luminance", "0.2", "--contrast", "0.5")
    typed("render", "-o", str(tmp_path / "a.png"), *words)
    typed("grid", "-o", str(tmp_path / "b.png"), "--faces", "generic", *words)
    for run in runs:
        setting = run.setting
        assert (setting.hair, setting.mask, setting.luminance, setting.contrast) == (False, "oval", 0.2, 0.5)
    typed("redraw", str(tmp_path / "a.png"), "--force")
    assert runs[-1].setting == runs[0].setting
    assert read_sidecar(tmp_path / "a.png.json").setting["mask"] == "oval"


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
    assert "drawn from other parameters; it is drawn anew" in typed(*words, "--turn", "10").stderr
    sidecar = tmp_path / "a.png.json"
    sidecar.write_text(json.dumps(json.loads(sidecar.read_text()) | {"cast": "another"}))
    assert "drawn with another cast than this one" in typed(*words, "--turn", "10").stderr
    assert len(runs) == 3


def test_how_a_replaced_picture_was_drawn_is_kept(tmp_path: Path, runs: list[PictureRun]) -> None:
    words = ["render", "-o", str(tmp_path / "a.png")]
    typed(*words)
    first = (tmp_path / "a.png.json").read_bytes()
    kept = tmp_path / "a.before-1.png.json"
    assert f"stays in {kept}: omote redraw" in typed(*words, "--turn", "10").stderr
    assert kept.read_bytes() == first
    second = (tmp_path / "a.png.json").read_bytes()
    typed(*words, "--turn", "20")
    assert (tmp_path / "a.before-2.png.json").read_bytes() == second
    typed(*words)
    typed(*words, "--turn", "10")  # drawn from the same as before: kept already
    assert {path.name for path in tmp_path.glob("*before*")} == {f"a.before-{n}.png.json" for n in (1, 2, 3)}
    typed("redraw", str(kept))
    assert (tmp_path / "a.before-1.png").read_bytes() == PICTURES[".png"]
    typed(*words, "--turn", "10", "--fresh")
    assert not (tmp_path / "a.before-4.png.json").exists(), "the same picture again takes no other's place"


@pytest.mark.parametrize("sidecar", [True, False])
def test_a_picture_that_omote_did_not_draw_stays_unless_it_is_told(
    tmp_path: Path, runs: list[PictureRun], sidecar: bool
) -> None:
    path = tmp_path / "a.png"
    theirs = PICTURES[".png"] + b" of somebody else"
    if sidecar:
        typed("render", "-o", str(path))
    path.write_bytes(theirs)
    refused = typed("render", "-o", str(path), "--fresh", status=1).stderr
    assert f"{path} is there already and is not as Omote drew it ({'a.png.json is of' if sidecar else 'no'} " in refused
    assert "--force" in refused
    assert (path.read_bytes(), len(runs)) == (theirs, int(sidecar))
    typed("render", "-o", str(path), "--force")
    assert path.read_bytes() == PICTURES[".png"]


def test_an_empty_file_is_no_picture_of_somebody(tmp_path: Path, runs: list[PictureRun]) -> None:
    (tmp_path / "a.png").touch()
    typed("render", "-o", str(tmp_path / "a.png"))
    assert len(runs) == 1


def test_a_strange_picture_among_those_of_a_table_stays(
    tmp_path: Path, small_cast: Cast, runs: list[PictureRun]
) -> None:
    one = next(iter(small_cast.faces))
    words = ["grid", "-o", str(tmp_path / "a.png"), "--faces"]
    (tmp_path / "a.pictures").mkdir()
    strange = tmp_path / "a.pictures" / f"{one}-neutral.png"
    strange.write_bytes(PICTURES[".png"] + b" of somebody else")
    assert str(strange) in typed(*words, one, status=1).stderr
    assert runs == []


def test_pictures_of_the_table_before_go_when_another_takes_its_place(
    tmp_path: Path, small_cast: Cast, runs: list[PictureRun]
) -> None:
    one, other, *_ = small_cast.faces
    path = tmp_path / "a.png"
    folder = tmp_path / "a.pictures"
    words = ["grid", "-o", str(path), "--faces"]
    typed(*words, f"{one},{other}")
    (folder / "mine.png").write_bytes(PICTURES[".png"] + b" of somebody else")
    said = typed(*words, one).stderr
    assert f"removed from {folder} what only the table before had, pictures: 1." in said
    assert {each.name for each in folder.glob("*.png")} == {f"{one}-neutral.png", "mine.png"}
    said = typed("render", "-o", str(path)).stderr
    assert f"{folder} still holds pictures of a former table" in said
    assert len(runs) == 3


def test_tables_that_share_a_folder_keep_their_pictures(
    tmp_path: Path, small_cast: Cast, runs: list[PictureRun]
) -> None:
    one, other, *_ = small_cast.faces
    typed("grid", "-o", str(tmp_path / "a.jpg"), "--faces", one)
    typed("grid", "-o", str(tmp_path / "a.png"), "--faces", other)
    assert len([*(tmp_path / "a.pictures").glob("*.png")]) == len(runs) == 2


def test_what_is_no_picture_is_not_replaced_by_one(tmp_path: Path, runs: list[PictureRun]) -> None:
    (tmp_path / "a.png").write_text("a diary")
    assert "no PNG picture" in typed("render", "-o", str(tmp_path / "a.png"), status=1).stderr
    assert runs == []
    assert [path.read_text() for path in tmp_path.iterdir()] == ["a diary"]


def test_a_sidecar_draws_its_picture_again(tmp_path: Path, small_cast: Cast, runs: list[PictureRun]) -> None:
    one, other = list(small_cast.faces)[:2]
    words = ["--morph", f"{one}:{other}:3", "--expressions", "smile", "--light", "flat", "--size", "32x36"]
    typed("grid", "-o", str(tmp_path / "a.png"), *words)
    before = {path: path.read_bytes() for path in tmp_path.rglob("*.*") if path.is_file()}
    assert "the same to the last byte" in typed("redraw", str(tmp_path / "a.png.json")).stderr
    assert {path: path.read_bytes() for path in tmp_path.rglob("*.*") if path.is_file()} == before
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
    of_another = msgspec.structs.replace(read_sidecar(sidecar), cast="another")
    of_another = msgspec.structs.replace(of_another, checksum=checksum_of(of_another))
    sidecar.write_bytes(encode_sidecar(of_another, PICTURES[".png"] + b" of another cast"))
    (tmp_path / "a.png").unlink()
    refused = typed("redraw", str(sidecar), status=1).stderr
    assert "comes out otherwise than its sidecar says, which was drawn with another cast than this one" in refused
    assert [path.name for path in tmp_path.iterdir()] == ["a.png.json"]
    said = typed("redraw", str(sidecar), "-o", str(tmp_path / "b.png")).stderr
    assert "the sidecar's picture was drawn with another cast than this one" in said
    assert len(runs) == 3


def test_redraw_proves_brings_back_and_replaces_only_when_told(tmp_path: Path, runs: list[PictureRun]) -> None:
    path = tmp_path / "a.png"
    sidecar = tmp_path / "a.png.json"
    typed("render", "-o", str(path))
    path.unlink()
    typed("redraw", str(sidecar))
    assert path.read_bytes() == PICTURES[".png"]
    assert "the same to the last byte" in typed("redraw", str(path)).stderr, "the picture stands for its sidecar"
    strange = typed("redraw", str(tmp_path / "b.png"), status=1).stderr
    assert f"no b.png.json lies beside {tmp_path / 'b.png'}" in strange
    path.write_bytes(PICTURES[".png"] + b", retouched")
    refused = typed("redraw", str(sidecar), status=1).stderr
    assert f"{path} is not the picture that its sidecar is of, it was changed since" in refused
    assert path.read_bytes() == PICTURES[".png"] + b", retouched"
    assert len(runs) == 3  # it was not drawn to find that out
    typed("redraw", str(sidecar), "--force")
    assert path.read_bytes() == PICTURES[".png"]


def test_of_a_sidecar_the_request_counts_and_nothing_else_may_be_edited(tmp_path: Path, runs: list[PictureRun]) -> None:
    path = tmp_path / "a.png"
    sidecar = tmp_path / "a.png.json"
    typed("render", "-o", str(path), "--expression", "smile=0.5")
    whole = json.loads(sidecar.read_text())
    edits: list[dict[str, Any]] = [
        {"pictures": {**whole["pictures"], "paper": "#fff"}},
        {"setting": {}},
        {"cast": "x"},
        {"pages": "x"},
    ]
    for edit in edits:
        sidecar.write_text(json.dumps(whole | edit))
        refused = typed("redraw", str(sidecar), status=1).stderr
        assert "cast, pages, setting or pictures were edited" in refused
        assert "change the words under request" in refused
    assert len(runs) == 1
    sidecar.write_text(json.dumps(whole | {"request": {**whole["request"], "expression": ["smile=0.75"]}}))
    said = typed("redraw", str(sidecar), "-o", str(tmp_path / "b.png")).stderr
    assert "the sidecar's picture was drawn from other parameters" in said
    assert runs[-1].pictures[0].sheet.poses[0][0]["expressions"] == {"smile": 0.75, "neutral": 0.25}


def test_a_redraw_that_is_stopped_changes_nothing(
    tmp_path: Path, small_cast: Cast, runs: list[PictureRun], monkeypatch: pytest.MonkeyPatch
) -> None:
    typed("render", "-o", str(tmp_path / "a.png"), "--face", next(iter(small_cast.faces)))

    def stopped(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("omote.server.headless.picture_run.draw_run", stopped)
    done = typed("redraw", str(tmp_path / "a.png.json"), status=130)
    assert done.stderr == "omote: stopped; nothing was changed.\n"
    assert len(runs) == 1


def test_own_work_of_a_show_is_drawn(
    tmp_path: Path, small_cast: Cast, runs: list[PictureRun], monkeypatch: pytest.MonkeyPatch
) -> None:
    data = pack_expression(small_cast.expressions["smile"])
    key = content_key(data)
    show = open_show(tmp_path / "a.omote")
    kept = item(1, name="crooked_smile", label="Crooked smile", head=1)
    show.apply([Content(key, data), kept, revision(1, 1, content=key, recipe=RECIPE)])
    show.close()
    words = ["render", "-o", str(tmp_path / "a.png"), "--expression", "crooked-smile"]
    assert "no expression 'crooked-smile'" in typed(*words, status=1).stderr
    typed(*words, "--show", str(tmp_path / "a.omote"))
    assert runs[0].pictures[0].sheet.poses[0][0]["expressions"] == {"crooked_smile": 1.0}
    assert json.loads((tmp_path / "a.png.json").read_text())["request"]["show"] == str(tmp_path / "a.omote")
    _redraw_from_elsewhere(tmp_path, words[3:], monkeypatch)


def _redraw_from_elsewhere(folder: Path, words: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    """A sidecar names its show file from its own folder, so both work from others, and after a move together."""
    for name in ("pictures", "elsewhere"):
        (folder / name).mkdir()
    monkeypatch.chdir(folder)
    typed("render", "-o", "pictures/b.png", *words, "--show", "a.omote")
    sidecar = folder / "pictures" / "b.png.json"
    assert json.loads(sidecar.read_text())["request"]["show"] == "../a.omote"
    monkeypatch.chdir(folder / "elsewhere")
    typed("redraw", str(sidecar))
    (folder / "a.omote").rename(folder / "moved.omote")
    refused = typed("redraw", str(sidecar), status=1).stderr
    assert "which is not there: say where with --show" in refused
    typed("redraw", str(sidecar), "--show", "../moved.omote")


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
        ("--turn up", "the turn's yaw is 'up', which is no number"),
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


@pytest.mark.parametrize(("text", "named"), [("{}", "omote is missing"), ('{"format": "gltf"}', "gltf")])
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
