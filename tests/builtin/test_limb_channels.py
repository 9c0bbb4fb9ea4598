"""Channels that play limb fields: expressions of the cast that leave heads alone."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import omote
from omote.builtin.limb_channels import with_limb_channels
from omote.model.space.expression import Title

CAST = omote.load_cast()


def test_a_limb_field_is_called_faded_and_released_as_an_expression() -> None:
    performer = omote.Performer(CAST)
    before = omote.evaluate_figure(CAST, performer.advance(0.0))
    performer.set_channel("belly", 0.8)
    fader = omote.evaluate_figure(CAST, performer.advance(1.0))
    performer.set_channel("belly", 0.0)
    performer.call_expression("belly", seconds=1.0)
    performer.advance(0.5)
    called = omote.evaluate_figure(CAST, performer.advance(1.0))
    head = CAST.space.vertex_count
    assert np.abs(fader - before)[head:].max() > 0.03
    np.testing.assert_allclose((fader - before)[head:], 0.8 * (called - before)[head:], atol=1e-5)
    np.testing.assert_allclose(called[:head], before[:head], atol=1e-6)


def test_each_field_has_a_channel_with_its_label() -> None:
    assert CAST.figures is not None
    for name, field in CAST.figures.limb_fields.items():
        assert CAST.titles[name] == Title(field.label, "limb", "body")
    assert with_limb_channels(replace(CAST, figures=None)).expressions.keys() == CAST.expressions.keys()


def test_a_name_that_is_taken_is_refused() -> None:
    with pytest.raises(ValueError, match="belly"):
        with_limb_channels(CAST)
