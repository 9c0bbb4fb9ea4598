"""What the README says holds: its Python example and its commands run as printed, and what pages count is there."""

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from omote.builtin import load_cast
from omote.edit.store.import_items import make_document
from omote.interchange.formats.expression_json import encode
from omote.model.controls.face_muscles import muscles
from tools.baking.sculpts import sculpt_paths
from tools.browser import find_browser

ROOT = Path(__file__).parent.parent
README = (ROOT / "README.md").read_text()


@pytest.fixture(scope="module")
def names() -> dict[str, Any]:
    """What the example leaves behind."""
    (example,) = re.findall(r"^```python\n(.*?)^```", README, re.MULTILINE | re.DOTALL)
    left: dict[str, Any] = {}
    exec(compile(example, "README.md", "exec"), left)
    return left


def test_the_frame_is_on_its_way(names: dict[str, Any]) -> None:
    frame = names["frame"]
    assert sum(frame.faces.values()) == pytest.approx(1)
    assert {"generic", "round"} <= frame.faces.keys()
    assert frame.channels["jawOpen"] == 0.4


def test_positions_are_finite_and_in_metres(names: dict[str, Any]) -> None:
    assert np.isfinite(names["points"]).all()
    assert 0.2 < np.ptp(names["points"], axis=0)[1] < 0.5
    assert {"eye_left", "teeth_lower", "tongue", "lashes"} <= names["parts"].keys()


def test_an_expression_comes_off_one_face_and_goes_onto_another(names: dict[str, Any]) -> None:
    again = names["omote"].compound(names["cast"].space, names["cast"].faces["kaori"], names["smile"])
    np.testing.assert_allclose(again, names["smiling"], atol=1e-5)
    assert 1e-3 < np.abs(names["on_old"] - names["cast"].faces["old"].positions).max() < 0.05


def test_any_head_may_be_the_generic_face(names: dict[str, Any]) -> None:
    assert len(names["space"].skin_triangles) > 0.5 * len(names["space"].triangles)


NUMBERS = dict(enumerate("zero one two three four five six seven eight nine ten eleven twelve".split())) | {
    13: "thirteen", 14: "fourteen", 15: "fifteen", 16: "sixteen", 17: "seventeen", 18: "eighteen", 19: "nineteen",
    20: "twenty",
}  # fmt: skip


def counted() -> dict[str, tuple[int, tuple[str, ...]]]:
    """What the pages count, by the words behind the number: how many there are, and the pages that say it."""
    cast = load_cast()
    kinds = [title.kind for title in cast.titles.values()]
    sculpts = len(sculpt_paths())
    examples = len(list((ROOT / "examples").glob("*.py")))
    return {
        "muscles": (len(muscles(cast.space)), ("README.md",)),
        "short programs": (examples, ("README.md", "docs/index.md")),
        "short scripts": (examples, ("CHANGELOG.md",)),
        "faces in millimetres|faces, and drawn": (len(cast.faces), ("docs/tutorials/researcher.md", "docs/index.md")),
        "people, five": (len(cast.faces) - sculpts, ("src/omote/builtin/__init__.py",)),
        "sculpted faces": (sculpts, ("src/omote/builtin/__init__.py",)),
        "styles": (len(cast.hair), ("CHANGELOG.md",)),
        "ARKit": (kinds.count("arkit"), ("README.md", "docs/transfer.md", "docs/glossary.md", "docs/conventions.md")),
        "MakeHuman": (kinds.count("makehuman"), ("docs/transfer.md", "docs/glossary.md", "CHANGELOG.md")),
    }


@pytest.mark.parametrize("words", counted())
def test_what_the_pages_count_is_what_there_is(words: str) -> None:
    count, pages = counted()[words]
    numbers = "|".join((r"\d+", *NUMBERS.values()))
    for page in pages:
        said = re.findall(rf"\b({numbers}) (?:{words})\b", (ROOT / page).read_text())
        assert said, f"{page} counts no {words} any more: take it out of this list"
        assert set(said) <= {str(count), NUMBERS.get(count, "")}, page


def commands() -> list[str]:
    """The `omote` commands of the README's shell blocks, as printed, in their order."""
    blocks = re.findall(r"^```sh\n(.*?)^```", README, re.MULTILINE | re.DOTALL)
    lines = [line for block in blocks for line in block.replace("\\\n", " ").splitlines()]
    return [line for line in lines if line.startswith("omote ")]


@pytest.fixture(scope="module")
def crew(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with what the README takes for granted: two show files, an own expression, shapes of another program,
    scans of two people."""
    folder = tmp_path_factory.mktemp("crew")
    cast = load_cast()
    made = make_document(cast.space, "Crooked smile", (), cast.expressions["cheeky"])
    (folder / "made.json").write_bytes(encode(made))
    (folder / "scans").mkdir()
    for name, path in (("old", "ann.ply"), ("man", "scans/bo.ply")):
        (folder / path).write_text(as_ply(1000.0 * cast.faces[name].positions, cast.space.triangles))
    for words in (
        ["file", "import", "my.omote", "made.json"],
        ["file", "import", "their.omote", "made.json"],
        ["export", "kaori", "-o", "shapes.glb", "--expressions", "smile"],
    ):
        typed(words, folder)
    return folder


def as_ply(points: NDArray[np.floating], triangles: NDArray[np.integer]) -> str:
    """A mesh as PLY text."""
    head = ["ply", "format ascii 1.0", f"element vertex {len(points)}", *(f"property float {axis}" for axis in "xyz"),
            f"element face {len(triangles)}", "property list uchar int vertex_indices", "end_header"]  # fmt: skip
    rows = [" ".join(f"{value:.4f}" for value in point) for point in points]
    rows += [f"3 {a} {b} {c}" for a, b, c in triangles.tolist()]
    return "\n".join([*head, *rows, ""])


def typed(words: list[str] | str, folder: Path) -> None:
    """Runs a command, or a line as printed, in a folder; fails where it does."""
    program = Path(sys.executable).parent
    browser = find_browser()
    environment = {**os.environ, "PATH": f"{program}{os.pathsep}{os.environ['PATH']}"}
    environment |= {} if browser is None else {"OMOTE_BROWSER": str(browser)}
    line = words if isinstance(words, str) else shlex.join(["omote", *words])
    done = subprocess.run(["sh", "-c", line], cwd=folder, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, (line, done.stderr)


def test_the_readme_is_short_and_has_commands() -> None:
    assert len(README.splitlines()) <= 120
    assert len(commands()) >= 10
    assert not [line for line in commands() if line.startswith("omote show")]  # those wait; test_cli.py opens a show


@pytest.mark.long
def test_every_command_of_the_readme_runs_as_printed(crew: Path) -> None:
    for line in commands():
        typed(line, crew)
    assert {"half_a_dog.png", "grid.png", "morph.png", "own.png", "crooked-smile.json"} <= {
        p.name for p in crew.iterdir()
    }
