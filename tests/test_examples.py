"""Every script of examples/ runs as a stranger would run it, and what it made is what its first lines promise."""

from __future__ import annotations

import ast
import csv
import json
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import msgspec
import numpy as np
import pytest
from numpy.typing import NDArray

import omote
from omote.interchange.formats.glb_reader import read_glb
from omote.interchange.formats.png import read_png
from omote.interchange.scans.wavefront_reader import read_obj_pieces
from omote.perform.frame import Frame
from omote.server.headless.chromium import find_chromium
from omote.show.wire import decode_answer
from tests import synthetic

ROOT = Path(__file__).parent.parent
OF_A_SHOW = {"chat_speaks"}  # plays one that runs: it takes its address, and writes nothing
SCRIPTS = sorted((ROOT / "examples").glob("*.py"))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Where an example writes; it makes the folder itself."""
    return tmp_path / "made here"


def run(name: str, folder: Path) -> str:
    """What an example prints; it must end well."""
    command = [sys.executable, str(ROOT / "examples" / f"{name}.py"), str(folder)]
    done = subprocess.run(command, cwd=folder.parent, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def rows_of(path: Path) -> list[dict[str, str]]:
    """The rows of a table by column."""
    with path.open(newline="") as file:
        return [*csv.DictReader(file)]


def vertices(path: Path) -> NDArray[np.float64]:
    """The vertices of an OBJ file (V, 3), metres."""
    return np.concatenate([piece.points for piece in read_obj_pieces(path.read_bytes())])


def largest_step(path: Path, other: Path) -> float:
    """How far apart two shapes are at most, metres."""
    return float(np.linalg.norm(vertices(path) - vertices(other), axis=1).max())


def has_browser() -> bool:
    """Whether there is a browser that draws."""
    try:
        find_chromium()
    except FileNotFoundError:
        return False
    return True


def test_every_script_has_a_line_in_the_readme_and_a_test_here() -> None:
    readme = (ROOT / "examples" / "README.md").read_text()
    names = [path.stem for path in SCRIPTS]
    assert sorted(re.findall(r"\[(\w+)\.py\]\(\1\.py\)", readme)) == names
    assert sorted(OF_A_SHOW | {*re.findall(r'run\("(\w+)", folder\)', Path(__file__).read_text())}) == names
    assert len(readme.splitlines()) <= 20


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: path.stem)
def test_a_script_is_short_and_says_what_for_whom_and_how(path: Path) -> None:
    text = path.read_text()
    head = ast.get_docstring(ast.parse(text)) or ""
    assert 30 <= len(text.splitlines()) <= 80
    assert re.search(r"^For ", head, re.MULTILINE)
    assert f"Run: python examples/{path.name} [{'ADDRESS' if path.stem in OF_A_SHOW else 'FOLDER'}]" in head


def test_playing_a_face_never_jumps_and_ends_at_rest(folder: Path) -> None:
    said = run("play_a_face", folder)
    rows = rows_of(folder / "frames.csv")
    openings = np.array([float(row["mouth_mm"]) for row in rows])
    assert len(said.splitlines()) == len(rows) == 75
    assert openings.max() > 20
    assert np.abs(np.diff(openings[:60])).max() < 0.2 * np.ptp(openings)  # nothing jumps
    assert openings[-1] < 1
    mixes = [dict(pair.split("=") for pair in row["faces"].split()) for row in rows]
    assert max(len(mix) for mix in mixes) == 3  # the second call began in the middle of the first
    assert mixes[-1] == {"child": "1.00"}


def test_a_timeline_moves_vertices_and_gives_the_same_again(folder: Path) -> None:
    run("mix_on_a_timeline", folder)
    rows = rows_of(folder / "timeline.csv")
    places = {row["vertex"]: [] for row in rows}  # type: dict[str, list[list[float]]]
    for row in rows:
        places[row["vertex"]].append([float(row[axis]) for axis in "xyz"])
    assert {name: len(track) for name, track in places.items()} == dict.fromkeys(("nose", "neck", "ear"), 61)
    assert all(np.ptp(np.array(track), axis=0).max() > 1e-3 for track in places.values())
    nose = vertices(folder / "last.obj")
    assert np.abs(nose - places["nose"][-1]).max(axis=1).min() < 2e-6  # the last row lies in the last frame


def test_a_new_expression_is_worn_by_three_faces(folder: Path) -> None:
    run("new_expression", folder)
    for name in ("kaori", "old", "dog"):
        neutral = folder / f"{name}_neutral.obj"
        smirk = folder / f"{name}_smirk.obj"
        moved = vertices(smirk) - vertices(neutral)
        lifted = np.linalg.norm(moved, axis=1) > 1e-3
        assert 0.005 < largest_step(neutral, smirk) < 0.015
        assert vertices(neutral)[lifted, 0].mean() > 0.01  # it is crooked: to the character's left
        assert moved[lifted, 1].mean() > 0


def test_a_face_from_a_text_file_smiles(folder: Path) -> None:
    run("face_from_text", folder)
    elf = vertices(folder / "elf_smile.obj")
    assert np.isfinite(elf).all()
    assert 'name = "elf"' in (folder / "elf.toml").read_text()


def test_strangers_wear_each_other_s_shapes_and_morph_evenly(folder: Path) -> None:
    told = [float(line.split()[-2]) for line in run("strangers_morph", folder).splitlines()]
    assert len(told) == 2
    assert min(told) > 5.0  # millimetres: an open jaw and half a smile
    steps = [largest_step(folder / f"{step}.obj", folder / f"{step + 1}.obj") for step in range(4)]
    whole = largest_step(folder / "0.obj", folder / "4.obj")
    assert 0.0 < max(steps) < 0.5 * whole


def test_faces_from_faces_are_three_different_ones(folder: Path) -> None:
    run("faces_from_faces", folder)
    made = sorted(folder.glob("*.obj"))
    assert [path.stem for path in made] == ["half", "kaori_150", "patched"]
    assert min(largest_step(a, b) for a in made for b in made if a != b) > 2e-3


def test_an_extracted_expression_moves_every_face_alike(folder: Path) -> None:
    said = run("extract_and_measure", folder)
    rows = rows_of(folder / "measured.csv")
    assert len(rows) == 17
    assert all(float(row["mouth_smiling_mm"]) > float(row["mouth_mm"]) + 2 for row in rows)
    assert all(float(row["rise_mm"]) > 2 for row in rows)
    (missed,) = re.findall(r"round trip on kaori: ([\d.]+) micrometres", said)
    assert float(missed) < 10


def test_any_head_becomes_a_space_and_wears_a_smile(folder: Path) -> None:
    run("your_own_head", folder)
    head, smile, long_smile = (vertices(folder / f"{name}.obj") for name in ("head", "smile", "long_smile"))
    moved = np.linalg.norm(smile - head, axis=1)
    assert 0.004 < moved.max() < 0.02
    assert np.count_nonzero(moved > 1e-4) < 0.2 * len(head)  # the mouth, not the head
    longer = np.linalg.norm(long_smile - head * [0.9, 1.2, 1.0], axis=1)
    assert (longer > 1e-4).sum() == pytest.approx((moved > 1e-4).sum(), rel=0.1)  # at the same places


def test_a_head_that_is_there_already_is_taken(folder: Path) -> None:
    points, triangles = synthetic.head()
    lines = [f"v {x} {y} {z}" for x, y, z in points] + [f"f {a}/{a} {b}/{b} {c}/{c}" for a, b, c in triangles + 1]
    folder.mkdir()
    (folder / "head.obj").write_text("\n".join(lines))
    said = run("your_own_head", folder)
    assert said.startswith(f"{len(points)} vertices")
    np.testing.assert_array_equal(vertices(folder / "head.obj"), points)
    moved = np.linalg.norm(vertices(folder / "smile.obj") - points, axis=1)
    assert 0.004 < moved.max() < 0.02
    assert (moved < 1e-4).mean() > 0.7


def test_an_export_holds_the_arkit_shapes(folder: Path) -> None:
    said = run("export_glb", folder)
    pieces = {piece.name: piece for piece in read_glb((folder / "child.glb").read_bytes())}
    assert len(pieces["skin"].moves) == 52
    assert {"jawOpen", "eyeBlinkLeft", "tongueOut"} <= pieces["skin"].moves.keys()
    (missed,) = re.findall(r"at most ([\d.]+) micrometres", said)
    assert float(missed) < 1


@pytest.mark.skipif(not has_browser(), reason="there is no Chromium or Chrome to draw with")
def test_a_grid_is_a_picture_with_a_face_in_each_cell(folder: Path) -> None:
    run("picture_grid", folder)
    picture = read_png((folder / "grid.png").read_bytes())
    height, width = picture.shape[:2]
    assert width > 4 * 160
    assert height > 3 * 180
    assert len(np.unique(picture.reshape(-1, picture.shape[2]), axis=0)) > 1000


def test_a_replayed_log_gives_the_same_bytes_and_the_calls_of_the_log(folder: Path) -> None:
    assert "the same bytes" in run("replay_a_log", folder)
    unpacker = msgspec.msgpack.Decoder()
    states = (folder / "states.bin").read_bytes()
    log = [json.loads(line) for line in (folder / "log.jsonl").read_text().splitlines()]
    assert [message["type"] for _, message in log][-1] == "panic"
    assert states.count(b"epoch") == 121
    begin = states.rindex(b"\xa4type\xa5state") - 3  # a map of more than fifteen keys begins with three bytes
    last = unpacker.decode(states[begin:])["characters"]["one"]
    assert last["expressions"] == {"neutral": 1.0}
    assert last["face_call"] is None  # panic stopped it on its way
    assert 0 < last["faces"]["noh"] < 1


def test_a_console_hears_its_call_arrive(folder: Path) -> None:
    run("talk_to_a_show", folder)
    heard = [json.loads(line) for line in (folder / "heard.jsonl").read_text().splitlines()]
    messages = [decode_answer(msgspec.msgpack.encode(message)) for message in heard]  # all of them are of the wire
    kinds = {type(message).__name__ for message in messages}
    assert {"Welcome", "State", "Refused"} <= kinds
    assert heard[-1]["characters"]["one"]["faces"] == {"dog": 1.0}
    states = [message["characters"]["one"] for message in heard if message["type"] == "state"]
    weights = [state["faces"].get("dog", 0.0) for state in states]
    assert weights == sorted(weights)
    assert (folder / "talk.omote").is_file()


def chat(address: str, typed: str) -> subprocess.CompletedProcess[str]:
    """The chat with a show at an address, with these lines typed."""
    command = [sys.executable, str(ROOT / "examples" / "chat_speaks.py"), address]
    return subprocess.run(command, input=typed, capture_output=True, text=True, check=False)


def test_a_chat_speaks_and_nods(tmp_path: Path) -> None:
    command = [str(Path(sys.executable).with_name("omote")), "show", str(tmp_path / "chat.omote"), "--no-open"]
    frames = list[Frame]()
    with subprocess.Popen([*command, "--port", "0", "--osc", "0"], stdout=subprocess.PIPE, text=True) as shown:
        try:
            assert shown.stdout is not None
            address = next(at[0] for line in shown.stdout if (at := re.search(r"http://127\.0\.0\.1:\d+", line)))
            with omote.connect(address, timeout=60) as show, ThreadPoolExecutor() as pool:
                done = pool.submit(chat, address, "Hello\nDo you like the theatre?\n\n")
                while not done.done():
                    show.wait()
                    frames.append(show["one"].frame)
        finally:
            shown.terminate()
    assert (done.result().returncode, done.result().stderr.count("Traceback")) == (0, 0)
    for text in ("Hello! Nice to meet you.", "My answer is maybe. Please believe me."):
        assert text in done.result().stdout
        spoken = [each.channels for each in frames if each.speech is not None and each.speech.text == text]
        jaws = [channels.get("jawOpen", 0.0) for channels in spoken]
        assert max(jaws) > 0.15
        assert jaws[0] < 0.05  # it begins with a mouth at rest
    assert min(frame.head.pitch for frame in frames) < -0.1  # it nods


def test_a_chat_without_a_show_says_so() -> None:
    done = chat("http://127.0.0.1:1", "Hello\n")
    assert done.returncode == 1
    assert "chat_speaks: no show at http://127.0.0.1:1 for 10 s" in done.stderr
    assert "Traceback" not in done.stderr
