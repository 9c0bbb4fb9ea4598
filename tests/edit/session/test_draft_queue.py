"""One thing at a time for a draft, in order, and no more waiting than can be."""

import pytest

from omote.edit.protocol.orders import Bake
from omote.edit.session.draft_queue import MOST_WAITING, DraftQueues, Task
from omote.edit.session.plan import Plan, Result
from omote.model.recipes.recipe import Recipe
from omote.show.validation import Refusal

PLAN = Plan(Bake(Recipe((), ()), {}), lambda baked: Result())


def task(queue: tuple[int, str] | None, request: int = 0) -> Task:
    """A task in a queue."""
    return Task(queue, lambda: PLAN, "ann", request)


def test_tasks_of_one_queue_take_turns_in_order() -> None:
    queues = DraftQueues()
    first = task((1, "ann"))
    assert queues.try_start(first)
    number, order = queues.start_order(first, PLAN)
    assert order is PLAN.order
    waiting = [task((1, "ann"), request) for request in range(5)]
    assert [queues.try_start(each) for each in waiting] == [False] * 5
    assert queues.finish_order(number) == (first, PLAN)
    assert [queues.next_task(first) for _ in range(6)] == [*waiting, None]
    assert queues.try_start(task((1, "ann"))), "the queue is free again"


def test_queues_do_not_wait_for_each_other() -> None:
    queues = DraftQueues()
    for queue in ((1, "ann"), (1, "bob"), (2, "ann"), None):
        assert queues.try_start(task(queue))
        queues.start_order(task(queue), PLAN)
    assert queues.try_start(task(None))


def test_orders_have_numbers_of_their_own_and_land_once() -> None:
    queues = DraftQueues()
    numbers = [queues.start_order(task((item, "ann")), PLAN)[0] for item in range(4)]
    assert len(set(numbers)) == 4
    assert queues.finish_order(numbers[2]) is not None
    assert queues.finish_order(numbers[2]) is None


def test_too_much_that_waits_is_refused() -> None:
    queues = DraftQueues()
    queues.start_order(task((1, "ann")), PLAN)
    for _ in range(MOST_WAITING):
        assert not queues.try_start(task((1, "ann")))
    with pytest.raises(Refusal, match="wait until they are answered"):
        queues.try_start(task((1, "ann")))
