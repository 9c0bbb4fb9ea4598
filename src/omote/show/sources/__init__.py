"""Sources of a session: what sends values all the time, whom it drives, and by what measure it is read."""
