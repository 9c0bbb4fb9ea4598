"""The commands, as they are typed."""

import json
import os
import signal
import socket
import sqlite3
import stat
import subprocess
import sys
from contextlib import closing
from importlib.metadata import version
from pathlib import Path

import pytest
from typer.testing import CliRunner

from omote.cli import app
from omote.model.cast import Cast
from omote.server.persistence.lock import lock_show
from omote.server.supervision.supervisor import Supervisor
from omote.showfile.show_file import JournalEntry, open_show

runner = CliRunner()
HEAVY = ("numpy", "numba", "aiohttp", "scipy", "rich.console")


@pytest.fixture
def small_cast(cast: Cast, monkeypatch: pytest.MonkeyPatch) -> Cast:
    """The synthetic cast in place of the built-in one."""
    monkeypatch.setattr("omote.builtin.load_cast", lambda: cast)
    return cast


def test_help_is_quick_because_nothing_heavy_is_imported() -> None:
    code = f"import sys, omote.cli; print([name for name in {HEAVY!r} if name in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_errors_that_need_no_cast_do_not_wait_for_one(tmp_path: Path) -> None:
    """What a person mistypes is told before the mathematics is loaded, which takes seconds."""
    (tmp_path / "notes.txt").write_text("hello")
    typed = [
        "--version", "shwo", "render --sise 3 -o a.png", "render -o nowhere/a.png", "render -o a.gif",
        "render -o a.png --background gren", "render -o a.png --gaze 80", "render -o a.png --face kaori=.3",
        "render -o a.png --quality best", "render -o a.png --light noon", "render -o a.png --show none.omote",
        "render -o a.jpg --transparent", "grid -o a.png", "grid -o a.png --faces old --turns x", "redraw none.json",
        "export kaori -o a.fbx", "export -o a.glb", "export kaori -o nowhere/a.glb",
        "export kaori -o a.glb --show notes.txt", "export --all -o a --show notes.txt",
        "render -o a.png --face nobody", "render -o a.png --expression noon", "render -o a.png --channel noon",
        "grid -o a.png --faces dog,nobody", "grid -o a.png --faces dog --expressions performed,noon",
        "grid -o a.png --morph dog:nobody:3", "export nobody -o a.glb", "export dog -o a.glb --expressions noon",
        "export --faces dog,nobody -o a", "face none.obj -o a", "face notes.txt -o a --look nobody",
        "face notes.txt -o a --hair afro", "face notes.txt --report a --expressions noon",
        "face notes.txt -o a --landmarks noon=1,2,3", "file import a none.obj --face nobody", "play-take none.csv",
        "file list none.omote", "file list notes.txt", "file check notes.txt", "file history none.omote smile",
        "file import a.omote none.json", "file import notes.txt none.json", "file export none.omote smile -o a",
        "show notes.txt", "show nowhere/a.omote", "show --port 99999",
        "cast --random 0 -o a", "cast --random 2", "cast --random 2 -o nowhere/a", "stimuli none.csv -o out",
        "stimuli notes.txt -o notes.txt",
    ]  # fmt: skip
    code = f"""
import sys
from typer.testing import CliRunner
from omote.cli import app
for words in {typed!r}:
    done = CliRunner().invoke(app, words.split())
    assert (done.exit_code == 0) == (words == "--version"), words
    assert not isinstance(done.exception, Exception), (words, done.exception)
    loaded = [name for name in ("numba", "scipy") if name in sys.modules]
    assert not loaded, (words, loaded)
"""
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-1000:]
    assert [path.name for path in tmp_path.iterdir()] == ["notes.txt"]


def test_help_names_the_commands() -> None:
    done = runner.invoke(app, ["--help"])
    assert done.exit_code == 0
    for name in ("show", "cast", "check", "render", "grid", "redraw"):
        assert name in done.output


def test_the_version_is_that_of_the_package() -> None:
    done = runner.invoke(app, ["--version"])
    assert (done.exit_code, done.output) == (0, f"omote {version('omote')}\n")


def test_the_cast_for_people_names_everybody(small_cast: Cast) -> None:
    done = runner.invoke(app, ["cast"])
    assert done.exit_code == 0
    assert all(name in done.output for name in (*small_cast.faces, "jawOpen", "smile"))
    assert "3 faces" in done.output


