"""Commands of automatic motion: springs and skin, and the parts of a cue that have them."""

from omote.model.cast import Cast
from omote.perform.scene.scene import Scene
from omote.show.objects.motion import SetSkin, SetSpring


def test_a_spring_is_set_by_how_much_of_it_shows(cast: Cast) -> None:
    scene = Scene.begun(cast)
    SetSpring("one", "ears-sway", 0.5).play(scene["one"])
    assert scene.goal_of("one/springs") == {
        "ears-sway": 0.5, "ears-flap": 1.0, "jowls-sway": 1.0, "cheeks-bounce": 1.0,
    }  # fmt: skip
    assert scene.advance(0.0).characters["one"].frame.springs == {"ears-sway": 0.5}
    assert SetSpring("one", "ears-sway", 0.5).control("one") == "one/set_spring:ears-sway"


def test_the_skin_has_faders_that_a_cue_has_too(cast: Cast) -> None:
    scene = Scene.begun(cast)
    SetSkin("one", "blood", 0.25).play(scene["one"])
    assert scene.goal_of("one/skin") == {"folds": 1.0, "blood": 0.25}
    assert scene.advance(0.0).characters["one"].frame.skin == {"blood": 0.25}
    assert SetSkin("one", "blood", 0.25).control("one") == "one/set_skin:blood"
