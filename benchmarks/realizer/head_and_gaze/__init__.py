"""Head and eyes: amount of movement, length of head paths, looking and pointing at targets."""
