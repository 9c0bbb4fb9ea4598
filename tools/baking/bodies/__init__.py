"""Makes the bodies of the built-in cast from the pinned CC0 package, one mesh with its heads."""
