"""The names of the built-in cast and of a show file's own work, without a face of either: what is mistyped is said at
once, for loading the cast takes twenty times as long."""

from __future__ import annotations

import json
import zipfile
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from omote.interchange.name_choices import NamedExpressions
from omote.model.body.limb_recipe import LIMB_KIND, limb_channels, read_limb_recipes
from omote.perform.name_lookup import OWN, find_name
from omote.showfile.changes import Stored, playing_items
from omote.stage_data.pose_words import PoseWords, merge_names

CAST = Path(__file__).parents[1] / "builtin" / "cast.npz"
"""The package `builtin` has the rest of it, and loads Numba."""
LIMB_FIELDS = CAST.with_name("limbs.toml")


class NameTitle(NamedTuple):
    """What an expression is called, and its kind."""

    label: str
    kind: str


@dataclass(frozen=True)
class CastNames:
    """The names of a cast. faces: labels by name, "" where there is none; titles: of expressions, by name; hair: the
    styles."""

    faces: Mapping[str, str]
    titles: Mapping[str, NameTitle]
    hair: tuple[str, ...]

    @property
    def expressions(self) -> Mapping[str, object]:
        """The expressions, by name."""
        return self.titles

    @property
    def kinds(self) -> dict[str, str]:
        """The kind of each expression, by name."""
        return {name: title.kind for name, title in self.titles.items()}

    def find_face(self, typed: str) -> str:
        """The face that a person means by a name or a label; ValueError for none."""
        return find_name(typed, self.faces, "face", self.faces)

    def check_names(self, typed: Iterable[str], what: str) -> None:
        """Rejects, by ValueError, names of faces, expressions or channels (what) that there are not. typed: as a person
        wrote them."""
        names, labels = (self.faces, self.faces) if what == "face" else (self.titles, self._labels)
        merge_names(tuple((name, 0.0) for name in dict.fromkeys(typed)), names, what, labels)

    @property
    def _labels(self) -> dict[str, str]:
        return {name: title.label for name, title in self.titles.items()}

    def check_words(self, words: PoseWords) -> None:
        """Rejects, by ValueError, words of a pose that name what is not there, or one thing twice."""
        labels = self._labels
        merge_names(words.expressions, self.titles, "expression", labels)
        merge_names(words.faces, self.faces, "face", self.faces)
        merge_names(words.channels, self.titles, "channel", labels)


def read_names(stored: Stored | None = None, /, path: Path = CAST) -> CastNames | None:
    """The names of the built-in cast, with a show file's own work; None where the cast cannot be read, which loading it
    says in words.

    stored: what the show file lists; path: of the cast.
    """
    try:
        about, styles = _read_about(path)
        faces: dict[str, str] = dict.fromkeys(about["faces"], "")
        titles = {row["name"]: NameTitle(row["label"], row["kind"]) for row in about["expressions"]}
        for recipe in read_limb_recipes(LIMB_FIELDS.read_bytes()):
            titles |= {each.name: NameTitle(each.label, LIMB_KIND) for each in limb_channels(recipe)}
    except (OSError, ValueError, KeyError, TypeError, zipfile.BadZipFile):
        return None
    for item, _ in playing_items(stored) if stored is not None else ():
        if item.kind == "face":
            faces[item.name] = item.label
        else:
            titles[item.name] = NameTitle(item.label, OWN)
    return CastNames(faces, titles, styles)


def find_exported(cast: NamedExpressions, stored: Stored, name: str, /) -> str:
    """The authored expression that a person means, else one of the cast; ValueError for neither, and for a face.

    cast: the built-in one, or its names; stored: of the show file; name: what the person typed.
    """
    own = {item.name: item.label for item in stored.items if item.kind == "expression" and item.head}
    labels = {name: title.label for name, title in cast.titles.items()} | own
    own_faces = [item for item in stored.items if item.kind == "face" and item.head]
    faces = {word: item.name for item in own_faces for word in (item.name, item.label)}
    if name in faces.keys() - {*own, *labels.values(), *cast.expressions}:
        raise ValueError(
            f"{name!r} is a face, and only expressions become documents; a face goes out whole, as a show file of its "
            f"own: -o {faces[name]}.omote"
        )
    others = (expression for expression in cast.expressions if expression not in own)
    return find_name(name, [*own, *others], "expression", labels)


def _read_about(path: Path) -> tuple[Any, tuple[str, ...]]:
    """What a cast says of itself, text in an array behind the header of NumPy's NPY, and its styles of hair."""
    with zipfile.ZipFile(path) as archive:
        data = archive.read("about.npy")
        names = archive.namelist()
    size = 2 if data[6:7] == b"\x01" else 4
    begin = 8 + size + int.from_bytes(data[8 : 8 + size], "little")
    return json.loads(data[begin:]), tuple(sorted({name.split("/")[1] for name in names if name.startswith("hair/")}))
