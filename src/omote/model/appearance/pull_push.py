"""Fills what is not known of a picture from what is known around it, smoothly: by a pyramid of weighted means."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Values = NDArray[np.float32]


def pull_push(values: Values, weights: Values, /) -> Values:
    """Fills a square picture (k, k, c), k a power of two, where its weights (k, k), 0 to 1, are not 1.

    What is known stays; the farther away it is, the larger the neighbourhood whose mean is filled in (S. Gortler et
    al., "The Lumigraph", 1996). A picture of which nothing is known becomes 0.
    """
    if len(values) == 1:
        return np.where(weights[..., None] > 0.0, values, np.float32(0.0))
    summed = _halve(weights[..., None])
    means = _halve(values * weights[..., None]) / np.maximum(summed, np.float32(1e-9))
    below = pull_push(means.astype(np.float32), np.minimum(4.0 * summed[..., 0], 1.0).astype(np.float32))
    filled: Values = weights[..., None] * values + (1.0 - weights[..., None]) * double(below)
    return filled


def double(values: Values, /) -> Values:
    """A picture (k, k, c) at twice the size, linear between the middles of its texels."""
    rows = _double_rows(values)
    return np.ascontiguousarray(_double_rows(rows.swapaxes(0, 1)).swapaxes(0, 1))


def _double_rows(values: Values) -> Values:
    above, below = np.concatenate([values[:1], values[:-1]]), np.concatenate([values[1:], values[-1:]])
    pairs = np.stack([0.25 * above + 0.75 * values, 0.75 * values + 0.25 * below], axis=1)
    return pairs.reshape(2 * len(values), *values.shape[1:]).astype(np.float32)


def halve(values: Values, /) -> Values:
    """A picture (k, k, c) at half the size: means of two by two texels."""
    return _halve(values)


def _halve(values: Values) -> Values:
    means: Values = 0.25 * (values[::2, ::2] + values[1::2, ::2] + values[::2, 1::2] + values[1::2, 1::2])
    return means
