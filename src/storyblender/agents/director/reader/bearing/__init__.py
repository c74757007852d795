"""How people bear themselves meanwhile: faces, eyes, what goes on, how things are carried, who is led."""
