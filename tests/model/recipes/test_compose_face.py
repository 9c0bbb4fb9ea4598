"""A face's recipe: the mix, regions, caricature and handles one after the other, its look, and what is refused."""

from __future__ import annotations

from dataclasses import replace

import msgspec
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omote.builtin import load_cast
from omote.model.albedo import Albedo
from omote.model.cast import Look
from omote.model.recipes.compose_face import FaceWithLook, compose_face, mix_faces, mix_looks
from omote.model.recipes.face_handles import default_handles, drag_handles
from omote.model.recipes.recipe import FaceRecipe, GainRow
from omote.model.sculpting.caricature import MOST_AMOUNT, caricature, find_folds
from omote.model.sculpting.regions import regional
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.gain import Gain
from omote.model.space.head_regions import REGIONS
from omote.perform.blending.evaluate import evaluate
from omote.perform.performer import Performer

CAST = load_cast()
SPACE = CAST.space
SOURCES = {name: FaceWithLook(face, CAST.looks[name]) for name, face in CAST.faces.items()}
ROWS = tuple(handle.row for handle in default_handles(SPACE))
names = st.sampled_from(sorted(SOURCES))


def made(recipe: FaceRecipe) -> FaceWithLook:
    return compose_face(SPACE, "hers", recipe, SOURCES)


def same(one: Face, other: Face) -> bool:
    first = fit(SPACE, one)
    second = fit(SPACE, other)
    return np.array_equal(first.positions, second.positions) and all(
        np.array_equal(first.parts[part], second.parts[part]) for part in SPACE.parts
    )


@pytest.mark.parametrize("name", SOURCES)
def test_one_face_alone_is_that_face_with_its_look(name: str) -> None:
    found = made(FaceRecipe({name: 1.0}, regions=dict.fromkeys(("nose",), name)))
    assert made(FaceRecipe({name: 1.0})).look == found.look == SOURCES[name].look
    assert same(made(FaceRecipe({name: 1.0})).face, SOURCES[name].face)
    assert np.allclose(found.face.positions, SOURCES[name].face.positions, atol=1e-6)
    assert found.face.name == "hers"


def test_a_mix_is_what_is_on_air_between_its_faces() -> None:
    performer = Performer(CAST)
    performer.call_face("kaori", seconds=0)
    performer.advance(0.1)
    performer.call_face("dog", seconds=1.0)
    frame = performer.advance(0.5)
    assert len(frame.faces) == 2
    found = made(FaceRecipe(dict(frame.faces))).face
    assert np.allclose(found.positions, evaluate(CAST, frame), atol=1e-6)


@given(one=names, other=names, share=st.floats(0.0, 1.0))
@settings(max_examples=20)
def test_a_mix_is_linear_in_its_shares(one: str, other: str, share: float) -> None:
    pair = [(SOURCES[one].face, share), (SOURCES[other].face, 1.0 - share)]
    between = mix_faces(SPACE, "a", pair)
    for part in SPACE.parts:
        first, second = (fit(SPACE, face).parts[part].astype(float) for face, _ in pair)
        assert np.allclose(between.parts[part], share * first + (1.0 - share) * second, atol=1e-6)
    assert np.allclose(
        between.positions, share * pair[0][0].positions + (1.0 - share) * pair[1][0].positions, atol=1e-6
    )


def test_base_regions_caricature_and_handles_follow_one_another() -> None:
    moves = np.zeros((len(ROWS), 3))
    moves[0] = 0.004
    recipe = FaceRecipe(
        {"kaori": 0.5, "old": 0.5},
        {"mouth": "dog", "brows": "cat"},
        1.2,
        ROWS,
        tuple((x, y, z) for x, y, z in moves.tolist()),
    )
    face = mix_faces(SPACE, "a", [(SOURCES["kaori"].face, 0.5), (SOURCES["old"].face, 0.5)])
    face = regional(SPACE, "a", {"mouth": SOURCES["dog"].face, "brows": SOURCES["cat"].face}, rest=face)
    face = drag_handles(SPACE, caricature(SPACE, face, 1.2), "a", rows=ROWS, moves=moves)
    assert same(made(recipe).face, face)


def test_the_look_of_a_region_comes_with_it_and_nothing_else_does() -> None:
    plain = made(FaceRecipe({"kaori": 1.0})).look
    mouth = made(FaceRecipe({"kaori": 1.0}, {"mouth": "dog"})).look
    dog = SOURCES["dog"].look
    assert mouth == replace(plain, lip=dog.lip, gloss=dog.gloss)
    assert made(FaceRecipe({"kaori": 1.0}, {"skull": "man"})).look.hair_style == SOURCES["man"].look.hair_style
    everything = made(FaceRecipe({"kaori": 1.0}, dict.fromkeys(REGIONS, "dog"))).look
    assert (everything.iris, everything.brow, everything.fur) == (dog.iris, dog.brow, plain.fur)


