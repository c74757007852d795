"""The crew. A role is one room; its policies and critic depend on the graph and on ports, never on adapters."""
