"""How soon the studio answers: Chromium against a service of its own."""
