"""Processes: forking, priority, and the messages between supervisor, standby and show process."""
