"""The schemas of gestures: definitions, the gesture language, gesture scripts."""
