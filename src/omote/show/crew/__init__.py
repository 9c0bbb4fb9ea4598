"""Who is connected to a show, and whose hands move what."""
