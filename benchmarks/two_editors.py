"""Two editors, a console and restarts: in 10,000 random steps nothing acknowledged is lost.

The steps of `tests/edit/session/test_edit_session.py` (edits, undo and redo, clashing saves, revisions brought back,
deletions, what is on air kept, orders that fail, servers that start anew), drawn afresh at every run, over tables in
memory and over real show files. Ends with 1, and prints the shortest history that fails, when any promise is broken.
`--steps N` sets their number.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections import Counter
from itertools import count
from pathlib import Path
from typing import Any

from hypothesis import HealthCheck, settings
from hypothesis.stateful import run_state_machine_as_test

from omote.edit.protocol import messages as wire
from omote.showfile.show_file import open_show
from tests.edit.session.test_edit_session import Authors, ShowTables

LENGTH = 100
"""Steps of a history."""


def count_steps(seen: Counter[str], folder: Path | None) -> type[Authors]:
    """Authors that count what they went through; folder: their show files lie there, None: in memory."""
    numbers = count()

    class Counted(Authors):
        def __init__(self) -> None:
            super().__init__()
            if folder is not None:
                shows = ShowTables(open_show(folder / f"{next(numbers)}.omote"))
                self.tables = lambda: shows
                self.close = shows.show.close

        def check_invariants(self, *arguments: Any, **options: Any) -> None:
            seen["steps"] += 1
            super().check_invariants(*arguments, **options)

        def teardown(self) -> None:
            replies = [each.message for outcome in self.harness.outcomes for each in outcome.replies]
            saved = [message for message in replies if isinstance(message, wire.Saved)]
            seen["acknowledged"] += sum(hasattr(message, "request") for message in replies)
            seen["kept aside"] += sum(message.aside for message in saved)
            seen["revisions"] += len(self.saved)
            if folder is not None:
                self.close()

    return Counted


def play(steps: int, folder: Path | None) -> Counter[str]:
    """What was gone through in as many steps at least; AssertionError where a promise is broken."""
    seen: Counter[str] = Counter()
    fresh = settings(
        max_examples=max(1, steps // LENGTH),
        stateful_step_count=LENGTH,
        derandomize=False,
        database=None,
        deadline=None,
        suppress_health_check=list(HealthCheck),
    )
    while seen["steps"] < steps:
        run_state_machine_as_test(count_steps(seen, folder), settings=fresh)
    return seen


def main() -> int:
    """Plays and prints."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--steps", type=int, default=10_000)
    steps = parser.parse_args().steps
    with tempfile.TemporaryDirectory() as folder:
        for where, place, share in (("in memory", None, 1.0), ("in show files", Path(folder), 0.2)):
            seen = play(int(steps * share), place)
            print(f"{where}: {seen['steps']} steps, {seen['acknowledged']} answers, {seen['revisions']} revisions,")
            print(f"  {seen['kept aside']} of them beside another editor's; acknowledged and lost: 0")
    return 0


if __name__ == "__main__":
    sys.exit(main())
