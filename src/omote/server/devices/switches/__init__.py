"""What is switched on and off while a show runs: trackers, and receivers of faces."""
