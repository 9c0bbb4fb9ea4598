"""How commands speak: beside what programs read, in words, and no name controls the terminal."""

from __future__ import annotations

import sqlite3

import pytest
import typer

from omote.showfile.schema import ShowFileError
from omote.terminal import escape_controls, exit_on_refusal, fail, has_screen, read_count, say


@pytest.mark.parametrize("text", ["\x1b[2J", "a\nb", "\u202e", "\x07"])
def test_control_characters_are_escaped_and_can_be_told_back(text: str) -> None:
    assert escape_controls(text).isprintable()
    assert escape_controls(text).encode().decode("unicode_escape") == text


def test_what_is_printable_stays() -> None:
    assert escape_controls("Käse 顔 'x'") == "Käse 顔 'x'"


def test_sentences_go_beside_what_programs_read(capsys: pytest.CaptureFixture[str]) -> None:
    say("a \x1b[31mred name")
    out, err = capsys.readouterr()
    assert (out, err) == ("", "omote: a \\x1b[31mred name\n")


def test_failing_says_why_and_ends_with_one(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(typer.Exit) as ended:
        fail("no such face")
    assert ended.value.exit_code == 1
    assert capsys.readouterr().err == "omote: no such face\n"


@pytest.mark.parametrize("error", [ShowFileError("odd"), OSError("odd"), ValueError("odd"), sqlite3.Error("odd")])
def test_an_error_of_a_file_is_said_and_no_traceback(error: Exception, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(typer.Exit), exit_on_refusal():
        raise error
    assert capsys.readouterr().err.startswith("omote: ")


def test_what_is_stopped_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(typer.Exit) as ended, exit_on_refusal():
        raise KeyboardInterrupt
    assert (ended.value.exit_code, capsys.readouterr().err) == (130, "omote: stopped.\n")


@pytest.mark.parametrize("text", ["0", "65", "two", "", "-1", "²", "9" * 5000])
def test_what_is_no_number_of_browsers_is_refused(text: str) -> None:
    assert (read_count(" 2 "), read_count(64)) == (2, 64)
    with pytest.raises(typer.BadParameter, match="is no number of browsers; give one from 1 to 64"):
        read_count(text)


def test_an_error_of_our_own_is_not_hidden() -> None:
    with pytest.raises(KeyError), exit_on_refusal():
        raise KeyError("ours")


def test_a_screen_is_known_by_its_display(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("omote.terminal.sys.platform", "linux")
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    assert not has_screen()
    monkeypatch.setenv("WAYLAND_DISPLAY", "wayland-0")
    assert has_screen()
