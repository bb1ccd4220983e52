"""Live speech: agreement with the analysis of recordings, and cost."""
