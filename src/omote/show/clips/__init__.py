"""The clips of a show: kept, edited, recorded while others play."""
