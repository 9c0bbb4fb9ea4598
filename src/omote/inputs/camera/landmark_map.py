"""The map from a face's landmarks to weights of units, gaze and head: a small network beside this module.

tools/tracking trains it on pictures of people of ours (docs/decisions/webcam.md).
"""

from __future__ import annotations

import zipfile
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Values
from omote.inputs.camera.face_features import measures, pose_terms
from omote.inputs.trackers.arkit_names import ARKIT_NAMES

MAP = Path(__file__).with_name("landmark_map.npz")
FORMAT = 1
UNITS = tuple(name for name in ARKIT_NAMES if not name.startswith("eyeLook"))
"""What the map gives first; then yaw and pitch of the gaze, then yaw, pitch and roll of the head (radians)."""
ANGLES = 5
OUTPUTS = len(UNITS) + ANGLES


@dataclass(frozen=True, eq=False)
class Compression:
    """A face's features as few numbers: principal components of how points moved and of the face at rest.

    moved_mean (1434,), moved_basis (1434, k); rest_mean (1434,), rest_basis (1434, m); centre, spread (f,): of each
    feature over all that was seen.
    """

    moved_mean: NDArray[np.float32]
    moved_basis: NDArray[np.float32]
    rest_mean: NDArray[np.float32]
    rest_basis: NDArray[np.float32]
    centre: NDArray[np.float32]
    spread: NDArray[np.float32]

    def features(self, face: Values, rest: Values, poses: Values) -> Values:
        """The features (..., f) of a face (..., 478, 3), of how it is at rest (same shape), and rows (..., 6) of
        poses."""
        return (self.raw(face, rest, poses) - self.centre) / self.spread

    def raw(self, face: Values, rest: Values, poses: Values) -> Values:
        """The same before they are scaled, of face, rest and poses as `features` takes them."""
        flat = (*face.shape[:-2], -1)
        moved = ((face - rest).reshape(flat) - self.moved_mean) @ self.moved_basis
        whose = (rest.reshape(flat) - self.rest_mean) @ self.rest_basis
        return np.concatenate([moved, measures(face) - measures(rest), pose_terms(poses), whose], axis=-1)


@dataclass(frozen=True, eq=False)
class LandmarkMap:
    """Features to outputs: a linear part (f, OUTPUTS) and a network of layers, each weights and offsets; swish between
    them (Ramachandran, Zoph and Le 2017).

    order, sign (f,): which feature, and with which sign, is each feature of the face in the mirror.
    """

    compression: Compression
    order: NDArray[np.intp]
    sign: NDArray[np.float32]
    linear: NDArray[np.float32]
    layers: Sequence[tuple[NDArray[np.float32], NDArray[np.float32]]]

    def estimate(self, features: Values) -> Values:
        """Weights of UNITS, gaze and head (radians): (..., OUTPUTS). Nothing is clipped.

        The mean of what the face gives and of what it gives in the mirror, turned back: a face has no better side.
        """
        rows, signs = mirror_outputs()
        other = self._outputs(features[..., self.order] * self.sign)
        return 0.5 * (self._outputs(features) + other[..., rows] * signs)

    def read_hidden(self, features: Values) -> Values:
        """The values of the last layer but the outputs."""
        values = features
        for weights, offsets in self.layers[:-1]:
            values = swish(values @ weights + offsets)
        return values

    def _outputs(self, features: Values) -> Values:
        weights, offsets = self.layers[-1]
        result: Values = self.read_hidden(features) @ weights + offsets + features @ self.linear
        return result


@cache
def mirror_outputs() -> tuple[NDArray[np.intp], Values]:
    """Which output, and with which sign, is each output of the face in the mirror: units of the other side; yaw of the
    gaze, yaw and roll of the head turn round."""
    other = [UNITS.index(_swap(name)) for name in UNITS]
    rows = np.array([*other, *range(len(UNITS), OUTPUTS)], np.intp)
    return rows, np.array([*np.ones(len(UNITS)), -1.0, 1.0, -1.0, 1.0, -1.0])


def _swap(name: str) -> str:
    if name.endswith("Left"):
        return name.removesuffix("Left") + "Right"
    return name.removesuffix("Right") + "Left" if name.endswith("Right") else name


def swish(values: Values) -> Values:
    """x / (1 + e^-x)."""
    result: Values = values / (1.0 + np.exp(-np.clip(values, -30.0, 30.0)))
    return result


@cache
def load_landmark_map() -> LandmarkMap:
    """The map that comes with Omote, read once; ValueError where it is missing or another version's."""
    return read_landmark_map(MAP)


def read_landmark_map(path: Path) -> LandmarkMap:
    """The map in a file that `tools/tracking` wrote; ValueError where it is none of this version."""
    try:
        with np.load(path, allow_pickle=False) as file:
            return _read(dict(file))
    except (KeyError, OSError, EOFError, ValueError, zipfile.BadZipFile) as error:
        raise ValueError(
            f"{path} is no map of this version ({error}); put back the one that came with Omote"
        ) from error


def _read(arrays: dict[str, NDArray[np.float32]]) -> LandmarkMap:
    if int(arrays["format"]) != FORMAT:
        raise ValueError(f"it has format {int(arrays['format'])}, this version reads {FORMAT}")
    named = {name: arrays[name].astype(np.float32) for name in Compression.__dataclass_fields__}
    count = sum(name.startswith("weights") for name in arrays)
    layers = [
        (arrays[f"weights{k}"].astype(np.float32), arrays[f"offsets{k}"].astype(np.float32)) for k in range(count)
    ]
    linear = arrays["linear"].astype(np.float32)
    if linear.shape != (len(named["centre"]), OUTPUTS):
        raise ValueError(f"its linear part has shape {linear.shape}; expected {(len(named['centre']), OUTPUTS)}")
    order = arrays["order"].astype(np.intp)
    sign = arrays["sign"].astype(np.float32)
    return LandmarkMap(Compression(**named), order, sign, linear, layers)