def test_colours_mix_in_linear_light_and_traits_as_numbers() -> None:
    black = Look(skin="#000000", age=0.0)
    white = Look(skin="#ffffff", age=1.0)
    grey = mix_looks([(black, 0.5), (white, 0.5)])
    assert (grey.skin, grey.age) == ("#bcbcbc", 0.5)  # half the light is 188 of 255 in sRGB
    assert mix_looks([(SOURCES["dog"].look, 1.0)]) == SOURCES["dog"].look


@given(looks=st.lists(st.sampled_from([one.look for one in SOURCES.values()]), min_size=1, max_size=5))
@settings(max_examples=30)
def test_a_mix_of_looks_is_a_look_between_them(looks: list[Look]) -> None:
    found = mix_looks([(look, 1.0 / len(looks)) for look in looks])
    for trait in ("age", "iris_size", "fur"):
        worn = [getattr(look, trait) for look in looks]
        assert min(worn) - 1e-9 <= getattr(found, trait) <= max(worn) + 1e-9
    reds = [int(look.skin[1:3], 16) for look in looks]
    assert min(reds) - 1 <= int(found.skin[1:3], 16) <= max(reds) + 1


def test_hair_is_one_style_whole_on_its_own_scalp() -> None:
    bald = Look(hair_style="", scalp=0.0, hair="#ff0000")
    bun = Look(hair_style="bun", scalp=1.0, hair="#202020")
    thin = Look(hair_style="thin", scalp=0.25, hair="#202020")
    for looks, style, scalp in [
        ([(bald, 0.6), (bun, 0.4)], "", 0.0),
        ([(bald, 0.4), (bun, 0.6)], "bun", 1.0),
        ([(thin, 0.6), (bun, 0.4)], "thin", 0.25),
        ([(bald, 0.4), (bun, 0.35), (thin, 0.25)], "bun", 1.0),
        ([(bald, 0.5), (thin, 0.5), (bun, 0.0)], "thin", 0.25),
    ]:
        found = mix_looks(looks)
        assert (found.hair_style, found.scalp, found.hair) == (style, scalp, "#202020")


def test_hair_is_that_of_the_largest_share_all_wearers_together() -> None:
    bald = Look(hair_style="")
    bun = Look(hair_style="bun")
    bob = Look(hair_style="bob")
    assert mix_looks([(bald, 0.4), (bun, 0.35), (bob, 0.25)]).hair_style == "bun"
    assert mix_looks([(bald, 0.6), (bun, 0.2), (bob, 0.2)]).hair_style == ""
    assert mix_looks([(bald, 0.4), (bun, 0.3), (replace(bun, age=1.0), 0.3)]).hair_style == "bun"


@given(
    base=st.lists(names, min_size=1, max_size=3, unique=True),
    regions=st.dictionaries(st.sampled_from(REGIONS), names, max_size=2),
    amount=st.sampled_from([1.0, 0.5, 1.3]),
)
@settings(max_examples=12)
def test_mixes_regions_and_some_caricature_fold_next_to_nothing(
    base: list[str], regions: dict[str, str], amount: float
) -> None:
    recipe = FaceRecipe(dict.fromkeys(base, 1.0 / len(base)), regions, amount)
    found = made(recipe).face
    bad = find_folds(SPACE.points, found.positions.astype(float), SPACE.skin_triangles)
    least = max(
        int(find_folds(SPACE.points, SOURCES[name].face.positions.astype(float), SPACE.skin_triangles).sum())
        for name in (*base, *regions.values())
    )
    assert bad.sum() <= least + 0.01 * len(bad)


