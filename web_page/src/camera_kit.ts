/** Lenses and apertures that a camera can have. */

import type { Board } from "./messages";

const USUAL = [18, 24, 28, 35, 40, 50, 65, 85, 100, 135];
/** Full stops; with the last nearly everything is sharp. */
export const STOPS = [1.4, 2, 2.8, 4, 5.6, 8, 11, 16, 22, 32];

/** The lenses of the project's kit, mm; the usual ones where it allows any. */
export function lensesOf(board: Board): number[] {
  return board.lens_kit.length ? board.lens_kit : USUAL;
}
