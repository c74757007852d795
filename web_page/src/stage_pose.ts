/** How a person on the stage stands or sits, what they look at and hold, as the shot begins or as it ends. */

import { LitElement, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import "./stage_motion";
import type { Edit } from "./messages";
import type { Stage } from "./stage_values";
import type { Wire } from "./wire";

type When = "start" | "end";
const POSTURES: Record<string, string> = { stand: "Stand", sit: "Sit", lie: "Lie", kneel: "Kneel", crouch: "Crouch", lean: "Lean" };
const WAYS: Record<string, string> = { left: "to the left", right: "to the right", up: "up", down: "down", camera: "into the camera" };

@customElement("sb-pose")
export class StagePose extends LitElement {
  @property({ attribute: false }) stage!: Stage;
  @property({ attribute: false }) person = "";
  /** The moment that is shown, from the start of the shot. */
  @property({ type: Number }) frame = 0;
  @property({ attribute: false }) wire!: Wire;
  @state() private when: When = "start";
  @state() private motions: Record<string, string> = {};
  @state() private ownMotions: Record<string, string> = {};

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  async connectedCallback(): Promise<void> {
    super.connectedCallback();
    const { motions, own_motions } = await this.wire.call<Record<"motions" | "own_motions", Record<string, string>>>("vocabulary");
    [this.motions, this.ownMotions] = [motions, own_motions];
  }

  private decide(place: Record<string, unknown>): void {
    this.mark({ [this.when]: place });
  }

  private mark(marks: Record<string, unknown>): void {
    const edit: Edit = { kind: "blocking", shot: this.stage.shot, person: this.person, marks };
    this.dispatchEvent(new CustomEvent("pose", { detail: edit }));
  }

  /** A motion is added from the moment that is shown. */
  private does(motion: string): void {
    const at = Math.round((this.frame / this.stage.fps) * 100) / 100;
    this.mark({ motions: { [motion]: { at } } });
  }

  /** A labelled list of choices; what is shown first stands for what is as it is. */
  private choice(label: string, now: string, names: Record<string, string>, chosen: (key: string) => void) {
    return html`<label>${label} <select @change=${(event: Event) => chosen((event.target as HTMLSelectElement).value)}>
      ${now in names ? nothing : html`<option value=${now} selected disabled>${now || "as the crew has it"}</option>`}
      ${Object.entries(names).map(([key, name]) => html`<option value=${key} ?selected=${key === now}>${name}</option>`)}
    </select></label>`;
  }

  render() {
    const person = this.stage.people[this.person];
    if (!person) return nothing;
    const { posture, on, holding, looking_at } = this.when === "start" ? person.start_pose : person.end_pose;
    const { sit, lie, hold, look } = this.stage.poses;
    const others = Object.fromEntries(Object.entries(look).filter(([id]) => id !== this.person));
    const carries = posture === "sit" ? sit : posture === "lie" ? lie : null;
    return html`<div class="bar pose" role="group" aria-label="Pose of ${person.name}">
      ${this.choice("As the shot", this.when, { start: "begins", end: "ends" }, (key) => (this.when = key as When))}
      ${this.choice("Posture", posture, POSTURES, (key) => this.decide({ posture: key }))}
      ${carries ? this.choice("On", on, carries, (key) => this.decide({ posture, on: key })) : nothing}
      ${this.choice("Looks", looking_at, { ...others, ...WAYS }, (key) => this.decide({ looking_at: key }))}
      ${this.choice("Holds", holding[0] ?? "nothing", { nothing: "nothing", ...hold }, (key) => this.decide({ holding: key === "nothing" ? [] : [key] }))}
      <sb-motion .own=${this.ownMotions} .motions=${this.motions} @motion=${(event: CustomEvent<string>) => this.does(event.detail)}></sb-motion>
    </div>`;
  }
}
