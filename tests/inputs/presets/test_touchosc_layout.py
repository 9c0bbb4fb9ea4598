"""The layout for TouchOSC, read back by our own reading of its XML: what its controls send plays the show."""

import zlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from xml.etree import ElementTree

import py2tosc
import pytest

from omote.builtin import load_cast
from omote.inputs.osc_feedback import tell_state
from omote.inputs.osc_input import OscInput
from omote.inputs.osc_packet import Argument, encode_message
from omote.inputs.presets.touchosc_layout import FOLLOW_PORT, FRAME, OF_CHARACTER, build_touchosc_layout
from omote.model.cast import Cast
from omote.perform.lights import LIGHTS
from omote.show.objects.leases import SetLeases
from omote.show.session import ShowSession

CONVERSIONS: dict[str, Callable[[str | float], Argument]] = {"STRING": str, "FLOAT": float, "INTEGER": int}
PLACE = ("127.0.0.1", 5)


@dataclass(frozen=True)
class OscControl:
    """A control that sends OSC. frame: x, y, width and height on the whole canvas."""

    kind: str
    name: str
    frame: tuple[float, float, float, float]
    message: ElementTree.Element

    @property
    def address(self) -> str:
        """What it sends to."""
        parts = self.message.findall("path/partial")
        assert {part.findtext("type") for part in parts} == {"CONSTANT"}
        return "".join(part.findtext("value") or "" for part in parts)

    def arguments(self, **values: float) -> list[Argument]:
        """What it sends where its values stand at these, 0 to 1."""
        return [self._argument(part, values) for part in self.message.findall("arguments/partial")]

    @staticmethod
    def _argument(part: ElementTree.Element, values: dict[str, float]) -> Argument:
        convert = CONVERSIONS[part.findtext("conversion") or ""]
        value = part.findtext("value") or ""
        if part.findtext("type") == "CONSTANT":
            return convert(value)
        low, high = (float(part.findtext(name) or "") for name in ("scaleMin", "scaleMax"))
        return convert(low + values[value] * (high - low))


def controls_of(node: ElementTree.Element, left: float = 0.0, top: float = 0.0) -> Iterator[OscControl]:
    """All controls that send OSC below a node."""
    properties = {each.findtext("key"): each for each in node.findall("properties/property")}
    numbers = [float(part.text or "") for part in properties["frame"].find("value") or ()]
    x, y = left + numbers[0], top + numbers[1]
    name = properties["name"].findtext("value") or "" if "name" in properties else ""
    for message in node.findall("messages/osc"):
        yield OscControl(node.get("type", ""), name, (x, y, numbers[2], numbers[3]), message)
    for child in node.findall("children/node"):
        yield from controls_of(child, x, y)


def read_controls(data: bytes) -> list[OscControl]:
    """The controls of a file."""
    root = ElementTree.fromstring(zlib.decompress(data))
    assert (root.tag, [child.tag for child in root]) == ("lexml", ["node"])
    return list(controls_of(root[0]))


@pytest.fixture(scope="module")
def session() -> ShowSession:
    """A show of the built-in cast."""
    return ShowSession(load_cast(), epoch=7)


@pytest.fixture(scope="module")
def data(session: ShowSession) -> bytes:
    """Its layout."""
    return build_touchosc_layout(
        session.cast, session.scene, {name: pad.dimensions for name, pad in session.scene.pads.items()}
    )


@pytest.fixture(scope="module")
def controls(data: bytes) -> list[OscControl]:
    """The controls of it."""
    return read_controls(data)


def press(osc: OscInput, control: OscControl, now: float = 0.0, **values: float) -> None:
    """Sends what a control sends."""
    osc.receive(PLACE, encode_message(control.address, *control.arguments(**values)), now)


