"""The recording of a show: what its session did, entry by entry, and a replay that does it again to the last bit."""
