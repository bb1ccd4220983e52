"""Scores a study: reads the answers (`tables`, `reading`), computes the statistics of each comparison (`ratings`,
`choices`, `preferences`, `recognition`, with the tests of `samples`), and formats them as tables (`report`)."""
