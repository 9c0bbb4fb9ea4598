"""Drafts: every request a step, undo and redo without end, and the draft found again after everything."""

import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.edit.protocol import messages as wire
from omote.edit.protocol.orders import Solve
from omote.edit.protocol.wire import read_recipe
from omote.edit.session.drafts import EDITS
from omote.model.cast import Cast
from omote.model.recipes.recipe import KEY, FaceRecipe, Layer, Pull, Recipe
from omote.show.declaration import Message
from tests import synthetic
from tests.authoring import POINTS, EditHarness, net_document, net_of

REST = (0.0, 0.0, 1.0)
PULLED = [Pull("smiler", 0.5)]


@pytest.fixture
def harness(cast: Cast) -> EditHarness:
    """Ann at a new expression, item 1."""
    harness = EditHarness(cast)
    harness.greet("ann")
    harness.ask("ann", wire.CreateExpression, "Grin", {}, False)
    return harness


def vectors(*, dtheta: float = 0.1) -> list[tuple[float, float, float]]:
    """One vector that moves, the rest at rest."""
    return [(dtheta, 0.0, 1.0), *[REST] * (POINTS - 1)]


def test_a_drag_is_solved_from_where_the_page_puts_it(harness: EditHarness) -> None:
    state = harness.ask("ann", wire.DragPoints, 1, "broad", [1], [(0.2, 0.01, 0.05)], vectors())
    order = harness.ordered[-1]
    assert isinstance(order, Solve)
    assert (order.face, order.points, order.targets) == ("broad", (1,), ((0.2, 0.01, 0.05),))
    assert order.vectors == tuple(vectors())
    assert state.recipe.vectors[1] == (0.2, 0.01, 1.0), "what the solve found"
    assert state.miss > 0.0
    assert (state.undo, state.redo, state.dirty, state.what) == (1, 0, True, "drag of a point")


def test_every_kind_of_edit_is_a_step(harness: EditHarness) -> None:
    net = net_of(harness.cast, POINTS + 1)
    steps: list[tuple[Any, ...]] = [
        (wire.SetVectors, vectors(), "nudge"),
        (wire.SetLayers, [Layer("smile", "Smile", 0.5, "mouth", True)]),
        (wire.SetPulls, PULLED),
        (wire.SetEyes, (0.1, 0.0, 0.1, 0.0), -0.5),
        (wire.SetComplexion, (0.5, 0.0, 0.0, 0.25, -0.1, 1.0, 0.5)),
        (wire.SetNet, list(net)),
        (wire.Flatten,),
    ]
    for number, (request, *arguments) in enumerate(steps, 1):
        state = harness.ask("ann", request, 1, *arguments)
        assert (state.undo, state.redo) == (number, 0)
    assert isinstance(state.recipe, Recipe)
    assert state.recipe.net == net
    assert state.recipe.ground is not None
    assert state.recipe.ground.removeprefix(KEY) in harness.tables.contents, "a recipe's ground is kept with it"
    assert (state.recipe.layers, state.recipe.pulls) == ((), ())


def test_a_preview_of_layers_is_what_they_would_make_and_no_step(harness: EditHarness) -> None:
    before = harness.ask("ann", wire.SetVectors, 1, vectors(), "nudge")
    kept = harness.tables.stored()
    layers = [Layer("smile", "Smile", 0.5)]
    preview = harness.ask("ann", wire.PreviewLayers, 1, layers, False)
    assert isinstance(preview, wire.Previewed)
    assert preview.content.removeprefix(KEY) in harness.session.contents
    assert harness.tables.stored() == kept
    assert harness.ask("ann", wire.OpenItem, 1).content == before.content
    assert harness.ask("ann", wire.SetLayers, 1, layers).content == preview.content


