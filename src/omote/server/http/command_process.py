"""Runs a command of omote for a page, in a process beside the show at a lower priority: no tick waits for it."""

from __future__ import annotations

import asyncio
import sys
from collections.abc import Sequence

PROGRAM = """
from omote.server.process.priority import lower_priority
lower_priority()
from omote.cli import main
main()
"""
COMMAND = (sys.executable, "-c", PROGRAM)
LONGEST = 300.0
"""Seconds that a command may take on a busy machine."""


class CommandError(Exception):
    """A command failed; its text is a sentence for the person who asked."""


async def run_command(arguments: Sequence[str], command: Sequence[str] = COMMAND) -> list[str]:
    """Runs a command; returns the sentences that it said. CommandError where it fails or takes too long."""
    child = await asyncio.create_subprocess_exec(
        *command, *arguments,
        stdin=asyncio.subprocess.DEVNULL, stdout=asyncio.subprocess.DEVNULL, stderr=asyncio.subprocess.PIPE,
    )  # fmt: skip
    try:
        _, said = await asyncio.wait_for(child.communicate(), LONGEST)
    except TimeoutError:
        raise CommandError("it took too long; try again when less plays.") from None
    finally:
        if child.returncode is None:
            child.kill()
            await child.wait()
    sentences = [line.removeprefix("omote: ") for line in said.decode(errors="replace").strip().splitlines()]
    if child.returncode:
        raise CommandError(sentences[-1] if sentences else "it failed without a word; try again")
    return sentences
