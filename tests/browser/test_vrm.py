"""An exported avatar in three-vrm: it plays every expression by name as Omote does, and looks where it is told to."""

from __future__ import annotations

import base64
import math
from collections.abc import Iterator, Mapping
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from playwright.sync_api import Browser, Page, Route

from omote.builtin import load_cast, load_mask, load_meshes
from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.interchange.avatar.export_vrm import vrm_bytes
from omote.interchange.avatar.preset_expressions import EMOTIONS, PRESETS, preset_weights
from omote.interchange.avatar.vrm_licence import Credit
from omote.interchange.export_face import ExportContext
from omote.perform.blending.evaluate import evaluate, evaluate_parts
from omote.perform.frame import Frame

pytestmark = pytest.mark.long

HERE = Path(__file__).resolve().parent
PACKAGES = HERE.parents[1] / "web" / "node_modules"
ADDRESS = "http://avatar.test"
FACE = "dog"
NEAR = 5e-5
"""Metres that a vertex may be from where ours is."""

Points = NDArray[np.float32]


@pytest.fixture(scope="module")
def avatar(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Page]:
    """A page with the face, as three-vrm has loaded it."""
    file = tmp_path_factory.mktemp("avatar") / "face.vrm"
    whole = ExportContext(load_cast(), load_meshes(), load_mask())
    file.write_bytes(vrm_bytes(whole, FACE, [], Credit(("Ann", "Ben"))))

    def answer(route: Route) -> None:
        name = route.request.url.removeprefix(ADDRESS).removeprefix("/")
        own = {"": HERE / "three_vrm.html", "face.vrm": file}
        route.fulfill(path=own.get(name, PACKAGES / name))

    page = browser.new_context(viewport={"width": 400, "height": 400}).new_page()
    said: list[str] = []
    page.on("console", lambda message: said.append(message.text) if message.type in ("warning", "error") else None)
    page.on("pageerror", lambda error: said.append(str(error)))
    page.route("**/*", answer)
    page.goto(ADDRESS)
    page.wait_for_function("() => Boolean(window.avatar)", polling=100)
    yield page
    page.context.close()
    assert said == []


def numbers(text: str) -> Points:
    """Numbers as the page tells them."""
    return np.frombuffer(base64.b64decode(text), np.float32)


def worn(page: Page, weights: Mapping[str, float], at: list[float] | None = None) -> dict[str, Points]:
    """Where three-vrm has the vertices of each mesh: (n, 3) metres."""
    page.evaluate("([weights, at]) => window.avatar.wear(weights, at)", [dict(weights), at])
    names = [name for name in page.evaluate("window.avatar.found.meshes") if name != "hair"]
    found = page.evaluate("names => names.map((name) => window.avatar.points(name))", names)
    return {name: numbers(text).reshape(-1, 3) for name, text in zip(names, found, strict=True)}


def ours(weights: Mapping[str, float], *, channels: bool) -> dict[str, Points]:
    """Where Omote has them."""
    cast, rest = load_cast(), {"neutral": 1.0}
    frame = Frame({FACE: 1.0}, rest, channels=weights) if channels else Frame({FACE: 1.0}, weights or rest)
    return {"skin": evaluate(cast, frame), **evaluate_parts(cast, frame)}


def farthest(theirs: Mapping[str, Points], own: Mapping[str, Points], rows: Mapping[str, NDArray[np.int_]]) -> float:
    """The largest distance, when the skin's first vertex at rest is laid upon ours."""
    return max(float(np.abs(theirs[name] - own[name][rows[name]]).max()) for name in theirs)


def test_three_vrm_plays_all_presets_and_all_units_by_name_where_omote_does(avatar: Page) -> None:
    found = avatar.evaluate("window.avatar.found")
    customs = [name[0].upper() + name[1:] for name in ARKIT_NAMES]
    assert sorted(found["presets"]) == sorted(PRESETS)
    assert sorted(found["customs"]) == sorted(customs)
    rows = {
        name: numbers(avatar.evaluate("name => window.avatar.rows(name)", name)).astype(int)
        for name in found["meshes"]
        if name != "hair"
    }
    rest, own = worn(avatar, {}), ours({}, channels=True)
    shift = (rest["skin"].astype(np.float64) - own["skin"][rows["skin"]]).mean(axis=0)
    names: dict[str, tuple[Mapping[str, float], bool]] = {
        preset: (weights, preset not in EMOTIONS) for preset, weights in preset_weights(load_cast()).items()
    }
    names |= {custom: ({unit: 1.0}, True) for custom, unit in zip(customs, ARKIT_NAMES, strict=True)}
    far = {}
    for name, (weights, channels) in names.items():
        theirs, aim = worn(avatar, {name: 1.0}), ours(weights, channels=channels)
        far[name] = farthest({mesh: points - shift for mesh, points in theirs.items()}, aim, rows)
        moves = max(float(np.abs(points - rest[mesh]).max()) for mesh, points in theirs.items())
        assert (moves > 10 * NEAR) == (name != "neutral"), name
    assert max(far.values()) <= NEAR, max(far, key=far.__getitem__)


@pytest.mark.parametrize(("yaw", "pitch"), [(10.0, 0.0), (-10.0, 0.0), (0.0, 6.0), (0.0, -6.0), (8.0, -5.0)])
def test_eyes_look_where_the_target_is(avatar: Page, yaw: float, pitch: float) -> None:
    """Degrees to the character's left and up, seen from between the eyes."""
    across, up = math.radians(yaw), math.radians(pitch)
    far = 50.0
    at = [far * math.sin(across) * math.cos(up), far * math.sin(up), far * math.cos(across) * math.cos(up)]
    rest, looking = worn(avatar, {}), worn(avatar, {}, at)
    for eye in ("eye_left", "eye_right"):
        middle = rest[eye].mean(axis=0)
        front = rest[eye][:, 2].argmax()
        before, after = rest[eye][front] - middle, looking[eye][front] - middle
        turned = math.degrees(math.atan2(after[0], after[2]) - math.atan2(before[0], before[2]))
        raised = math.degrees(
            math.asin(after[1] / np.linalg.norm(after)) - math.asin(before[1] / np.linalg.norm(before))
        )
        assert turned == pytest.approx(yaw, abs=0.5)
        assert raised == pytest.approx(pitch, abs=0.5)


def test_the_skeleton_stands_on_its_feet_and_carries_the_head(avatar: Page) -> None:
    bones = {
        name: avatar.evaluate("name => window.avatar.bone(name)", name)
        for name in ("head", "leftFoot", "leftHand", "rightHand")
    }
    rest = worn(avatar, {})
    low = rest["skin"][:, 1].min()
    assert 0.0 < bones["leftFoot"][1] < 0.1 * bones["head"][1]
    assert bones["leftHand"][0] == -bones["rightHand"][0] > 0.0  # the character's left is +x, as it looks along +z
    assert low < bones["head"][1] < rest["skin"][:, 1].max()
    avatar.evaluate("window.avatar.turnHead(Math.PI / 2)")
    turned = worn(avatar, {})
    avatar.evaluate("window.avatar.turnHead(0)")
    for mesh, points in rest.items():
        away = points - np.array(bones["head"], np.float32)
        np.testing.assert_allclose(turned[mesh] - bones["head"], away[:, [2, 1, 0]] * [1, 1, -1], atol=1e-5)
