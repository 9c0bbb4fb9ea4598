"""What pages ask of bindings: played and kept at once; presets are offered once, and learning belongs to one."""

import pytest

from omote.inputs.bindings.binding_changes import EditableBindings
from omote.inputs.bindings.binding_document import decode_stored
from omote.inputs.bindings.bindings import Bindings
from omote.inputs.bindings.control_binding import Binding
from omote.inputs.bindings.target import read_target
from omote.inputs.page_devices.binding_commands import BindingCommands
from omote.inputs.reading import Reading
from omote.show.objects.bindings import (
    Bind,
    BindingDocument,
    BindingsChanged,
    Learn,
    LearningState,
    LoadPreset,
    RestoreBindings,
    Unbind,
)

JAW = read_target("/omote/one/channel/jawOpen")
NANO = "nanoKONTROL2"
XBOX = "Xbox pad"


def commands(*own: Binding, presets: dict[str, str] | None = None) -> tuple[BindingCommands, Bindings, list[bytes]]:
    playing = Bindings()
    kept = list[bytes]()
    return BindingCommands(EditableBindings(own), playing, presets or {}, kept.append), playing, kept


def test_a_preset_is_offered_at_the_first_time_alone() -> None:
    made, playing, kept = commands()
    first = made.greet(NANO, "midi")
    assert first is not None
    assert {each.device for each in playing.bindings} == {NANO}
    assert decode_stored(kept[-1])[1] == {NANO: "nanokontrol2"}
    again, playing, kept = commands(presets={NANO: "nanokontrol2"})
    assert again.greet(NANO, "midi") is first
    assert (playing.bindings, kept) == ((), [])


def test_a_device_on_which_something_is_bound_keeps_it() -> None:
    own = Binding(NANO, "1/cc0", JAW)
    made, playing, _ = commands(own)
    assert made.greet(NANO, "midi") is not None
    assert playing.bindings == (own,)


def test_a_device_that_nobody_knows_has_no_preset() -> None:
    made, playing, kept = commands()
    assert made.greet("a desk of my own", "midi") is None
    assert (playing.bindings, kept) == ((), [])


def test_what_is_loaded_is_taken_back_whole() -> None:
    own = Binding(NANO, "1/cc100", JAW)
    made, playing, _ = commands(own)
    changed = made.carry_out(LoadPreset("p1", NANO, "nanokontrol2", "one"))
    assert [each.control for each in changed.removed] == ["1/cc100"]
    assert own not in playing.bindings
    made.carry_out(RestoreBindings("r1", "p1"))
    assert playing.bindings == (own,)


def test_the_newest_who_asks_learns() -> None:
    made, playing, _ = commands()
    made.learn("a", "Ana", Learn("l1", "/omote/one/head", "yaw"), 0.0)
    made.learn("b", "Ben", Learn("l2", JAW.path), 0.0)
    assert made.list_now().learning == LearningState("l2", JAW.path, "", [], "Ben")
    assert made.hear([Reading("pad", "1/note60", 1.0, key=True)]) is None
    learned = made.hear([Reading("pad", "1/note60", 0.0, key=True)])
    assert learned is not None
    assert learned[0] == "b"
    assert [each.button for each in playing.bindings] == ["toggle"]
    assert made.hear([Reading("pad", "1/note61", 0.0, key=True)]) is None


def push(made: BindingCommands, control: str, to: str, axis: str) -> BindingsChanged:
    """Learns a direction by pushing a stick of the gamepad."""
    made.learn("a", "Ana", Learn(f"{control} {to} {axis}", to, axis), 0.0)
    learned = [made.hear([Reading(XBOX, control, place)]) for place in (0.5, 0.7, 1.0)]
    (changed,) = [each[1] for each in learned if each is not None]
    return changed


def test_what_is_learned_takes_the_place_of_the_preset_and_undo_brings_that_back() -> None:
    made, playing, _ = commands()
    made.greet(XBOX, "gamepad")
    of_preset = playing.bindings
    changed = push(made, "axis0", "/omote/one/head", "yaw")
    assert sorted((each.control, each.to) for each in changed.removed) == [
        ("axis0", "/omote/*/gaze"),  # the same stick
        ("axis2", "/omote/*/head"),  # the same direction by another one
    ]
    heads = [each for each in playing.bindings if each.target.path.endswith("/head") and each.target.axis_name == "yaw"]
    assert [each.control for each in heads] == ["axis0"]
    push(made, "axis0", "/omote/one/gaze", "yaw")  # of what somebody has learned nothing makes way
    assert len([each for each in playing.bindings if each.control == "axis0"]) == 2
    made.carry_out(RestoreBindings("back 1", "axis0 /omote/one/gaze yaw"))
    made.carry_out(RestoreBindings("back 2", "axis0 /omote/one/head yaw"))
    assert set(playing.bindings) == set(of_preset)


def test_a_bank_of_one_s_own_leaves_the_preset_to_the_others() -> None:
    made, playing, _ = commands()
    made.greet(XBOX, "gamepad")
    made.learn("a", "Ana", Learn("l", "/omote/one/head", "yaw", bank="mine"), 0.0)
    before = playing.bindings
    for place in (0.5, 0.7, 1.0):
        made.hear([Reading(XBOX, "axis0", place)])
    assert playing.bindings[:-1] == before


def test_a_preset_leaves_levels_to_what_somebody_has_bound_before() -> None:
    own = Binding(NANO, "1/cc100", read_target("/omote/one/head", (), "yaw"))
    made, playing, _ = commands(own, Binding(NANO, "1/note1", read_target("/omote/one/expression", ("smile", 1.0))))
    made.greet(XBOX, "gamepad")
    given = [each for each in playing.bindings if each.device == XBOX]
    played = {(each.target.path, each.target.axis_name) for each in given}
    assert ("/omote/*/head", "yaw") not in played
    assert {("/omote/*/head", "pitch"), ("/omote/*/gaze", "yaw")} <= played
    assert any(each.target.arguments[:1] == ("smile",) for each in given)  # two keys may call the same


@pytest.mark.parametrize(
    "wrong",
    [
        Bind("x", BindingDocument("pad", "1/cc7", "/omote/one/nose")),
        Unbind("x", BindingDocument("pad", "1/cc7", JAW.path)),
        LoadPreset("x", "pad", "theremin"),
        RestoreBindings("x", "never"),
    ],
    ids=lambda message: type(message).__name__,
)
def test_what_cannot_be_changes_nothing(
    wrong: Bind | Unbind | LoadPreset | RestoreBindings,
) -> None:
    made, playing, kept = commands(Binding("pad", "1/cc8", JAW))
    number = made.number
    with pytest.raises(ValueError, match=r".{10,}"):
        made.carry_out(wrong)
    assert (made.number, kept, len(playing.bindings)) == (number, [], 1)
