"""Films of a posed hand: a lens, lamps, skin, a room, noise; as the motion JPEG that a browser takes for a camera."""

from __future__ import annotations

import io
from dataclasses import dataclass

import numpy as np
from numba import njit
from numpy.typing import NDArray
from PIL import Image

from tools.baking.package import Package
from tools.hands.posed_hand import SHAPES, HandPose, RiggedHand, Values, rotation_about
from tools.tracking import rasterizer

Floats = NDArray[np.float32]

WIDTH = 640
HEIGHT = 480
FINE = 2
"""Pixels are drawn so many times as fine, along each axis."""
FILM_RATE = 30
"""Pictures a second of a film that Chromium takes for a camera."""
NOISES = 8
"""Pictures of noise, of which each picture has one."""
_CODED = (255.0 * np.linspace(0.0, 1.0, 4096) ** (1 / 2.2)).astype(np.float32)
_MIDDLE = np.array([0.0, 0.06, 0.0])
"""Of the palm and the fingers, along the palm's axes, metres from the wrist."""
SKINS = ((0.93, 0.72, 0.60), (0.80, 0.56, 0.43), (0.62, 0.40, 0.28), (0.38, 0.23, 0.16))
VIEWS = {
    "profile": np.array([[0.0, 1.0, 0.0], [0.0, 0.0, -1.0], [-1.0, 0.0, 0.0]]),
    "thumb": np.array([[0.0, -1.0, 0.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]]),
}
"""From the palm's axes to the camera's (right, up, towards the lens): the little finger, or the thumb, to the lens."""


@dataclass(frozen=True, eq=False)
class HandSetting:
    """distance: metres; focal: of the lens, in widths of the picture; turn: of the hand to the lens, radians; lamps
    (2, 6): direction and light; ambient (3,); skin (3,), linear; room (h, w, 3); noise: of a pixel, 0 to 255."""

    distance: float
    focal: float
    turn: float
    lamps: Values
    ambient: Values
    skin: Values
    room: Floats
    noise: float
    place: Values


def random_hand(package: Package, draw: np.random.Generator) -> RiggedHand:
    """A hand of random proportions."""
    return RiggedHand(package, {name: float(draw.uniform(-0.6, 0.6)) for name in SHAPES})


def random_hand_setting(draw: np.random.Generator) -> HandSetting:
    """A camera in a room, at the side of a hand."""
    lamps = np.zeros((2, 6))
    for row, strength in enumerate((draw.uniform(0.5, 1.0), draw.uniform(0.1, 0.4))):
        yaw = draw.uniform(-1.1, 1.1)
        pitch = draw.uniform(0.0, 1.0)
        lamps[row, :3] = np.sin(yaw) * np.cos(pitch), np.sin(pitch), np.cos(yaw) * np.cos(pitch)
        lamps[row, 3:] = strength * np.array([1.0, draw.uniform(0.88, 1.0), draw.uniform(0.8, 1.0)])
    low, high = sorted(draw.choice(len(SKINS), 2, replace=False))
    share = draw.uniform()
    skin = ((1.0 - share) * np.array(SKINS[low]) + share * np.array(SKINS[high])) ** 2.2
    coarse = draw.uniform(0.02, 0.5, (int(draw.integers(3, 9)), int(draw.integers(3, 9)), 1)) * draw.uniform(0.4, 1, 3)
    room = Image.fromarray(np.uint8(255 * coarse)).resize((WIDTH, HEIGHT), Image.Resampling.BICUBIC)
    return HandSetting(
        distance=float(draw.uniform(0.42, 0.5)), focal=0.95, turn=float(draw.normal(0.0, 0.05)), lamps=lamps,
        ambient=draw.uniform(0.2, 0.4) * np.ones(3), skin=skin, room=np.asarray(np.asarray(room) / 255.0, np.float32),
        noise=float(draw.uniform(1.0, 5.0)), place=draw.normal(0.0, 0.01, 2),
    )  # fmt: skip


