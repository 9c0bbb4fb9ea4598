"""Lids and lips close on a face as far as on the generic face (docs/method.md, "Contact of lids and lips").

Openings are measured along each line by hat functions; what is missing is given back by equality-constrained least
squares of minimum norm, whose responses are solved once per face: M^-1 C' (C M^-1 C')^-1.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.linalg import splu

from omote.arrays import Indices, Values
from omote.model.space.lid_lip_lines import RUNGS, Kind, Line, lip_amplitude
from omote.model.transfer.fold_repair import SheetGeometry

# How many hat functions there are along a line: between three of them lids close unevenly, and a muzzle's lips cross.
BINS: Mapping[Kind, int] = {"lids": 8, "lips": 7}
# A correction dies out over this share of the line's width, and is nothing beyond FARTHEST_WIDTHS.
LENGTH_WIDTHS = 0.2
FARTHEST_WIDTHS = 1.5
# Where the jaw goes with the lips in full: (distance to the lids - to the lips) / their sum.
JAW = 0.4
_UP = np.array([0.0, 1.0, 0.0])


@dataclass(frozen=True, eq=False)
class Contact:
    """How one line of a face is opened and closed.

    bins (b, RUNGS): hat functions along the line; source, target (RUNGS, 3): directions along which openings are
    measured on the generic face and on this one; ratios (RUNGS,): how much longer the rungs are here; there, here
    (RUNGS,): openings at rest on both; gain: how much larger lips open here; near (m,), response (m, b, 3): the
    displacement of the vertices near the line that opens a bin by one metre.
    """

    line: Line
    bins: Values
    source: Values
    target: Values
    ratios: Values
    there: Values
    here: Values
    gain: float
    near: Indices
    response: Values


def build_contact(line: Line, generic: Values, positions: Values, sheet: SheetGeometry, /) -> Contact:
    """The contact of a line on a face with positions (V, 3); generic (V, 3): the face on which expressions were
    made.

    sheet: of that face.
    """
    there = line.rungs(generic)
    here = line.rungs(positions)
    long_there = np.linalg.norm(there, axis=1)
    long_here = np.linalg.norm(here, axis=1)
    lips = line.kind == "lips"
    source = np.tile(_UP, (RUNGS, 1)) if lips else there / long_there[:, None]
    target = np.tile(_UP, (RUNGS, 1)) if lips else here / long_here[:, None]
    asked = np.einsum("br,rk,rc->brkc", hat_functions(BINS[line.kind]), line.weights, target)
    near, response = solve_responses(line, asked, positions, sheet)
    return Contact(
        line, hat_functions(BINS[line.kind]), source, target, long_here / long_there, (source * there).sum(axis=1),
        (target * here).sum(axis=1), lip_amplitude(line, generic, positions), near, response,
    )  # fmt: skip


def hat_functions(count: int, /) -> Values:
    """So many hat functions over the rungs that sum to one: (count, RUNGS)."""
    shares = (np.arange(RUNGS) + 0.5) / RUNGS * count - 0.5
    result: Values = np.maximum(0.0, 1.0 - np.abs(shares - np.arange(count)[:, None]))
    result /= result.sum(axis=0)
    return result


def solve_responses(line: Line, asked: Values, positions: Values, sheet: SheetGeometry, /) -> tuple[Indices, Values]:
    """The vertices (m,) near a line, and the smoothest displacements (m, b, 3) of them that give each asked sum alone
    one metre: M^-1 C' (C M^-1 C')^-1.

    Least squares of minimum norm under equality constraints, by the Schur complement of its KKT system.

    asked (b, RUNGS, 4, 3): how much each coordinate of a rung's vertices counts in a sum; positions (V, 3): the face,
    metres; sheet: its.
    """
    width = float(np.ptp(positions[line.loop, 0]))
    used = np.unique(sheet.triangles)
    distance = np.full(len(used), np.inf)
    for vertex in line.loop:
        distance = np.minimum(distance, np.linalg.norm(positions[used] - positions[vertex], axis=1))
    near = used[distance < FARTHEST_WIDTHS * width].astype(np.int32)
    place = np.full(len(positions), -1)
    place[near] = np.arange(len(near))
    openings = np.zeros((len(asked), len(near), 3))
    for column in range(4):
        for rung in range(RUNGS):
            openings[:, place[line.vertices[rung, column]]] += asked[:, rung, column]
    solver = splu(sparse.csc_array(_stiffness(sheet, near, place, LENGTH_WIDTHS * width)))
    flat = np.stack([solver.solve(np.ascontiguousarray(openings[:, :, c].T)) for c in range(3)], axis=2)
    gram = np.einsum("bvc,vdc->bd", openings, flat)
    return near, np.einsum("vbc,bd->vdc", flat, np.linalg.inv(gram))


def _stiffness(sheet: SheetGeometry, near: Indices, place: NDArray[np.int64], length: float) -> sparse.csr_array:
    """M = D'D + diag(valence / 3 / length^2) on the near vertices, those beyond held."""
    touched = np.flatnonzero((place[sheet.triangles] >= 0).any(axis=1))
    corners = place[sheet.triangles[touched]]
    slopes = sheet.gradients[touched]
    energy = np.einsum("tkd,tld->tkl", slopes, slopes)
    rows = np.repeat(corners, 3, axis=1).ravel()
    cols = np.tile(corners, (1, 3)).ravel()
    inside = (rows >= 0) & (cols >= 0)
    shape = (len(near), len(near))
    matrix = sparse.coo_array((energy.ravel()[inside], (rows[inside], cols[inside])), shape=shape).tocsr()
    valence = (sheet.starts[near + 1] - sheet.starts[near]) / 3.0
    return sparse.csr_array(matrix + sparse.diags_array(valence / length**2))


def close_contact(contact: Contact, positions: Values, moved: Values, /) -> None:
    """Opens or closes the line of positions (V, 3), in place, as far as moved (V, 3), the generic face, has it.

    contact: of the line on this face.
    """
    source = (contact.source * contact.line.rungs(moved)).sum(axis=1)
    now = (contact.target * contact.line.rungs(positions)).sum(axis=1)
    if contact.line.kind == "lips":
        missing = contact.bins @ (contact.here + contact.gain * (source - contact.there) - now)
    else:
        missing = contact.bins @ (contact.ratios * source - now)
    positions[contact.near] += np.einsum("vbc,b->vc", contact.response, missing)


def compute_gain(generic: Values, contacts: tuple[Contact, ...], amplitude: float, /) -> Values:
    """How much larger a displacement of the generic face (V, 3) becomes at each vertex, (V,): its gain.

    contacts: of lids and lips.

    amplitude: the jaw's, of `lid_lip_lines.jaw_amplitude`: as large where a vertex is nearer to the lips than to the
    lids, one around these, smoothly between.
    """
    gain = np.ones(len(generic))
    lids = np.full(len(generic), np.inf)
    for contact in contacts:
        if contact.line.kind == "lids":
            lids = np.minimum(lids, _distance(generic, contact.line))
    for contact in contacts:
        if contact.line.kind == "lips" and np.isfinite(lids).all():
            lips = _distance(generic, contact.line)
            share = np.minimum(np.maximum((lids - lips) / (lids + lips) / JAW, 0.0), 1.0)
            gain += (amplitude - 1.0) * share * share * (3.0 - 2.0 * share)
    return gain


def _distance(points: Values, line: Line) -> Values:
    return np.linalg.norm(points[:, None] - points[line.loop], axis=2).min(axis=1)
