"""The command `omote show`, as it is typed: ports, and what is said of sockets."""

import re
import socket
from pathlib import Path

import pytest
from typer.testing import CliRunner

from omote.cli import app
from omote.server.access.people_file import new_people, read_people
from omote.server.access.show_addresses import FIRST_PAGES
from omote.server.http.static_pages import PAGES as STATIC_PAGES
from omote.server.supervision.supervisor import Supervisor
from omote.show.access.access_role import ACCESS_ROLES
from omote.show.access.people_list import token_of
from omote.show_command import PAGES, announce, say_who_is_heard

runner = CliRunner()
pytestmark = pytest.mark.usefixtures("announcements_made")


@pytest.mark.parametrize("port", ["70000", "on", "9000.5"])
def test_what_is_no_port_for_osc_is_said(tmp_path: Path, port: str) -> None:
    done = runner.invoke(app, ["show", str(tmp_path / "a.omote"), "--osc", port], env={"COLUMNS": "400"})
    assert done.exit_code == 2
    assert "is no port" in done.stderr
    assert list(tmp_path.iterdir()) == []


@pytest.mark.usefixtures("no_show")
def test_a_port_for_osc_that_is_taken_ends_the_command_and_off_needs_none(tmp_path: Path) -> None:
    opened = ["show", str(tmp_path / "a.omote"), "--port", "0", "--no-open", "--osc"]
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind(("127.0.0.1", 0))
        done = runner.invoke(app, [*opened, str(taken.getsockname()[1])])
    assert done.exit_code == 1
    assert "cannot be opened for OSC (another program has it, perhaps another show)" in done.stderr
    assert list(tmp_path.iterdir()) == []
    assert runner.invoke(app, [*opened, "off"]).exit_code == 0


