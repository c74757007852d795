"""Readers for Fountain, Final Draft and prose; the text the user wrote is never rewritten."""
