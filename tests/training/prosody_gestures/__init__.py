"""Reading others' recordings with motion, and learning from them."""
