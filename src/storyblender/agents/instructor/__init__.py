"""The Instructor: a person's words about a finished storyboard become typed edits."""
