"""Who performs: the service over HTTP, or a local install by its command; and what they answer."""
