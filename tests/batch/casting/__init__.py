"""Who performs, who listens, whose voice is learnt."""
