"""Speech that still goes on: sound in, what the body does out, before the line has ended.

`voice` hears, `events` tells.
"""
