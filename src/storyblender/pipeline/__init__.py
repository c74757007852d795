"""The paper's three stages, resumable: ground -> materialize -> stage, then shoot and deliver."""
