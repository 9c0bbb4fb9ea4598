"""Every message of an editor's link, its encoding and validation, and the orders to the workshop."""
