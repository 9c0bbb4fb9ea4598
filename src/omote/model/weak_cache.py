"""Remembers what is made of an object for as long as the object lives."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import TypeVar
from weakref import WeakKeyDictionary

Key = TypeVar("Key")
Other = TypeVar("Other")
Value = TypeVar("Value")


def weakly_cached(make: Callable[[Key], Value], /) -> Callable[[Key], Value]:
    """`make`, called once for each argument; what it gave is dropped with that argument, to which it must not refer."""
    cached: WeakKeyDictionary[Key, Value] = WeakKeyDictionary()

    @wraps(make)
    def recall(key: Key, /) -> Value:
        if key not in cached:
            cached[key] = make(key)
        return cached[key]

    return recall


def weakly_cached_with(make: Callable[[Other, Key], Value], /) -> Callable[[Other, Key], Value]:
    """The same of the second of two arguments, such as a face on a space; made anew where the first one is another."""
    cached: WeakKeyDictionary[Key, tuple[Other, Value]] = WeakKeyDictionary()

    @wraps(make)
    def recall(other: Other, key: Key, /) -> Value:
        entry = cached.get(key)
        if entry is None or entry[0] is not other:
            entry = cached[key] = (other, make(other, key))
        return entry[1]

    return recall
