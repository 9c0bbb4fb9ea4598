"""`omote stimuli`, as it is typed: what is wrong in a table is told before anything is drawn."""

from pathlib import Path

import pytest
from typer.testing import CliRunner

from omote.cli import app
from omote.model.cast import Cast
from tests.server.false_browser import false_browser
from tests.server.synthetic_server import MASK, PAGES, meshes


@pytest.fixture(autouse=True)
def studio(cast: Cast, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The synthetic cast, and a browser that only speaks."""
    for name, made in (("load_cast", cast), ("load_meshes", meshes(cast)), ("load_mask", MASK), ("read_pages", PAGES)):
        monkeypatch.setattr(f"omote.server.headless.picture_run.{name}", lambda made=made: made)
    monkeypatch.setenv("OMOTE_BROWSER", str(false_browser(tmp_path)))


def said(tmp_path: Path, table: str, *, status: int = 0) -> str:
    (tmp_path / "design.csv").write_text(table)
    done = CliRunner().invoke(app, ["stimuli", str(tmp_path / "design.csv"), "-o", str(tmp_path / "out")])
    assert done.exit_code == status, done.output
    return done.output


def test_a_table_is_drawn_and_what_is_the_experiments_own_is_said(tmp_path: Path) -> None:
    text = said(tmp_path, "name,block\na,1\nb,2\n")
    assert "headings of your own, carried into drawn.csv as they are: block." in text
    assert "out has 2 pictures of 2 rows, and drawn.csv" in text
    (tmp_path / "out" / "a.png").unlink()
    assert "1 of 2 pictures are there already; going on." in said(tmp_path, "name,block\na,1\nb,2\n")


def test_progress_names_the_row_of_a_clip(tmp_path: Path) -> None:
    text = said(tmp_path, "name,seconds,fps\nopens,0.2,5\n")
    assert "1 of 2: opens/0001.png, " in text
    assert "2 of 2: opens/0002.png, " in text


def test_what_is_wrong_is_told_and_nothing_is_drawn(tmp_path: Path) -> None:
    text = said(tmp_path, "name,face\n" + "".join(f"a{number},nobody{number}\n" for number in range(30)), status=1)
    assert "design.csv, row 2, face: there is no face 'nobody0' in this cast" in text
    assert text.splitlines()[-1].endswith("design.csv (30, 10 more than are said here).")
    assert not (tmp_path / "out").exists()
