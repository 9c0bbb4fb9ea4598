"""The reference of trackers, from the table of protocols and the names of coefficients."""

from __future__ import annotations

from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS, advise

INTRODUCTION = """# Trackers

What `omote show --listen` hears: face trackers, each over UDP at a port of its own; `-tcp` over TCP, and
`vtubestudio-pc` is a program that the show connects to. How to use them:
[Your own face](../howto/trackers.md).

A packet that cannot be read is rejected with a reason and counted, and changes nothing. What a frame lacks stays as it
was. Weights lie between -0.5 and 1.5; a head or gaze beyond what ours turns is at its end.

| `--listen` | tracker | port | asked at the phone's port | at the sender |
|---|---|---:|---:|---|
"""
NAMES = """
## Coefficients

Found by name in any case, with `Left` and `Right` or `_L` and `_R`; left and right are the performer's own. Other names
that a sender has play the channels of the cast that are called so, and are left out where there is none.

"""


def tracker_page() -> str:
    """The page: a row for each protocol, and the names."""
    rows = (
        (
            f"`{each.name}`",
            each.title,
            each.port or "of the pages",
            each.phone_port or "",
            advise(each, "ADDRESS", each.port),
        )
        for each in TRACKER_PROTOCOLS.values()
    )
    table = "".join(f"| {' | '.join(map(str, row))} |\n" for row in rows)
    return INTRODUCTION + table + NAMES + ", ".join(f"`{name}`" for name in ARKIT_NAMES) + ".\n"
