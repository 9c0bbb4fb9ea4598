"""What an address is made of."""

from omote.inputs.addresses.address import PRESS, SECONDS, Address, Value
from omote.show import messages as wire


def test_a_pattern_names_the_character_where_it_is_one() -> None:
    own = Address("panic", "", (PRESS,), lambda who, _: wire.Panic(who))
    assert own.pattern == "/omote/{character}/panic"
    assert Address("panic", "", (PRESS,), lambda who, _: wire.Panic(who), of_show=True).pattern == "/omote/panic"


def test_times_presses_and_what_has_a_default_may_be_left_out() -> None:
    assert PRESS.may_be_left_out
    assert SECONDS.may_be_left_out
    assert Value("strength", default=1.0).may_be_left_out
    assert not Value("weight").may_be_left_out
