"""Every message of an editor has an answer, and waits where it must."""

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pytest

from omote.builtin import load_figures
from omote.edit.compute.order_runner import OrderRunner
from omote.edit.protocol import messages as wire
from omote.edit.protocol.orders import Bake
from omote.edit.session import drafts
from omote.edit.session.items import own_things
from omote.edit.session.requests import ANSWERS, queue_key
from omote.model.body.compose_pose import pose_of
from omote.model.body.pose import STAND
from omote.model.body.pose_recipe import PoseRecipe
from omote.model.cast import Cast
from omote.perform.performer import Performer
from omote.perform.snapshot import names_held
from omote.show.objects.link import Cancel
from omote.stage_data.playing_cast import PlayingCast, build_playing_cast
from tests.authoring import EditHarness


def test_every_request_has_an_answer_but_greet_and_cancel() -> None:
    assert ANSWERS.keys() == {*wire.EDITOR_MESSAGES} - {wire.Greet, Cancel}


def test_every_change_of_a_recipe_has_an_order() -> None:
    assert drafts.EDITS.keys() == {kind for kind in wire.EDITOR_MESSAGES if issubclass(kind, wire.RecipeChange)}


def test_what_changes_a_draft_waits_for_it_and_nothing_else_does() -> None:
    assert queue_key(wire.Undo(1, 5), "ann") == queue_key(wire.Save(1, 5, ""), "ann") == (5, "ann")
    assert queue_key(wire.Undo(1, 5), "bob") == (5, "bob")
    assert queue_key(wire.CreateFace(1, "Aunt", {}, True), "ann") == (0, "ann")
    for message in (wire.Delete(1, 5), wire.Restore(1, 5), wire.AskHistory(1, 5), wire.Duplicate(1, 5, "Copy")):
        assert queue_key(message, "ann") is None


def test_there_must_be_an_item_and_a_draft(cast: Cast) -> None:
    harness = EditHarness(cast)
    harness.greet("ann")
    assert harness.ask("ann", wire.OpenItem, 1).reason == "there is no item 1: choose one from the list."
    harness.ask("ann", wire.CreateExpression, "Grin", {}, False)
    harness.greet("bob")
    for request, arguments in ((wire.Undo, ()), (wire.Save, ("",)), (wire.BringBack, (1,)), (wire.Flatten, ())):
        assert harness.ask("bob", request, 1, *arguments).reason == "'Grin' is not open here: open it first."


def test_new_things_begin_from_what_was_said(cast: Cast) -> None:
    harness = EditHarness(cast)
    harness.greet("ann")
    state = harness.ask("ann", wire.CreateExpression, "Grin", {"smile": 0.5, "jawOpen": -0.5, "neutral": 1.0}, False)
    assert [(layer.source, layer.weight) for layer in state.recipe.layers] == [("smile", 0.5), ("jawOpen", -0.5)]
    state = harness.ask("ann", wire.CreateFace, "Aunt", {}, True)
    assert state.recipe.base == {"generic": 1.0}
    assert (state.undo, state.redo, state.dirty, state.base, state.what) == (0, 0, True, 0, "new")


@pytest.mark.parametrize(
    ("request_type", "arguments", "sentence"),
    [
        (wire.CreateExpression, ("\n", {}, False), "the label"),
        (wire.CreateExpression, ("Grin", {"smile": float("nan")}, False), "a weight"),
        (wire.CreateExpression, ("Grin", {"nothing": 1.0}, False), "no expression 'nothing'"),
        (wire.CreateFace, ("Aunt", {}, False), "from no face"),
        (wire.CreateFace, ("Aunt", {"broad": 0.5}, False), "a mix of faces sums to 1"),
        (wire.CreateFace, ("Aunt", {"smile": 1.0}, False), "no face 'smile'"),
    ],
)
def test_new_things_that_cannot_be_are_refused(
    cast: Cast, request_type: type, arguments: tuple[object, ...], sentence: str
) -> None:
    harness = EditHarness(cast)
    harness.greet("ann")
    assert sentence in harness.ask("ann", request_type, *arguments).reason
    assert harness.tables.stored().items == ()


def played(harness: EditHarness) -> PlayingCast:
    """The cast with what the show file holds now."""
    contents: Mapping[str, bytes] = harness.tables.contents
    return build_playing_cast(harness.cast, own_things(harness.session.authored.state), contents)


def with_figures(cast: Cast) -> EditHarness:
    """An editor of a cast that has bodies and poses, with one who has said hello."""
    full = replace(cast, figures=load_figures())
    harness = EditHarness(full)
    harness.make_baked = OrderRunner(full).run
    harness.greet("ann")
    return harness


def test_an_own_pose_is_made_changed_undone_saved_and_plays(cast: Cast) -> None:
    harness = with_figures(cast)
    draft = harness.ask("ann", wire.CreatePose, "Pointing", STAND)
    assert draft.recipe == PoseRecipe()
    pointing = PoseRecipe(trunk=(10.0, 0.0, 0.0), hips=(0.0, -0.1, 0.0))
    changed = harness.ask("ann", wire.SetPose, draft.item, pointing, "trunk")
    assert (changed.recipe, changed.undo, changed.dirty) == (pointing, 1, True)
    assert harness.ask("ann", wire.Undo, draft.item).recipe == PoseRecipe()
    assert harness.ask("ann", wire.Redo, draft.item).recipe == pointing
    assert "pointing" not in played(harness).poses
    harness.ask("ann", wire.Save, draft.item, "")
    playing = played(harness)
    own = playing.poses["pointing"]
    wanted = pose_of(pointing, load_figures().space.skeleton, "pointing", "Pointing")
    np.testing.assert_array_equal(own.turns, wanted.turns)
    assert own.label == "Pointing"
    performer = Performer(playing)
    performer.call_pose("pointing", seconds=1.0)
    figure = performer.advance(1.0).figure
    assert figure is not None
    assert figure.poses == {"pointing": 1.0}
    held = names_held(performer.snapshot())
    assert held.poses == {"pointing"}
    again = harness.ask("ann", wire.CreatePose, "Pointing more", harness.tables.items[draft.item].name)
    assert again.recipe == pointing


def test_a_pose_that_no_joint_can_do_is_refused(cast: Cast) -> None:
    harness = with_figures(cast)
    draft = harness.ask("ann", wire.CreatePose, "Bad", STAND)
    nowhere = PoseRecipe(hips=(math.nan, 0.0, 0.0))
    with pytest.raises(ValueError, match="travel of pose"):
        OrderRunner(harness.cast).run(Bake(nowhere, {}))
    assert isinstance(harness.ask("ann", wire.SetPulls, draft.item, []), wire.EditRefused)
