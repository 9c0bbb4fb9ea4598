"""The reference of the public Python names."""

import inspect
from functools import cached_property

import omote
from tools.website.python_reference import GROUPS, python_page, section_of, signature_of


def example(cast: "omote.Cast", *, size: tuple[int, int] = (1, 2), **others: str) -> "omote.Face":
    """Gives a face.

    Parameters
    ----------
    cast : Cast
        Where it
        is from.

    Examples
    --------
    >>> 1 + 1
    2
    """
    raise NotImplementedError


def test_every_public_name_is_on_the_page_once() -> None:
    named = [name for names in GROUPS.values() for name in names]
    assert sorted(named) == sorted(omote.__all__)
    page = python_page()
    for name in named:
        assert page.count(f"### `omote.{name}`") == 1
        value = getattr(omote, name)
        methods = inspect.getmembers(value, inspect.isroutine) if inspect.isclass(value) else []
        for method, _ in methods:
            if isinstance(inspect.getattr_static(value, method), cached_property):
                continue  # read as an attribute
            assert method.startswith("_") or f"#### `{name}.{method}`" in page


def test_a_section_has_the_signature_and_all_of_the_docstring() -> None:
    text = section_of("omote.example", example, depth=3)
    assert signature_of("f", example).startswith("f(cast: omote.Cast, *, size: ")
    assert signature_of("f", example).endswith("= (1, 2), **others: str) -> omote.Face")
    assert "* `cast` (Cast): Where it is from." in text
    assert "```pycon\n>>> 1 + 1\n2\n```" in text
