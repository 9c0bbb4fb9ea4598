"""An exported avatar in three-vrm: it plays every expression by name as Omote does, and looks where it is told to."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Browser, Page

from omote.builtin import load_cast, load_mask, load_meshes
from omote.interchange.avatar.export_vrm import TURNED, vrm_bytes
from omote.interchange.avatar.preset_expressions import PRESETS, preset_weights
from omote.interchange.avatar.vrm_licence import Credit, Version
from omote.interchange.export_face import ExportContext
from tests.browser.avatar_page import (
    NEAR,
    PERFECT_SYNC,
    Meshes,
    Points,
    blended,
    distances,
    numbers,
    on_air,
    open_avatar,
    worn,
)
from tests.interchange.figures.figures import SUITED

pytestmark = pytest.mark.long

FACE = "dog"


def write_face(file: Path, version: Version) -> Path:
    """The face as a VRM."""
    whole = ExportContext(load_cast(), load_meshes(), load_mask())
    file.write_bytes(vrm_bytes(whole, FACE, [], Credit(("Ann", "Ben"), version=version)))
    return file


def as_exported(weights: Mapping[str, float]) -> Meshes:
    """Where Omote has the face on air; of `mouthClose` alone teeth are drawn in, as far as an open jaw needs, and what
    parts the lips for `tongueOut`, and takes .06 mm of a fold out of the dog's `sad`, is of the frame, not of a
    target."""
    of_frame = ({"mouthClose": 1.0}, {"tongueOut": 1.0}, {"sad": 1.0})
    return blended(FACE, weights) if weights in of_frame else on_air(FACE, weights)


def turn(page: Page, bone: str, angles: list[float]) -> None:
    """Turns a bone of the avatar by its name in VRM, radians about x, y and z."""
    page.evaluate("([bone, angles]) => window.avatar.turn(bone, angles)", [bone, angles])


@pytest.fixture(scope="module")
def avatar(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Page]:
    """The face as VRM 1.0."""
    with open_avatar(browser, write_face(tmp_path_factory.mktemp("avatar") / "face.vrm", "1.0")) as page:
        yield page


@pytest.fixture
def older(browser: Browser, tmp_path: Path) -> Iterator[Page]:
    """The face as VRM 0.x."""
    with open_avatar(browser, write_face(tmp_path / "face.vrm", "0.x")) as page:
        yield page


def test_three_vrm_plays_all_presets_and_all_units_by_name_where_omote_does(avatar: Page) -> None:
    found = avatar.evaluate("window.avatar.found")
    assert sorted(found["presets"]) == sorted(PRESETS)
    assert sorted(found["customs"]) == sorted(PERFECT_SYNC)
    far = distances(avatar, {**preset_weights(load_cast()), **PERFECT_SYNC}, as_exported, np.ones(3))
    assert max(far.values()) <= NEAR, max(far, key=far.__getitem__)


def test_three_vrm_plays_the_older_version_alike(older: Page) -> None:
    found = older.evaluate("window.avatar.found")
    assert sorted(found["presets"]) == sorted(set(PRESETS) - {"surprised"})
    assert sorted(found["customs"]) == sorted([*PERFECT_SYNC, "Surprised"])  # no preset there
    presets = preset_weights(load_cast())
    names = {name: presets[name] for name in ("happy", "ih", "blinkLeft", "lookRight", "neutral")}
    names |= {"Surprised": presets["surprised"], "JawOpen": PERFECT_SYNC["JawOpen"]}
    far = distances(older, names, partial(on_air, FACE), TURNED)
    assert max(far.values()) <= NEAR, max(far, key=far.__getitem__)
    rest = worn(older, {})
    looking = worn(older, {}, [-5.0, 0.0, -50.0])  # ahead is -z, so the left is at -x
    front = rest["eye_left"][:, 2].argmin()
    assert looking["eye_left"][front, 0] < rest["eye_left"][front, 0] - 1e-3


@pytest.mark.parametrize(("yaw", "pitch"), [(10.0, 0.0), (-10.0, 0.0), (0.0, 6.0), (0.0, -6.0), (8.0, -5.0)])
def test_eyes_look_where_the_target_is(avatar: Page, yaw: float, pitch: float) -> None:
    """Degrees to the character's left and up, seen from between the eyes."""
    across = math.radians(yaw)
    up = math.radians(pitch)
    far = 50.0
    at = [far * math.sin(across) * math.cos(up), far * math.sin(up), far * math.cos(across) * math.cos(up)]
    rest = worn(avatar, {})
    looking = worn(avatar, {}, at)
    for eye in ("eye_left", "eye_right"):
        middle = rest[eye].mean(axis=0)
        front = rest[eye][:, 2].argmax()
        before = rest[eye][front] - middle
        after = looking[eye][front] - middle
        turned = math.degrees(math.atan2(after[0], after[2]) - math.atan2(before[0], before[2]))
        raised = math.degrees(
            math.asin(after[1] / np.linalg.norm(after)) - math.asin(before[1] / np.linalg.norm(before))
        )
        assert turned == pytest.approx(yaw, abs=0.5)
        assert raised == pytest.approx(pitch, abs=0.5)