def test_all_that_its_controls_send_is_obeyed(session: ShowSession, controls: list[OscControl]) -> None:
    osc = OscInput(lambda: session)
    session.join("desk", "Desk")
    session.receive("desk", SetLeases("on", True), 0.0)
    for control in controls:
        for x, y in ((0.0, 0.0), (0.5, 1.0), (1.0, 0.5)):
            press(osc, control, x=x, y=y)
            assert osc.last_rejection is None, control.address
    assert osc.heard == 3 * len(controls)


def test_each_name_has_a_button_that_calls_it(session: ShowSession, controls: list[OscControl]) -> None:
    cast = session.cast
    for path, names in (("one/face", cast.faces), ("one/expression", cast.expressions), ("light", LIGHTS)):
        buttons = {control.name: control for control in controls if control.address == f"/omote/{path}"}
        assert list(buttons) == list(names)
        for name, button in buttons.items():
            assert (button.kind, button.arguments()) == ("BUTTON", [name])
            assert [each.findtext("condition") for each in button.message.findall("triggers/trigger")] == ["RISE"]
            assert button.message.get("receive", button.message.findtext("receive")) == "0"


def test_faders_and_pads_play_what_they_show(session: ShowSession, controls: list[OscControl]) -> None:
    osc = OscInput(lambda: session)
    by_address = {control.address: control for control in controls}
    press(osc, by_address["/omote/one/channel/jawOpen"], x=0.75)
    press(osc, by_address["/omote/one/gaze"], x=1.0, y=0.5)
    press(osc, by_address["/omote/one/head"], x=0.5, y=0.5)
    state = session.tick(0.0).characters["one"]
    assert state.channels["jawOpen"] == pytest.approx(1.0)
    assert state.gaze == pytest.approx((0.698132, 0.0), abs=1e-5)
    assert state.head == pytest.approx((0.0, 0.0, 0.0), abs=1e-6)
    told = tell_state(session.tick(0.1))
    followed = [each for each in controls if each.message.findtext("receive") == "1" and each.address in told]
    assert {"/omote/one/gaze", "/omote/one/fade/face", "/omote/one/channel/jawOpen"} <= {e.address for e in followed}
    for control in followed:
        watched = [each.findtext("var") for each in control.message.findall("triggers/trigger")]
        assert watched == (["x", "y"] if control.kind == "XY" else ["x"])
        assert len(control.arguments(x=0.0, y=0.0)) == len(told[control.address]), control.address


def test_a_button_lets_its_controls_follow(session: ShowSession, controls: list[OscControl]) -> None:
    osc = OscInput(lambda: session)
    press(osc, next(each for each in controls if each.address == "/omote/subscribe"))
    assert ("127.0.0.1", FOLLOW_PORT) in {place for place, _ in osc.news(session.tick(1.0), 1.0)}


def test_every_character_has_its_pages_and_all_have_one(cast: Cast) -> None:
    controls = read_controls(build_touchosc_layout(cast, ["one", "two"], {"mouth": 2, "jaw": 1}))
    owners = {who: [c for c in controls if c.address.startswith(f"/omote/{who}/")] for who in ("one", "two", "*")}
    assert len(owners["one"]) == len(owners["two"]) == len(owners["*"]) > 0
    assert sorted({control.address.split("/")[3] for control in owners["two"]}) == sorted(
        {path.split("/")[0] for paths in OF_CHARACTER.values() for path in paths}
    )


def test_controls_lie_on_the_canvas_and_are_large_enough_for_fingers(controls: list[OscControl]) -> None:
    _, _, width, height = FRAME
    for control in controls:
        x, y, wide, high = control.frame
        assert x >= 0
        assert y >= 0
        assert x + wide <= width
        assert y + high <= height
        assert min(wide, high) >= 60, control


def test_a_reader_that_is_not_ours_finds_nothing_wrong_and_writes_the_same(data: bytes) -> None:
    document = py2tosc.loads(data)
    assert document.validate() == []
    assert document.dumps().encode() == zlib.decompress(data)
