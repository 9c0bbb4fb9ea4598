"""Files of bindings: what people write, and what is wrong with it."""

import pytest

from omote.inputs.bindings.binding_file import BindingFileError, read_bindings

GOOD = """
[[binding]]
device = "sACN"
control = "1/1"
to = "/omote/one/channel/jawOpen"

[[binding]]
device = "nanoKONTROL2"
control = "1/cc16"
to = "/omote/one/head"
axis = "yaw"
low = -45
high = 45.0
curve = 2

[[binding]]
device = "nanoKONTROL2"
control = "1/note36"
to = "/omote/one/face"
arguments = ["dog", 2.0]
bank = "B"
"""
ONE = '[[binding]]\ndevice = "sACN"\ncontrol = "1/1"\nto = "/omote/panic"\n'


def test_a_file_is_read_in_its_order() -> None:
    jaw, head, face = read_bindings(GOOD)
    assert (jaw.low, jaw.high, jaw.pick_up) == (0.0, 1.0, False)
    assert (head.low, head.high, head.curve, head.target.axis, head.pick_up) == (-45, 45.0, 2, 0, True)
    assert (face.target.arguments, face.bank) == (("dog", 2.0), "B")


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("[[binding", "no TOML"),
        ("", "1 to 1024 tables"),
        ("speed = 1\n" + ONE, "something else"),
        ("binding = 3", "1 to 1024 tables"),
        ("binding = [3]", "binding 1: '3' is no table"),
        (ONE + ONE.replace("to =", "too ="), "binding 2: there is no key 'too'"),
        (ONE.replace('"1/1"', "11"), "binding 1: control is '11'; expected str"),
        (ONE.replace('control = "1/1"\n', ""), "binding 1: control missing"),
        (ONE.replace("1/1", "1/600"), "slot 600"),
        (ONE.replace("panic", "pan"), "there is no address"),
        (ONE + "low = true", "low is 'True'; expected int or float"),
        (ONE + 'button = "toggle"', "called by a press"),
    ],
)
def test_what_is_wrong_is_said_and_where(text: str, why: str) -> None:
    with pytest.raises(BindingFileError, match=why):
        read_bindings(text)
