"""Words, utterances and voices that tests make."""
