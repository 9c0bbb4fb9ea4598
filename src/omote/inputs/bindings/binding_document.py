"""Bindings as documents: what pages send and are told, and what the show file keeps (JSON)."""

from __future__ import annotations

import math
from collections.abc import Sequence

import msgspec

from omote.inputs.bindings.binding_file import MOST_BINDINGS, read_binding
from omote.inputs.bindings.control_binding import Binding
from omote.show.objects.bindings import BindingDocument, StoredBindings
from omote.show.objects.documents import read_document as read_stored


def read_document(document: BindingDocument) -> Binding:
    """The binding of a document; ValueError where it is none."""
    for argument in document.arguments:
        if isinstance(argument, float) and not math.isfinite(argument):
            raise ValueError(f"an argument is {argument}; give finite numbers and names")
    table = {key: value for key, value in msgspec.structs.asdict(document).items() if value not in (None, "", [])}
    return read_binding(table)


def document_of(binding: Binding) -> BindingDocument:
    """The document of a binding, with its range written out."""
    target = binding.target
    return BindingDocument(
        device=binding.device,
        control=binding.control,
        to=target.path,
        axis=target.axis_name if target.is_level else "",
        arguments=[
            float(argument) if isinstance(argument, int | float) else str(argument) for argument in target.arguments
        ],
        low=binding.low if target.is_level else None,
        high=binding.high if target.is_level else None,
        curve=binding.curve,
        pick_up=binding.pick_up,
        button=binding.button or "",
        relative=binding.relative or "",
        step=binding.step,
        bank=binding.bank,
        dead_zone=binding.dead_zone,
    )


def encode_stored(bindings: Sequence[Binding], presets: dict[str, str]) -> bytes:
    """What the show file keeps of bindings. presets: the name of each device's preset, by device."""
    return StoredBindings([document_of(binding) for binding in bindings], presets).encode()


def decode_stored(data: bytes) -> tuple[list[Binding], dict[str, str], list[str]]:
    """The bindings and presets that a show file has kept, and a sentence for each that cannot be used.

    A binding that an older or a newer Omote has made may name what this one has not: it is left out, the others play.
    """
    if not data:
        return [], {}, []
    try:
        stored = read_stored(StoredBindings, data)
    except ValueError as error:
        return [], {}, [f"the bindings in the show file cannot be read ({error}); nothing is bound"]
    bindings = []
    wrong = []
    for document in stored.bindings[:MOST_BINDINGS]:
        try:
            bindings.append(read_document(document))
        except ValueError as error:
            wrong.append(f"{document.control} of {document.device} is not bound: {error}")
    return bindings, stored.presets, wrong
