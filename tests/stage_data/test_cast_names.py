"""Names without a cast: those that the cast has, in its order, and a show file's own beside them."""

from pathlib import Path

import pytest

from omote.builtin import load_cast
from omote.perform.name_lookup import OWN
from omote.showfile.changes import Stored
from omote.stage_data.cast_names import CAST, CastNames, find_exported, read_names
from omote.stage_data.picture_request import GridRequest, RenderRequest, check_names
from omote.stage_data.pose_words import read_pose
from tests.showfile.authored_work import item, revision

OWN_WORK = Stored(
    (
        item(1, kind="face", name="aunt", label="Frau Aunt", head=1),
        item(2, name="grin", label="Crooked grin", head=1),
        item(3, name="gone", label="Gone", head=1, deleted=True),
    ),
    tuple(revision(number) for number in (1, 2, 3)),
)


def names(stored: Stored | None = None) -> CastNames:
    found = read_names(stored)
    assert found is not None
    return found


def words(**typed: str) -> dict[str, str]:
    return {"face": "generic", "expression": "", "channel": "", "turn": "", "gaze": "", "light": "flat", **typed}


def test_they_are_those_of_the_cast() -> None:
    cast = load_cast()
    found = names()
    assert [*found.faces] == [*cast.faces]
    assert {name: tuple(title) for name, title in found.titles.items()} == {
        name: (title.label, title.kind) for name, title in cast.titles.items()
    }
    assert [*found.expressions] == [*cast.expressions]
    assert [*found.hair] == [*cast.hair]


def test_own_work_that_plays_is_found_by_names_and_labels() -> None:
    found = names(OWN_WORK)
    assert found.find_face("frau aunt") == "aunt"
    assert found.kinds["grin"] == OWN
    assert "gone" not in found.titles
    found.check_words(read_pose(**words(face="Aunt=0.5+kaori", expression="crooked GRIN", channel="AU45")))
    assert find_exported(found, OWN_WORK, "Crooked Grin") == "grin"


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        ({"face": "nobody"}, "there is no face 'nobody'"),
        ({"expression": "grin"}, "there is no expression 'grin'"),
        ({"channel": "noon=0.5"}, "there is no channel 'noon'"),
        ({"face": "dog=0.5+Dog=0.5"}, "comes twice"),
    ],
)
def test_what_is_none_is_rejected(typed: dict[str, str], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        names().check_words(read_pose(**words(**typed)))


def test_a_face_is_no_document() -> None:
    with pytest.raises(ValueError, match=r"is a face, .* -o aunt\.omote$"):
        find_exported(names(), OWN_WORK, "Frau Aunt")


@pytest.mark.parametrize("data", [None, b"", CAST.read_bytes()[:100_000]])
def test_a_cast_that_cannot_be_read_has_no_names(tmp_path: Path, data: bytes | None) -> None:
    path = tmp_path / "cast.npz"
    if data is not None:
        path.write_bytes(data)
    assert read_names(path=path) is None


@pytest.mark.parametrize(
    ("request_", "said"),
    [
        (RenderRequest(face=("kaorii=0.5",)), "there is no face 'kaorii'"),
        (RenderRequest(face=("kaori=0.5",), expression=("smil=3",)), "there is no expression 'smil'"),
        (RenderRequest(face=("kaori=0.5",), channel=("jawOpened=9",)), "there is no channel 'jawOpened'"),
        (GridRequest(faces="kaori=0.5,kaorii=0.5"), "weigh 0.5 together"),  # the first picture that cannot be drawn
    ],
)
def test_a_name_that_is_mistyped_is_told_before_the_weight_beside_it(
    request_: RenderRequest | GridRequest, said: str
) -> None:
    with pytest.raises(ValueError, match=said):
        check_names(request_, names())
