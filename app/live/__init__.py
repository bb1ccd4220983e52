"""Live speech: sound in, behaviours and frames out, before the line has ended. Begin with `session`."""
