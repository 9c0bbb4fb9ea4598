"""MIDI Show Control as orders for the list of cues: who is meant, and what each command asks for."""

from __future__ import annotations

from collections.abc import Sequence

from omote.perform.cues.cue import check_cue_number
from omote.perform.cues.show_control import ALL_DEVICES, ALL_TYPES, ShowControl
from omote.show.objects.cues import CuePlay, Go, PauseCues, SetStandby

FORMS = (0x01, 0x30, 0x40, ALL_TYPES)
"""The kinds of equipment that a show takes itself for: lighting (which desks send to all), video, projection."""


def is_meant(control: ShowControl, device: int) -> bool:
    """Whether a message is for the show or for all. control: the message; device: the number of the show."""
    return control.device in (device, ALL_DEVICES) and control.form in FORMS


def read_show_control(control: ShowControl, call: str, lists: Sequence[str]) -> CuePlay:
    """What a message asks for; ValueError for a number or a list that there cannot be.

    control: the message; call: its id; lists: the names of the lists of cues, in their order. A list of a message is
    the one that is called so, else the one at that place, from 1.
    """
    number = _plain(control.number) if control.number else ""
    name = _list_named(control.cue_list, lists)
    if control.command == "go":
        return Go(call, number, cue_list=name)
    if control.command == "load":
        return SetStandby(call, check_cue_number(number), cue_list=name)
    return PauseCues(call, on=control.command == "stop")


def _plain(number: str) -> str:
    """A number without zeros that say nothing, which desks write: 012.500 is 12.5."""
    whole, _, decimals = number.partition(".")
    whole = whole.lstrip("0") or "0"
    decimals = decimals.rstrip("0")
    return check_cue_number(f"{whole}.{decimals}" if decimals else whole)


def _list_named(written: str, lists: Sequence[str]) -> str:
    if not written or written in lists:
        return written
    if written.isdecimal() and 1 <= int(written) <= len(lists):
        return lists[int(written) - 1]
    raise ValueError(f"there is no list of cues {written!r}; there are {len(lists)}: {', '.join(lists)[:200]}")
