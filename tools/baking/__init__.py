"""The steps that turn the pinned CC0 package into the built-in cast (src/omote/builtin)."""