@pytest.mark.parametrize(
    ("recipe", "sentence"),
    [
        (FaceRecipe({}), "base of this face is empty"),
        (FaceRecipe({"nobody": 1.0}), "no face 'nobody'"),
        (FaceRecipe({"kaori": 0.5}), "sum to 0.5; expected 1"),
        (FaceRecipe({"kaori": 1.5, "dog": -0.5}), "'kaori' has weight 1.5"),
        (FaceRecipe({"kaori": float("nan")}), "'kaori' has weight nan"),
        (FaceRecipe({"kaori": 1.0}, {"beak": "dog"}), "no region 'beak'"),
        (FaceRecipe({"kaori": 1.0}, {"nose": "nobody"}), "no face 'nobody'"),
        (FaceRecipe({"kaori": 1.0}, amount=2 * MOST_AMOUNT), "caricature's amount is 6.0"),
        (FaceRecipe({"kaori": 1.0}, amount=float("nan")), "caricature's amount is nan"),
        (FaceRecipe({"kaori": 1.0}, gains=(GainRow("tail", 1.0),)), "a gain is of region 'tail'"),
        (FaceRecipe({"kaori": 1.0}, look={"tail": 1.0}), "no 'tail' to choose; expected age, blush"),
        (FaceRecipe({"kaori": 1.0}, look={"lashes": float("nan")}), "lashes of a look is nan"),
        (FaceRecipe({"kaori": 1.0}, points=(1,)), "moves of handles has shape"),
        (FaceRecipe({"kaori": 1.0}, moves=((0.0, 0.0, 0.0),)), "expected a list of rows"),
        (FaceRecipe({"kaori": 1.0}, points=(-4,), moves=((0.0, 0.0, 0.0),)), "stands on row -4"),
    ],
)
def test_what_makes_no_face_is_refused_with_a_sentence(recipe: FaceRecipe, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        made(recipe)


def test_gains_are_those_of_the_faces_and_of_the_recipe_before_all() -> None:
    dog = SOURCES["dog"]
    loud = FaceWithLook(replace(dog.face, gains=(Gain("mouth", 2.0), Gain("ears", 1.0))), dog.look)
    sources = {**SOURCES, "dog": loud}

    def gains(recipe: FaceRecipe) -> tuple[Gain, ...]:
        return compose_face(SPACE, "new", recipe, sources).face.gains

    assert gains(FaceRecipe({"dog": 1.0})) == loud.face.gains
    assert gains(FaceRecipe({"dog": 0.5, "kaori": 0.5})) == (Gain("mouth", 1.5), Gain("ears", 0.5))
    assert gains(FaceRecipe({"kaori": 1.0}, {"ears": "dog"}, 1.2)) == (Gain("ears", 1.0),)
    rows = (GainRow("mouth", 1.0), GainRow("ears", 3.0, "joy"))
    assert gains(FaceRecipe({"dog": 1.0}, gains=rows)) == (Gain("ears", 1.0), Gain("ears", 3.0, "joy"))


@given(one=names, other=names, chosen=st.fixed_dictionaries(
    {}, optional={
        "hair_style": st.sampled_from(["", *CAST.hair]), "hair": st.just("#102030"), "lip": st.just("#a03040"),
        "freckles": st.floats(0.0, 1.0), "scalp": st.floats(0.0, 1.0),
    }
))  # fmt: skip
@settings(max_examples=20)
def test_what_is_chosen_of_a_look_goes_before_what_its_faces_bring(
    one: str, other: str, chosen: dict[str, str | float]
) -> None:
    recipe = FaceRecipe({one: 1.0}, {"mouth": other, "skull": other})
    brought = vars(made(recipe).look)
    found = vars(made(msgspec.structs.replace(recipe, look=chosen)).look)
    for name, value in found.items():
        if name == "scalp" and name not in chosen and found["hair_style"] != brought["hair_style"]:
            assert value == (1.0 if found["hair_style"] else 0.0)  # another style comes with its own
        else:
            assert value == chosen.get(name, brought[name]), name


@pytest.mark.parametrize("side", ["kaori", "old"])
def test_half_of_two_faces_takes_the_hair_of_either(side: str) -> None:
    style = CAST.looks[side].hair_style
    half = made(FaceRecipe({"kaori": 0.5, "old": 0.5}, look={"hair_style": style}))
    assert half.look.hair_style == style


def test_weights_that_were_rounded_on_air_are_scaled() -> None:
    rounded = compose_face(SPACE, "a", FaceRecipe({"kaori": 0.33334, "dog": 0.33334, "cat": 0.33334}), SOURCES)
    exact = compose_face(SPACE, "a", FaceRecipe(dict.fromkeys(("kaori", "dog", "cat"), 1 / 3)), SOURCES)
    assert np.allclose(rounded.face.positions, exact.face.positions, atol=1e-9)


def photographed(name: str, cover: int = 255) -> FaceWithLook:
    texels = np.full((1024, 1024, 4), (200, 120, 90, cover), np.uint8)
    return FaceWithLook(SOURCES[name].face, replace(SOURCES[name].look, albedo=Albedo(texels)))


def test_a_picture_of_skin_stays_through_caricature_and_handles() -> None:
    kaori = photographed("kaori")
    recipe = FaceRecipe(
        {"kaori": 1.0}, amount=1.4, points=ROWS, moves=((0.0, 0.002, 0.0), *((0.0, 0.0, 0.0),) * (len(ROWS) - 1))
    )
    assert compose_face(SPACE, "hers", recipe, {"kaori": kaori}, CAST.atlas).look.albedo is kaori.look.albedo


def test_a_mix_with_a_painted_face_is_covered_by_half_of_the_picture_and_painted_like_that_face() -> None:
    sources = {"kaori": photographed("kaori"), "dog": SOURCES["dog"]}
    found = compose_face(SPACE, "both", FaceRecipe({"kaori": 0.5, "dog": 0.5}), sources).look
    assert found.albedo is not None
    assert found.albedo.cover == pytest.approx(0.5, abs=0.5 / 255)
    dog = SOURCES["dog"].look
    kaori = sources["kaori"].look
    assert (found.skin, found.coat, found.fur, found.brows) == (dog.skin, dog.coat, dog.fur, dog.brows)
    assert found.pores == pytest.approx((dog.pores + kaori.pores) / 2)  # relief stays: its pores are half of both


def test_regions_bring_their_pictures_where_the_skin_has_an_atlas() -> None:
    sources = {"kaori": photographed("kaori"), "dog": SOURCES["dog"]}
    recipe = FaceRecipe({"dog": 1.0}, regions={"mouth": "kaori"})
    found = compose_face(SPACE, "hers", recipe, sources, CAST.atlas).look.albedo
    assert found is not None
    assert 0.0 < found.cover < 0.5
    assert compose_face(SPACE, "hers", recipe, sources).look.albedo is None
