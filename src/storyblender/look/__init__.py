"""G-buffer and light list to picture: relight, atmosphere, ink, pencil, grade. Pure numpy."""
