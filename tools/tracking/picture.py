"""Pictures as a camera takes them: a person in a light, before something, through a lens."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from omote.builtin import load_mask, load_meshes
from omote.interchange.formats.png import read_png
from tools.tracking import rasterizer
from tools.tracking.random_people import Floats, Person, Values

SIZE = 288
"""Width and height of a picture, pixels."""
FINE = 2
"""Pixels are drawn so many times as fine, along each axis."""
KINDS = {
    "skin": rasterizer.SKIN,
    "eye_left": rasterizer.EYE_LEFT,
    "eye_right": rasterizer.EYE_RIGHT,
    "teeth_upper": rasterizer.TEETH,
    "teeth_lower": rasterizer.TEETH,
    "tongue": rasterizer.TONGUE,
    "lashes": rasterizer.LASHES,
}
NECK = np.array([0.0, -0.09, 0.02])
"""Where heads turn, metres."""


@dataclass(frozen=True, eq=False)
class Setting:
    """Lens, place, light and noise of somebody's camera, the same for all their pictures.

    focal: of the lens, in widths of the picture; distance: metres from the face; lamps (4, 6): as `rasterizer`;
    room (h, w, 3): what is behind; clothes (3,): their colour; exposure; noise: of a pixel, 0 to 255; blur: pixels.
    """

    focal: float
    distance: float
    centre: Values
    lamps: Values
    room: Values
    clothes: Values
    exposure: float
    noise: float
    tilt: float


def random_setting(draw: np.random.Generator) -> Setting:
    """A camera in a room."""
    fill = draw.uniform(0.48, 0.8)  # the head's height in the picture
    distance = float(np.exp(draw.uniform(np.log(0.38), np.log(1.0))))
    focal = distance * fill / 0.24
    key = _direction(draw.uniform(-1.2, 1.2), draw.uniform(-0.1, 1.0))
    fill_in = _direction(draw.uniform(-1.5, 1.5), draw.uniform(-0.3, 0.6))
    warm = draw.uniform(0.75, 1.0)
    lamps = np.zeros((4, 6))
    lamps[0] = [*key, *(draw.uniform(0.3, 1.1) * np.array([1.0, 0.5 + 0.5 * warm, warm]))]
    lamps[1] = [*fill_in, *(draw.uniform(0.05, 0.5) * np.array([warm, 0.5 + 0.5 * warm, 1.0]))]
    lamps[2, 3:] = draw.uniform(0.15, 0.6) * np.array([1, 1, 1]) + draw.normal(0, 0.02, 3)
    lamps[3, 3:] = draw.uniform(0.05, 0.35) * np.array([1, 0.95, 0.9])
    coarse = draw.uniform(0.0, 0.7, (int(draw.integers(2, 9)), int(draw.integers(2, 9)), 1)) * draw.uniform(0.3, 1, 3)
    return Setting(
        focal=focal, distance=distance, centre=draw.normal(0.0, 0.03, 2), lamps=lamps, room=coarse,
        clothes=draw.uniform(0.02, 0.6, 3), exposure=float(draw.uniform(0.8, 1.25)),
        noise=float(draw.uniform(1.0, 7.0)),
        tilt=float(draw.normal(0.0, 0.07)),
    )  # fmt: skip


@dataclass(frozen=True)
class Pose:
    """A head before the camera: yaw, pitch, roll in our signs (radians), and a move from its place (metres)."""

    head: tuple[float, float, float] = (0.0, 0.0, 0.0)
    move: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def rotation(self) -> Values:
        """The rotation (3, 3): by yaw about y, then by -pitch about x, then by -roll about z."""
        yaw, pitch, roll = self.head
        return turn("y", yaw) @ turn("x", -pitch) @ turn("z", -roll)


def turn(axis: str, angle: float) -> Values:
    """The rotation about an axis, right-handed.

    axis: "x", "y" or "z"; angle: radians.
    """
    c, s = np.cos(angle), np.sin(angle)
    if axis == "x":
        return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
    if axis == "y":
        return np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


class Photographer:
    """Takes pictures of one person in one setting."""

    def __init__(self, person: Person, setting: Setting) -> None:
        self.person = person
        self.setting = setting
        self._meshes = _meshes()
        rest, parts = person.pose({}, (0.0, 0.0))
        self._hair = person.strands(rest)
        self._balls = {name: _ball_axes(parts[name]) for name in ("eye_left", "eye_right")}
        side = SIZE * FINE
        self._room = _stretch(setting.room, side)
        self._depth = np.empty((side, side), np.float32)
        self._hit = np.empty((side, side), np.int32)
        self._shares = np.empty((side, side, 2), np.float32)

    def view(self, points: NDArray[np.floating], pose: Pose) -> Values:
        """Points (n, 3) of the head in the camera's frame: x right, y up, z from the camera.

        points: metres; pose: of the head.
        """
        turned = (points - NECK) @ pose.rotation().T + NECK + np.asarray(pose.move)
        tilted = turned @ turn("x", self.setting.tilt).T  # a camera that looks up or down at them
        centred = tilted - np.array([0.0, -0.012, 0.10])
        result: Values = centred + np.array([0.0, 0.0, -self.setting.distance])
        return result

    def project(self, seen: Values) -> Values:
        """Fractions of the picture (n, 2), y down."""
        plane = self.setting.focal * seen[:, :2] / -seen[:, 2:]
        return np.stack([0.5 + plane[:, 0], 0.5 - plane[:, 1]], 1) + self.setting.centre

    def take(
        self, weights: dict[str, float], gaze: tuple[float, float], pose: Pose, draw: np.random.Generator
    ) -> NDArray[np.uint8]:
        """A picture (SIZE, SIZE, 3).

        weights: by unit; gaze: yaw and pitch, radians; pose: of the head; draw: of noise.
        """
        mesh = self._meshes
        side = SIZE * FINE
        skin, parts = self.person.pose(weights, gaze)
        both = {"skin": skin, **parts}
        normals = np.concatenate([_normals(both[name], triangles) for name, triangles in mesh.own])
        drawn = np.concatenate([both[name] for name, _ in mesh.own])[mesh.source]
        seen = self.view(drawn, pose)
        rotation = turn("x", self.setting.tilt) @ pose.rotation()
        facing = normals[mesh.source] @ rotation.T
        screen = np.concatenate([self.project(seen) * side, -seen[:, 2:]], 1).astype(np.float32)
        local = self._sight(both)
        self._depth[:], self._hit[:] = rasterizer.FAR, -1
        rasterizer.draw_triangles(
            screen, mesh.triangles, mesh.material, self.person.look.lashes, self._depth, self._hit, self._shares
        )
        picture = self._behind(pose)
        self._draw_hair(pose, picture)
        rasterizer.shade_pixels(
            self._hit, self._shares, mesh.triangles, mesh.material, facing.astype(np.float32),
            seen.astype(np.float32), mesh.uv, mesh.openness, local, mesh.mask, _colours(self.person),
            _traits(self.person), self.setting.lamps.astype(np.float32), picture,
        )  # fmt: skip
        return self._develop(picture, draw)

    def _draw_hair(self, pose: Pose, picture: Floats) -> None:
        if self._hair is None:
            return
        places, light = self._hair
        seen = self.view(places.reshape(-1, 3), pose)
        screen = np.concatenate([self.project(seen) * SIZE * FINE, -seen[:, 2:]], 1).astype(np.float32)
        lamps = self.setting.lamps
        shade = (light * float(lamps[0, 3:].mean() * 0.7 + lamps[2, 3:].mean())).astype(np.float32)
        thick = max(1.5, 0.0028 * self.setting.focal * SIZE * FINE / self.setting.distance)
        rasterizer.draw_strands(
            screen.reshape(*places.shape), shade, _linear(self.person.look.hair).astype(np.float32), thick,
            self._depth, self._hit, picture,
        )  # fmt: skip

    def _sight(self, both: dict[str, Floats]) -> Floats:
        """Of each drawn vertex of an eyeball: where it lies on the ball at rest, (V, 3)."""
        rows = [
            self._balls[name] if name in self._balls else np.zeros((len(both[name]), 3), np.float32)
            for name, _ in self._meshes.own
        ]
        return np.concatenate(rows)[self._meshes.source].astype(np.float32)

    def _behind(self, pose: Pose) -> Floats:
        """The room, with shoulders and a neck that go where the head goes."""
        side = SIZE * FINE
        picture = self._room.copy()
        chest = self.project(self.view(np.array([[0.0, -0.15, 0.0]]), Pose(move=pose.move)))[0] * side
        wide = 0.2 * self.setting.focal * side / self.setting.distance
        rows = np.arange(side, dtype=np.float32)[:, None]
        columns = np.arange(side, dtype=np.float32)
        across = ((columns - chest[0]) / wide) ** 2
        body = across + (np.minimum(rows - chest[1] - 0.5 * wide, 0) / (0.5 * wide)) ** 2 < 1
        picture[body] = self.setting.clothes
        left, right, top, low = (
            int(np.clip(edge, 0, side))
            for edge in (chest[0] - 0.29 * wide, chest[0] + 0.29 * wide, chest[1] - 0.35 * wide, chest[1] + 0.2 * wide)
        )
        picture[top:low, left:right] = 0.4 * _linear(self.person.look.skin)
        return picture

    def _develop(self, picture: Floats, draw: np.random.Generator) -> NDArray[np.uint8]:
        small = 0.25 * (picture[::2, ::2] + picture[1::2, ::2] + picture[::2, 1::2] + picture[1::2, 1::2])
        coded = np.clip(small * self.setting.exposure, 0, None)
        coded = coded / (1.0 + 0.25 * coded)
        values = 255 * np.sqrt(np.clip(coded, 0, 1)) ** np.float32(0.909)
        values += self.setting.noise * draw.standard_normal(values.shape, np.float32)
        result: NDArray[np.uint8] = np.clip(np.rint(values), 0, 255).astype(np.uint8)
        return result


@dataclass(frozen=True, eq=False)
class Meshes:
    """All that is drawn as one mesh."""

    own: tuple[tuple[str, NDArray[np.int32]], ...]
    source: NDArray[np.int32]
    triangles: NDArray[np.int32]
    material: NDArray[np.int32]
    uv: Floats
    openness: Floats
    mask: NDArray[np.uint8]


@cache
def _meshes() -> Meshes:
    own = []
    source = []
    triangles = []
    material = []
    uv = []
    openness = []
    rows = places = 0
    for mesh in load_meshes():
        of_own = mesh.source[mesh.triangles].astype(np.int32)
        own.append((mesh.name, of_own))
        source.append(mesh.source + rows)
        triangles.append(mesh.triangles + places)
        material.append(np.full(len(mesh.triangles), KINDS[mesh.name]))
        uv.append(mesh.uv)
        openness.append(mesh.openness / 255.0)
        rows += int(mesh.source.max()) + 1
        places += len(mesh.source)
    return Meshes(
        tuple(own), np.concatenate(source).astype(np.int32), np.concatenate(triangles).astype(np.int32),
        np.concatenate(material).astype(np.int32), np.concatenate(uv).astype(np.float32),
        np.concatenate(openness).astype(np.float32), np.ascontiguousarray(read_png(load_mask())[:1024]),
    )  # fmt: skip


def _stretch(room: Values, side: int) -> Floats:
    """A coarse picture (h, w, 3), stretched to (side, side, 3)."""
    ys, xs = np.linspace(0, room.shape[0] - 1, side), np.linspace(0, room.shape[1] - 1, side)
    y0, x0 = np.minimum(ys.astype(int), room.shape[0] - 2), np.minimum(xs.astype(int), room.shape[1] - 2)
    ty, tx = (ys - y0)[:, None, None], (xs - x0)[None, :, None]
    top = room[y0][:, x0] * (1 - tx) + room[y0][:, x0 + 1] * tx
    low = room[y0 + 1][:, x0] * (1 - tx) + room[y0 + 1][:, x0 + 1] * tx
    return np.asarray(top * (1 - ty) + low * ty, np.float32)


def _normals(points: Floats, triangles: NDArray[np.int32]) -> Floats:
    found = np.empty_like(points)
    rasterizer.normals_of(points, triangles, found)
    return found


def _ball_axes(ball: Floats) -> Floats:
    offset = ball - ball.mean(0)
    return np.asarray(offset / np.linalg.norm(offset, axis=1, keepdims=True), np.float32)


def _linear(colour: str) -> Values:
    coded = np.frombuffer(bytes.fromhex(colour[1:]), np.uint8) / 255
    result: Values = coded**2.2
    return result


def _colours(person: Person) -> Floats:
    look = person.look
    of_look = [_linear(colour) for colour in (look.skin, look.lip, look.brow, look.blush, look.iris)]
    rest = [[0.72, 0.68, 0.64], [0.75, 0.7, 0.6], [0.5, 0.16, 0.14], [0.02, 0.015, 0.012]]
    return np.array([*of_look, *rest], np.float32)


def _traits(person: Person) -> Floats:
    look = person.look
    return np.array([look.brows, 0.3, 0.42 * look.iris_size, 0.36, look.gloss], np.float32)


def _direction(yaw: float, pitch: float) -> list[float]:
    return [np.sin(yaw) * np.cos(pitch), np.sin(pitch), np.cos(yaw) * np.cos(pitch)]
