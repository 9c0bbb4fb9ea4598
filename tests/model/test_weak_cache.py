"""Values made once for an object, and dropped with it."""

import gc
import weakref

from omote.model.weak_cache import weakly_cached, weakly_cached_with


class Thing:
    """What can be weakly referenced."""


def test_a_value_is_made_once_for_an_object_and_dropped_with_it() -> None:
    made = list[Thing | None]()

    @weakly_cached
    def part_of(thing: Thing) -> set[int]:
        made.append(None)
        return {id(thing)}

    one, other = Thing(), Thing()
    part = part_of(one)
    assert part_of(one) is part
    assert part_of(other) is not part
    assert len(made) == 2
    kept = weakref.ref(one)
    del one
    gc.collect()
    assert kept() is None


def test_a_value_of_two_objects_is_made_anew_for_another_first_one_and_dropped_with_the_second() -> None:
    made = list[None]()

    @weakly_cached_with
    def part_of(whole: Thing, thing: Thing) -> set[int]:
        made.append(None)
        return {id(whole), id(thing)}

    one, other, thing = Thing(), Thing(), Thing()
    part = part_of(one, thing)
    assert part_of(one, thing) is part
    assert part_of(other, thing) == {id(other), id(thing)}
    assert part_of(one, thing) is not part
    assert len(made) == 3
    kept = weakref.ref(thing)
    del thing
    gc.collect()
    assert kept() is None
