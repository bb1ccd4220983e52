"""Tests of `understudy.behavior.slots`."""
