"""Who answers for the crew: language models, people who answer files in a folder, and recordings of both."""
