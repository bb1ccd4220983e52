"""Motions, gestures and files of motion that tests make and read."""
