"""Who is connected to a show."""
