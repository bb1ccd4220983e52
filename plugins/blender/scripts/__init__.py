"""Scripts of lines: voice-over sheets, subtitles and screenplays, and the recordings that belong to them."""
