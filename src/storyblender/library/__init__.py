"""What the studio already owns: assets on disk, and the body data it fetches once."""
