"""What hands play is a part of every performer, with its documentation; what it does: test_performer.py."""

import inspect

from omote.perform.called_mix import CalledMix
from omote.perform.performer import Performer


def test_a_performer_plays_what_hands_play_as_it_is() -> None:
    methods = [name for name, _ in inspect.getmembers(CalledMix, inspect.isfunction)]
    assert "call_face" in methods
    assert all(getattr(Performer, name) is getattr(CalledMix, name) for name in methods)
