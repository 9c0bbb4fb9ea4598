"""Bindings of a show while people change them: each change can be taken back, and that again."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from omote.inputs.bindings.binding_file import MOST_BINDINGS
from omote.inputs.bindings.control_binding import Binding

REMEMBERED_CHANGES = 128


@dataclass(frozen=True)
class BindingChange:
    """What a change has added and removed."""

    added: tuple[Binding, ...] = ()
    removed: tuple[Binding, ...] = ()


class EditableBindings:
    """The bindings of a show. own: those of the show file; fixed: those of a file of the command line, which stand
    before own ones of the same control and which nobody changes."""

    def __init__(self, own: Iterable[Binding] = (), fixed: Iterable[Binding] = ()) -> None:
        self.own, self.fixed = tuple(dict.fromkeys(own)), tuple(fixed)
        self._changes: dict[str, BindingChange] = {}

    @property
    def playing(self) -> tuple[Binding, ...]:
        """All that play: an own binding does not where a fixed one has its control in its bank."""
        taken = {(each.device, each.control, each.bank) for each in self.fixed}
        return (*self.fixed, *(each for each in self.own if (each.device, each.control, each.bank) not in taken))

    def bind(self, change: str, binding: Binding, replaces: Binding | None = None) -> BindingChange:
        """Adds a binding in the place of `replaces` and of one of the same control and target; ValueError where a file
        has fixed its control, or where there are too many."""
        self._check_free(binding)
        gone = tuple(each for each in self.own if each == replaces or _same(each, binding))
        return self._make(change, BindingChange((binding,), gone))

    def unbind(self, change: str, binding: Binding) -> BindingChange:
        """Takes a binding away; ValueError where there is none such."""
        if binding not in self.own:
            where = "in the file of --bindings: change it there" if binding in self.fixed else "bound to nothing so"
            raise ValueError(f"{binding.control} of {binding.device} is {where}")
        return self._make(change, BindingChange((), (binding,)))

    def give(self, change: str, device: str, bindings: Sequence[Binding]) -> BindingChange:
        """Gives a device bindings in the place of all its own; those whose control a file has fixed are left out."""
        taken = {(each.device, each.control) for each in self.fixed}
        wanted = tuple(each for each in bindings if (each.device, each.control) not in taken)
        return self._make(change, BindingChange(wanted, tuple(each for each in self.own if each.device == device)))

    def restore(self, change: str, earlier: str) -> BindingChange:
        """Takes an earlier change back, as far as it still stands; ValueError where it is not remembered."""
        made = self._changes.get(earlier)
        if made is None:
            raise ValueError("that change cannot be taken back any more: the show was started again since, or long ago")
        there = set(self.own)
        for binding in made.removed:
            self._check_free(binding)
        gone = tuple(each for each in made.added if each in there and each not in made.removed)
        back = tuple(each for each in made.removed if each not in there)
        return self._make(change, BindingChange(back, gone))

    def _make(self, change: str, wanted: BindingChange) -> BindingChange:
        gone, new = set(wanted.removed), list(dict.fromkeys(wanted.added))
        left = [each for each in self.own if each not in gone and each not in new]
        if len(left) + len(new) > MOST_BINDINGS:
            raise ValueError(f"there would be {len(left) + len(new)} bindings; at most {MOST_BINDINGS} are kept")
        self.own = _in_place(self.own, wanted.removed, new, left)
        self._changes[change] = wanted
        if len(self._changes) > REMEMBERED_CHANGES:
            del self._changes[next(iter(self._changes))]
        return wanted

    def _check_free(self, binding: Binding) -> None:
        if any((binding.device, binding.control, binding.bank) == (f.device, f.control, f.bank) for f in self.fixed):
            raise ValueError(
                f"{binding.control} of {binding.device} is bound in the file of --bindings: change it there"
            )


def _same(one: Binding, other: Binding) -> bool:
    """Whether two bindings are one that has been changed: of one control, in one bank, to one target."""
    return (one.device, one.control, one.bank, one.target) == (other.device, other.control, other.bank, other.target)


def _in_place(
    before: Sequence[Binding], gone: Sequence[Binding], new: Sequence[Binding], left: Sequence[Binding]
) -> tuple[Binding, ...]:
    """The bindings that are left, with the new ones where the first that is gone stood, else at the end."""
    at = min((before.index(each) for each in gone if each in before), default=len(before))
    ahead = sum(each in left for each in before[:at])
    return (*left[:ahead], *new, *left[ahead:])
