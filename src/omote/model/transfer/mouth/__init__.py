"""How an expression reaches a face: the stages of a compound, their inverse, and correctives of combinations."""
