"""What commands tell and draw: the picture of an analysis."""
