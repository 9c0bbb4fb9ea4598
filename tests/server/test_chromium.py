"""Finding a browser, and having one that ends with us."""

from pathlib import Path

import pytest

from omote.server.chromium import COMMANDS, find_chromium, open_chromium
from omote.server.devtools import BrowserError
from tests.server.false_browser import false_browser


def test_the_wish_comes_before_what_is_installed(tmp_path: Path) -> None:
    wish = tmp_path / "mine"
    wish.touch()
    false_browser(tmp_path)
    assert find_chromium({"OMOTE_BROWSER": str(wish), "PATH": str(tmp_path)}) == wish


def test_a_wish_that_is_no_file_is_refused_and_not_replaced(tmp_path: Path) -> None:
    false_browser(tmp_path)
    with pytest.raises(FileNotFoundError, match="OMOTE_BROWSER is '/nowhere/chrome', which is no file"):
        find_chromium({"OMOTE_BROWSER": "/nowhere/chrome", "PATH": str(tmp_path)})


@pytest.mark.parametrize("command", COMMANDS)
def test_an_installed_one_is_found_under_each_of_its_names(tmp_path: Path, command: str) -> None:
    installed = false_browser(tmp_path).rename(tmp_path / command)
    assert find_chromium({"PATH": str(tmp_path)}) == installed


def test_without_one_it_says_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("omote.server.chromium.MAC_APPLICATIONS", ())
    with pytest.raises(FileNotFoundError, match="install Chromium"):
        find_chromium({"PATH": str(tmp_path)})


@pytest.mark.asyncio
async def test_a_browser_answers_and_ends_with_its_block(tmp_path: Path) -> None:
    async with open_chromium(false_browser(tmp_path)) as tools:
        assert (await tools.call("Browser.getVersion", x=1))["parameters"] == {"x": 1}
        arguments = (tmp_path / "arguments").read_text().splitlines()
        profile = Path(next(each for each in arguments if each.startswith("--user-data-dir=")).partition("=")[2])
        assert profile.is_dir()
        assert "--headless" in arguments
    assert not profile.exists()


@pytest.mark.asyncio
async def test_a_browser_that_does_not_end_is_ended(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("omote.server.chromium.GOODBYE", 0.01)
    deaf = false_browser(tmp_path, loop="\nimport threading\nthreading.Event().wait()\n")
    async with open_chromium(deaf):
        pass  # it comes here, and the block ends: that is all


@pytest.mark.asyncio
async def test_a_program_that_is_no_browser_is_a_sentence(tmp_path: Path) -> None:
    async with open_chromium(false_browser(tmp_path, loop="")) as tools:
        with pytest.raises(BrowserError, match=r"the browser (has )?ended"):
            await tools.call("Browser.getVersion")
