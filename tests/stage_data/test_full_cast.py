"""A show file's own faces and expressions beside the built-in ones."""

from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from msgspec import structs

from omote.edit.protocol.wire import write_recipe
from omote.edit.store.import_items import ImportedItem, changes_to_import
from omote.model.albedo import SIDES, Albedo
from omote.model.cast import Cast, Look
from omote.model.recipes.recipe import KEY, FaceRecipe
from omote.model.space.face import Face
from omote.showfile.changes import Content, Item, Revision, Stored, content_key
from omote.showfile.contents import pack_face
from omote.showfile.schema import ShowFileError
from omote.showfile.show_file import open_show
from omote.stage_data.full_cast import build_full_cast, find_face, free_faces, playing_items, read_show
from tests import synthetic


def kept(cast: Cast) -> tuple[Stored, dict[str, bytes]]:
    """A face and an expression as a show file keeps them."""
    face = Face("long", cast.faces["long"].positions)
    arrivals = [ImportedItem("Grin", cast.expressions["smile"]), ImportedItem("Aunt", (face, Look(iris="#00ff00")))]
    changes = changes_to_import(cast, Stored(), arrivals, wall=0.0)
    items = tuple(change for change in changes if isinstance(change, Item))
    revisions = tuple(change for change in changes if isinstance(change, Revision))
    return Stored(items, revisions), {change.key: change.data for change in changes if isinstance(change, Content)}


def test_what_plays_is_in_the_cast_under_its_name() -> None:
    base = synthetic.cast()
    cast = build_full_cast(base, *kept(base), pytest.fail)
    assert cast.expressions.keys() - base.expressions.keys() == {"grin"}
    assert cast.titles["grin"].label == "Grin"
    np.testing.assert_array_equal(cast.expressions["grin"].dh, base.expressions["smile"].dh)
    assert cast.faces.keys() - base.faces.keys() == {"aunt"}
    assert cast.looks["aunt"].iris == "#00ff00"