def test_layers_alone_are_previewed_without_all_else_of_the_draft(harness: EditHarness) -> None:
    layers = [Layer("smile", "Smile", 0.5)]
    bare = harness.ask("ann", wire.SetLayers, 1, layers).content
    harness.ask("ann", wire.SetVectors, 1, vectors(), "nudge")
    harness.ask("ann", wire.SetPulls, 1, PULLED)
    harness.ask("ann", wire.SetEyes, 1, (0.1, 0.0, 0.1, 0.0), -0.5)
    harness.ask("ann", wire.SetComplexion, 1, (0.0, 0.0, 0.0, 0.0, 0.0, 1.0))
    assert harness.ask("ann", wire.PreviewLayers, 1, layers, True).content == bare
    assert harness.ask("ann", wire.PreviewLayers, 1, layers, False).content != bare


def test_a_preview_that_cannot_be_is_refused(harness: EditHarness) -> None:
    heavy = harness.ask("ann", wire.PreviewLayers, 1, [Layer("smile", "Smile", 99.0)], False)
    assert isinstance(heavy, wire.EditRefused)
    harness.ask("ann", wire.CreateFace, "Face", {"broad": 1.0}, False)
    face = harness.ask("ann", wire.PreviewLayers, 2, [], False)
    assert isinstance(face, wire.EditRefused)
    assert "only expressions have layers" in face.reason


def test_the_history_says_what_was_done(harness: EditHarness) -> None:
    assert harness.ask("ann", wire.SetVectors, 1, vectors(), " mirrored ").what == "mirrored"
    assert harness.ask("ann", wire.SetNet, 1, list(net_of(harness.cast, POINTS - 1))).what == "1 control points removed"
    assert harness.ask("ann", wire.Undo, 1).what == "mirrored"


def test_what_changes_nothing_is_no_step(harness: EditHarness) -> None:
    first = harness.ask("ann", wire.SetPulls, 1, PULLED)
    before = harness.tables.stored()
    again = harness.ask("ann", wire.SetPulls, 1, PULLED)
    assert again.undo == first.undo == 1
    same = harness.ask("ann", wire.SetNet, 1, list(net_of(harness.cast)))
    assert (same.undo, harness.tables.stored()) == (1, before)


@given(st.lists(st.floats(-1.0, 2.0), min_size=1, max_size=12, unique=True), st.data())
def test_undo_and_redo_lead_to_the_same_places(pulls: list[float], data: st.DataObject) -> None:
    harness = EditHarness(synthetic.cast())
    harness.greet("ann")
    states = [harness.ask("ann", wire.CreateExpression, "Grin", {}, False)]
    states += [harness.ask("ann", wire.SetPulls, 1, [Pull("smiler", pull)]) for pull in pulls]
    at = len(pulls)
    for step in data.draw(st.lists(st.sampled_from([-1, 1]), max_size=30)):
        answer = harness.ask("ann", wire.Undo if step < 0 else wire.Redo, 1)
        if 0 <= at + step <= len(pulls):
            at += step
            seen = answer
            wanted = states[at]
            assert (seen.recipe, seen.content, seen.what) == (wanted.recipe, wanted.content, wanted.what)
            assert (seen.undo, seen.redo) == (at, len(pulls) - at)
        else:
            assert isinstance(answer, wire.EditRefused)


def test_a_new_step_drops_what_was_undone(harness: EditHarness) -> None:
    for pull in (0.1, 0.2, 0.3):
        harness.ask("ann", wire.SetPulls, 1, [Pull("smiler", pull)])
    harness.ask("ann", wire.Undo, 1)
    harness.ask("ann", wire.Undo, 1)
    state = harness.ask("ann", wire.SetPulls, 1, [Pull("smiler", 0.9)])
    assert (state.undo, state.redo) == (2, 0)
    assert harness.ask("ann", wire.Undo, 1).recipe.pulls == (Pull("smiler", 0.1),)
    assert harness.ask("ann", wire.Redo, 1).recipe.pulls == (Pull("smiler", 0.9),)


