"""What pages ask of the bindings of a show: made, changed, taken away, learned, given by presets, taken back."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import msgspec

from omote.inputs.bindings.binding_changes import BindingChange, EditableBindings
from omote.inputs.bindings.binding_document import document_of, encode_stored, read_document
from omote.inputs.bindings.bindings import Bindings
from omote.inputs.bindings.control_binding import Binding
from omote.inputs.bindings.missing_names import list_missing
from omote.inputs.bindings.target import read_target
from omote.inputs.osc_orders import OrderReader
from omote.inputs.page_devices.learning import Learning
from omote.inputs.presets.preset import Preset
from omote.inputs.presets.preset_list import PRESETS, find_preset, preset_for
from omote.inputs.reading import Reading
from omote.perform.pad_playing import NO_PADS
from omote.perform.pads.blend_space import Pad
from omote.perform.scene.character_names import ALL
from omote.show.objects.bindings import (
    Bind,
    BindingDocument,
    BindingList,
    BindingsChanged,
    Learn,
    LearningState,
    LoadPreset,
    RestoreBindings,
    Unbind,
)

Keep = Callable[[bytes], None]


@dataclass(frozen=True)
class Learner:
    """Who learns what."""

    who: str
    name: str
    asked: Learn
    learning: Learning


class BindingCommands:
    """The bindings of a show while people change them. playing: is given them; presets: by device, "" for one that was
    offered none or took it away; keep: takes what the show file is to keep. number: rises with each change;
    missing: for each binding what it names that is not there."""

    def __init__(
        self, editable: EditableBindings, playing: Bindings, presets: Mapping[str, str], keep: Keep = lambda _: None
    ) -> None:
        self.editable = editable
        self.presets = dict(presets)
        self._playing = playing
        self._keep = keep
        self.learner: Learner | None = None
        self.missing: list[str] = []
        self._loaded: list[BindingsChanged] = []
        self._reader: OrderReader | None = None
        self._pads = NO_PADS
        self.number = 0
        playing.replace(editable.playing)

    def carry_out(self, message: Bind | Unbind | LoadPreset | RestoreBindings) -> BindingsChanged:
        """Does what a page asks for; ValueError where it cannot be, and nothing has changed."""
        match message:
            case Bind(change, binding, replaces):
                before = [] if replaces is None else [read_document(replaces)]
                outcome = self.editable.bind(change, read_document(binding), before)
            case Unbind(change, binding):
                outcome = self.editable.unbind(change, read_document(binding))
            case LoadPreset(change, device, name, character):
                preset = find_preset(name)
                outcome = self.editable.give(change, device, preset.bindings(device, character))
                self.presets[device] = preset.name
            case RestoreBindings(change, earlier):
                return self.restore(change, earlier)
        return self._changed(message.id, outcome)

    def give_all(self, change: str, bindings: Sequence[Binding]) -> BindingsChanged:
        """Gives all devices bindings in the place of all that are not fixed; ValueError where there are too many.

        change: the id by which it can be taken back.
        """
        return self._changed(change, self.editable.give_all(change, bindings))

    def restore(self, change: str, earlier: str) -> BindingsChanged:
        """Takes an earlier change back; ValueError where it is not remembered. change: the id of this one."""
        return self._changed(change, self.editable.restore(change, earlier))

    def know_names(self, reader: OrderReader, pads: Mapping[str, Pad] = NO_PADS) -> None:
        """Looks anew which bindings name what is not there. reader: of the cast and the characters of the show; pads:
        those of the show, by name."""
        self._reader = reader
        self._pads = pads
        if self.missing != (missing := list_missing(self.editable.playing, reader, pads)):
            self.missing = missing
            self.number += 1

    def rename_pad(self, pad: str, to: str) -> None:
        """Has bindings follow a pad to another name; controls that are held play on.

        pad: its name before; to: its name now.
        """
        if self.editable.rename_pad(pad, to):
            self._use((pad, to))

    def who_plays_pad(self, pad: str) -> list[str]:
        """The controls that move a pad (by its name), in words."""
        moving = (binding for binding in self.editable.playing if binding.target.pad == pad)
        return [*dict.fromkeys(f"{binding.control} of {binding.device}" for binding in moving)]

    def greet(self, device: str, kind: str) -> Preset | None:
        """The preset of a device that is plugged in: the one that it was given; at its first time, where nothing is
        bound on it, the one that is made for it, which pages are to be told (`take_loaded`). Levels that somebody has
        bound to another device are left to that.

        kind: midi, gamepad or space_mouse.
        """
        if device not in self.presets:
            preset = preset_for(device, kind)
            bound = any(binding.device == device for binding in self.editable.playing)
            self.presets[device] = preset.name if preset else ""
            if preset and not bound:
                chosen = {_played(each) for each in self.editable.playing if not self._is_of_preset(each)}
                wanted = [
                    binding
                    for binding in preset.bindings(device, ALL)
                    if not (binding.target.is_level and _played(binding) in chosen)
                ]
                outcome = self.editable.give(f"preset {device}", device, wanted)
                changed = self._changed(f"preset {device}", outcome)
                self._loaded.append(msgspec.structs.replace(changed, preset=preset.label))
        return PRESETS.get(self.presets[device])

    def take_loaded(self) -> list[BindingsChanged]:
        """Returns and clears what presets have bound that nobody asked for."""
        loaded = self._loaded
        self._loaded = []
        return loaded

    def learn(self, who: str, name: str, asked: Learn, now: float) -> None:
        """Binds the next control that moves to what is asked for; an empty one stops. ValueError for no target.

        who: the page; name: what others call it; now: seconds of the show's clock.
        """
        self.number += 1
        self.learner = None
        if asked.to:
            target = read_target(asked.to, asked.arguments, asked.axis or None)
            self.learner = Learner(who, name, asked, Learning(target, now, asked.bank))

    def hear(self, readings: list[Reading]) -> tuple[str, BindingsChanged] | None:
        """What is learned from readings, and for whom; None while nothing is. ValueError where it cannot be bound. What
        the preset of the device has bound to the same control, or lets another control of it play, makes way."""
        learner = self.learner
        learned = None if learner is None else learner.learning.hear(readings)
        if learner is None or learned is None:
            return None
        self.learner = None
        self.number += 1
        change = self.editable.bind(learner.asked.id, learned, self._making_way(learned))
        return learner.who, self._changed(learner.asked.id, change)

    def _making_way(self, learned: Binding) -> list[Binding]:
        """The bindings that nobody has chosen and that play beside one that is learned."""
        return [
            binding
            for binding in self.editable.own
            if (binding.device, binding.bank) == (learned.device, learned.bank)
            and (binding.control == learned.control or _played(binding) == _played(learned))
            and self._is_of_preset(binding)
        ]

    def _is_of_preset(self, binding: Binding) -> bool:
        """Whether a binding is as the preset of its device has it."""
        preset = PRESETS.get(self.presets.get(binding.device, ""))
        return preset is not None and binding in preset.bindings(binding.device, binding.target.character)

    def pass_time(self, now: float) -> None:
        """Ends learning that has gone on for too long."""
        if self.learner is not None and now >= self.learner.learning.until:
            self.learner = None
            self.number += 1

    def list_now(self) -> BindingList:
        """All bindings, for pages."""
        learner = self.learner
        asked = None if learner is None else learner.asked
        return BindingList(
            bindings=[document_of(binding) for binding in self.editable.playing],
            fixed=[document_of(binding) for binding in self.editable.fixed],
            learning=None
            if learner is None or asked is None
            else LearningState(asked.id, asked.to, asked.axis, asked.arguments, learner.name),
            presets=[preset.document for preset in PRESETS.values()],
            missing=self.missing,
        )

    def _changed(self, change: str, outcome: BindingChange) -> BindingsChanged:
        self._use()
        return BindingsChanged(change, _documents(outcome.added), _documents(outcome.removed))

    def _use(self, renamed: tuple[str, str] | None = None) -> None:
        """Plays and keeps the bindings that there are now. renamed: as of `Bindings.replace`."""
        self.number += 1
        self._playing.replace(self.editable.playing, renamed)
        if self._reader is not None:
            self.missing = list_missing(self.editable.playing, self._reader, self._pads)
        self._keep(encode_stored(self.editable.own, self.presets))


def _played(binding: Binding) -> tuple[object, ...]:
    """What a binding plays, of whichever character, in whichever time."""
    target = binding.target
    path = target.path.replace(f"/{target.character}/", "/*/", 1) if target.character else target.path
    return path, target.axis, target.arguments[:1]


def _documents(bindings: tuple[Binding, ...]) -> list[BindingDocument]:
    return [document_of(binding) for binding in bindings]
