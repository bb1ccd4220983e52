"""Head and eyes: how much they move, the way a head goes, and looking and pointing at targets."""
