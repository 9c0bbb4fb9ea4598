"""Bindings of a show while people change them: each change can be taken back, and that again."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass

from omote.inputs.bindings.binding_file import MOST_BINDINGS
from omote.inputs.bindings.control_binding import Binding, binding_after_rename

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
        self.own = tuple(dict.fromkeys(own))
        self.fixed = tuple(fixed)
        self._changes: dict[str, BindingChange] = {}

    @property
    def playing(self) -> tuple[Binding, ...]:
        """All that play: an own binding does not where a fixed one has its control in its bank."""
        taken = {(binding.device, binding.control, binding.bank) for binding in self.fixed}
        return (
            *self.fixed,
            *(binding for binding in self.own if (binding.device, binding.control, binding.bank) not in taken),
        )

    def bind(self, change: str, binding: Binding, replaces: Collection[Binding] = ()) -> BindingChange:
        """Adds a binding in the place of those that it `replaces` and of one of the same control and target; ValueError
        where a file has fixed its control, or where there are too many.

        change: the id by which it can be taken back.
        """
        self._check_free(binding)
        gone = tuple(own_binding for own_binding in self.own if own_binding in replaces or _same(own_binding, binding))
        return self._make(change, BindingChange((binding,), gone))

    def unbind(self, change: str, binding: Binding) -> BindingChange:
        """Takes a binding away; ValueError where there is none such. change: the id by which that can be taken back."""
        if binding not in self.own:
            where = "in the file of --bindings: change it there" if binding in self.fixed else "bound to nothing so"
            raise ValueError(f"{binding.control} of {binding.device} is {where}")
        return self._make(change, BindingChange((), (binding,)))

    def give(self, change: str, device: str, bindings: Sequence[Binding]) -> BindingChange:
        """Gives a device bindings in the place of all its own; those whose control a file has fixed are left out.

        change: the id by which that can be taken back.
        """
        taken = {(binding.device, binding.control) for binding in self.fixed}
        wanted = tuple(binding for binding in bindings if (binding.device, binding.control) not in taken)
        return self._make(
            change,
            BindingChange(wanted, tuple(binding for binding in self.own if binding.device == device)),
        )

    def give_all(self, change: str, bindings: Sequence[Binding]) -> BindingChange:
        """Gives all devices bindings in the place of all own ones, as `give`. change: the id by which it can be taken
        back."""
        taken = {(binding.device, binding.control) for binding in self.fixed}
        wanted = tuple(binding for binding in bindings if (binding.device, binding.control) not in taken)
        gone = tuple(binding for binding in self.own if binding not in wanted)
        return self._make(change, BindingChange(tuple(each for each in wanted if each not in self.own), gone))

    def rename_pad(self, pad: str, to: str) -> bool:
        """Has own bindings follow a pad to another name, and what of them can be taken back; whether one does.

        pad: its name before; to: its name now.
        """

        def later(bindings: tuple[Binding, ...]) -> tuple[Binding, ...]:
            return tuple(dict.fromkeys(binding_after_rename(binding, pad, to) for binding in bindings))

        before = self.own
        self.own = later(before)
        self._changes = {
            key: BindingChange(later(change.added), later(change.removed)) for key, change in self._changes.items()
        }
        return self.own != before

    def restore(self, change: str, earlier: str) -> BindingChange:
        """Takes an earlier change back, as far as it still stands; ValueError where it is not remembered."""
        undone = self._changes.get(earlier)
        if undone is None:
            raise ValueError("that change cannot be taken back any more: the show was started again since, or long ago")
        there = set(self.own)
        for binding in undone.removed:
            self._check_free(binding)
        gone = tuple(binding for binding in undone.added if binding in there and binding not in undone.removed)
        back = tuple(binding for binding in undone.removed if binding not in there)
        return self._make(change, BindingChange(back, gone))

    def _make(self, change: str, wanted: BindingChange) -> BindingChange:
        gone = set(wanted.removed)
        new = list(dict.fromkeys(wanted.added))
        left = [binding for binding in self.own if binding not in gone and binding not in new]
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


def _same(old: Binding, new: Binding) -> bool:
    """Whether two bindings are one that has been changed: of one control, in one bank, to one target."""
    return (old.device, old.control, old.bank, old.target) == (new.device, new.control, new.bank, new.target)


def _in_place(
    before: Sequence[Binding], gone: Sequence[Binding], new: Sequence[Binding], left: Sequence[Binding]
) -> tuple[Binding, ...]:
    """The bindings that are left, with the new ones where the first that is gone stood, else at the end."""
    at = min((before.index(binding) for binding in gone if binding in before), default=len(before))
    ahead = sum(binding in left for binding in before[:at])
    return (*left[:ahead], *new, *left[ahead:])
