"""The addresses of OSC by which a sender holds parts of a character, or of the scene."""

from __future__ import annotations

from omote.inputs.addresses.address import PRESS, Address, Kind, Value
from omote.show import messages as wire


def lease_addresses(kind: Kind, *, of_show: bool) -> tuple[Address, ...]:
    """The addresses by which a sender holds, takes over and releases parts: of a character, or of the scene."""
    part = Value("part", kind)
    whose = "of the scene (light, framing, or all of all characters)" if of_show else "of it (face, head ..., or all)"
    return (
        Address(
            "lease/{part}",
            f"holds a part {whose}: nobody else plays it, while leases are on",
            (part, PRESS),
            lambda who, call, part: wire.Lease(call, who, part),
            of_show,
        ),
        Address(
            "take_over/{part}",
            f"takes over a part {whose} that another holds",
            (part, PRESS),
            lambda who, call, part: wire.Lease(call, who, part, take_over=True),
            of_show,
        ),
        Address(
            "release_lease/{part}",
            f"releases a part {whose}, or wants no more what another holds",
            (part, PRESS),
            lambda who, call, part: wire.ReleaseLease(call, who, part),
            of_show,
        ),
    )
