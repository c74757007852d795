/** A field for a number that may lie between its steps. */

import { html } from "lit";

/**
 * @param now What is there; a number that cannot be is put back to it.
 * @param changed Hears of another number.
 */
export function numberField(label: string, now: number, changed: (value: number) => void, step: number, least: number, most: number, unit = "") {
  return html`<label>${label} <input type="number" step=${step} min=${least} max=${most} .value=${String(now)}
    @change=${(event: Event) => {
      const field = event.target as HTMLInputElement;
      const { badInput, rangeOverflow, rangeUnderflow } = field.validity;
      if (field.value && !badInput && !rangeOverflow && !rangeUnderflow) changed(Number(field.value));
      else field.value = String(now);
    }} />${unit}</label>`;
}
