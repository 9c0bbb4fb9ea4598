"""Faces mixed region by region, smooth at the borders."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from omote.arrays import Values
from omote.geometry import mesh
from omote.model.sculpting.socket_depth import mend_lining
from omote.model.space.eye_socket import ball_heights, set_ball_heights
from omote.model.space.face import Face
from omote.model.space.face_fit import FittedFace, fit
from omote.model.space.gain import Gain, regional_gains
from omote.model.space.head_regions import REGIONS, Region, region_weights
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.similarity import Similarity, fit_similarity
from omote.model.transfer.mouth_at_rest import mend_mouth

_NOWHERE = np.zeros((1, 3))


def regional(space: ParameterSpace, name: str, faces: Mapping[Region, Face], /, *, rest: Face | None = None) -> Face:
    """A face with each region from another face, smooth at the borders.

    Each face is first turned, scaled and moved so that its borders lie on those of the rest (of the face around the
    skull, where every region is named), so faces of all sizes mix. One face everywhere gives that face.

    Parameters
    ----------
    space : ParameterSpace
        The space of all of them.
    name : str
        The new face's.
    faces : mapping of Face, by region
        Regions: brows, eyes, nose, cheeks, mouth, jaw, ears, skull.
    rest : Face, optional
        Where the other regions come from; without it the generic face.

    Returns
    -------
    Face
        Its lids lie on its eyeballs as those of the faces that it has its eyes from; it answers each
        region as that region's face does.

    Raises
    ------
    ValueError
        On a region that is none, and on a face that does not belong to the space.

    Examples
    --------
    >>> faces = {"eyes": cast.faces["doll"], "jaw": cast.faces["heavy"]}
    >>> omote.regional(cast.space, "hers", faces, rest=cast.faces["old"]).positions.shape
    (4278, 3)

    References
    ----------
    docs/sculpts.md, "Mixes and caricature"; the borders are laid on each other by Umeyama's similarity (1991).
    """
    strange = [region for region in faces if region not in REGIONS]
    if strange:
        raise ValueError(f"there is no region {strange[0]!r}; expected some of {', '.join(REGIONS)}")
    generic = rest or Face("generic", space.points, {name: part.points for name, part in space.parts.items()})
    chosen = {region: fit(space, faces.get(region, generic)) for region in REGIONS}
    whole = fit(space, generic) if len(faces) < len(REGIONS) else chosen["skull"]
    laid = _align_regions(space, chosen, whole)
    weights = region_weights(space)
    skin = sum((weights[region][:, None] * laid[region](face.positions) for region, face in chosen.items()), _NOWHERE)
    parts = {}
    for part in space.parts.values():
        # An eyeball is round: one weight for all of it, that of the skin that places it; the others bend like the skin.
        shares = region_weights(space, part.points)
        if part.eye:
            shares = {region: np.full(len(part.points), weights[region][part.ring].mean()) for region in REGIONS}
        rows = (shares[region][:, None] * laid[region](face.parts[part.name]) for region, face in chosen.items())
        parts[part.name] = sum(rows, _NOWHERE)
    wanted = {}
    for eye in space.eyes:
        over = (weights[region] * ball_heights(face.positions, face.parts[eye]) for region, face in chosen.items())
        wanted[eye] = sum(over, np.zeros(1))
    gains = regional_gains(generic.gains, {region: face.gains for region, face in faces.items()})
    return fit_with_lids(space, name, skin, parts, wanted, gains)


def _align_regions(
    space: ParameterSpace, chosen: Mapping[Region, FittedFace], whole: FittedFace
) -> dict[Region, Similarity]:
    """Aligns each region's face with the whole one, by the border of all regions that the face gives."""
    weights = region_weights(space)
    area = vertex_areas(space)
    aligned: dict[Region, Similarity] = {}
    for region, face in chosen.items():
        own = sum((weights[other] for other in REGIONS if chosen[other] is face), np.zeros(1))
        aligned[region] = fit_similarity(face.positions, whole.positions, area * own * (1.0 - own))
    return aligned


def vertex_areas(space: ParameterSpace) -> Values:
    """Area of the sheet's triangles around each vertex (V,), square metres, three times."""
    area = np.zeros(space.vertex_count)
    for corner in range(3):
        np.add.at(area, space.skin_triangles[:, corner], mesh.areas(space.points, space.skin_triangles))
    return area


def fit_with_lids(
    space: ParameterSpace, name: str, skin: Values, parts: dict[str, Values], wanted: Mapping[str, Values],
    gains: tuple[Gain, ...],
) -> Face:  # fmt: skip
    """The face, fitted, its lids at the wanted heights over its eyeballs, sockets and mouth in order.

    space: the space of the generic head; name: of the new face; skin: (V, 3), metres; parts: (n, 3) each, metres;
    gains: those of the face.
    """
    face = Face(name, set_ball_heights(skin, parts, wanted), parts, gains)
    return mend_mouth(space, mend_lining(space, face))
