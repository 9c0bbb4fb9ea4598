"""Makes the heads of the built-in cast from the pinned CC0 package."""
