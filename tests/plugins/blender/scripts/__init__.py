"""Scripts as the extension reads them."""
