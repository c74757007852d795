/** Colours between the browser, which writes them as a screen shows them, and the story, which keeps them scene-linear. */

/** A scene-linear colour as the browser writes it; what is brighter than white is shown as its hue. */
export function hex(color: number[]): string {
  const most = Math.max(1, ...color);
  const parts = color.map((part) => Math.round(255 * encoded(part / most)));
  return `#${parts.map((part) => part.toString(16).padStart(2, "0")).join("")}`;
}

/** A colour of the browser, scene-linear. */
export function linear(color: string): number[] {
  return [1, 3, 5].map((at) => Math.round(decoded(parseInt(color.slice(at, at + 2), 16) / 255) * 1e5) / 1e5);
}

function encoded(value: number): number {
  return value <= 0.0031308 ? value * 12.92 : 1.055 * value ** (1 / 2.4) - 0.055;
}

function decoded(value: number): number {
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}
