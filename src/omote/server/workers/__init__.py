"""Computes beside the show: the worker process, its orders and their schedule."""
