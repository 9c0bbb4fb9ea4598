"""What a binding names is there or not, and it is said what."""

from omote.inputs.bindings.control_binding import Binding
from omote.inputs.bindings.missing_names import list_missing
from omote.inputs.bindings.target import read_target
from omote.inputs.osc_orders import OrderReader
from omote.perform.pads.blend_space import Pad, PadLook
from tests import synthetic

TARGETS = {
    "/omote/one/face": ("broad",),
    "/omote/*/expression": ("grin",),
    "/omote/two/panic": (),
    "/omote/one/channel/jawOpen": (),
    "/omote/one/channel/grin": (),
    "/omote/one/fade/face": (),
    "/omote/framing": ("one+two",),
    "/omote/one/pad/Mouth": (),
    "/omote/one/pad/snout": (),
    "bank:b": (),
}
SNOUT = "/omote/one/pad/snout"
PAD = Pad("mouth", "mouth", 1, (PadLook("Rest", {"neutral": 1.0}, (-1.0,)), PadLook("Jaw", {"jawOpen": 1.0}, (1.0,))))
BINDINGS = [
    Binding("pad", str(at), read_target(path, given, "x" if "/pad/" in path else None))
    for at, (path, given) in enumerate(TARGETS.items())
]


def missing(*characters: str) -> dict[str, str]:
    reader = OrderReader(synthetic.cast(), dict(zip(characters, characters, strict=True)))
    reasons = list_missing(BINDINGS, reader, {"mouth": PAD})
    return {path: reason for path, reason in zip(TARGETS, reasons, strict=True) if reason}


def test_what_is_not_there_is_named() -> None:
    found = missing("one")
    assert set(found) == {"/omote/*/expression", "/omote/two/panic", "/omote/one/channel/grin", "/omote/framing", SNOUT}
    assert found[SNOUT].startswith("there is no pad 'snout'")
    assert found["/omote/*/expression"].startswith("there is no expression 'grin' in this cast")
    assert found["/omote/two/panic"] == "there is no character 'two' in this scene, which has one, and * for all"


def test_what_is_there_again_plays_again() -> None:
    assert set(missing("one", "two")) == {"/omote/*/expression", "/omote/one/channel/grin", SNOUT}
