"""Commands that pages ask for: what they say, and why they failed."""

import sys

import pytest

from omote.server.http.command_process import CommandError, run_command

pytestmark = pytest.mark.asyncio


async def run(program: str) -> list[str]:
    """What a program of Python says as a command."""
    return await run_command(["one"], (sys.executable, "-c", f"import sys; {program}"))


async def test_a_command_says_what_it_did() -> None:
    said = await run("sys.stderr.write(f'omote: {sys.argv[1]}.\\nomote: two.\\n')")
    assert said == ["one.", "two."]


async def test_a_failure_is_its_last_sentence() -> None:
    with pytest.raises(CommandError, match=r"^two\.$"):
        await run("sys.exit('omote: one.\\nomote: two.')")
    with pytest.raises(CommandError, match="without a word"):
        await run("sys.exit(3)")
