"""The recording, and what is heard in it: contours, words and phones in time, agitation, feeling, the speaker."""