def test_the_net_goes_with_the_first_state_and_whenever_it_changes(harness: EditHarness) -> None:
    net = net_of(harness.cast)
    other = net_of(harness.cast, POINTS + 1)
    assert harness.ask("ann", wire.OpenItem, 1).net == net_document(net)
    assert harness.ask("ann", wire.SetPulls, 1, PULLED).net is None
    assert harness.ask("ann", wire.SetNet, 1, list(other)).net == net_document(other)
    assert harness.ask("ann", wire.SetPulls, 1, []).net is None
    harness.ask("ann", wire.Undo, 1)
    harness.start()
    harness.greet("ann")
    assert harness.ask("ann", wire.OpenItem, 1).net == net_document(other)
    assert harness.ask("ann", wire.Undo, 1).net == net_document(net), "across the change, after a restart"


def test_a_restart_finds_the_draft_the_cursor_and_all_steps(harness: EditHarness) -> None:
    for pull in (0.1, 0.2, 0.3):
        harness.ask("ann", wire.SetPulls, 1, [Pull("smiler", pull)])
    before = harness.ask("ann", wire.Undo, 1)
    harness.start()
    harness.greet("page 2", editor="ann")
    after = harness.ask("page 2", wire.OpenItem, 1)
    assert (after.recipe, after.content, after.undo, after.redo) == (before.recipe, before.content, 2, 1)
    assert harness.ask("page 2", wire.Redo, 1).recipe.pulls == (Pull("smiler", 0.3),)


def test_another_editor_begins_where_the_unsaved_draft_is(harness: EditHarness) -> None:
    harness.ask("ann", wire.SetPulls, 1, PULLED)
    harness.greet("bob")
    state = harness.ask("bob", wire.OpenItem, 1)
    assert (list(state.recipe.pulls), state.undo, state.others) == (PULLED, 0, ["Ann"])
    harness.ask("bob", wire.SetPulls, 1, [])
    assert list(harness.ask("ann", wire.OpenItem, 1).recipe.pulls) == PULLED, "each has a draft of their own"


def test_an_untouched_draft_is_brought_up_to_what_plays_and_can_go_back(harness: EditHarness) -> None:
    harness.ask("ann", wire.Save, 1, "")
    harness.greet("bob")
    harness.ask("bob", wire.OpenItem, 1)
    harness.ask("bob", wire.SetPulls, 1, PULLED)
    harness.ask("bob", wire.Save, 1, "")
    state = harness.ask("ann", wire.OpenItem, 1)
    assert (state.base, state.dirty, state.undo, list(state.recipe.pulls)) == (2, False, 1, PULLED)
    assert state.what == "revision 2 of Bob"
    assert harness.ask("ann", wire.Undo, 1).recipe.pulls == ()


def test_a_draft_with_work_in_it_is_left_as_it_is(harness: EditHarness) -> None:
    harness.ask("ann", wire.Save, 1, "")
    harness.ask("ann", wire.SetEyes, 1, (0.1, 0.0, 0.1, 0.0), 0.0)
    harness.greet("bob")
    harness.ask("bob", wire.OpenItem, 1)
    harness.ask("bob", wire.SetPulls, 1, PULLED)
    harness.ask("bob", wire.Save, 1, "")
    state = harness.ask("ann", wire.OpenItem, 1)
    assert (state.base, state.dirty, state.recipe.pulls) == (1, True, ())


def test_faces_are_edited_whole(harness: EditHarness) -> None:
    state = harness.ask("ann", wire.CreateFace, "Aunt", {"generic": 0.5, "broad": 0.5}, False)
    assert state.net is None
    recipe = FaceRecipe({"long": 1.0}, {"mouth": "broad"}, 1.5, (3,), ((0.0, 0.01, 0.0),))
    state = harness.ask("ann", wire.SetFace, 2, recipe, "mouth of another")
    assert (state.recipe, state.undo, state.what) == (recipe, 1, "mouth of another")
    assert harness.ask("ann", wire.Undo, 2).recipe == FaceRecipe({"generic": 0.5, "broad": 0.5})


