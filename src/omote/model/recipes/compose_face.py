"""Composes the face (identity) and look of a recipe: a mix of faces, regions of others, caricature, handles."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields

import numpy as np

from omote.model.albedo import Albedo, SkinAtlas, decode_light, encode_light, mix_albedos, regional_albedo
from omote.model.appearance.look_suggestion import wear_hair
from omote.model.cast import TRAITS, Look
from omote.model.recipes.face_handles import drag_handles
from omote.model.recipes.recipe import FaceRecipe
from omote.model.sculpting.caricature import caricature, check_amount
from omote.model.sculpting.regions import regional
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.gain import Gain, check_gain_region, mix_gains, override_gains
from omote.model.space.head_regions import Region, check_region
from omote.model.space.parameter_space import ParameterSpace

_SUM = 1e-3  # How far weights of faces may be from summing to one: what is on air was rounded on its way.

_BARELY = 1e-3  # of painted skin that shows: less says nothing of a look

# What of a look only its painted skin shows: where a picture stands in its place, it counts as much less.
_PAINTED = ("skin", "lip", "brow", "blush", "coat", "freckles", "stubble", "brows", "fur", "stripes")

CHOSEN = frozenset(field.name for field in fields(Look)) - {"albedo"}
"""What of a look a recipe can choose, by name."""

# What of a look lies in which region; the rest goes with the mix.
_OF_REGIONS: Mapping[Region, tuple[str, ...]] = {
    "brows": ("brow", "brows"),
    "eyes": ("iris", "iris_size", "slit", "lashes", "makeup"),
    "cheeks": ("blush", "freckles"),
    "mouth": ("lip", "gloss"),
    "jaw": ("stubble",),
    "skull": ("hair", "hair_style", "scalp"),
}


@dataclass(frozen=True, eq=False)
class FaceWithLook:
    """A face and its look."""

    face: Face
    look: Look


def compose_face(
    space: ParameterSpace, name: str, recipe: FaceRecipe, sources: Mapping[str, FaceWithLook], /,
    atlas: SkinAtlas | None = None,
) -> FaceWithLook:  # fmt: skip
    """Composes the face of a recipe, under a name: base, then regions, then caricature, then handles; its gains
    are those of the base and of the regions' faces, except where the recipe sets its own, and so is its look.

    sources: the faces that it names; atlas: how the skin lies on its texture, without which regions bring no pictures.
    Raises ValueError on faces, regions, handles and traits that nobody knows, weights that do not sum to one, and what
    makes no face of this space.
    """
    shares = _shares(recipe, sources)
    chosen = {check_region(region): _find_source(sources, source) for region, source in recipe.regions.items()}
    face = mix_faces(space, name, [(sources[source].face, share) for source, share in shares.items()])
    if chosen:
        face = regional(space, name, {region: one.face for region, one in chosen.items()}, rest=face)
    check_amount(recipe.amount)
    if recipe.amount != 1.0:
        face = caricature(space, face, recipe.amount)
    if len(recipe.points) or len(recipe.moves):
        face = drag_handles(space, face, name, rows=recipe.points, moves=recipe.moves)
    look = mix_looks([(sources[source].look, share) for source, share in shares.items()])
    worn = {trait: getattr(one.look, trait) for region, one in chosen.items() for trait in _OF_REGIONS.get(region, ())}
    if atlas is not None and chosen:
        pictures = tuple((region, one.look.albedo) for region, one in chosen.items())
        worn["albedo"] = regional_albedo(space, atlas, look.albedo, pictures)
    gains = override_gains(face.gains, _gains(recipe))
    look = choose_look(Look(**{**vars(look), **worn}), recipe.look)
    return FaceWithLook(Face(name, face.positions, face.parts, gains), look)


def choose_look(look: Look, chosen: Mapping[str, str | float], /) -> Look:
    """A look with chosen colours, traits, garment and hair style in place of its own; another style comes with its own
    shade on the scalp where none is chosen.

    chosen: by the names of `Look`, but for a picture. Raises ValueError on names and values that no look has.
    """
    strange = sorted(chosen.keys() - CHOSEN)
    if strange:
        raise ValueError(f"a look has no {strange[0][:80]!r} to choose; expected {', '.join(sorted(CHOSEN))}")
    garment = chosen.get("garment", look.garment)
    if not isinstance(garment, str):
        raise ValueError(f"garment of a look is {garment!r}; expected the name of a garment")
    style = chosen.get("hair_style", look.hair_style)
    if not isinstance(style, str):
        raise ValueError(f"hair_style of a look is {style!r}; expected the name of a style")
    if style != look.hair_style:
        look = wear_hair(look, style)
    return Look(**{**vars(look), **chosen})


def _gains(recipe: FaceRecipe) -> tuple[Gain, ...]:
    return tuple(Gain(check_gain_region(row.region), row.value, row.expression) for row in recipe.gains)


def mix_faces(space: ParameterSpace, name: str, faces: Sequence[tuple[Face, float]], /) -> Face:
    """Mixes faces by shares that sum to one: skin, parts and gains; named `name`.

    space: the space of the generic head.
    """
    skin = np.zeros(space.points.shape)
    parts = {part: np.zeros(one.points.shape) for part, one in space.parts.items()}
    for face, share in faces:
        fitted = fit(space, face)
        skin += share * fitted.positions.astype(np.float64)
        for part, points in parts.items():
            points += share * fitted.parts[part].astype(np.float64)
    return Face(name, skin, parts, mix_gains([(face.gains, share) for face, share in faces]))


def mix_looks(looks: Sequence[tuple[Look, float]], /) -> Look:
    """Mixes looks by shares that sum to one: colours in linear light, as the stage mixes them.

    Hair is one style, whole, on the scalp that goes with it: a mixed hairline would fit none. It is that of the largest
    share (of styles worn by several, all their shares) where half of the mix or more wear any; its colour is mixed from
    all who wear hair. The garment is whole too, that of the largest share. Pictures of skin mix; what is painted is
    mixed from those whose paint shows.
    """
    style = _style(looks)
    painted = _painted_shares(looks)
    wearers = _normalize_shares([(look, share) for look, share in looks if look.hair_style == style])
    haired = _normalize_shares([(look, share) for look, share in looks if look.hair_style]) or looks
    pictures = tuple((look.albedo, share) for look, share in looks)
    mixed: dict[str, str | float | Albedo | None] = {"hair_style": style, "garment": _garment(looks)}
    mixed["albedo"] = mix_albedos(pictures)
    for trait in (field.name for field in fields(Look) if field.name not in mixed):
        those = {"scalp": wearers, "hair": haired, **dict.fromkeys(_PAINTED, painted)}.get(trait, looks)
        worn = [(getattr(look, trait), share) for look, share in those]
        if trait in TRAITS:
            low, high = TRAITS[trait]
            mixed[trait] = min(max(sum(float(value) * share for value, share in worn), low), high)
        else:
            mixed[trait] = _colour(worn)
    return Look(**mixed)  # type: ignore[arg-type]


def _style(looks: Sequence[tuple[Look, float]]) -> str:
    """The hair style of a mix, "" for none."""
    shares: dict[str, float] = {}
    for look, share in looks:
        shares[look.hair_style] = shares.get(look.hair_style, 0.0) + share
    if shares.pop("", 0.0) > sum(shares.values()):
        return ""
    return max(shares, key=lambda style: shares[style])


def _garment(looks: Sequence[tuple[Look, float]]) -> str:
    """What most of a mix wear."""
    shares: dict[str, float] = {}
    for look, share in looks:
        shares[look.garment] = shares.get(look.garment, 0.0) + share
    return max(shares, key=lambda garment: shares[garment])


def _painted_shares(looks: Sequence[tuple[Look, float]]) -> Sequence[tuple[Look, float]]:
    """The shares of looks by how much of their painted skin shows beside pictures; all of them where none does."""
    if all(look.albedo is None for look, _ in looks):
        return looks
    shown = [(look, share * (1.0 - (look.albedo.cover if look.albedo else 0.0))) for look, share in looks]
    return _normalize_shares(shown) if sum(share for _, share in shown) > _BARELY else looks


def _normalize_shares(looks: Sequence[tuple[Look, float]]) -> list[tuple[Look, float]]:
    """Scales the shares of looks to sum to one."""
    total = sum(share for _, share in looks)
    return [(look, share / total) for look, share in looks if share > 0.0]


def _colour(worn: list[tuple[str, float]]) -> str:
    """The colour between those given as "#rrggbb" with their shares, mixed as light."""
    codes = np.frombuffer(bytes.fromhex("".join(colour[1:] for colour, _ in worn)), np.uint8).reshape(-1, 3)
    return "#" + encode_light(np.array([share for _, share in worn]) @ decode_light(codes)).tobytes().hex()


def _shares(recipe: FaceRecipe, sources: Mapping[str, FaceWithLook]) -> dict[str, float]:
    if not recipe.base:
        raise ValueError("the base of this face is empty; expected at least one face, such as generic by 1")
    for source, weight in recipe.base.items():
        _find_source(sources, source)
        if not 0.0 <= weight <= 1.0:
            raise ValueError(f"face {source!r} has weight {weight!r} in the base; expected a number from 0 to 1")
    total = sum(recipe.base.values())
    if abs(total - 1.0) > _SUM:
        raise ValueError(f"the weights of the base sum to {total:.4g}; expected 1: scale them")
    return {source: weight / total for source, weight in recipe.base.items() if weight}


def _find_source(sources: Mapping[str, FaceWithLook], source: str) -> FaceWithLook:
    if source not in sources:
        raise ValueError(f"there is no face {source!r}; expected one of {', '.join(sources) or 'none'}")
    return sources[source]
