"""Sockets of devices and programs that play a show."""