@pytest.mark.usefixtures("no_show")
def test_a_show_begins_without_osc_where_another_program_has_its_usual_port(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind(("127.0.0.1", 0))
        monkeypatch.setattr("omote.show_sockets.OSC_PORT", taken.getsockname()[1])
        done = runner.invoke(app, ["show", str(tmp_path / "a.omote"), "--port", "0", "--no-open"])
    assert done.exit_code == 0
    assert "OSC is off: port" in done.stderr


@pytest.mark.usefixtures("no_show")
@pytest.mark.parametrize(("words", "expected"), [([], True), (["--no-announce"], False), (["--osc", "off"], False)])
def test_a_show_is_announced_under_its_own_name(
    tmp_path: Path, announcements_made: list[tuple[object, ...]], words: list[str], expected: bool
) -> None:
    opened = ["show", str(tmp_path / "ghosts.omote"), "--port", "0", "--no-open", "--osc", "0", *words]
    assert runner.invoke(app, opened).exit_code == 0
    assert [(host, show) for host, _, _, show in announcements_made] == [("127.0.0.1", "ghosts")] * expected


def test_on_windows_it_says_where_it_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("omote.show_command.sys.platform", "win32")
    done = runner.invoke(app, ["show"])
    assert done.exit_code == 1
    assert "WSL" in done.stderr


@pytest.mark.usefixtures("no_show")
def test_at_its_end_it_says_so_and_where_the_show_is_kept(tmp_path: Path) -> None:
    path = tmp_path / "a.omote"
    opened = ["show", str(path), "--port", "0", "--no-open", "--osc", "off"]
    assert runner.invoke(app, opened).stderr.splitlines()[-1] == (
        f"omote: the show has ended; all that was authored and was on air is kept in {path}: omote show {path} goes on."
    )


ADDRESSES = re.compile(r"^  (\w+) +http://[\w.:]+(/\w+)\?token=([\w-]{30})$", re.MULTILINE)


@pytest.mark.parametrize("host", ["127.0.0.1", "localhost"])
def test_on_loopback_nobody_needs_a_token(tmp_path: Path, no_show: list[Supervisor], host: str) -> None:
    done = runner.invoke(app, ["show", str(tmp_path / "a.omote"), "--host", host, "--port", "0", "--no-open"])
    assert done.exit_code == 0
    assert "token" not in done.stdout + done.stderr
    assert "--people" not in no_show[0]._program
    assert not (tmp_path / "a.omote.people").exists()


def test_off_loopback_it_prints_an_address_for_each_role_and_a_picture(
    tmp_path: Path, no_show: list[Supervisor]
) -> None:
    words = ["show", str(tmp_path / "a.omote"), "--host", "0.0.0.0", "--port", "0", "--no-open", "--osc", "off"]
    done = runner.invoke(app, words)
    assert done.exit_code == 0
    people = read_people(tmp_path / "a.omote.people")
    assert ADDRESSES.findall(done.stdout) == [
        (role, FIRST_PAGES[role], token_of(people, person))
        for role, person in zip(ACCESS_ROLES, people.people, strict=True)
    ]
    assert re.search(
        r"^  The pages http://\S+/cues, /solo, /clips, /notes, /runs, /camera, ", done.stdout, re.MULTILINE
    )
    assert "heard" not in done.stderr
    words[1:2] = [str(tmp_path / "b.omote"), "--artnet", "0"]
    assert "Art-Net is heard from this machine alone" in runner.invoke(app, words).stderr
    assert done.stdout.count("\u2580") > 50 or done.stdout.count("##") > 50
    assert no_show[0]._program[-2:] == ("--people", str(tmp_path / "a.omote.people"))
    (address,) = re.findall(r"^  view +(\S+)$", done.stdout, re.MULTILINE)
    again = runner.invoke(app, ["access", "code", "view", str(tmp_path / "a.omote")])
    assert (address in again.stdout, again.stderr) == (True, "")


def test_a_list_of_people_that_cannot_be_read_ends_the_command(tmp_path: Path) -> None:
    (tmp_path / "a.omote.people").write_text("{}")
    done = runner.invoke(app, ["show", str(tmp_path / "a.omote"), "--host", "0.0.0.0", "--port", "0", "--no-open"])
    assert done.exit_code == 1
    assert "is no list of people" in done.stderr


def test_https_is_handed_on_and_said(
    tmp_path: Path, no_show: list[Supervisor], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    words = ["show", str(tmp_path / "a.omote"), "--port", "0", "--no-open", "--osc", "off"]
    done = runner.invoke(app, [*words, "--https"])
    assert (done.exit_code, "stage       https://127.0.0.1:" in done.stdout) == (0, True)
    folder = tmp_path / "omote" / "https"
    named = ["--certificate", f"{folder}/certificate.pem", "--key", f"{folder}/key.pem"]
    assert list(no_show[0]._program[-6:]) == [*named, "--authority", f"{folder}/authority.pem"]
    words[1] = str(tmp_path / "b.omote")
    assert runner.invoke(app, [*words, *named]).exit_code == 0
    for wrong, why in (
        (named[:2], "belong together"),
        ([*named[:3], f"{folder}/gone.pem"], "gone.pem cannot be read"),
        ([*named[:3], named[1]], "certificate.pem has no key in it"),
    ):
        done = runner.invoke(app, [*words, *wrong])
        assert (done.exit_code, why in done.stderr) == (1, True)


def test_each_page_is_printed_in_one_column(capsys: pytest.CaptureFixture[str]) -> None:
    announce("127.0.0.1", 8090, browser=False)
    lines = [line for line in capsys.readouterr().out.splitlines() if "http" in line]
    assert [line.split() for line in lines] == [[page, f"http://127.0.0.1:8090/{page}"] for page in PAGES]
    assert set(PAGES) == {path[1:] for path in STATIC_PAGES} - {""}
    assert len({line.index("http") for line in lines}) == 1


@pytest.mark.parametrize("screen", [True, False])
def test_a_browser_opens_where_there_is_a_screen(monkeypatch: pytest.MonkeyPatch, screen: bool) -> None:
    opened: list[str] = []
    monkeypatch.setattr("omote.show_command.has_screen", lambda: screen)
    monkeypatch.setattr("omote.show_command.webbrowser.open", opened.append)
    announce("127.0.0.1", 8090, browser=True)
    assert opened == (["http://127.0.0.1:8090/stage", "http://127.0.0.1:8090/console"] if screen else [])


@pytest.mark.parametrize(
    ("words", "why"),
    [
        (["--sacn", "0"], "'0' is no universe"),
        (["--allow", "desk"], "'desk' is neither an address nor a network"),
        (["--bindings", "gone.toml"], "gone.toml cannot be read (it is not there)"),
    ],
)
def test_what_is_asked_wrongly_of_devices_ends_the_command(tmp_path: Path, words: list[str], why: str) -> None:
    done = runner.invoke(app, ["show", str(tmp_path / "a.omote"), "--port", "0", "--no-open", *words])
    assert (done.exit_code, done.stderr.count("\n")) == (1, 1)
    assert why in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_what_was_asked_of_devices_is_handed_on(tmp_path: Path, no_show: list[Supervisor]) -> None:
    (tmp_path / "desk.toml").write_text('[[binding]]\ndevice = "a"\ncontrol = "b"\nto = "/omote/panic"\n')
    words = ["--osc", "off", "--artnet", "0", "--allow", "any", "--bindings", str(tmp_path / "desk.toml")]
    done = runner.invoke(app, ["show", str(tmp_path / "a.omote"), "--port", "0", "--no-open", *words])
    assert done.exit_code == 0
    (supervisor,) = no_show
    assert supervisor._program[-4:] == ("--allow", "any", "--bindings", str(tmp_path / "desk.toml"))
    assert list(supervisor._handed) == ["--artnet"]


@pytest.mark.parametrize(
    ("allow", "said"),
    [
        ("", "are heard from this machine alone: --allow 192.0.2.0/24 lets"),
        ("10.0.0.0/8", "from this machine and from 10.0.0.0/8"),
    ],
)
def test_off_loopback_it_says_who_is_heard(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, allow: str, said: str
) -> None:
    monkeypatch.setattr("omote.server.access.show_addresses.own_address", lambda: "192.0.2.2")
    say_who_is_heard(allow, ["OSC", "Art-Net"])
    heard = capsys.readouterr().err
    assert said in heard
    assert "OSC and Art-Net are heard" in heard
    say_who_is_heard(allow, [])
    assert capsys.readouterr().err == ""


def test_who_starts_a_show_off_loopback_enters_as_an_admin(monkeypatch: pytest.MonkeyPatch) -> None:
    opened: list[str] = []
    people = new_people(0.0)
    monkeypatch.setattr("omote.show_command.has_screen", lambda: True)
    monkeypatch.setattr("omote.show_command.webbrowser.open", opened.append)
    announce("0.0.0.0", 8090, browser=True, people=people, scheme="https")
    token = token_of(people, people.people[-1])
    assert opened == [f"https://127.0.0.1:8090/{page}?token={token}" for page in ("stage", "console")]
