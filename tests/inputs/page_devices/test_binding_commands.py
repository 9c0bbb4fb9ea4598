"""What pages ask of bindings: played and kept at once; presets are offered once, and learning belongs to one."""

import pytest

from omote.inputs.bindings.binding_changes import EditableBindings
from omote.inputs.bindings.binding_document import decode_stored
from omote.inputs.bindings.bindings import Bindings
from omote.inputs.bindings.control_binding import Binding
from omote.inputs.bindings.target import read_target
from omote.inputs.page_devices.binding_commands import BindingCommands
from omote.inputs.reading import Reading
from omote.show.objects.bindings import Bind, BindingDocument, Learn, LearningState, LoadPreset, RestoreBindings, Unbind

JAW = read_target("/omote/one/channel/jawOpen")
NANO = "nanoKONTROL2"


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
