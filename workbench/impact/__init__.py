"""Impact pressure from entry velocity and relative angle."""
