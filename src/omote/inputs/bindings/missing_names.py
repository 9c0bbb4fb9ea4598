"""Bindings whose face, expression, channel, pad or character is not there now: they wait until the name comes back."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from omote.inputs.bindings.control_binding import Binding
from omote.inputs.osc_orders import OrderReader
from omote.inputs.osc_packet import Argument, OscMessage
from omote.perform.name_lookup import find_name
from omote.perform.pads.blend_space import Pad


def list_missing(bindings: Iterable[Binding], reader: OrderReader, pads: Mapping[str, Pad]) -> list[str]:
    """For each binding what it names that there is not, in words; "" where all is there.

    reader: of the cast and the characters of the show; bindings: those of the show; pads: its pads, by name.
    """
    reason_of: dict[tuple[str, tuple[Argument, ...]], str] = {}
    reasons = []
    for binding in bindings:
        target = binding.target
        asked = target.path, tuple(value.low for value in target.values) or target.arguments
        if asked not in reason_of:
            reason_of[asked] = "" if target.bank is not None else _why_missing(OscMessage(*asked), reader)
            if target.pad and not reason_of[asked]:
                reason_of[asked] = _why_no_pad(target.pad, pads)
        reasons.append(reason_of[asked])
    return reasons


def _why_missing(message: OscMessage, reader: OrderReader) -> str:
    try:
        reader.read(message, "")
    except ValueError as error:
        return str(error).removeprefix(f"{message.address}: ")
    return ""


def _why_no_pad(name: str, pads: Mapping[str, Pad]) -> str:
    try:
        find_name(name, pads, "pad", where="")
    except ValueError as error:
        return str(error)
    return ""
