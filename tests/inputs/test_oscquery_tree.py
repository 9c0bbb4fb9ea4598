"""The tree of addresses that surfaces read: each leaf is one that the parser obeys, and the other way round."""

from itertools import product

import pytest

from omote.inputs.osc_addresses import ADDRESSES
from omote.inputs.osc_feedback import AddressValues
from omote.inputs.osc_orders import OrderReader
from omote.inputs.osc_packet import Argument, OscMessage
from omote.inputs.oscquery_tree import (
    NO_ACCESS,
    READ_WRITE,
    WRITE,
    Node,
    build_addresses,
    find_node,
    host_info,
    with_values,
)
from omote.model.body.pose_regions import POSE_REGIONS
from omote.model.known_names import PLAY_REGIONS
from omote.perform.complexion import SKIN_FADERS
from omote.perform.easing import DEFAULT_EASING
from omote.perform.gestures import GESTURES
from omote.perform.layers.layer_names import LAYER_PARTS, LAYERS
from omote.perform.lights import LIGHTS
from omote.perform.scene.scene import Scene
from omote.perform.speech.spelling import LANGUAGES
from omote.perform.springs.cast_springs import SPRING_NAMES
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import CallFace
from omote.show.objects.faders import SetChannel
from omote.show.objects.leases import SetLeases
from omote.show.objects.link import Hello
from omote.show.ownership.parts import CHARACTER_PARTS, SCENE_PARTS
from omote.show.session import ShowSession
from tests import synthetic

CAST = synthetic.cast()
PADS = {name: pad.dimensions for name, pad in Scene.begun(CAST).pads.items()}
OF_CUES = ("/omote/back", "/omote/assert", "/omote/update_cue", "/keep_pass")
"""What needs a cue that has been called (tests/show/cues), or a pass that is recorded (tests/show/clips)."""


@pytest.fixture
def session() -> ShowSession:
    return ShowSession(CAST)


def leaves(node: Node) -> list[Node]:
    own = [node] if "TYPE" in node else []
    return own + [leaf for child in node.get("CONTENTS", {}).values() for leaf in leaves(child)]


def nodes(node: Node) -> list[Node]:
    return [node] + [below for child in node.get("CONTENTS", {}).values() for below in nodes(child)]


def extremes(leaf: Node) -> list[list[Argument]]:
    """The arguments at both ends of what a leaf says that it takes."""
    ranges = leaf.get("RANGE", [])
    if None in ranges or leaf["FULL_PATH"].endswith(("/look_at/character", *OF_CUES)):
        return []  # of what there is not yet: there is one character here, which cannot look at itself, and no cue
    lows = [each["VALS"][0] if "VALS" in each else each["MIN"] for each in ranges]
    highs = [each["VALS"][-1] if "VALS" in each else each["MAX"] for each in ranges]
    return [lows, highs] if ranges else [[True]]


def test_all_that_the_tree_offers_is_obeyed_at_both_ends_of_its_range(session: ShowSession) -> None:
    session.join("osc", "OSC")
    session.receive("osc", SetLeases("on", True), 0.0)
    for leaf in leaves(build_addresses(CAST, ["one"], PADS)):
        for arguments in extremes(leaf):
            call = f"{leaf['FULL_PATH']}{arguments}"[-64:]
            orders = OrderReader(CAST, {"one": "One"}).read(OscMessage(leaf["FULL_PATH"], tuple(arguments)), call)
            assert orders
            assert [session.receive("osc", order, 0.0) for order in orders] == [[]] * len(orders)


def test_a_text_has_no_range_and_another_character_is_one_of_those_that_there_are() -> None:
    told = {leaf["FULL_PATH"]: leaf for leaf in leaves(build_addresses(CAST, ["one", "two"]))}
    assert told["/omote/one/look_at/gaze_point"]["RANGE"] == [None]
    assert told["/omote/gaze_point"]["TYPE"] == "sfff"
    assert told["/omote/one/look_at/character"]["RANGE"] == [{"VALS": ["one", "two"]}]


