"""Bindings that people change: what is taken back is as it was, and what a file has fixed stays."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.bindings.binding_changes import REMEMBERED_CHANGES, EditableBindings
from omote.inputs.bindings.binding_file import MOST_BINDINGS
from omote.inputs.bindings.control_binding import Binding
from omote.inputs.bindings.target import read_target

JAW = read_target("/omote/one/channel/jawOpen")
SMILE = read_target("/omote/one/channel/smile")
ALL = [Binding(d, c, t, high=h) for d in ("pad", "desk") for c in ("1", "2") for t in (JAW, SMILE) for h in (1.0, 0.5)]


@given(st.lists(st.tuples(st.sampled_from(["bind", "unbind", "give"]), st.sampled_from(ALL)), max_size=12))
def test_all_changes_taken_back_in_turn_leave_what_was_there(steps: list[tuple[str, Binding]]) -> None:
    bindings = EditableBindings(ALL[:2])
    seen = [set(bindings.own)]
    made = []
    for number, (what, binding) in enumerate(steps):
        try:
            if what == "bind":
                bindings.bind(str(number), binding)
            elif what == "unbind":
                bindings.unbind(str(number), binding)
            else:
                bindings.give(str(number), binding.device, [binding])
        except ValueError:
            continue
        made.append(str(number))
        seen.append(set(bindings.own))
    for change in reversed(made):
        assert set(bindings.own) == seen.pop()
        bindings.restore(f"back {change}", change)
    assert set(bindings.own) == seen.pop()


def test_a_binding_takes_the_place_of_the_one_that_it_replaces() -> None:
    first = ALL[0]
    second = ALL[4]
    third = ALL[8]
    bindings = EditableBindings([first, second, third])
    changed = bindings.bind("a", Binding("pad", "9", JAW), replaces=[second])
    assert changed.removed == (second,)
    assert bindings.own == (first, *changed.added, third)


def test_what_a_file_has_fixed_plays_first_and_is_not_changed() -> None:
    fixed = Binding("pad", "1", SMILE)
    bindings = EditableBindings([Binding("pad", "1", JAW), Binding("pad", "2", JAW)], [fixed])
    assert bindings.playing == (fixed, Binding("pad", "2", JAW))
    with pytest.raises(ValueError, match="bound in the file of --bindings"):
        bindings.bind("a", Binding("pad", "1", JAW))
    with pytest.raises(ValueError, match="in the file of --bindings"):
        bindings.unbind("b", fixed)
    given = bindings.give("c", "pad", [Binding("pad", "1", JAW), Binding("pad", "3", JAW)])
    assert given.added == (Binding("pad", "3", JAW),)


def test_what_is_not_there_is_not_taken_away_and_what_is_forgotten_not_back() -> None:
    bindings = EditableBindings()
    with pytest.raises(ValueError, match="bound to nothing so"):
        bindings.unbind("a", ALL[0])
    for number in range(REMEMBERED_CHANGES + 1):
        bindings.bind(str(number), ALL[number % 2])
    with pytest.raises(ValueError, match="cannot be taken back any more"):
        bindings.restore("x", "0")


def test_there_are_not_more_than_a_file_may_have() -> None:
    bindings = EditableBindings(Binding("pad", str(number), JAW) for number in range(MOST_BINDINGS))
    with pytest.raises(ValueError, match=f"at most {MOST_BINDINGS}"):
        bindings.bind("a", Binding("pad", "one more", JAW))
    assert len(bindings.own) == MOST_BINDINGS
