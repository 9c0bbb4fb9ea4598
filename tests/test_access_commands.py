"""The commands `omote access ...`, as they are typed."""

import os
from pathlib import Path

import pytest
from typer.testing import CliRunner

from omote.cli import app
from omote.server.access.people_file import open_people, people_path, read_people
from omote.server.persistence.lock import note_address, take_lock
from omote.show.access.people_list import find_person
from omote.showfile.identification import ID_PLACE, MAGIC, OURS

runner = CliRunner()


@pytest.fixture
def show(tmp_path: Path) -> Path:
    open_people(people_path(tmp_path / "tour.omote"))
    return tmp_path / "tour.omote"


def test_a_token_is_made_shown_again_and_revoked(show: Path) -> None:
    words = ["access", "add", "Ada", str(show), "--role", "edit", "--hours", "8", "--address", "http://10.0.0.7:8090"]
    done = runner.invoke(app, words)
    assert done.exit_code == 0
    (address,) = [line.strip() for line in done.stdout.splitlines() if "token=" in line]
    person = find_person(read_people(people_path(show)), address.partition("/editor?token=")[2], 0.0)
    assert person is not None
    assert (person.name, person.role, address[:21]) == ("Ada", "edit", "http://10.0.0.7:8090/")
    again = runner.invoke(app, ["access", "code", "ada", str(show), "--address", "http://10.0.0.7:8090"])
    assert again.stdout == done.stdout
    listed = runner.invoke(app, ["access", "list", str(show)]).stdout
    assert [line.split()[1] for line in listed.splitlines()] == ["view", "operate", "edit", "admin", "Ada"]
    assert "until" in listed.splitlines()[-1]
    assert runner.invoke(app, ["access", "revoke", "Ada", str(show)]).exit_code == 0
    assert "Ada" not in runner.invoke(app, ["access", "list", str(show)]).stdout


@pytest.mark.parametrize(
    ("words", "why"),
    [
        (["add", "Ada", "--role", "king"], "'king' is no role; give view"),
        (["add", "Ada", "--hours", "0"], "for 0 hours cannot be"),
        (["add", "view"], "for 'view' already"),
        (["add", " "], "is no name"),
        (["code", "Ben"], "no token for 'Ben'; there are tokens for view, operate, edit, admin"),
        (["revoke", "Ben"], "no token for 'Ben'"),
        (["revoke", "admin"], "the last who may change"),
    ],
)
def test_what_cannot_be_is_said_and_changes_nothing(show: Path, words: list[str], why: str) -> None:
    before = read_people(people_path(show))
    done = runner.invoke(app, ["access", *words[:2], str(show), *words[2:]])
    assert (done.exit_code, why in done.stderr) == (1, True)
    assert read_people(people_path(show)) == before


def test_what_is_no_show_is_said_and_nothing_is_made(tmp_path: Path) -> None:
    done = runner.invoke(app, ["access", "list", str(tmp_path / "new.omote")])
    assert done.exit_code == 1
    assert f"there is no show file {tmp_path / 'new.omote'}" in done.stderr
    (tmp_path / "notes.omote").write_text("milk, eggs")
    done = runner.invoke(app, ["access", "add", "Ada", str(tmp_path / "notes.omote")])
    assert (done.exit_code, "is a text file, not a show" in done.stderr) == (1, True)
    (tmp_path / "tour.omote").write_bytes(MAGIC.ljust(ID_PLACE, b"\0") + OURS)
    done = runner.invoke(app, ["access", "list", str(tmp_path / "tour")])
    assert (done.exit_code, "there are no tokens for this show yet" in done.stderr) == (1, True)
    assert sorted(each.name for each in tmp_path.iterdir()) == ["notes.omote", "tour.omote"]


@pytest.mark.parametrize("command", ["add", "code", "revoke"])
def test_a_file_before_the_name_is_said(show: Path, command: str) -> None:
    before = read_people(people_path(show))
    for words in ([str(show), "Ada"], ["tour.omote"]):
        done = runner.invoke(app, ["access", command, *words])
        assert (done.exit_code, "is a show file; the name comes first" in done.stderr) == (1, True)
    assert read_people(people_path(show)) == before


@pytest.mark.parametrize(
    ("noted", "printed", "said"),
    [
        ("https://192.0.2.9:9443", "https://192.0.2.9:9443/stage?token=", ""),
        ("https://[2001:db8::7]:9443", "https://[2001:db8::7]:9443/stage?token=", ""),
        ("http://127.0.0.1:8123", ":8123/stage?token=", "for this machine alone: others reach it after"),
        ("", ":8090/stage?token=", "the address is guessed"),
        ("no address", ":8090/stage?token=", "the address is guessed"),
    ],
)
def test_an_address_is_that_of_the_show_as_it_was_opened(show: Path, noted: str, printed: str, said: str) -> None:
    lock = take_lock(show)
    note_address(lock, "http://192.0.2.200:80, which was longer before")
    note_address(lock, noted)
    done = runner.invoke(app, ["access", "code", "view", str(show)])
    os.close(lock)
    assert (done.exit_code, printed in done.stdout) == (0, True)
    assert said in done.stderr
    assert bool(said) == bool(done.stderr)


def test_an_address_by_hand_is_completed_or_rejected(show: Path) -> None:
    lock = take_lock(show)
    note_address(lock, "https://192.0.2.9:9443")
    os.close(lock)
    for given in ("192.0.2.2:1", "https://192.0.2.2:1/console?token=x", " https://192.0.2.2:1 "):
        done = runner.invoke(app, ["access", "code", "view", str(show), "--address", given])
        assert "  https://192.0.2.2:1/stage?token=" in done.stdout
    before = read_people(people_path(show))
    for given in ("ftp://192.0.2.2", "http://192.0.2.2:port", "://"):
        done = runner.invoke(app, ["access", "add", "Ada", str(show), "--address", given])
        assert (done.exit_code, "is no address" in done.stderr) == (1, True)
    assert read_people(people_path(show)) == before
