"""Every address of OSC that a show obeys, once: the parser, the documentation and what surfaces are told use this list.

Angles are in degrees. A number comes as float, integer, boolean or numeric text, a switch as 0, 1, true or false; as
OSC's buttons send 1 when they are pressed and 0 when they are let go, a command without a value happens at a number
above 0 or without any.
"""

from __future__ import annotations

import difflib
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache

from omote.inputs.addresses.address import PRESS, ROOT, SECONDS, Address, Value
from omote.inputs.addresses.lease_addresses import lease_addresses
from omote.inputs.addresses.speech_addresses import SPEECH_ADDRESSES, STRENGTH
from omote.inputs.osc_packet import OscError
from omote.inputs.trackers.packet_format import explain_format
from omote.perform.easing import DEFAULT_EASING
from omote.perform.frame import DETAIL_LIMIT, DETAILS, DIRECTION_LIMITS, POINT_LIMITS, TargetKind
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST, GAZE_LIMITS, HEAD_LIMITS
from omote.perform.scene.character_names import ALL
from omote.perform.scene.scene_frame import PLACE_LIMITS
from omote.show import messages as wire

CALL_SECONDS = 1.0
"""How long a call takes that names no time."""
CHANNEL = "channel/{name}"
BY_HAND = "hand"
"""In the place of the seconds: the T-bar moves the call."""

REMEMBERED_LENGTH = 120
"""Characters of an address that is remembered when it was found: a fader sends the same one again and again."""

VMC_ROOT = "/VMC/"
"""How addresses begin that a tracker sends: to its own port, not to this one."""
FADER = Value("position")
INFLUENCE = Value("influence")
WAY = replace(SECONDS, kind="time")
_LIMITS = {**PLACE_LIMITS, "turn": (-180.0, 180.0)}
_UNITS = {"x": "m", "depth": "m", "size": "", "turn": "degrees"}
PLACE = *(Value(name, low=low, high=high, unit=_UNITS[name]) for name, (low, high) in _LIMITS.items()), WAY


def _angles(limits: Mapping[str, float]) -> tuple[Value, ...]:
    return tuple(
        Value(name, low=-round(math.degrees(limit), 9), high=round(math.degrees(limit), 9), unit="degrees")
        for name, limit in limits.items()
    )


def _radians(value: Value, degrees: float) -> float:
    """An angle as messages have it; ValueError, in the degrees that came, where it is out of its range."""
    if not value.low <= degrees <= value.high:
        span = f"{value.low:g} to {value.high:g}"
        raise ValueError(f"the {value.name} is {degrees:g} degrees; give a number from {span}")
    return math.radians(degrees)


def _motion_detail(detail: str) -> Callable[..., wire.FromClient]:
    return lambda who, _, value: wire.SetMotion(who, **{detail: value})


_LOOKED_AT: Mapping[TargetKind, str] = {
    "gaze_point": "a named point of the house",
    "character": "another character",
    "stage": "the camera of a stage, by the name in its address",
}


def _look_at(kind: TargetKind) -> Callable[..., wire.FromClient]:
    return lambda who, _, name: wire.LookAt(who, kind, name)


def _turn(message: Callable[..., wire.FromClient], angles: Sequence[Value]) -> Callable[..., wire.FromClient]:
    return lambda who, _, *degrees: message(who, *map(_radians, angles, degrees))


