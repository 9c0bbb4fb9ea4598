"""Finding a browser, and having one that ends with us."""

import asyncio
import os
import sys
from pathlib import Path

import pytest

from omote.server.headless.chromium import COMMANDS, find_chromium, open_chromium
from omote.server.headless.devtools import BrowserError
from tests.server.false_browser import false_browser


def test_the_wish_comes_before_what_is_installed(tmp_path: Path) -> None:
    request = tmp_path / "mine"
    request.touch()
    false_browser(tmp_path)
    assert find_chromium({"OMOTE_BROWSER": str(request), "PATH": str(tmp_path)}) == request


def test_a_wish_that_is_no_file_is_refused_and_not_replaced(tmp_path: Path) -> None:
    false_browser(tmp_path)
    with pytest.raises(FileNotFoundError, match="OMOTE_BROWSER is '/nowhere/chrome', which is no file"):
        find_chromium({"OMOTE_BROWSER": "/nowhere/chrome", "PATH": str(tmp_path)})


@pytest.mark.parametrize("command", COMMANDS)
def test_an_installed_one_is_found_under_each_of_its_names(tmp_path: Path, command: str) -> None:
    installed = false_browser(tmp_path).rename(tmp_path / command)
    assert find_chromium({"PATH": str(tmp_path)}) == installed


def test_without_one_it_says_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("omote.server.headless.chromium.MAC_APPLICATIONS", ())
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
async def test_a_browser_that_does_not_end_is_ended(tmp_path: Path) -> None:
    deaf = false_browser(tmp_path, loop="\nimport threading\nthreading.Event().wait()\n")
    async with open_chromium(deaf):
        pass  # it comes here, and the block ends: that is all


@pytest.mark.asyncio
async def test_a_browser_ends_when_we_are_killed(tmp_path: Path) -> None:
    path = false_browser(tmp_path, loop="\nprint(os.getpid(), file=open(sys.argv[0] + '.pid', 'w'))\nos.read(4, 1)\n")
    code = f"""if True:
        import asyncio, os, pathlib, signal
        from omote.server.headless.chromium import open_chromium
        async def main():
            async with open_chromium(pathlib.Path({str(path)!r})) as tools:
                await tools.call("Browser.getVersion")
        asyncio.run(main())
    """
    ours = await asyncio.create_subprocess_exec(sys.executable, "-c", code, stdout=asyncio.subprocess.PIPE)
    while not (started := tmp_path / "chromium.pid").exists() or not started.read_text():
        await asyncio.sleep(0.01)
    ours.kill()
    await ours.wait()
    while alive(int(started.read_text())):
        await asyncio.sleep(0.01)


def alive(pid: int) -> bool:
    """Whether there is such a process."""
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True


@pytest.mark.asyncio
async def test_a_program_that_is_no_browser_is_a_sentence(tmp_path: Path) -> None:
    async with open_chromium(false_browser(tmp_path, loop="")) as tools:
        with pytest.raises(BrowserError, match=r"the browser (has )?ended"):
            await tools.call("Browser.getVersion")
