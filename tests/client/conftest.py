"""A show that programs are linked to."""

from tests.server.conftest import show_harness  # noqa: F401
