"""What is said, as text: `transcript.py` splits it into words; the others read marks of how it is to be spoken and what
they mean: *words* that are emphasized, and the tags of SSML, APML and our own. Imports only the ground floor."""
