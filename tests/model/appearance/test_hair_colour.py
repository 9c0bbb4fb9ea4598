"""The colour of hair in photographs: of the cast, photographed in strange lights."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.interchange.skin_texture import decode_srgb
from omote.model.appearance.hair_colour import HairColour, find_hair_colour, find_scalp
from omote.model.appearance.lab import to_lab
from omote.model.cast import Look
from omote.model.fitting.landmarks import find_landmarks
from omote.model.fitting.photographs.photograph import Photograph, PhotographCamera
from tools.photographs.colour_distance import colour_distance
from tools.photographs.photographer import photograph
from tools.photographs.sculpted_people import NAME, Sculpted, model_of
from tools.tracking.picture import Setting, random_setting, turn
from tools.tracking.random_people import HUMANS

CAST = load_cast()
SCALP = find_scalp(CAST.space, CAST.hair)
SIDE = 320
HAIRED = tuple(name for name in HUMANS if CAST.looks[name].hair_style)
# CIE delta E 2000: more is another colour at a glance.
SAME = 8.0


def light(colour: str) -> np.ndarray:
    """Linear light (1, 3)."""
    return decode_srgb(colour).astype(np.float64)[None]


def distance(one: str, other: str) -> float:
    """CIE delta E 2000."""
    return float(colour_distance(to_lab(light(one)), to_lab(light(other)))[0])


def look_at(name: str, look: Look, room: np.ndarray | None = None, turns: tuple[float, ...] = (0.0, 0.7)) -> HairColour:
    """What is found in photographs of one of the cast, in a light and a room of their own."""
    draw = np.random.default_rng([31, sorted(CAST.faces).index(name)])
    face = dataclasses.replace(CAST.faces[name], name=NAME)
    person = Sculpted(face, CAST.with_faces(face, looks={NAME: look}), look)
    setting = random_setting(draw)
    setting = setting if room is None else dataclasses.replace(setting, room=room)
    return find(person, setting, turns, draw)


def find(person: Sculpted, setting: Setting, turns: tuple[float, ...], draw: np.random.Generator) -> HairColour:
    cameras = [PhotographCamera(turn("y", yaw), np.array([0.0, 0.0, -0.7]), 1.4 * SIDE, SIDE, SIDE) for yaw in turns]
    pictures = [photograph(camera, model_of(person, {}, (0.0, 0.0)), setting, draw)[0] for camera in cameras]
    views = [Photograph(np.zeros((478, 2)), SIDE, SIDE, picture=picture) for picture in pictures]
    return find_hair_colour(CAST.space, SCALP, person.face, views, cameras, person.look.skin)


@pytest.mark.parametrize("name", HAIRED)
def test_hair_of_the_cast_has_its_colour_in_any_light(name: str) -> None:
    look = CAST.looks[name]
    found = look_at(name, look)
    assert found.colour is not None, found.doubt
    assert distance(found.colour, look.hair) < min(SAME, 0.5 * distance(look.skin, look.hair))


def test_hair_of_any_colour_is_that_colour() -> None:
    colours = ("#101010", "#d8c08a", "#8a3a1c", "#6b3145", "#b8b4ae")
    wished = [dataclasses.replace(CAST.looks["kaori"], hair=each) for each in colours]
    found = [look_at("kaori", look, np.full((2, 2, 3), [0.1, 0.3, 0.5])).colour for look in wished]
    for colour, seen in zip(colours, found, strict=True):
        assert seen is not None
        assert min(colours, key=lambda each: distance(each, seen)) == colour


def test_a_bald_head_has_no_hair() -> None:
    found = look_at("man", dataclasses.replace(CAST.looks["man"], hair_style="", scalp=0.0))
    assert found.colour is None
    assert found.bare
    assert "show skin" in found.doubt


def test_hair_before_a_room_of_its_colour_is_doubted() -> None:
    look = CAST.looks["kaori"]
    dark = np.broadcast_to(0.6 * decode_srgb(look.hair), (2, 2, 3))
    found = look_at("kaori", look, np.array(dark))
    assert found.colour is None
    assert not found.bare
    assert "behind" in found.doubt


def test_photographs_without_pictures_and_of_no_head_say_so() -> None:
    face = CAST.faces["kaori"]
    away = PhotographCamera(np.eye(3), np.array([9.0, 0.0, -0.7]), 400.0, SIDE, SIDE)
    plain = Photograph(np.zeros((478, 2)), SIDE, SIDE)
    empty = dataclasses.replace(plain, picture=np.zeros((SIDE, SIDE, 3), np.uint8))
    for view in (plain, empty):
        found = find_hair_colour(CAST.space, SCALP, face, [view], [away], "#c09070")
        assert found.colour is None
        assert "No photograph" in found.doubt


def test_hair_grows_on_the_scalp_and_nowhere_on_the_face() -> None:
    points = CAST.space.points
    crown = int(np.argmax(np.where(CAST.space.on_sheet, points[:, 1], -np.inf)))
    assert SCALP[crown]
    for mark in find_landmarks(CAST.space).values():
        assert not SCALP[mark]
    assert all(SCALP[np.unique(style.anchors)].any() for style in CAST.hair.values())
