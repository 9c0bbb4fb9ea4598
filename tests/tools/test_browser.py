"""Looking for a browser: a wish first, then what is installed, then an earlier download."""

from pathlib import Path

import pytest

from omote.server.headless.chromium import COMMANDS
from tools import browser
from tools.browser import SENTENCE, find_browser


def executable(path: Path) -> Path:
    """An empty program at `path`."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("#!/bin/sh\n")
    path.chmod(0o755)
    return path


def test_the_wish_comes_first(tmp_path: Path) -> None:
    wish = executable(tmp_path / "mine")
    executable(tmp_path / "bin" / "chromium")
    assert find_browser({"OMOTE_BROWSER": str(wish), "PATH": str(tmp_path / "bin")}, tmp_path) == wish


def test_a_wish_that_is_no_file_is_refused_and_not_replaced(tmp_path: Path) -> None:
    executable(tmp_path / "chromium")
    with pytest.raises(FileNotFoundError, match="OMOTE_BROWSER is '/nowhere/chrome', which is no file"):
        find_browser({"OMOTE_BROWSER": "/nowhere/chrome", "PATH": str(tmp_path)}, tmp_path)


@pytest.mark.parametrize("command", COMMANDS)
def test_an_installed_one_is_found_under_each_of_its_names(tmp_path: Path, command: str) -> None:
    installed = executable(tmp_path / "bin" / command)
    assert find_browser({"PATH": str(tmp_path / "bin")}, tmp_path) == installed


@pytest.mark.parametrize("folder", ["chromium-1255/chrome-linux", "chromium-1255/chrome-linux64"])
def test_an_earlier_download_comes_last(tmp_path: Path, folder: str) -> None:
    downloaded = executable(tmp_path / "browsers" / folder / "chrome")
    assert find_browser({"PATH": str(tmp_path / "bin")}, tmp_path / "browsers") == downloaded
    installed = executable(tmp_path / "bin" / "chromium")
    assert find_browser({"PATH": str(tmp_path / "bin")}, tmp_path / "browsers") == installed


def test_where_there_is_none_the_sentence_says_what_to_install(tmp_path: Path) -> None:
    assert find_browser({"PATH": str(tmp_path)}, tmp_path) is None
    assert "apt-get install chromium" in SENTENCE


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """What is asked for on a machine with nothing, where neither Debian nor Playwright can help."""
    asked: list[str] = []
    monkeypatch.setattr(browser, "find_browser", lambda: None)
    monkeypatch.setattr(browser, "find_library", lambda name: None)
    monkeypatch.setattr(browser, "can_use_apt", lambda: True)
    monkeypatch.setattr(browser, "install_debian", lambda *packages: asked.extend(packages))
    monkeypatch.setattr(browser, "install_playwright", lambda: asked.append("playwright"))
    return asked


def test_debian_is_asked_first_then_playwright_then_one_sentence_is_said(
    asked: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert browser.main() == 1
    assert asked == [*browser.DEBIAN, "playwright"]
    assert capsys.readouterr().err == SENTENCE + "\n"


def test_debian_is_not_asked_where_it_is_not_ours(asked: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(browser, "can_use_apt", lambda: False)
    assert browser.provide_browser() is None
    assert asked == ["playwright"]


def test_nothing_is_installed_where_all_is_there(
    asked: list[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(browser, "find_browser", lambda: executable(tmp_path / "chromium"))
    monkeypatch.setattr(browser, "find_library", lambda name: "lib.so")
    assert browser.provide_browser() == tmp_path / "chromium"
    assert asked == []


def test_a_browser_on_a_bare_machine_gets_its_libraries_only(
    asked: list[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(browser, "find_browser", lambda: executable(tmp_path / "chromium"))
    assert browser.provide_browser() == tmp_path / "chromium"
    assert asked == [package for package in browser.DEBIAN if package != "chromium"]


def test_a_driver_that_does_not_start_is_said_in_one_sentence(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    monkeypatch.setattr(browser, "provide_browser", lambda: tmp_path / "chromium")
    monkeypatch.setattr(browser, "driver_trouble", lambda: "libatomic.so.1: no such file")
    assert browser.main() == 1
    assert capsys.readouterr().err == browser.NO_DRIVER.format("libatomic.so.1: no such file") + "\n"


def test_the_driver_starts_here() -> None:
    assert browser.driver_trouble() is None
