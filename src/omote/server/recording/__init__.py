"""The recording of a show on the disk, and its replay."""
