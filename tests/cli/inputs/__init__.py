"""What commands read: mistakes that are told before anything large is loaded."""
