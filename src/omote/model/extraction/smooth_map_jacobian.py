"""The derivative of the smooth map's continuous stages, factorised: what its inverse takes steps with.

Detail transfer reads K x = K g u + D'A soft(W(u) - D g u), with K = D'A D + M / l^2, W the deformation gradients and g
the gain; so its Jacobian is K^-1 B with B sparse. Contact adds one row per bin (Woodbury identity).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.linalg import splu

from omote.arrays import Values
from omote.geometry import mesh
from omote.model.space.face import Face
from omote.model.space.lid_lip_lines import RUNGS
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.fold_repair import SheetGeometry, triangle_frames
from omote.model.transfer.lid_lip_contact import Contact
from omote.model.transfer.smooth_map import LENGTH, TOLERANCE, SmoothMap, prepare_smooth_map


@dataclass(frozen=True, eq=False)
class ContactRows:
    """What contact does, which is linear, for b bins: their lack is wanted (b, 3 n) times the source's change less read
    (b, 3 n) times the sheet's; respond (3 n, b) gives it back."""

    wanted: Values
    read: Values
    respond: Values


@dataclass(frozen=True, eq=False)
class SmoothMapJacobian:
    """How the continuous stages change the n sheet vertices of a face with those of the generic one: K^-1 B, contact.

    stiffness (3 n, 3 n): K; solver: B factorised; contact: its rows.
    """

    stiffness: sparse.csc_array
    solver: splu
    contact: ContactRows

    @cached_property
    def _responses(self) -> tuple[Values, Values]:
        """What a unit of each bin asks of the source (3 n, b), and the inverse of the bins' own system (b, b)."""
        rows = self.contact
        if not len(rows.wanted):
            return rows.respond, np.zeros((0, 0))
        back = self.solver.solve(self.stiffness @ rows.respond)
        own = np.eye(len(rows.wanted)) + rows.wanted @ back - rows.read @ rows.respond
        return back, np.linalg.pinv(own)

    def solve(self, change: Values, /) -> Values:
        """The change (n, 3) of the generic face's displacement that changes the face's sheet by (n, 3) metres."""
        back, inverse = self._responses
        flat = np.ascontiguousarray(change).ravel()
        result = self.solver.solve(self.stiffness @ flat)
        bins = inverse @ (self.contact.wanted @ result - self.contact.read @ flat)
        return (result - back @ bins).reshape(-1, 3)


def linearise_smooth_map(space: ParameterSpace, face: Face, displacement: Values, /) -> SmoothMapJacobian:
    """The Jacobian at a displacement (V, 3) of the generic face, metres.

    Raises RuntimeError where it is singular.

    space, face: whose map; displacement (V, 3): metres.
    """
    ready = prepare_smooth_map(space, face)
    place = np.full(len(displacement), -1)
    place[ready.detail.used] = np.arange(len(ready.detail.used))
    stiffness, product = _assemble_detail(ready, ready.generic + displacement, displacement, place)
    rows = [_read_contact(contact, place) for contact in ready.contacts]
    return SmoothMapJacobian(stiffness, splu(product), _join(rows, 3 * len(ready.detail.used)))


def _assemble_detail(
    ready: SmoothMap, source: Values, displacement: Values, place: NDArray[np.int64]
) -> tuple[sparse.csc_array, sparse.csc_array]:
    """K and B of detail transfer at a source (V, 3): (3 n, 3 n) each."""
    detail = ready.detail
    geometry = ready.geometry
    triangles = geometry.triangles
    count = len(geometry.triangles)
    gain = ready.gain[triangles]
    grown = np.einsum("tkd,tk->tkd", geometry.gradients, gain)
    change = (triangle_frames(source, triangles) @ geometry.inverse_frames - np.eye(3)) @ geometry.plane
    missing = change * gain.mean(axis=1)[:, None, None] - np.einsum("tkd,tkc->tcd", grown, displacement[triangles])
    to_frames = np.einsum("tcjkx,tjd->tcdkx", _differentiate_frames(source, geometry), _in_plane(geometry))
    slope = to_frames * gain.mean(axis=1)[:, None, None, None, None]
    here = np.zeros_like(slope)
    for axis in range(3):
        slope[:, axis, :, :, axis] -= grown.transpose(0, 2, 1)
        here[:, axis, :, :, axis] = geometry.gradients.transpose(0, 2, 1)
    slope = _differentiate_threshold(missing.reshape(count, 6)) @ slope.reshape(count, 6, 9)
    weighted = (here.reshape(count, 6, 9) * detail.areas[:count, None, None]).transpose(0, 2, 1)
    mass = np.bincount(place[triangles].ravel(), np.repeat(detail.areas[:count] / 3.0, 3))
    own = sparse.diags_array(np.repeat(mass / LENGTH**2, 3))
    unknowns = (place[triangles][:, :, None] * 3 + np.arange(3)).reshape(count, 9)
    stiffness = _scatter(weighted @ here.reshape(count, 6, 9), unknowns, 3 * len(mass)) + own
    pulled = _scatter(weighted @ slope, unknowns, 3 * len(mass))
    product = stiffness @ sparse.diags_array(np.repeat(ready.gain[detail.used], 3)) + pulled
    return sparse.csc_array(stiffness), sparse.csc_array(product)