def test_own_layers_are_kept_as_they_played_when_they_were_laid(harness: EditHarness) -> None:
    harness.ask("ann", wire.SetPulls, 1, PULLED)
    harness.ask("ann", wire.Save, 1, "")
    (before,) = harness.session.own()
    harness.ask("ann", wire.CreateExpression, "Wide grin", {"grin": 1.0}, False)
    harness.ask("ann", wire.SetPulls, 1, [])
    harness.ask("ann", wire.Save, 1, "")
    state = harness.ask("ann", wire.OpenItem, 2)
    assert state.recipe.layers == (Layer(before.source, "Grin", 1.0),)


def bad_requests(net: tuple[int, ...]) -> list[tuple[str, type[Message], tuple[Any, ...]]]:
    """Requests on item 1 that must be refused, and a word of the sentence."""
    good = vectors()
    return [
        ("no point was dragged", wire.DragPoints, ("broad", [], [], good)),
        ("2 targets for 1 points", wire.DragPoints, ("broad", [0], [REST, REST], good)),
        ("points are 0 to 4", wire.DragPoints, ("broad", [5], [REST], good)),
        ("points are 0 to 4", wire.DragPoints, ("broad", [-1], [REST], good)),
        ("at most once", wire.DragPoints, ("broad", [1, 1], [REST, REST], good)),
        ("where a point is put", wire.DragPoints, ("broad", [1], [(math.nan, 0.0, 0.0)], good)),
        ("no face 'nobody'", wire.DragPoints, ("nobody", [1], [REST], good)),
        ("1 vectors for 5", wire.DragPoints, ("broad", [1], [REST], [REST])),
        ("dtheta", wire.SetVectors, (vectors(dtheta=math.inf), "")),
        ("printable", wire.SetVectors, (good, "a\nb")),
        ("two control points", wire.SetNet, ([*net, net[0]],)),
        ("no expression 'nothing'", wire.SetLayers, ([Layer("nothing", "?")],)),
        ("not there any more", wire.SetLayers, ([Layer("#nothing", "?")],)),
        ("no muscle", wire.SetPulls, ([Pull("biter", 1.0)],)),
        ("eyeball", wire.SetEyes, ((math.nan, 0.0, 0.0, 0.0), 0.0)),
        ("complexion", wire.SetComplexion, ((0.0, 0.0, 2.5, 0.0, 0.0, 0.0, 0.0),)),
        ("for a face", wire.SetFace, (FaceRecipe({"generic": 1.0}), "")),
        ("nothing was undone", wire.Redo, ()),
        ("no revision 7", wire.BringBack, (7,)),
    ]


@pytest.mark.parametrize("number", range(len(bad_requests((0, 1, 2)))))
def test_what_cannot_be_is_refused_and_changes_nothing(harness: EditHarness, number: int) -> None:
    sentence, request, arguments = bad_requests(net_of(harness.cast))[number]
    before = harness.tables.stored(), harness.session.stored(), dict(harness.tables.contents)
    answer = harness.ask("ann", request, 1, *arguments)
    assert isinstance(answer, wire.EditRefused)
    assert sentence in answer.reason
    assert answer.reason.endswith(".")
    assert (harness.tables.stored(), harness.session.stored(), harness.tables.contents) == before


def test_the_beginning_cannot_be_undone_and_faces_take_no_vectors(harness: EditHarness) -> None:
    assert "this is how the draft began" in harness.ask("ann", wire.Undo, 1).reason
    harness.ask("ann", wire.CreateFace, "Aunt", {"broad": 1.0}, False)
    assert "item 2 is a face" in harness.ask("ann", wire.SetVectors, 2, vectors(), "").reason


def test_a_solve_that_ends_out_of_range_is_refused(harness: EditHarness) -> None:
    answer = harness.ask("ann", wire.DragPoints, 1, "broad", [1], [(0.0, 0.9, 0.0)], vectors())
    assert isinstance(answer, wire.EditRefused)
    assert "dh of a control point" in answer.reason
    assert len(harness.tables.edits) == 1


def test_all_steps_in_the_file_can_be_read(harness: EditHarness) -> None:
    harness.ask("ann", wire.SetPulls, 1, PULLED)
    assert all(isinstance(read_recipe(edit.recipe), Recipe) for edit in harness.tables.edits.values())
    assert len(EDITS) == 10