def test_a_show_file_is_read_from_python(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    base = synthetic.cast()
    path = tmp_path / "evening show ü.omote"
    monkeypatch.setattr("omote.stage_data.full_cast.load_cast", lambda: base)
    with closing(open_show(path)) as show:
        arrivals = [ImportedItem("Grin", base.expressions["smile"])]
        show.apply(changes_to_import(base, Stored(), arrivals, wall=0.0))
    before = path.read_bytes()
    for named in (path, str(path), path.with_suffix("")):
        np.testing.assert_array_equal(read_show(named).expressions["grin"].dh, base.expressions["smile"].dh)
    assert path.read_bytes() == before
    assert [each.name for each in tmp_path.iterdir()] == [path.name], "nothing is left beside it"


def test_what_is_no_show_is_refused_and_what_is_of_another_head_left_out(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    small = synthetic.cast()
    with pytest.raises(ShowFileError, match="there is no show file"):
        read_show(tmp_path / "none.omote")
    (tmp_path / "notes.txt").write_text("hello")
    with pytest.raises(ShowFileError, match=r"notes\.txt is"):
        read_show(tmp_path / "notes.txt")
    with pytest.raises(TypeError, match="a show file is named by its path, not by 7"):
        read_show(7)  # type: ignore[arg-type]
    larger = small.expressions["smile"]
    short = replace(larger, dtheta=larger.dtheta[1:], dh=larger.dh[1:], ratio=larger.ratio[1:])
    monkeypatch.setattr("omote.stage_data.full_cast.load_cast", lambda: small)
    with closing(open_show(tmp_path / "a.omote")) as show:
        arrivals = [ImportedItem("Grin", short), ImportedItem("Glad", larger)]
        show.apply(changes_to_import(small, Stored(), arrivals, wall=0.0))
    with pytest.warns(UserWarning, match=r"the own expression grin cannot be played on the built-in head \(.* has"):
        read = read_show(tmp_path / "a.omote")
    assert read.expressions.keys() - small.expressions.keys() == {"glad"}, "the rest of the file can be used"


def test_own_faces_are_found_by_their_labels() -> None:
    stored, contents = kept(synthetic.cast())
    renamed = Stored(
        tuple(structs.replace(item, label=f"Frau {item.label}") for item in stored.items), stored.revisions
    )
    cast = build_full_cast(synthetic.cast(), renamed, contents, pytest.fail)
    assert find_face(cast, renamed, "frau aunt") == find_face(cast, renamed, "AUNT") == "aunt"
    assert find_face(cast, None, "Long") == "long"
    with pytest.raises(ValueError, match="there is no face 'Frau Grin' in this cast; near are"):
        find_face(cast, renamed, "Frau Grin")


def test_a_face_of_another_head_is_left_out_and_named() -> None:
    small = synthetic.cast()
    cut = Face("cut", small.faces["long"].positions[1:])
    whole = Face("long", small.faces["long"].positions)
    arrivals = [ImportedItem("Cut", (cut, Look())), ImportedItem("Aunt", (whole, Look()))]
    changes = changes_to_import(small, Stored(), arrivals, wall=0.0)
    stored = Stored(
        tuple(change for change in changes if isinstance(change, Item)),
        tuple(change for change in changes if isinstance(change, Revision)),
    )
    contents = {change.key: change.data for change in changes if isinstance(change, Content)}
    told: list[str] = []
    cast = build_full_cast(small, stored, contents, told.append)
    assert (cast.faces.keys() - small.faces.keys(), cast.looks.keys() - small.looks.keys()) == ({"aunt"}, {"aunt"})
    (sentence,) = told
    assert sentence.startswith("the own face cut cannot be played on the built-in head (")
    assert "it is left out." in sentence
    assert "delete it" in sentence


def test_what_is_deleted_or_never_saved_does_not_play() -> None:
    stored, contents = kept(synthetic.cast())
    grin, aunt = stored.items
    gone = Item(grin.id, grin.kind, grin.name, grin.label, head=1, deleted=True)
    unsaved = Item(aunt.id, aunt.kind, aunt.name, aunt.label)
    changed = Stored((gone, unsaved), stored.revisions)
    assert playing_items(changed) == []
    assert (
        build_full_cast(synthetic.cast(), changed, contents, pytest.fail).faces.keys() == synthetic.cast().faces.keys()
    )


def test_a_face_is_free_that_is_made_of_free_faces_alone() -> None:
    base = synthetic.cast()
    first, second = list(base.faces)[:2]
    painted = Look(albedo=Albedo(np.zeros((SIDES[0], SIDES[0], 4), np.uint8)))
    looks = [Look(iris=f"#00000{number}") for number in range(6)]
    contents = [pack_face(base.faces[first], look) for look in (*looks, painted)]
    keys = [content_key(content) for content in contents]
    mix = FaceRecipe({first: 0.5, second: 0.5}, regions={"nose": second}, amount=1.3)
    recipes = {
        "mix": mix,
        "of_mix": FaceRecipe({KEY + keys[0]: 1.0}),
        "scan": FaceRecipe({KEY + keys[2]: 1.0}),
        "of_scan": FaceRecipe({first: 0.5, KEY + keys[2]: 0.5}),
        "regional": FaceRecipe({first: 1.0}, regions={"nose": KEY + keys[2]}),
        "moved": structs.replace(mix, points=(1,), moves=((0.0, 0.0, 0.01),)),
        "painted": mix,
    }
    items = tuple(Item(place, "face", name, name, head=1) for place, name in enumerate(recipes, start=1))
    revisions = tuple(
        Revision(place, 1, 0, write_recipe(recipe), keys[place - 1], 0.0, "Ada")
        for place, recipe in enumerate(recipes.values(), start=1)
    )
    free = free_faces(Stored(items, revisions), dict(zip(keys, contents, strict=True)))
    assert free == {"mix", "of_mix"}