def test_the_cast_for_programs_is_json(small_cast: Cast) -> None:
    document = json.loads(runner.invoke(app, ["cast", "--json"]).output)
    assert document["digest"] == small_cast.digest
    assert [face["name"] for face in document["faces"]] == list(small_cast.faces)
    assert [each["name"] for each in document["expressions"]] == list(small_cast.expressions)
    assert set(document["expressions"][0]) == {"name", "label", "kind", "region", "facs"}


@pytest.mark.parametrize("arguments", [["cast"], ["cast", "--json"]])
def test_a_missing_cast_is_one_sentence(monkeypatch: pytest.MonkeyPatch, arguments: list[str]) -> None:
    def missing() -> None:
        raise FileNotFoundError("the built-in cast is missing: run `make bake`")

    monkeypatch.setattr("omote.builtin.load_cast", missing)
    done = runner.invoke(app, arguments)
    assert done.exit_code == 1
    assert done.stderr == "omote: the built-in cast is missing: run `make bake`\n"


@pytest.mark.parametrize(("verdicts", "code"), [([(True, "a"), (True, "b")], 0), ([(True, "a"), (False, "b")], 1)])
def test_check_passes_when_all_is_good(
    monkeypatch: pytest.MonkeyPatch, verdicts: list[tuple[bool, str]], code: int
) -> None:
    monkeypatch.setattr("omote.server.check.run_checks", lambda: iter(verdicts))
    done = runner.invoke(app, ["check"])
    assert done.exit_code == code
    assert ("BAD   b" in done.output) == (code == 1)
    assert ("cannot play" in done.stderr) == (code == 1)


def test_show_says_where_to_look(tmp_path: Path, no_show: list[Supervisor]) -> None:
    done = runner.invoke(app, ["show", str(tmp_path / "a.omote"), "--port", "0", "--no-open"])
    assert done.exit_code == 0
    assert len(no_show) == 1
    assert "/stage" in done.output
    assert "/console" in done.output
    assert "/editor" in done.output
    assert (tmp_path / "a.omote").exists()


