"""From annotation to profile (NGS §3.2)."""
