"""From answers to the papers' tables: read (`tables`, `answers`), computed (`ratings`, `choices`), shown (`report`)."""
