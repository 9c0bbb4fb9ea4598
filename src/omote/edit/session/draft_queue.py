"""Lanes: of what concerns one draft only one thing is under way, and the rest waits in order."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field

from omote.edit.protocol.orders import EditOrder
from omote.edit.session.plan import Plan, Result
from omote.edit.store.authored_state import DraftKey
from omote.show.validation import Refusal

MOST_WAITING = 32
"""Things that wait in a lane; more are refused."""


@dataclass(frozen=True)
class Task:
    """Something to carry out when its turn comes; lane None: at once. Who asked, under which number or ticket."""

    queue: DraftKey | None
    begin: Callable[[], Plan | Result] = field(repr=False)
    who: str = ""
    request: int = -1
    ticket: str | None = None


class DraftQueues:
    """What is under way, by the number of its order, and what waits behind it."""

    def __init__(self) -> None:
        self._ordered = 0
        self._under_way: dict[int, tuple[Task, Plan]] = {}
        self._waiting: dict[DraftKey, deque[Task]] = {}

    def try_start(self, task: Task) -> bool:
        """Whether it is the task's turn now; else it waits. Refusal where too much waits already."""
        if task.queue is None or task.queue not in self._waiting:
            return True
        waiting = self._waiting[task.queue]
        if len(waiting) >= MOST_WAITING:
            raise Refusal(f"{MOST_WAITING} requests wait for this already: wait until they are answered.")
        waiting.append(task)
        return False

    def order(self, task: Task, plan: Plan) -> tuple[int, EditOrder]:
        """The plan's order under its number; its lane is taken until `finish_order`."""
        self._ordered += 1
        self._under_way[self._ordered] = task, plan
        if task.queue is not None:
            self._waiting.setdefault(task.queue, deque())
        return self._ordered, plan.order

    def finish_order(self, order: int) -> tuple[Task, Plan] | None:
        """What an order was for; None where it is not under way."""
        return self._under_way.pop(order, None)

    def next_task(self, task: Task) -> Task | None:
        """The task whose turn comes after this one; None: the lane is free."""
        if task.queue is None or task.queue not in self._waiting:
            return None
        if self._waiting[task.queue]:
            return self._waiting[task.queue].popleft()
        del self._waiting[task.queue]
        return None
