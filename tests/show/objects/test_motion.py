"""Commands of automatic motion: springs, and the part of a cue that has them."""

from omote.model.cast import Cast
from omote.perform.scene.scene import Scene
from omote.show.objects.motion import SetSpring


def test_a_spring_is_set_by_how_much_of_it_shows(cast: Cast) -> None:
    scene = Scene.begun(cast)
    SetSpring("one", "ears-sway", 0.5).play(scene["one"])
    assert scene.goal_of("one/springs") == {
        "ears-sway": 0.5, "ears-flap": 1.0, "jowls-sway": 1.0, "cheeks-bounce": 1.0,
    }  # fmt: skip
    assert scene.advance(0.0).characters["one"].frame.springs == {"ears-sway": 0.5}
    assert SetSpring("one", "ears-sway", 0.5).control("one") == "one/set_spring:ears-sway"
