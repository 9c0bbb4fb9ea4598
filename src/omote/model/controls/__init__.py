"""The controls of an author: control net, muscles, tangents and the inverse solve of a drag."""
