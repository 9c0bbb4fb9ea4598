"""Queues of tasks, one per draft: of each draft one task is under way at a time, and the rest wait in order."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field

from omote.edit.protocol.orders import EditOrder
from omote.edit.session.plan import Plan, Result
from omote.edit.store.authored_state import DraftKey
from omote.show.validation import Refusal

MOST_WAITING = 32
"""Tasks that may wait in one queue; more are rejected."""


@dataclass(frozen=True)
class Task:
    """A request to carry out in its turn; queue None: at once. Who asked, under which number or ticket."""

    queue: DraftKey | None
    begin: Callable[[], Plan | Result] = field(repr=False)
    who: str = ""
    request: int = -1
    ticket: str | None = None


class DraftQueues:
    """The tasks under way, by the number of their order, and those that wait behind them."""

    def __init__(self) -> None:
        self._ordered = 0
        self._under_way: dict[int, tuple[Task, Plan]] = {}
        self._waiting: dict[DraftKey, deque[Task]] = {}

    def try_start(self, task: Task) -> bool:
        """Whether the task may start now; else it waits. Refusal where too many wait already."""
        if task.queue is None or task.queue not in self._waiting:
            return True
        waiting = self._waiting[task.queue]
        if len(waiting) >= MOST_WAITING:
            raise Refusal(f"{MOST_WAITING} requests wait for this already: wait until they are answered.")
        waiting.append(task)
        return False

    def start_order(self, task: Task, plan: Plan) -> tuple[int, EditOrder]:
        """Numbers a plan's order; its queue is busy until `finish_order`.

        task: what was asked; plan: its order, and what follows.
        """
        self._ordered += 1
        self._under_way[self._ordered] = task, plan
        if task.queue is not None:
            self._waiting.setdefault(task.queue, deque())
        return self._ordered, plan.order

    def finish_order(self, order: int) -> tuple[Task, Plan] | None:
        """The task and plan of a finished order; None where it is not under way."""
        return self._under_way.pop(order, None)

    def next_task(self, task: Task) -> Task | None:
        """The next task of the same queue; None: the queue is free."""
        if task.queue is None or task.queue not in self._waiting:
            return None
        if self._waiting[task.queue]:
            return self._waiting[task.queue].popleft()
        del self._waiting[task.queue]
        return None