def test_without_a_file_the_show_is_kept_in_the_state_directory(
    tmp_path: Path, no_show: list[Supervisor], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    assert runner.invoke(app, ["show", "--port", "0", "--no-open"]).exit_code == 0
    assert len(no_show) == 1
    assert (tmp_path / "omote" / "show.omote").exists()


def opened(path: Path, status: int = 0) -> str:
    """What `omote show` says of a file."""
    done = runner.invoke(app, ["show", str(path), "--port", "0", "--no-open"])
    assert done.exit_code == status, done.output
    return done.stderr


@pytest.mark.usefixtures("no_show")
def test_show_says_which_file_it_opened_or_made(tmp_path: Path) -> None:
    assert f"a new show begins in {tmp_path / 'a.omote'}\n" in opened(tmp_path / "a.omote")
    assert f"a new show begins in {tmp_path / 'b.omote'}\n" in opened(tmp_path / "b")  # the ending may be left out
    show = open_show(tmp_path / "c.omote")
    show.write_journal(JournalEntry(1, 0.0, b"state"))
    show.close()
    goes_on = f"the show of {tmp_path / 'c.omote'} goes on; it holds 0 own faces and expressions\n"
    assert goes_on in opened(tmp_path / "c")


@pytest.mark.usefixtures("no_show")
def test_show_makes_no_folder(tmp_path: Path) -> None:
    assert f"its folder {tmp_path / 'nowhere'} is not there" in opened(tmp_path / "nowhere" / "a.omote", status=1)
    (tmp_path / "file").touch()
    assert f"{tmp_path / 'file'} is no folder; name another file" in opened(tmp_path / "file" / "a.omote", status=1)
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


@pytest.mark.parametrize("port", ["70000", "-1", "x", "8090.5", "9" * 5000])
def test_what_is_no_port_is_said_in_plain_words(tmp_path: Path, port: str) -> None:
    done = runner.invoke(app, ["show", str(tmp_path / "a.omote"), "--port", port], env={"COLUMNS": "400"})
    assert done.exit_code == 2
    assert "is no port; give a number from 1 to 65535, or 0 for any free one" in done.stderr
    assert list(tmp_path.iterdir()) == []


@pytest.mark.usefixtures("no_show")
def test_a_port_in_use_is_one_sentence(tmp_path: Path) -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = str(taken.getsockname()[1])
        done = runner.invoke(app, ["show", str(tmp_path / "a.omote"), "--port", port, "--no-open"])
    assert done.exit_code == 1
    assert done.stderr.startswith(f"omote: port {port} on 127.0.0.1 cannot be opened")
    assert done.stderr.count("\n") == 1


@pytest.mark.usefixtures("no_show")
def test_a_refused_port_leaves_no_show_file(tmp_path: Path) -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = str(taken.getsockname()[1])
        runner.invoke(app, ["show", str(tmp_path / "a.omote"), "--port", port, "--no-open"])
    assert list(tmp_path.iterdir()) == []


@pytest.mark.usefixtures("no_show")
def test_a_show_that_is_played_already_is_one_sentence(tmp_path: Path) -> None:
    lock_show(tmp_path / "a.omote")
    done = runner.invoke(app, ["show", str(tmp_path / "a.omote"), "--port", "0", "--no-open"])
    assert done.exit_code == 1
    assert "another Omote plays" in done.stderr


@pytest.mark.usefixtures("no_show")
def test_a_corrupt_show_file_does_not_keep_the_show_from_opening(tmp_path: Path) -> None:
    open_show(tmp_path / "a.omote").close()
    damaged = (tmp_path / "a.omote").read_bytes()[:5000]
    (tmp_path / "a.omote").write_bytes(damaged)
    done = runner.invoke(app, ["show", str(tmp_path / "a.omote"), "--port", "0", "--no-open"])
    assert done.exit_code == 0
    assert (tmp_path / "a.omote.corrupt-1").read_bytes() == damaged
    assert "a.omote is damaged" in done.stderr
    assert "it is kept as" in done.stderr.lower()


def fill_theirs(folder: Path) -> dict[str, bytes]:
    """Files that are no shows, under names that say so and names that do not; gives all of them."""
    with closing(sqlite3.connect(folder / "places.sqlite")) as connection:
        connection.execute("CREATE TABLE theirs (x)")
    for name in ("notes.txt", "notes.omote", "notes"):
        (folder / name).write_text("milk and eggs\n")
    (folder / "picture.png").write_bytes(b"\x89PNG\r\n\x1a\n" + bytes(range(256)) * 40)
    (folder / "disk.img").write_bytes(bytes(100_000))
    (folder / "__init__.py").touch()
    (folder / "theirs.omote").write_bytes((folder / "places.sqlite").read_bytes())
    (folder / "link.omote").symlink_to(folder / "notes.txt")
    return {path.name: path.read_bytes() for path in folder.iterdir()}


SHOW_FILE_COMMANDS = [
    ["show", "{}", "--port", "0", "--no-open"],
    ["export", "kaori", "-o", "new.glb", "--show", "{}"],
    ["file", "list", "{}"],
    ["file", "check", "{}"],
    ["file", "history", "{}", "smile"],
    ["file", "import", "{}", "smile.json"],
    ["file", "export", "{}", "smile", "-o", "new.json"],
]
"""Every command that takes a show file."""


@pytest.mark.usefixtures("no_show")
@pytest.mark.parametrize("words", SHOW_FILE_COMMANDS, ids=" ".join)
def test_what_was_never_a_show_is_rejected_untouched(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, words: list[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    before = fill_theirs(tmp_path)
    for name in before:
        done = runner.invoke(app, [word.format(name) for word in words])
        assert done.exit_code == 1, (name, done.output)
        assert done.stderr.startswith("omote: "), name
        assert not any(word in done.output for word in ("Errno", "Traceback", "database is", "error code")), done.output
        assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before


@pytest.mark.usefixtures("no_show")
@pytest.mark.parametrize("words", SHOW_FILE_COMMANDS, ids=" ".join)
def test_a_folder_or_a_device_is_rejected_untouched(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, words: list[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    os.mkfifo("pipe")
    (tmp_path / "folder").mkdir()
    for name, noun in (("pipe", "a pipe"), ("folder", "a folder"), (os.devnull, "a device")):
        done = runner.invoke(app, [word.format(name) for word in words])
        assert (done.exit_code, noun in done.output) == (1, True), done.output
        assert sorted(path.name for path in tmp_path.iterdir()) == ["folder", "pipe"]
    assert stat.S_ISCHR(Path(os.devnull).stat().st_mode)


@pytest.mark.parametrize(
    ("words", "target"),
    [
        ("render -o {}", "picture.png"),
        ("grid --faces kaori -o {}", "picture.png"),
        ("export kaori -o {}", "head.glb"),
        ("file export a.omote smile -o {}", "package.json"),
        ("file export a.omote smile -o {}", "notes.txt"),
        ("file export a.omote smile -o {}", "a.omote"),
        ("file export a.omote smile -o {}", os.devnull),
    ],
)
def test_an_output_never_takes_the_place_of_another_kind_of_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, words: str, target: str
) -> None:
    monkeypatch.chdir(tmp_path)
    open_show(tmp_path / "a.omote").close()
    for name in ("picture.png", "head.glb", "package.json", "notes.txt"):
        (tmp_path / name).write_text('{"name": "theirs"}\n')
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    done = runner.invoke(app, words.format(target).split())
    assert done.exit_code == 1
    assert f"{target} is " in done.stderr
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before
    assert stat.S_ISCHR(Path(os.devnull).stat().st_mode)


@pytest.mark.usefixtures("no_show")
def test_a_good_copy_is_not_opened_in_place(tmp_path: Path) -> None:
    open_show(tmp_path / "a.omote.good").close()
    done = runner.invoke(app, ["show", str(tmp_path / "a.omote.good"), "--port", "0", "--no-open"])
    assert (done.exit_code, "copy it under a name of its own" in done.stderr) == (1, True)
    assert [path.name for path in tmp_path.iterdir()] == ["a.omote.good"]


@pytest.mark.usefixtures("no_show")
def test_a_link_and_its_file_are_one_show(tmp_path: Path) -> None:
    (tmp_path / "link.omote").symlink_to(tmp_path / "real.omote")
    lock_show(tmp_path / "real.omote")
    done = runner.invoke(app, ["show", str(tmp_path / "link.omote"), "--port", "0", "--no-open"])
    assert (done.exit_code, "another Omote plays" in done.stderr) == (1, True)
    (tmp_path / "loop").symlink_to(tmp_path / "loop")
    done = runner.invoke(app, ["show", str(tmp_path / "loop"), "--port", "0", "--no-open"])
    assert (done.exit_code, done.stderr.count("\n")) == (1, 1)


@pytest.mark.usefixtures("no_show")
def test_pages_that_are_not_built_are_one_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def missing() -> None:
        raise FileNotFoundError("the pages are not built: run `make web`.")

    monkeypatch.setattr("omote.server.supervision.preparation.read_pages", missing)
    done = runner.invoke(app, ["show", str(tmp_path / "a.omote"), "--port", "0", "--no-open"])
    assert (done.exit_code, done.stderr) == (1, "omote: the pages are not built: run `make web`.\n")


def test_the_real_show_opens_and_ends(tmp_path: Path) -> None:
    command = [sys.executable, "-c", "from omote.cli import main; main()", "show", str(tmp_path / "a.omote")]
    show = subprocess.Popen([*command, "--port", "0", "--no-open", "--no-announce"], stdout=subprocess.PIPE, text=True)
    assert show.stdout is not None
    with show.stdout as said:
        assert "/stage" in said.readline()
        show.send_signal(signal.SIGINT)
        assert show.wait(60.0) == 0


def test_an_ending_that_is_left_out_is_the_files_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    open_show(tmp_path / "a.omote").close()
    done = runner.invoke(app, ["file", "export", "a.omote", "smile", "-o", "smile"])
    assert "smile.json holds smile" in done.stderr
    assert "did you mean smile.json?" in runner.invoke(app, ["file", "import", "a.omote", "smile"]).stderr
    (tmp_path / "head").write_bytes(b"glTF")
    assert "is told by its name; end that with .ply, .obj, .glb, .gltf, .vrm, .json" in (
        runner.invoke(app, ["file", "import", "a.omote", "head"]).stderr
    )
    for command in ("list", "check"):
        assert "a.omote" in runner.invoke(app, ["file", command, "a"]).stdout
    assert "there is no show file b.omote" in runner.invoke(app, ["file", "list", "b"]).stderr
    assert "is no name of a document; end it with .json" in (
        runner.invoke(app, ["file", "export", "a.omote", "smile", "-o", "smile.xml"]).stderr
    )
    assert runner.invoke(app, ["file", "import", "b", "smile.json"]).exit_code == 0
    assert {path.name for path in tmp_path.iterdir()} >= {"smile.json", "b.omote"}


@pytest.mark.parametrize("words", [["say"], ["say", "Hello", "--character", "one"]])
def test_a_command_to_speak_is_told_what_does(words: list[str]) -> None:
    done = CliRunner().invoke(app, words)
    assert done.exit_code == 1
    assert 'omote.connect("http://127.0.0.1:8090")["one"].say("Hello")' in done.stderr
