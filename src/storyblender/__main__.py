"""``python -m storyblender``: the command line."""

from storyblender.cli import app

if __name__ == "__main__":
    app()