def test_every_address_and_every_name_of_the_cast_has_its_leaf() -> None:
    macros = {"one": ["smile"], "two": ["jaw", "turn"]}
    paths = {leaf["FULL_PATH"] for leaf in leaves(build_addresses(CAST, ["one", "two"], PADS, macros))}
    wanted = set()
    for address in ADDRESSES:
        for owner in ["one"] if address.of_show else ["one", "two"]:
            written = address.pattern.replace("{character}", owner)
            layered = address.path.startswith("layer")
            known: set[str] = {*LAYERS} if layered else set(CAST.expressions) - {"neutral"}
            known = {*GESTURES} if address.path.startswith("gesture") else known
            known = {*PADS} if address.path.startswith("pad/") else known
            known = {*macros[owner]} if address.path.startswith("macro/") else known
            known = {*SPRING_NAMES} if address.path.startswith("spring/") else known
            known = {*SKIN_FADERS} if address.path.startswith("skin/") else known
            unlisted = ("memory", "clip", "setup")  # whose names no cast has
            known = set() if address.path.startswith(unlisted) else known
            names = known if "{name}" in written or layered else {""}
            languages = LANGUAGES if "{language}" in written else [""]
            posed = POSE_REGIONS if address.path.startswith("pose/") else PLAY_REGIONS
            regions = (LAYER_PARTS if layered else posed) if "{region}" in written else [""]
            held = SCENE_PARTS if address.of_show else CHARACTER_PARTS
            parts = [*held, "all"] if "{part}" in written else [""]
            places = product(names, regions, parts, languages)
            wanted |= {
                written.format(name=name, layer=name, region=region, part=part, language=language)
                for name, region, part, language in places
            }
    assert paths == wanted


def test_each_node_says_where_it_stands_and_what_may_be_done() -> None:
    root = build_addresses(CAST, ["one"])
    for node in nodes(root):
        assert find_node(root, node["FULL_PATH"]) is node
        told = node.get("TYPE") not in (None, "I") and not node["FULL_PATH"].endswith(
            (
                "/enter",
                "/leave",
                "/say",
                "/say/en",
                "/say/de",
                "/say/voice",
                "/fade_to_black",
                "/fade_up",
                "/take",
                "/stop_clip",
            )
        )
        assert node["ACCESS"] == (NO_ACCESS if "TYPE" not in node else READ_WRITE if told else WRITE)
        assert node["ACCESS"] != READ_WRITE or len(node["TYPE"]) == len(node["RANGE"])
    assert find_node(root, "/omote/nobody/face") is None
    assert find_node(root, "/omote/one/face/on") is None


def test_ranges_are_the_names_of_the_cast_and_the_limits_of_numbers() -> None:
    root = build_addresses(CAST, ["one"])
    face, head, light = (find_node(root, f"/omote/{path}") for path in ("one/face", "one/head", "light"))
    assert face is not None
    assert head is not None
    assert light is not None
    assert face["RANGE"] == [{"VALS": list(CAST.faces)}]
    assert light["RANGE"] == [{"VALS": list(LIGHTS)}]
    assert (head["TYPE"], head["UNIT"]) == ("fff", ["angle.degree"] * 3)
    assert head["RANGE"] == [{"MIN": pytest.approx(-90.0), "MAX": pytest.approx(90.0)}] * 3


def test_values_are_those_on_air(session: ShowSession) -> None:
    session.receive("a", Hello("console", PROTOCOL_VERSION), 0.0)
    session.receive("a", SetChannel("one", "jawOpen", 0.25), 0.0)
    session.receive("a", CallFace("one", "c", "broad", 0.0, DEFAULT_EASING), 0.0)
    root = with_values(build_addresses(CAST, ["one"]), AddressValues(session.tick(0.0)))
    values = {leaf["FULL_PATH"]: leaf.get("VALUE") for leaf in leaves(root)}
    assert values["/omote/one/channel/jawOpen"] == [0.25]
    assert values["/omote/one/face"] == ["broad"]
    assert values["/omote/one/head"] == [0.0, 0.0, 0.0]
    assert values["/omote/panic"] is None
    quiet = [value for path, value in values.items() if "/channel/" in path and "jawOpen" not in path]
    assert quiet == [[0.0]] * len(quiet)


def test_the_host_says_its_port_and_what_it_does_not_do() -> None:
    told = host_info("Omote", 9001)
    assert (told["OSC_PORT"], told["OSC_TRANSPORT"]) == (9001, "UDP")
    assert told["EXTENSIONS"]["VALUE"] is True
    assert told["EXTENSIONS"]["LISTEN"] is False