def test_folds_show_as_far_as_an_expression_presses_the_skin(avatar: Page) -> None:
    def shown(weights: Mapping[str, float]) -> dict[str, float]:
        worn(avatar, weights)
        return {name: float(part) for name, part in avatar.evaluate("window.avatar.shown()").items()}

    assert set(shown({}).values()) == {0.0}
    angry, half = shown({"angry": 1.0}), shown({"angry": 0.5})
    assert max(angry.values()) > 0.3
    assert half == {name: pytest.approx(0.5 * part) for name, part in angry.items()}
    assert set(shown({"blink": 1.0}).values()) == {0.0}


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
    turn(avatar, "head", [0.0, math.pi / 2, 0.0])
    turned = worn(avatar, {})
    turn(avatar, "head", [0.0, 0.0, 0.0])
    for mesh, points in rest.items():
        away = points - np.array(bones["head"], np.float32)
        np.testing.assert_allclose(turned[mesh] - bones["head"], away[:, [2, 1, 0]] * [1, 1, -1], atol=1e-5)


def test_a_figure_hangs_its_arm_by_the_bone_of_the_upper_arm(browser: Browser, tmp_path: Path) -> None:
    cast = load_cast()
    names = ("neutral", "eyeLookUpLeft", "eyeLookDownLeft", "eyeLookOutLeft")
    plain = replace(cast, expressions={name: cast.expressions[name] for name in names}, titles={})
    path = tmp_path / "face.vrm"
    context = ExportContext(plain, load_meshes(), load_mask())
    path.write_bytes(vrm_bytes(context, "kaori", [], Credit(("Ann",)), body="heavy", hair=False))
    with open_avatar(browser, path) as page:
        rest = {mesh: points(page, mesh) for mesh in SUITED}
        shoulder = np.array(page.evaluate("window.avatar.bone('leftUpperArm')"))
        turn(page, "leftUpperArm", [0.0, 0.0, -math.pi / 2])
        hung = {mesh: points(page, mesh) for mesh in SUITED}
    left = rest["bare"][:, 0] > 0.0
    away = (rest["bare"] - shoulder)[left]
    down = np.column_stack([away[:, 1], -away[:, 0], away[:, 2]])
    np.testing.assert_allclose(hung["bare"][left] - shoulder, down, atol=1e-4)
    np.testing.assert_allclose(hung["bare"][~left], rest["bare"][~left], atol=1e-6)
    np.testing.assert_allclose(hung["shoes"], rest["shoes"], atol=1e-6)
    assert np.abs(rest["shoes"][:, 1].min()) < 1e-4
    assert hung["garment"][:, 0].max() < rest["garment"][:, 0].max() - 0.2


def points(page: Page, mesh: str) -> Points:
    """Where three-vrm has the vertices of a mesh, (n, 3) metres."""
    return numbers(page.evaluate("name => window.avatar.points(name)", mesh)).reshape(-1, 3)
