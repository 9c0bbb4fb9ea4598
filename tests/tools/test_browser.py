"""Looking for a browser: a wish first, then what is installed, then an earlier download."""

from pathlib import Path

import pytest

from tools.browser import COMMANDS, SENTENCE, find_browser


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
    browser = executable(tmp_path / "bin" / command)
    assert find_browser({"PATH": str(tmp_path / "bin")}, tmp_path) == browser


@pytest.mark.parametrize("folder", ["chromium-1255/chrome-linux", "chromium-1255/chrome-linux64"])
def test_an_earlier_download_comes_last(tmp_path: Path, folder: str) -> None:
    downloaded = executable(tmp_path / "browsers" / folder / "chrome")
    assert find_browser({"PATH": str(tmp_path / "bin")}, tmp_path / "browsers") == downloaded
    installed = executable(tmp_path / "bin" / "chromium")
    assert find_browser({"PATH": str(tmp_path / "bin")}, tmp_path / "browsers") == installed


def test_where_there_is_none_the_sentence_says_what_to_install(tmp_path: Path) -> None:
    assert find_browser({"PATH": str(tmp_path)}, tmp_path) is None
    assert "apt-get install chromium" in SENTENCE
