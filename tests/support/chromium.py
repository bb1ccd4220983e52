"""Debian's Chromium, in which pages are tested where it is installed."""

import shutil

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
