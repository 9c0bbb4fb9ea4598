"""Faces are read plainly here: by one point of the lower lip."""

from tests.inputs.performers.conftest import plain_tracker

__all__ = ["plain_tracker"]
