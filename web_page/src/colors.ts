/** Scene-linear colours as the browser's colour fields have them. */

/** A scene-linear colour as the browser writes it; what is brighter than white is shown as its hue. */
export function hex(color: number[]): string {
  const most = Math.max(1, ...color);
  const parts = color.map((part) => Math.round(255 * (part / most) ** (1 / 2.2)));
  return `#${parts.map((part) => part.toString(16).padStart(2, "0")).join("")}`;
}

export function linear(color: string): number[] {
  return [1, 3, 5].map((at) => Math.round((parseInt(color.slice(at, at + 2), 16) / 255) ** 2.2 * 10000) / 10000);
}
