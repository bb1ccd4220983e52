"""Manual annotations of a speaker's recording: words, tags, phases, phrases, units, and movements of head and eyes."""