HEAD, GAZE, DIRECTION = _angles(HEAD_LIMITS), _angles(GAZE_LIMITS), _angles(DIRECTION_LIMITS)
POINT = tuple(Value(name, low=low, high=high, unit="m") for name, (low, high) in POINT_LIMITS.items())
ADDRESSES: tuple[Address, ...] = (
    Address(
        "face",
        "brings a face on air",
        (Value("name", "face"), SECONDS),
        lambda who, call, name, seconds: wire.CallFace(who, call, name, seconds, DEFAULT_EASING),
    ),
    Address(
        "expression",
        "brings an expression on air, all of it or a part (strength)",
        (Value("name", "expression"), SECONDS, STRENGTH),
        lambda who, call, name, seconds, strength: wire.CallExpression(
            who, call, name, seconds, DEFAULT_EASING, strength=strength
        ),
    ),
    Address(
        "expression/{region}",
        "brings an expression on air in one region of the face alone: brows, eyes, mouth or rest",
        (Value("region", "region"), Value("name", "expression"), WAY),
        lambda who, call, region, name, seconds: wire.CallExpression(who, call, name, seconds, DEFAULT_EASING, region),
    ),
    Address(
        CHANNEL,
        "sets the weight of a unit or of any expression, beside the calls",
        (Value("name", "channel"), Value("weight", low=CHANNEL_LOWEST, high=CHANNEL_HIGHEST)),
        lambda who, _, name, weight: wire.SetChannel(who, name, weight),
    ),
    Address(
        "layer/{name}",
        "sets how much of a layer shows, everywhere",
        (Value("name", "layer"), INFLUENCE),
        lambda who, _, layer, influence: wire.SetLayer(who, layer, None, influence),
    ),
    Address(
        "layer/{name}/{region}",
        "sets how much of a layer shows in brows, eyes, mouth, rest, head or gaze",
        (Value("name", "layer"), Value("region", "part"), INFLUENCE),
        lambda who, _, layer, region, influence: wire.SetLayer(who, layer, region, influence),
    ),
    Address(
        "layer_on/{name}",
        "switches a layer on (1 or true) or off (0 or false)",
        (Value("name", "layer"), Value("on", "switch")),
        lambda who, _, layer, on: wire.SetLayer(who, layer, None, None, on == 1.0),
    ),
    Address(
        "motion",
        "sets how much it moves by itself: lids, eyes, head, breath; 0.5 as people move",
        (Value("liveliness", low=0.0, high=1.0),),
        lambda who, _, liveliness: wire.SetMotion(who, liveliness),
    ),
    *(
        Address(
            f"motion/{detail}",
            f"sets the {detail} of its own motion, beside all else of it; 1 at first",
            (Value(detail, low=0.0, high=DETAIL_LIMIT),),
            _motion_detail(detail),
        )
        for detail in DETAILS
    ),
    Address(
        "motion/idle",
        "whether it moves as people do (1 or true) while its tracker is lost, where it holds still otherwise",
        (Value("on", "switch"),),
        lambda who, _, on: wire.SetMotion(who, idle=on == 1.0),
    ),
    Address("look_ahead", "its eyes look at nothing", (PRESS,), lambda who, _: wire.LookAt(who, "ahead")),
    Address(
        "look_at/direction",
        "its eyes look in a direction of the house: to the picture's right, up",
        DIRECTION,
        lambda who, _, *degrees: wire.LookAt(
            who, "direction", yaw=_radians(DIRECTION[0], degrees[0]), pitch=_radians(DIRECTION[1], degrees[1])
        ),
    ),
    Address(
        "look_at/point",
        "its eyes look at a point: to the picture's right, above the eyes, before the front line",
        POINT,
        lambda who, _, x, y, z: wire.LookAt(who, "point", x=x, y=y, z=z),
    ),
    *(
        Address(
            f"look_at/{kind}",
            f"its eyes look at {what}",
            (Value("name", "character" if kind == "character" else "text"),),
            _look_at(kind),
        )
        for kind, what in _LOOKED_AT.items()
    ),
    Address("head", "turns the head", HEAD, _turn(wire.SetHead, HEAD)),
    Address("gaze", "turns the eyes, relative to the head", GAZE, _turn(wire.SetGaze, GAZE)),
    Address("fade/face", "moves the T-bar of the faces", (FADER,), lambda who, _, x: wire.FadeFace(who, x)),
    Address(
        "fade/expression", "moves the T-bar of the expressions", (FADER,), lambda who, _, x: wire.FadeExpression(who, x)
    ),
    Address("release/face", "lets go of the T-bar of the faces", (PRESS,), lambda who, _: wire.ReleaseFace(who)),
    Address(
        "release/expression",
        "lets go of the T-bar of the expressions",
        (PRESS,),
        lambda who, _: wire.ReleaseExpression(who),
    ),
    Address(
        "panic", "holds it still and neutral; again, it brings its home face", (PRESS,), lambda who, _: wire.Panic(who)
    ),
    Address(
        "enter",
        "brings it onto the stage",
        (WAY,),
        lambda who, call, seconds: wire.EnterCharacter(call, who, seconds),
    ),
    Address(
        "leave",
        "takes it off the stage",
        (WAY,),
        lambda who, call, seconds: wire.LeaveCharacter(call, who, seconds),
    ),
    Address(
        "place",
        "moves it: to the picture's right, behind the front line, larger, turned",
        PLACE,
        lambda who, call, x, depth, size, turn, seconds: wire.PlaceCharacter(
            who, x, depth, size, _radians(PLACE[3], turn), seconds, call
        ),
    ),
    *SPEECH_ADDRESSES,
    *lease_addresses("lease", of_show=False),
    Address(
        "light",
        "brings a light on air",
        (Value("name", "light"), SECONDS),
        lambda _, call, name, seconds: wire.CallLight(call, name, seconds, DEFAULT_EASING),
        of_show=True,
    ),
    Address(
        "framing",
        "brings a shot of these characters on air",
        (Value("characters", "framing"), WAY),
        lambda _, call, names, seconds: wire.CallFraming(call, names, seconds, DEFAULT_EASING),
        of_show=True,
    ),
    Address(
        "panic",
        "holds all faces still and neutral; again, it brings the home face",
        (PRESS,),
        lambda _, __: wire.Panic(ALL),
        of_show=True,
    ),
    Address(
        "gaze_point",
        "names a point of the house that eyes may look at, or moves it",
        (Value("name", "text"), *POINT),
        lambda _, call, name, x, y, z: wire.SetGazePoint(call, name, x, y, z),
        of_show=True,
    ),
    Address(
        "delete_gaze_point",
        "forgets a named point of the house",
        (Value("name", "text"),),
        lambda _, call, name: wire.DeleteGazePoint(call, name),
        of_show=True,
    ),
    *lease_addresses("scene_lease", of_show=True),
)


