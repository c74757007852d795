"""Services that assets come from: one module each, which knows its wire format and nothing of stories."""
