"""People whose true expressions are known, and how far maps are from them."""
