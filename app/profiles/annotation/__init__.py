"""What people marked in a recording of a speaker: words, tags, phases, phrases, units, and what head and eyes do."""