def _in_plane(geometry: SheetGeometry) -> Values:
    return geometry.inverse_frames @ geometry.plane


def _scatter(blocks: Values, unknowns: NDArray[np.int64], size: int) -> sparse.csc_array:
    """The sum of blocks (T, 9, 9) at the unknowns (T, 9) of each triangle."""
    where = np.repeat(unknowns, 9, axis=1).ravel(), np.tile(unknowns, (1, 9)).ravel()
    return sparse.coo_array((blocks.ravel(), where), shape=(size, size)).tocsc()


def _differentiate_threshold(missing: Values) -> Values:
    """The derivative (T, 6, 6) of soft thresholding at missing gradients (T, 6)."""
    size = np.maximum(np.linalg.norm(missing, axis=1), 1e-12)
    beyond = size > TOLERANCE
    along = missing / size[:, None]
    share = np.where(beyond, TOLERANCE / size, 1.0)[:, None, None]
    return (1.0 - share) * np.eye(6) + np.where(beyond, TOLERANCE / size, 0.0)[:, None, None] * (
        along[:, :, None] * along[:, None, :]
    )


def _differentiate_frames(positions: Values, geometry: SheetGeometry) -> Values:
    """How `triangle_frames` change with each corner: (T, 3, 3, corner, 3)."""
    a, b, c = positions[geometry.triangles].transpose(1, 0, 2)
    first = b - a
    second = c - a
    normal = np.cross(first, second)
    squared = np.maximum((normal * normal).sum(axis=1), 1e-36)[:, None, None]
    scaled = np.eye(3) / squared**0.25 - 0.5 * normal[:, :, None] * normal[:, None, :] / squared**1.25
    by_second = scaled @ mesh.cross_matrices(first)
    by_first = -scaled @ mesh.cross_matrices(second)
    result = np.zeros((len(normal), 3, 3, 3, 3))
    for axis in range(3):
        result[:, axis, 0, 1, axis] = result[:, axis, 1, 2, axis] = 1.0
        result[:, axis, 0, 0, axis] = result[:, axis, 1, 0, axis] = -1.0
    result[:, :, 2, 0], result[:, :, 2, 1], result[:, :, 2, 2] = -by_first - by_second, by_first, by_second
    return result


def _read_contact(contact: Contact, place: NDArray[np.int64]) -> ContactRows:
    """The rows of one line."""
    bins = contact.bins
    size = int(place.max()) + 1
    line = contact.line
    wanted = np.zeros((len(bins), size, 3))
    read = np.zeros((len(bins), size, 3))
    respond = np.zeros((size, 3, len(bins)))
    factor = np.full(RUNGS, contact.gain) if line.kind == "lips" else contact.ratios
    for column in range(4):
        for rung in range(RUNGS):
            vertex = place[line.vertices[rung, column]]
            share = bins[:, rung, None] * line.weights[rung, column]
            wanted[:, vertex] += share * factor[rung] * contact.source[rung]
            read[:, vertex] += share * contact.target[rung]
    respond[place[contact.near]] = contact.response.transpose(0, 2, 1)
    flat = len(bins), -1
    return ContactRows(wanted.reshape(flat), read.reshape(flat), respond.reshape(-1, len(bins)))


def _join(rows: list[ContactRows], size: int) -> ContactRows:
    """The rows of all lines, for so many unknowns."""
    return ContactRows(
        np.concatenate([np.zeros((0, size)), *(row.wanted for row in rows)]),
        np.concatenate([np.zeros((0, size)), *(row.read for row in rows)]),
        np.concatenate([np.zeros((size, 0)), *(row.respond for row in rows)], axis=1),
    )
