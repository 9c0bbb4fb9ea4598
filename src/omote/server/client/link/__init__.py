"""The link of a program to a running show."""
