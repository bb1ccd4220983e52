"""Speakers' profiles: annotations in, profiles learnt, mixed and written. Imports `understudy.profiles`."""
