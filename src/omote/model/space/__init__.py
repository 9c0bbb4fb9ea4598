"""The parameter space S, the faces and expressions defined on it, and how a face is fitted to it."""