def find_address(written: str) -> tuple[Address, str, list[str]]:
    """The address, the character, and the values that stand in the address itself; OscError where there is none."""
    find = _find_again if len(written) <= REMEMBERED_LENGTH else _find_address
    address, character, named = find(written)
    return address, character, list(named)


def _find_address(written: str) -> tuple[Address, str, tuple[str, ...]]:
    root, *parts = written.strip("/").split("/")
    for address in ADDRESSES if root == ROOT else ():
        character, rest = ("", parts) if address.of_show else ("".join(parts[:1]), parts[1:])
        wanted = address.path.split("/")
        if len(rest) != len(wanted) or (not character and not address.of_show):
            continue
        if all(want == part or (want.startswith("{") and part) for want, part in zip(wanted, rest, strict=True)):
            named = tuple(part for want, part in zip(wanted, rest, strict=True) if want.startswith("{"))
            return address, character, named
    raise OscError(_explain_unknown(written[:80]))


_find_again = lru_cache(maxsize=1024)(_find_address)


@lru_cache(maxsize=256)
def _explain_unknown(written: str) -> str:
    """Why an address is none, with the nearest that there are; remembered: what sends one wrong sends it again."""
    if written.startswith(VMC_ROOT):
        return explain_format("vmc")
    character = "".join(written.strip("/").split("/")[1:2]) or "{character}"
    known = [address.pattern.replace("{character}", character) for address in ADDRESSES]
    near = difflib.get_close_matches(written, known, n=3, cutoff=0.7)
    there = (
        f"near are {', '.join(near)}" if near else f"they are like {known[0]}; /{ROOT} of the show's pages lists all"
    )
    return f"there is no address {written!r}; {there}"
