"""Sets built from a SetPlan."""
