"""The paper's nouns: frozen, checked once when they are made."""