class HandCamera:
    """Takes pictures of one hand in one setting. view: of `VIEWS`; draw: of noise."""

    def __init__(
        self, hand: RiggedHand, setting: HandSetting, draw: np.random.Generator, view: str = "profile"
    ) -> None:
        self.hand = hand
        self.setting = setting
        self._view = rotation_about(np.array([0.0, 1.0, 0.0]), setting.turn) @ VIEWS[view]
        self._material = np.zeros(len(hand.triangles), np.int32)
        self._noises = setting.noise * draw.standard_normal((NOISES, HEIGHT, WIDTH, 3), np.float32)
        self._draw = draw

    def take(self, pose: HandPose | None) -> NDArray[np.uint8]:
        """A picture (480, 640, 3); of the room alone without a pose."""
        picture = self.setting.room.copy()
        if pose is not None:
            self._add_hand(pose, picture)
        coded = _CODED[np.clip(picture * (len(_CODED) - 1), 0, len(_CODED) - 1).astype(np.intp)]
        coded += self._noises[self._draw.integers(NOISES)]
        result: NDArray[np.uint8] = np.clip(np.rint(coded), 0, 255).astype(np.uint8)
        return result

    def _add_hand(self, pose: HandPose, picture: Floats) -> None:
        points = np.ascontiguousarray(self.hand.pose(pose))
        normals = np.empty_like(points)
        rasterizer.normals_of(points, self.hand.triangles, normals)
        screen = self._project(points)
        left, top = np.clip(np.floor(screen[:, :2].min(0)), 0, (WIDTH - 1, HEIGHT - 1)).astype(int)
        right, low = np.clip(np.ceil(screen[:, :2].max(0)) + 1, (left + 1, top + 1), (WIDTH, HEIGHT)).astype(int)
        screen[:, :2] = (screen[:, :2] - (left, top)) * FINE
        rows = (low - top) * FINE
        columns = (right - left) * FINE
        depth = np.full((rows, columns), rasterizer.FAR, np.float32)
        hit = np.full((rows, columns), -1, np.int32)
        shares = np.empty((rows, columns, 2), np.float32)
        rasterizer.draw_triangles(screen, self.hand.triangles, self._material, 1.0, depth, hit, shares)
        behind = picture[top:low, left:right]
        drawn = behind.repeat(FINE, 0).repeat(FINE, 1)
        _paint(hit, shares, self.hand.triangles, self._light(normals @ self._view.T), drawn)
        behind[:] = drawn.reshape(low - top, FINE, right - left, FINE, 3).mean((1, 3))

    def _project(self, points: Values) -> Floats:
        """The points (n, 3) in the picture: pixels right and down, metres from the camera."""
        setting = self.setting
        seen = (points - _MIDDLE) @ self._view.T + np.array([*setting.place, -setting.distance])
        scale = setting.focal * WIDTH / -seen[:, 2]
        across = WIDTH / 2 + scale * seen[:, 0]
        down = HEIGHT / 2 - scale * seen[:, 1]
        return np.stack([across, down, -seen[:, 2]], 1).astype(np.float32)

    def _light(self, normals: Values) -> Floats:
        """The colour (n, 3) of each point, linear. normals (n, 3): towards the camera is +z."""
        light = self.setting.ambient * (0.75 + 0.25 * normals[:, 1:2])
        for lamp in self.setting.lamps:
            light = light + np.clip((normals @ lamp[:3] + 0.2) / 1.2, 0.0, None)[:, None] * lamp[3:]
        rim = (1.0 - np.clip(normals[:, 2:3], 0.0, 1.0)) ** 3
        return np.asarray(self.setting.skin * light * (1.0 - 0.3 * rim), np.float32)


@njit(cache=True)
def _paint(hit, shares, triangles, colours, picture):  # type: ignore[no-untyped-def]
    """Paints what was hit into picture (H, W, 3), by the colours (n, 3) of its corners."""
    for y in range(hit.shape[0]):
        for x in range(hit.shape[1]):
            if hit[y, x] >= 0:
                a, b, c = triangles[hit[y, x]]
                second, third = shares[y, x]
                for part in range(3):
                    picture[y, x, part] = (
                        (1.0 - second - third) * colours[a, part] + second * colours[b, part] + third * colours[c, part]
                    )


def jpeg_of(picture: NDArray[np.uint8], quality: int = 88) -> bytes:
    """A picture (h, w, 3) as JPEG. quality: of 100."""
    written = io.BytesIO()
    Image.fromarray(picture).save(written, "JPEG", quality=quality)
    return written.getvalue()
