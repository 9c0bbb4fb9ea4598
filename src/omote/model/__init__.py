"""The method's objects, frozen and validated once when they are made."""
