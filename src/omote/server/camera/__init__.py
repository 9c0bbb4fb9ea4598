"""Performers' cameras: the links of camera pages, and a performer's own machine that passes them on."""
