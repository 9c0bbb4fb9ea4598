"""The cast: every face and every expression of a show (the dataclass; the built-in one is loaded by omote.builtin)."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from omote.model.albedo import Albedo, SkinAtlas
from omote.model.body.body import Body
from omote.model.body.figures import Figures
from omote.model.body.garment import SUIT, Garment
from omote.model.body.pose import Pose
from omote.model.hair import HairStyle
from omote.model.known_names import GENERIC, NEUTRAL, KnownNames
from omote.model.space.expression import Expression, Title, refuse_name
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.parameter_space import ParameterSpace, Transfer
from omote.model.transfer.paper_map import compile_expression

# Radians, metres: a field extracted where nothing moves holds the rounding of float32.
_REST = 1e-6


TRAITS: Mapping[str, tuple[float, float]] = MappingProxyType(
    {"iris_size": (0.5, 2.0), "slit": (0.0, 1.0), "lashes": (0.0, 1.0)}
    | dict.fromkeys(
        (
            "pores",
            "age",
            "freckles",
            "stubble",
            "brows",
            "makeup",
            "gloss",
            "fur",
            "stripes",
            "lacquer",
            "scalp",
            "milk",
            "pinstripes",
            "checks",
            "dots",
        ),
        (0.0, 1.0),
    )
)
"""What of a look is a number, and from where to where it goes."""


@dataclass(frozen=True)
class Look:
    """The colours of a face, "#rrggbb" each, and its traits, which are numbers: all of them mix with the faces.

    hair_style: one of the cast's, or ""; garment: one of its figures'.
    iris_size: the iris' radius over a person's; slit: 0 a round pupil, 1 an upright slit; lashes: how many there are;
    coat: the second colour of a fur (muzzle, throat, blaze).
    Of the skin, 0 to 1: pores; age (lines, spots, thin lips); freckles; stubble; brows (0 none, 1 bushy); makeup of the
    eyes; gloss of the lips; fur instead of bare skin; stripes, from a hound's coat (0) to a tabby's (1); lacquer, the
    painted white of a mask; scalp, the shadow of hair on the skin; milk, a baby's few small teeth.
    cloth, trim: the first and the second colour of the garment; pinstripes, checks, dots, 0 to 1: how much of each
    pattern in its second colour lies on its first.
    albedo: the picture of a certain person that stands in place of what is painted, where there is one.
    """

    skin: str = "#d9a98c"
    lip: str = "#b5645c"
    brow: str = "#3a2a20"
    blush: str = "#d98a7a"
    iris: str = "#5a4632"
    hair: str = "#3a2a20"
    hair_style: str = ""
    iris_size: float = 1.0
    slit: float = 0.0
    lashes: float = 0.8
    coat: str = "#eadfcd"
    pores: float = 0.6
    age: float = 0.15
    freckles: float = 0.0
    stubble: float = 0.0
    brows: float = 0.5
    makeup: float = 0.0
    gloss: float = 0.3
    fur: float = 0.0
    stripes: float = 0.0
    lacquer: float = 0.0
    scalp: float = 1.0
    milk: float = 0.0
    garment: str = SUIT
    cloth: str = "#222226"
    trim: str = "#d6cbb6"
    pinstripes: float = 0.0
    checks: float = 0.0
    dots: float = 0.0
    albedo: Albedo | None = None

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            if name in TRAITS:
                object.__setattr__(self, name, _validate_trait(name, value))
                continue
            if name in ("hair_style", "garment", "albedo"):
                continue  # the cast knows which there are
            colour = value
            digits = colour[1:] if isinstance(colour, str) else ""
            if len(digits) != 6 or colour[0] != "#" or not all(digit in "0123456789abcdefABCDEF" for digit in digits):
                raise ValueError(f"{name} of a look is {colour!r}; expected a colour such as '#c08a70'")
        if not isinstance(self.albedo, Albedo | None):
            raise ValueError(
                f"albedo of a look is a {type(self.albedo).__name__}; expected an Albedo, or None for none"
            )


def _validate_trait(name: str, value: object) -> float:
    low, high = TRAITS[name]
    if isinstance(value, bool) or not isinstance(value, int | float) or not low <= value <= high:
        raise ValueError(f"{name} of a look is {value!r}; expected a number from {low:g} to {high:g}")
    return float(value)


def _numbers(expression: Expression) -> list[np.ndarray]:
    """Every number of an expression."""
    turns = (expression.eyes, np.array(expression.pupil), expression.ears, expression.head)
    blood = [np.array(expression.complexion)] if any(expression.complexion) else []  # older ones keep their digest
    fields = (expression.dtheta, expression.dh, expression.ratio, expression.residual)
    return [*fields, *turns, *blood, *expression.parts.values()]


def _refuse_others_at_rest(cast: Cast) -> None:
    """Rejects another face or expression under a reserved name: panic and every start of a show return to these two."""
    generic = cast.faces.get(GENERIC)
    neutral = cast.expressions[NEUTRAL]
    if generic is not None and not np.array_equal(generic.positions, cast.space.points.astype(np.float32)):
        raise ValueError(f"face {GENERIC!r} is not the face the space was built from; give it another name")
    rests = (neutral.dtheta, neutral.dh, neutral.ratio - 1.0, neutral.residual, neutral.eyes, *neutral.parts.values())
    rests += (neutral.ears, neutral.head)
    if neutral.pupil or any(neutral.complexion) or any(np.abs(values).max(initial=0.0) > _REST for values in rests):
        raise ValueError(f"expression {NEUTRAL!r} moves something; expected the field at rest: give it another name")


def _refuse_strange_looks(cast: Cast) -> None:
    for name, look in cast.looks.items():
        if name not in cast.faces:
            raise ValueError(f"there is a look for {name!r}; expected one of the faces {', '.join(cast.faces)}")
        if not isinstance(look, Look):
            raise TypeError(f"the look of {name!r} is a {type(look).__name__}; expected a Look")
        if look.hair_style not in ("", *cast.hair):
            raise ValueError(
                f"the look of {name!r} has hair style {look.hair_style!r}; this cast has "
                f'{", ".join(cast.hair) or "none"}: choose one, or "" for no hair'
            )
        if cast.garments and look.garment not in cast.garments:
            raise ValueError(
                f"the look of {name!r} has garment {look.garment!r}; this cast has {', '.join(cast.garments)}: "
                "choose one"
            )


@dataclass(frozen=True, eq=False, repr=False)
class Cast:
    """Faces and expressions by name, on one space; "generic" is M0 itself and "neutral" the field at rest.

    Parameters
    ----------
    space : ParameterSpace
        What all of them belong to.
    faces, expressions : mappings of Face and of Expression, by name
        What can be called.
    looks : mapping of Look, by the name of a face
        Colours and traits; a face without one gets a plain one.
    titles : mapping of Title, by the name of an expression
        What people read of it; an expression without one gets a plain one.
    hair : mapping of HairStyle, by name
        The styles that looks may name.
    atlas : SkinAtlas, optional
        How the skin lies on its texture; without it regional mixes keep the picture of the rest.
    folding : array_like, (V,), optional
        How far expressions press each vertex of the skin together at most, of 255 (`omote.model.folding`); without it
        no skin folds.
    figures : Figures, optional
        The bodies and poses; without them heads stand alone.

    Raises
    ------
    ValueError
        Where a face or an expression does not belong to the space, or a look names a style that is not there.
    KeyError
        From `cast.faces["dgo"]` and the like, with the names that are near: dog, doll, goblin.

    Examples
    --------
    >>> omote.Cast(cast.space, {"generic": cast.faces["generic"]}, {"neutral": cast.expressions["neutral"]}).titles
    mappingproxy({'neutral': Title(label='neutral', kind='own', region='whole')})

    References
    ----------
    K. Arai (1993), section 2.1; docs/method.md.
    """

    space: ParameterSpace
    faces: Mapping[str, Face]
    expressions: Mapping[str, Expression]
    looks: Mapping[str, Look] = field(default_factory=dict)
    titles: Mapping[str, Title] = field(default_factory=dict)
    hair: Mapping[str, HairStyle] = field(default_factory=dict)
    atlas: SkinAtlas | None = None
    folding: NDArray[np.uint8] | None = None
    figures: Figures | None = None

    def __post_init__(self) -> None:
        for name, face in self.faces.items():
            fit(self.space, face)
            if name != face.name:
                raise ValueError(f"the face under {name!r} is named {face.name!r}; expected one name for both")
        if NEUTRAL not in self.expressions:
            raise ValueError(f"the cast has no expression {NEUTRAL!r}; expected the field at rest under that name")
        for name in self.expressions:
            refuse_name(name, "an expression")
        _refuse_others_at_rest(self)
        _refuse_strange_looks(self)
        looks = {name: self.looks.get(name, Look()) for name in self.faces}
        titles = {name: self.titles.get(name, Title(name.replace("_", " "))) for name in self.expressions}
        for attribute, what, values in (
            ("faces", "face", self.faces),
            ("expressions", "expression", self.expressions),
            ("looks", "face", looks),
            ("titles", "expression", titles),
            ("hair", "hair style", self.hair),
        ):
            object.__setattr__(self, attribute, MappingProxyType(KnownNames(what, values)))

    def __repr__(self) -> str:
        """How much is in it."""
        return f"<cast of {len(self.faces)} faces and {len(self.expressions)} expressions>"

    @property
    def poses(self) -> Mapping[str, Pose]:
        """The poses of its figures, by name; none without figures.

        Examples
        --------
        >>> "bow" in cast.poses
        True
        """
        return {} if self.figures is None else self.figures.poses

    @property
    def bones(self) -> tuple[str, ...]:
        """The bones of its figures, in the order in which poses turn them; none without figures.

        Examples
        --------
        >>> cast.bones[0]
        'root'
        """
        return () if self.figures is None else self.figures.space.skeleton.names

    @property
    def bodies(self) -> Mapping[str, Body]:
        """The bodies of its figures, by name; none without figures.

        Examples
        --------
        >>> cast.bodies["child"].size
        1.12
        """
        return {} if self.figures is None else self.figures.bodies

    @property
    def garments(self) -> Mapping[str, Garment]:
        """What its figures can wear, by name; none without figures.

        Examples
        --------
        >>> cast.garments["suit"].label
        'Stage suit'
        """
        return {} if self.figures is None else self.figures.garments

    @property
    def face_labels(self) -> Mapping[str, str]:
        """What faces are called that have another label than their name: none of these.

        Examples
        --------
        >>> dict(cast.face_labels)
        {}
        """
        return {}

    def with_faces(self, *faces: Face, looks: Mapping[str, Look] | None = None) -> Cast:
        """A new cast with these faces added (or, by name, replaced).

        Parameters
        ----------
        *faces : Face
            Each with the topology of the space.
        looks : mapping of Look, by the name of a face, optional
            Their colours and traits.

        Returns
        -------
        Cast
            The other faces and all expressions are the same objects as before.

        Raises
        ------
        ValueError
            Where a face does not belong to the space.

        Examples
        --------
        >>> half = omote.Face("half", (cast.faces["kaori"].positions + cast.faces["old"].positions) / 2)
        >>> [*cast.with_faces(half).faces][-1]
        'half'
        """
        for face in faces:
            fit(self.space, face)  # what is no face is refused as such, before it is asked for its name
        return replace(
            self, faces={**self.faces, **{face.name: face for face in faces}}, looks={**self.looks, **(looks or {})}
        )

    def with_expressions(self, **expressions: Expression) -> Cast:
        """A new cast with these expressions added (or, by name, replaced).

        Parameters
        ----------
        **expressions : Expression
            Each under its name.

        Returns
        -------
        Cast
            The other expressions and all faces are the same objects as before.

        Raises
        ------
        ValueError
            Where an expression does not belong to the space.

        Examples
        --------
        >>> [*cast.with_expressions(beam=cast.expressions["joy"]).expressions][-1]
        'beam'
        """
        for expression in expressions.values():
            compile_expression(self.space, expression)
        return replace(self, expressions={**self.expressions, **expressions})

    def under(self, transfer: Transfer, /) -> Cast:
        """This cast with another transfer rule: the fields stay, the map from S to the faces changes.

        Parameters
        ----------
        transfer : {"smooth", "paper"}
            The rule.

        Returns
        -------
        Cast
            On a space of its own.

        Raises
        ------
        ValueError
            Where there is no such rule.

        Examples
        --------
        >>> cast.under("paper").space.transfer
        'paper'
        """
        fields = {name: replace(expression, transfer=transfer) for name, expression in self.expressions.items()}
        return replace(self, space=self.space.under(transfer), expressions=fields)

    @cached_property
    def digest(self) -> str:
        """A name for exactly this content, hexadecimal: what is computed from the cast may be kept under it for
        ever."""
        state = hashlib.blake2b(digest_size=12)
        arrays: list[np.ndarray] = [self.space.points, self.space.triangles, self.space.membranes]
        for part in self.space.parts.values():
            arrays += [part.points, part.triangles, part.anchors, part.weights]
        for face in self.faces.values():
            arrays += [face.positions, *face.parts.values()]
        for expression in self.expressions.values():
            arrays += _numbers(expression)
        arrays += [] if self.folding is None else [self.folding]
        arrays += [array for style in self.hair.values() for array in style.arrays]
        for array in arrays:
            state.update(np.ascontiguousarray(array).data)
        texts = (*self.faces, *self.expressions, *self.looks.values(), *self.titles.values(), *self.space.rules)
        state.update(repr(texts).encode())
        gains = [face.gains for face in self.faces.values()]
        state.update(repr((gains, [expression.name for expression in self.expressions.values()])).encode())
        return state.hexdigest()
