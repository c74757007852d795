"""Scene, camera and light plan to pictures: Workbench passes, Cycles light, frames, animatic."""
