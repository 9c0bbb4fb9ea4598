"""A show file's own faces and expressions beside the built-in ones."""

import numpy as np

from omote.edit.store.import_items import ImportedItem, changes_to_import
from omote.model.cast import Cast, Look
from omote.model.space.face import Face
from omote.showfile.changes import Item, PutContent, PutItem, PutRevision, Stored
from omote.stage_data.full_cast import build_full_cast, playing_items
from tests import synthetic


def kept(cast: Cast) -> tuple[Stored, dict[str, bytes]]:
    """A face and an expression as a show file keeps them."""
    face = Face("long", cast.faces["long"].positions)
    arrivals = [ImportedItem("Grin", cast.expressions["smile"]), ImportedItem("Aunt", (face, Look(iris="#00ff00")))]
    changes = changes_to_import(cast, Stored(), arrivals, wall=0.0)
    items = tuple(change.item for change in changes if isinstance(change, PutItem))
    revisions = tuple(change.revision for change in changes if isinstance(change, PutRevision))
    return Stored(items, revisions), {change.key: change.data for change in changes if isinstance(change, PutContent)}


def test_what_plays_is_in_the_cast_under_its_name() -> None:
    base = synthetic.cast()
    cast = build_full_cast(base, *kept(base))
    assert cast.expressions.keys() - base.expressions.keys() == {"grin"}
    assert cast.titles["grin"].label == "Grin"
    np.testing.assert_array_equal(cast.expressions["grin"].dh, base.expressions["smile"].dh)
    assert cast.faces.keys() - base.faces.keys() == {"aunt"}
    assert cast.looks["aunt"].iris == "#00ff00"


def test_what_is_deleted_or_never_saved_does_not_play() -> None:
    stored, contents = kept(synthetic.cast())
    grin, aunt = stored.items
    gone = Item(grin.id, grin.kind, grin.name, grin.label, head=1, deleted=True)
    unsaved = Item(aunt.id, aunt.kind, aunt.name, aunt.label)
    changed = Stored((gone, unsaved), stored.revisions)
    assert playing_items(changed) == []
    assert build_full_cast(synthetic.cast(), changed, contents).faces.keys() == synthetic.cast().faces.keys()
