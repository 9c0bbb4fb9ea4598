"""Sources mean what plays now, for ever: own names become keys, keys stay, all else is refused."""

import pytest

from omote.edit.protocol import messages as wire
from omote.model.cast import Cast
from omote.model.recipes.recipe import FaceRecipe, Layer, Recipe
from omote.show.validation import Refusal
from tests.authoring import EditHarness, net_of


@pytest.fixture
def harness(cast: Cast) -> EditHarness:
    """With an own expression, an own face, and an expression nothing is saved of."""
    harness = EditHarness(cast)
    harness.greet("ann")
    harness.ask("ann", wire.CreateExpression, "Grin", {"smile": 1.0}, False)
    harness.ask("ann", wire.Save, 1, "")
    harness.ask("ann", wire.CreateFace, "Aunt", {"broad": 0.5, "long": 0.5}, False)
    harness.ask("ann", wire.Save, 2, "")
    harness.ask("ann", wire.CreateExpression, "Sneer", {}, False)
    return harness


def test_names_of_the_cast_stay_and_own_names_become_what_plays(harness: EditHarness) -> None:
    grin, aunt = harness.session.own()
    sources = harness.session.authored.sources
    assert sources.resolve("expression", "smile") == "smile"
    assert sources.resolve("expression", "grin") == grin.source
    assert sources.resolve("expression", grin.source) == grin.source
    assert sources.resolve("face", "aunt") == aunt.source


@pytest.mark.parametrize(
    ("kind", "source", "sentence"),
    [
        ("expression", "#nothing", "'#nothing' names is not there any more"),
        ("expression", "smil", "no expression 'smil' in this cast; near are smile"),
        ("face", "smile", "no face 'smile'"),
        ("face", "grin", "no face 'grin'"),
        ("expression", "sneer", "nothing of 'Sneer' has been saved yet"),
    ],
)
def test_what_plays_nowhere_is_refused(harness: EditHarness, kind: str, source: str, sentence: str) -> None:
    with pytest.raises(Refusal, match=sentence):
        harness.session.authored.sources.resolve(kind, source)  # type: ignore[arg-type]


def test_a_deleted_name_is_refused_but_its_key_stays(harness: EditHarness) -> None:
    source = harness.session.own()[0].source
    harness.ask("ann", wire.Delete, 1)
    with pytest.raises(Refusal, match="no expression 'grin'"):
        harness.session.authored.sources.resolve("expression", "grin")
    assert harness.session.authored.sources.resolve("expression", source) == source


def test_a_whole_recipe_is_resolved(harness: EditHarness) -> None:
    grin, aunt = harness.session.own()
    net = net_of(harness.cast)
    recipe = Recipe(net, ((0.0, 0.0, 1.0),) * len(net), grin.source, (Layer("grin", "Grin"), Layer("smile", "Smile")))
    found = harness.session.authored.sources.resolve_recipe(recipe)
    assert isinstance(found, Recipe)
    assert ([layer.source for layer in found.layers], found.ground) == ([grin.source, "smile"], grin.source)
    face = FaceRecipe({"aunt": 0.5, aunt.source: 0.25, "broad": 0.25}, {"mouth": "aunt"})
    assert harness.session.authored.sources.resolve_recipe(face) == FaceRecipe(
        {aunt.source: 0.75, "broad": 0.25}, {"mouth": aunt.source}
    )
    assert harness.session.authored.sources.contents(FaceRecipe({"broad": 1.0})) == {}
    assert harness.session.authored.sources.contents(harness.session.authored.sources.resolve_recipe(face)).keys() == {
        aunt.content
    }


def test_labels_are_what_people_read(harness: EditHarness) -> None:
    sources = harness.session.authored.sources
    (grin, _) = harness.session.own()
    assert sources.label("expression", "grin") == sources.label("expression", grin.source) == "Grin"
    assert sources.label("expression", "browInnerUp") == "browInnerUp"
    assert sources.label("expression", "#0123456789abcdef") == "#0123456789a"


def test_a_content_that_is_gone_is_refused(harness: EditHarness) -> None:
    with pytest.raises(Refusal, match="content 'gone' is not there any more"):
        harness.session.authored.sources.contents(FaceRecipe({"#gone": 1.0}))
