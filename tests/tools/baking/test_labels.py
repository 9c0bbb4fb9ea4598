"""Labels in plain words."""

import pytest

from omote.perform.name_lookup import fold
from tools.baking.expressions import ARKIT, MAKEHUMAN, OMOTE, PERFORMED, SPRINGS
from tools.baking.labels import LABELS, label

NAMES = ["neutral", *PERFORMED, *ARKIT, *MAKEHUMAN, *OMOTE, *SPRINGS]
FOREIGN = ("parling", "protusion", "extern", "platysma", "eversion", "dilatation", "later", "retraction", "shrug")


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("jawOpen", "Open jaw"),
        ("mouthSmileLeft", "Mouth corner up, left"),
        ("mouthLeft", "Mouth to the left"),
        ("eye-right-slit", "Eye to a slit, right"),
        ("mouth-parling", "Part lips"),
        ("smile", "Smile"),
    ],
)
def test_labels_are_words(name: str, words: str) -> None:
    assert label(name) == words


def test_every_unit_has_a_label_of_its_own() -> None:
    folded = [fold(label(name)) for name in NAMES]
    assert len(set(folded)) == len(NAMES)
    units = {*ARKIT, *MAKEHUMAN, *OMOTE}
    assert all(label(name) != name[0].upper() + name[1:] for name in units)


def test_no_label_means_another_name() -> None:
    names = {fold(name): name for name in NAMES}
    assert [(name, names[fold(label(name))]) for name in NAMES if names.get(fold(label(name)), name) != name] == []


def test_every_label_is_used_and_none_is_foreign() -> None:
    stems = {label(name).removesuffix(", left").removesuffix(", right") for name in NAMES}
    assert set(LABELS.values()) <= stems
    assert [text for text in LABELS.values() for word in FOREIGN if word in text.lower()] == []


def test_a_pair_differs_by_its_side_alone() -> None:
    for name in (*ARKIT, *MAKEHUMAN):
        for left, right in (("Left", "Right"), ("-left-", "-right-")):
            twin = name.replace(left, right)
            if twin != name and label(name).endswith(", left"):
                assert label(twin) == label(name).replace(", left", ", right")
