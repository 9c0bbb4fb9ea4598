"""Keeps lids and the lining of the sockets where they belong around the eyeballs."""
