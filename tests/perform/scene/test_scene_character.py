"""A character is a performer that wears its face from the first frame; its light is the scene's."""

from omote.model.cast import Cast
from omote.perform.performer import Performer
from omote.perform.scene.scene import Scene
from omote.perform.scene.scene_character import SceneCharacter


def test_a_new_one_is_a_performer_who_was_called_to_its_face(cast: Cast) -> None:
    performer = Performer(cast)
    performer.advance(2.0)
    performer.call_face("broad", seconds=0.0)
    performer.set_home("broad")
    scene = Scene(cast)
    character = SceneCharacter.new(cast, "broad", 2.0, scene.call_light, scene._check_target)
    assert character.snapshot() == performer.snapshot()


def test_its_light_is_the_scenes(cast: Cast) -> None:
    scene = Scene.begun(cast)
    scene["one"].call_light("flat", seconds=0.0)
    two = scene.add("two")
    frame = scene.advance(0.0)
    assert frame.light == {"flat": 1.0}
    assert [each.frame.light for each in frame.characters.values()] == [frame.light] * 2
    two.call_light("portrait", seconds=2.0)
    assert scene.advance(1.0).light_call is not None
