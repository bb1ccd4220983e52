"""Learns a profile from annotations (NGS §3.2)."""
