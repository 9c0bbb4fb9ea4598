"""`make trust`: tries what is in this folder as a whole and writes build/trust.md. `--seed N`, `--most N`."""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from collections.abc import Mapping
from pathlib import Path

from tests.trust.disk_faults import ERRORS, ROOT, DiskTrial, Findings, disk_trial
from tests.trust.save_paths import BUGS, PATHS

PAGE = ROOT / "build" / "trust.md"
MEMORY = Path("/dev/shm")
CAUGHT_BY: Mapping[str, str] = {
    "saves are not synced": "edit",
    "a save is acknowledged before it is written": "edit",
    "a save that fails is acknowledged": "edit",
    "a save is more than one commit": "edit",
    "the journal's log is not synced": "play",
    "a backup is not synced": "back up",
    "a backup is synced after it is renamed": "back up",
    "a backup is written over the one before": "back up",
    "backups are rotated before the new one is verified": "back up a damaged file",
    "a corrupt file is deleted": "recover",
}
"""On which save path each planted bug is tried."""
HEAD = """# How Omote is broken on purpose

`make trust` writes this page; `make trust SEED=N` draws others of what is drawn, and the same N draws the same. It
tries the show file so far, not yet the whole of a show: no server, no browser and no network is disturbed here. The
short form, of some seconds, is part of `make test`.

## What was tried

Each save path runs before a library that records each change of the disk and can let each call fail
(`tests/trust/faulty_disk.c`). A loss of power leaves what was synced; of the rest of a file any write may be missing
and the last one torn between two sectors; names change in their order (`tests/trust/crash_states.py`, after Pillai et
al., OSDI 2014). Each call fails by {errors}, once and from then on. Afterwards the show is opened as `omote show`
opens it: it opens, every acknowledged save and synced state is there, each save is whole or not there, every backup is
whole, a corrupt file is kept.
"""
FOUND = """
## What it found, and is mended

* A show file from `omote file export` was renamed and its folder not synced: with the power it could go again.
* `omote file export` to a disk that became full said nothing, and wrote a show file without what it was to hold.
* A new show whose first start lost its power in the log's first page was called another program's database: no start
  opened it.

## What others say

Figures of other programs, by their own pages or their users': Blender saves every 2 minutes, Bitfocus Companion every
10 s, Mosquitto every 30 minutes; Companion keeps one backup and one before it. SQLite, which keeps the show file, is
itself tested with failing calls and simulated losses of power (<https://sqlite.org/testing.html>). We know of no
program for the stage that publishes which faults it was tried with.
"""


def catch(trial: DiskTrial, bug: str, most: int, every: int) -> Mapping[str, int]:
    """The checks that catch a planted bug, with how often; of failing calls only where no loss of power tells."""
    path = CAUGHT_BY[bug]
    return trial.lose_power(path, bug, most).found or trial.fail_calls(path, bug, every).found


def report(findings: Mapping[str, Findings], caught: Mapping[str, Mapping[str, int]], seed: int, seconds: float) -> str:
    """The page: what was tried and found, in Markdown."""
    lines = [HEAD.format(errors=", ".join(ERRORS)).rstrip(), ""]
    lines += ["| save path | states after a loss of power | failing calls | checks that failed |", "|---|---|---|---|"]
    for path, found in findings.items():
        failed = ", ".join(f"{check} ({count})" for check, count in found.found.items()) or "none"
        lines.append(f"| {path} | {found.states:,} | {found.failures:,} | {failed} |")
    states = sum(found.states for found in findings.values())
    failures = sum(found.failures for found in findings.values())
    lines.append(f"\nSeed {seed}: {states:,} states and {failures:,} failing calls, with the bugs in {seconds:.0f} s.")
    lines += ["", "## Planted bugs", "", "| bug | caught by |", "|---|---|"]
    lines += [f"| {bug} | {', '.join(checks) or '**nothing**'} |" for bug, checks in caught.items()]
    return "\n".join(lines) + "\n" + FOUND


def main() -> int:
    """Tries all, prints how far it is, and writes the page; 1 where anything was found or a bug was not."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--most", type=int, default=2000, help="states of a save path that are checked")
    parser.add_argument("--every", type=int, default=4, help="each call fails (1), each second one (2) ...")
    options = parser.parse_args()
    begun = time.monotonic()
    findings = dict[str, Findings]()
    caught = dict[str, Mapping[str, int]]()
    place = MEMORY if MEMORY.is_dir() else None
    with tempfile.TemporaryDirectory(dir=place) as folder, disk_trial(Path(folder), options.seed) as trial:
        for path in PATHS:
            findings[path] = trial.lose_power(path, most=options.most)
            failing = trial.fail_calls(path, every=options.every)
            findings[path].failures = failing.failures
            findings[path].found += failing.found
            findings[path].examples |= failing.examples
            sys.stdout.write(f"{path}: {findings[path]}\n")
            sys.stdout.flush()
        for bug in BUGS:
            caught[bug] = catch(trial, bug, options.most // 10, options.every)
            sys.stdout.write(f"{bug}: {dict(caught[bug])}\n")
            sys.stdout.flush()
    PAGE.parent.mkdir(exist_ok=True)
    PAGE.write_text(report(findings, caught, options.seed, time.monotonic() - begun))
    return int(any(found.found for found in findings.values()) or not all(caught.values()))


if __name__ == "__main__":
    sys.exit(main())
