"""Performers: how the landmarks of a person's face before a camera are read, by the person's name."""

from __future__ import annotations

from typing import ClassVar

import msgspec

from omote.show.objects.documents import Document


class StoredPerformer(Document, frozen=True):
    """A performer. calibration: what `inputs.camera` reads; guided: whether by the guided minute."""

    kind: ClassVar[str] = "performer"

    calibration: msgspec.Raw
    guided: bool = False
