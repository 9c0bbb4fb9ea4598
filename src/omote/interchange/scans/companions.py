"""What lies beside a scan's file: textures, materials and buffers that it names."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from omote.interchange.formats.error_reasons import explain_error
from omote.interchange.formats.gltf_scene import Find, find_nothing
from omote.interchange.scans.picture_reader import read_picture


@dataclass
class Companions:
    """Reads files beside the given one and collects what is to be told.

    find: the bytes of a name that the file gives, None where none lies beside it; notes: sentences about what is
    missing or unreadable and not needed for the shape.
    """

    find: Find = find_nothing
    notes: list[str] = field(default_factory=list)

    def picture(self, name: str, /) -> NDArray[np.uint8] | None:
        """The picture of this name, None and a note where there is none or it cannot be read."""
        try:
            data = self.find(name)
            if data is None:
                self.note(f"its texture {_short(name)!r} does not lie beside it: give both together")
                return None
            return read_picture(data)
        except (ValueError, OSError) as error:
            self.note(f"its texture {_short(name)!r} cannot be read ({explain_error(error)})")
            return None

    def note(self, sentence: str, /) -> None:
        """Adds a sentence once."""
        if sentence not in self.notes and len(self.notes) < 20:
            self.notes.append(sentence)


def _short(name: str) -> str:
    return name[-80:]
