"""Who owns what: the parts that seats hold and want, and the controls that hands move."""
