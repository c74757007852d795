/** A model from the person's disk: dropped here or chosen, sent to the studio, and a thing made from it. */

import { LitElement, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";

/** A call that takes something from outside, and what hears whether it was done. */
export interface Take {
  name: "take_offer" | "take_model";
  call: object;
  settled: (done: boolean) => void;
}

const MODELS = [".glb", ".gltf", ".blend", ".obj", ".fbx", ".stl", ".ply", ".usd", ".usda", ".usdc", ".usdz"];
const PARTS = [".bin", ".mtl", ".png", ".jpg", ".jpeg", ".webp", ".tga", ".bmp", ".tif", ".tiff"];
const MOST_MIB = 256;

@customElement("sb-own-model")
export class OwnModel extends LitElement {
  @property() thing = "";
  @property({ type: Boolean }) locked = false;
  @state() private over = false;
  @state() private doing = "";
  @state() private wrong = "";

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  protected willUpdate(changed: Map<string, unknown>): void {
    if (changed.has("thing")) this.wrong = "";
  }

  /** Send the files one by one, then have the thing made from them. */
  private async take(list: FileList | null | undefined): Promise<void> {
    const files = [...(list ?? [])];
    if (!files.length || this.doing || this.locked) return;
    this.wrong = problem(files);
    if (this.wrong) return;
    const batch = [...crypto.getRandomValues(new Uint8Array(8))].map((byte) => byte.toString(16).padStart(2, "0")).join("");
    const model = files.find((file) => isOne(file, MODELS))!.name;
    try {
      for (const file of files) {
        this.doing = `Taking in ${file.name} ...`;
        const answer = await fetch(`/models/${batch}/${encodeURIComponent(file.name)}`, { method: "POST", body: file });
        if (!answer.ok) throw new Error(await answer.text());
      }
      this.doing = `Reading ${model} ...`;
      const settled = (done: boolean) => ((this.doing = ""), done && this.dispatchEvent(new Event("taken")));
      const detail: Take = { name: "take_model", call: { thing: this.thing, batch }, settled };
      this.dispatchEvent(new CustomEvent("take", { detail, bubbles: true }));
    } catch (error) {
      [this.doing, this.wrong] = ["", error instanceof TypeError ? "the studio cannot be reached" : (error as Error).message];
    }
  }

  render() {
    return html`<label class="drop ${this.over ? "over" : ""}"
      @dragover=${(event: DragEvent) => (event.preventDefault(), (this.over = true))} @dragleave=${() => (this.over = false)}
      @drop=${(event: DragEvent) => (event.preventDefault(), (this.over = false), this.take(event.dataTransfer?.files))}>
      <input type="file" class="unseen" multiple accept=${[...MODELS, ...PARTS].join(",")} ?disabled=${this.locked || this.doing !== ""}
        @change=${(event: Event) => this.chosen(event.target as HTMLInputElement)} />
      <b>${this.doing || "Drop a model from your disk here, or choose it"}</b>
      <small>.glb, .gltf with its files, .blend, .obj, .fbx, .stl, .ply or USD; it is kept in the storyboard</small></label>
      ${this.wrong ? html`<p class="wrong" role="alert">${this.wrong}</p>` : nothing}`;
  }

  private chosen(input: HTMLInputElement): void {
    void this.take(input.files);
    input.value = "";
  }
}

/** What is wrong with files that are to be one model; empty if nothing is seen to be. */
function problem(files: File[]): string {
  const other = files.find((file) => !isOne(file, [...MODELS, ...PARTS]));
  if (other) return `${other.name} is no file of a model; a model ends in ${MODELS.join(", ")}`;
  const models = files.filter((file) => isOne(file, MODELS));
  if (models.length !== 1) return models.length ? "Give one model at a time." : "Give the model too, not only its pictures.";
  const size = files.reduce((sum, file) => sum + file.size, 0);
  return size > MOST_MIB << 20 ? `${models[0].name} is larger than ${MOST_MIB} MiB; make it smaller` : "";
}

function isOne(file: File, endings: string[]): boolean {
  return endings.some((ending) => file.name.toLowerCase().endsWith(ending));
}
