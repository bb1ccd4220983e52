"""Shows what the words of a gesture say of size, number and place, its slots, in metres and degrees."""
