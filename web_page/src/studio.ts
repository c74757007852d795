/** The studio: what is open, what is selected, and which view shows it. */

import { LitElement, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import "./assets_view";
import "./board_view";
import "./crew_view";
import "./cut_view";
import "./deliver_view";
import "./library_view";
import "./link_dialog";
import "./message_bar";
import "./pull_view";
import "./revise_view";
import "./set_view";
import "./shot_inspector";
import "./stage_view";
import "./start_view";
import type { Said } from "./message_bar";
import type { Take } from "./own_model";
import type { Board, CrewEvent, Edit, News, Places, Pulled, Status } from "./messages";
import { Wire } from "./wire";

const EVENTS_SHOWN = 400;
const ALSO = "Also changed: ";
/** The views of a made project, in the order of their buttons. */
const VIEWS = {
  board: "Board",
  stage: "Stage",
  assets: "Cast and assets",
  library: "Library",
  set: "Set and light",
  cut: "Cut",
  revise: "Revised script",
  deliver: "Deliver",
};
/** The views that have the inspector of the selected shot beside them. */
const WITH_INSPECTOR: View[] = ["board", "stage"];
/** The view of what was saved in Blender has its button in the line that says so. */
type View = keyof typeof VIEWS | "pull";

/** What edits came to, and what a person should know of it. */
interface Applied {
  words: string;
  warnings: string[];
}

function told(done: Applied): string {
  return [done.words, ...done.warnings].join(". ");
}

@customElement("sb-studio")
export class Studio extends LitElement {
  @state() private board: Board | null = null;
  @state() private places: Places | null = null;
  @state() private status: Status | null = null;
  @state() private selected: string[] = [];
  /** The person or thing that was looked at last. */
  private asset = "";
  @state() private view: View = "board";
  @state() private events: CrewEvent[] = [];
  @state() private said: Said | null = null;
  @state() private connected = true;
  /** What was saved in Blender and is not taken over, in a sentence. */
  @state() private blender = "";
  /** Whether that sentence was put away; the next save brings it back. */
  @state() private blenderRead = false;
  /** What the person has seen: the board's revision, or what their last edit came to. */
  private revision = "";
  private edited: Promise<unknown> = Promise.resolve();
  private high = new ResizeObserver(([header]) =>
    document.documentElement.style.setProperty("--top", `${header.borderBoxSize[0].blockSize}px`),
  );
  private wire = new Wire(
    (news) => this.hear(news),
    () => this.joined(),
    () => (this.connected = false),
  );

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  connectedCallback(): void {
    super.connectedCallback();
    document.addEventListener("keydown", this.keys);
    document.addEventListener("pointerdown", this.read, { capture: true });
    window.addEventListener("focus", () => void this.lookAtBlender());
  }

  protected firstUpdated(): void {
    this.high.observe(this.querySelector("header")!);
  }

  /** What was done is read once the next thing is begun; what could not be done stays until it is dismissed. */
  private read = (event: Event): void => {
    if (this.said && !this.said.wrong && !(event.target as HTMLElement).closest(".messages")) this.said = null;
  };

  private keys = (event: KeyboardEvent): void => {
    const typing = (event.target as HTMLElement).closest("input, textarea, select");
    if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "z" && !typing) {
      event.preventDefault();
      void this.step(event.shiftKey ? "redo" : "undo");
    } else if (event.key === "/" && !typing) {
      event.preventDefault();
      this.querySelector<HTMLInputElement>("#say")?.focus();
    } else if (event.key === "Escape") {
      if (typing) (event.target as HTMLElement).blur();
      else if (this.view !== "board") this.view = "board";
      else this.selected = [];
    }
  };

  private async joined(): Promise<void> {
    this.connected = true;
    this.places = await this.wire.call<Places>("places");
    this.status = this.places.status;
    await this.look();
    await this.lookAtBlender();
  }

  /** Ask for the board; where no project is open there is none. */
  private async look(): Promise<void> {
    try {
      this.board = await this.wire.call<Board>("board");
      this.revision = this.board.revision;
      document.title = `${this.board.title} - StoryBlender`;
      const shots = new Set(this.board.scenes.flatMap((scene) => scene.shots.map((shot) => shot.shot)));
      this.selected = this.selected.filter((name) => shots.has(name));
    } catch {
      this.board = null;
    }
  }

  private hear(news: News): void {
    if (news.news === "blender") {
      this.blenderRead = false;
      void this.lookAtBlender();
    }
    if (news.news === "status" && news.status) this.status = news.status;
    if (news.news === "event" && news.event) this.events = [...this.events, news.event].slice(-EVENTS_SHOWN);
    if (news.news === "event" && news.event?.role === "frames" && news.event.kind === "warning")
      this.say(news.event.message ?? "", true);
    if (news.news === "event" && news.event?.kind === "follow") this.sayFollowed(news.event);
    if (news.news === "board" || news.news === "frames" || (news.event?.role === "frames" && this.status?.busy))
      void this.look();
  }

  /** Ask whether story.blend was saved in Blender, or whether changes there wait for a choice. */
  private async lookAtBlender(): Promise<void> {
    if (!this.board?.made || this.making) return;
    const found = await this.wire.call<{ saved: string[]; conflicts: number }>("blender").catch(() => null);
    if (!found) return;
    this.blender = found.saved.length
      ? `${found.saved.join(", ")} was saved in Blender. It is not written anew before you take that over.`
      : found.conflicts
        ? `${found.conflicts === 1 ? "One change" : `${found.conflicts} changes`} in Blender and here: choose which stands.`
        : "";
  }

  private takeOver(choice: object): Promise<boolean> {
    return this.attempt(async () => {
      const done = await this.wire.call<Pulled>("take_over", choice);
      this.view = "board";
      await this.lookAtBlender();
      const changes = done.understood.length;
      const taken = changes ? `${changes === 1 ? "One change is" : `${changes} changes are`} taken over from Blender` : "";
      if (done.kept.length)
        throw new Error(`${taken ? `${taken}; but not this` : "Not taken over from Blender"}: ${done.kept.join("; ")}. A dated copy of the file has it`);
      return taken || "Nothing was to be taken over";
    });
  }

  private say(text: string, wrong = false): void {
    this.said = text ? { text, wrong } : null;
  }

  /** Add to what was said of an edit that a shot which nobody edited changed in consequence. */
  private sayFollowed(event: CrewEvent): void {
    const before = this.said && !this.said.wrong ? this.said.text : "";
    const how = before.includes(ALSO) ? "; " : before ? `. ${ALSO}` : ALSO;
    this.say(`${before}${how}${event.subject} ${event.message}`);
  }

  /** Do something, and show the studio's sentence if it cannot be done. */
  private async attempt(work: () => Promise<string>): Promise<boolean> {
    try {
      this.say(await work());
      return true;
    } catch (error) {
      this.say((error as Error).message, true);
      return false;
    }
  }

  private step(way: "undo" | "redo"): Promise<boolean> {
    const done = way === "undo" ? "Undone" : "Done again";
    return this.attempt(async () => `${done}: ${(await this.wire.call<{ done: string }>(way)).done}`);
  }

  /** Make edits, after those that are under way: what follows a gesture at once is made on what that came to. */
  private edit(edits: Edit[]): Promise<boolean> {
    return this.call("apply", { edits });
  }

  /** Make an edit by a call of its own. */
  private call(name: "apply" | "panorama" | "surface" | Take["name"], detail: object): Promise<boolean> {
    const made = this.edited.then(() =>
      this.attempt(async () => {
        const done = await this.wire.call<Applied & { version: string }>(name, { ...detail, revision: this.revision });
        this.revision = done.version;
        return told(done);
      }),
    );
    this.edited = made;
    return made;
  }

  private instruct(event: SubmitEvent): void {
    event.preventDefault();
    const field = (event.target as HTMLFormElement).querySelector<HTMLInputElement>("#say")!;
    const words = field.value.trim();
    if (!words || !this.board) return;
    const about = words.includes(":") ? "" : `${this.selected.join(", ")}: `;
    void this.attempt(async () => {
      const done = await this.wire.call<Applied>("instruct", { words: about + words, revision: this.revision });
      field.value = "";
      return told(done);
    });
  }

  /** Begin long work: ``make`` of a script, ``revise`` by another version of it, or what was stopped. */
  private begin(call: "make" | "revise" | "go_on", detail: object): Promise<boolean> {
    this.events = [];
    this.selected = [];
    return this.attempt(async () => {
      this.status = await this.wire.call<Status>(call, detail);
      this.view = "board";
      return "";
    });
  }

  render() {
    return html`
      <header>
        <button class="home" @click=${() => this.leave()} title="Scripts and projects">StoryBlender</button>
        <h1>${this.board?.title || "Storyboards"}</h1>${this.board ? html`<span class="summary">${this.board.summary}</span>` : nothing}
        <span class="space"></span>
        ${this.board?.made && !this.making ? this.tools(this.board) : nothing}
        <sb-link .wire=${this.wire}></sb-link>
      </header>
      <div class="messages">
        ${this.connected ? nothing : html`<p class="bar wrong" role="alert">The studio does not answer. Start it again; nothing is lost.</p>`}
        ${this.said
          ? html`<sb-message .said=${this.said} @dismiss=${() => this.say("")}></sb-message>`
          : nothing}
        ${this.board ? this.unfinished(this.board) : nothing}
        ${this.blender && !this.blenderRead && this.view !== "pull" && this.board?.made && !this.making
          ? html`<p class="bar" role="status">${this.blender} <button @click=${() => (this.view = "pull")}>Look at it</button>
              <button @click=${() => this.takeOver({})}>Take over</button>
              <button class="quiet" aria-label="Put this away" @click=${() => (this.blenderRead = true)}>×</button></p>`
          : nothing}
      </div>
      <main>${this.main()}</main>
    `;
  }

  private show(view: View): void {
    if (view === "stage" && !this.selected.length) this.selected = [this.board!.scenes[0].shots[0].shot];
    if (view === "assets") this.selected = [];
    this.view = view;
    if (view === "stage") this.querySelector<HTMLElement>("sb-stage canvas")?.focus();
  }

  private tools(board: Board) {
    return html`
      <nav aria-label="Views">${(Object.keys(VIEWS) as (keyof typeof VIEWS)[]).map((view) => html`<button class=${this.view === view ? "chosen" : ""}
        aria-current=${this.view === view ? "page" : nothing} @click=${() => this.show(view)}>${VIEWS[view]}</button>`)}</nav>
      <form class="say" @submit=${(event: SubmitEvent) => this.instruct(event)}>
        <input id="say" aria-label="Say it" autocomplete="off" ?disabled=${!this.selected.length}
          placeholder=${this.selected.length ? `${this.selected.join(", ")}: closer, low angle ...` : "Select a shot, then say what you want"} />
      </form>
      <button @click=${() => this.step("undo")} ?disabled=${!board.undo} title=${board.undo || "Nothing to undo"}>Undo</button>
      <button @click=${() => this.step("redo")} ?disabled=${!board.redo} title=${board.redo || "Nothing to redo"}>Redo</button>
    `;
  }

  private main() {
    if (this.making || (this.status?.error && !this.board?.scenes.length)) {
      return html`<sb-crew .events=${this.events} .status=${this.status} .board=${this.board}
        @stop=${() => this.stop()} @go-on=${() => this.begin("go_on", {})} @back=${() => this.leave()}></sb-crew>`;
    }
    if (!this.board) {
      return html`<sb-start .places=${this.places}
        @make=${(event: CustomEvent) => this.begin("make", event.detail)}
        @open=${(event: CustomEvent<string>) =>
          this.attempt(async () => ((this.board = await this.wire.call<Board>("open", { project: event.detail })), ""))}></sb-start>`;
    }
    return html`
      ${this.shown(this.board)}
      ${this.selected.length === 1 && WITH_INSPECTOR.includes(this.view)
        ? html`<sb-shot .board=${this.board} .shot=${this.selected[0]} .wire=${this.wire}
            @edit=${(event: CustomEvent<Edit[]>) => this.edit(event.detail)}
            @close=${() => ((this.selected = []), (this.view = "board"))}></sb-shot>`
        : nothing}
    `;
  }

  /** Whether the crew works on the story; while something is written that is delivered, every view stays. */
  private get making(): boolean {
    return !!this.status?.busy && !this.status.work.startsWith("write ");
  }

  private stop(): Promise<boolean> {
    return this.attempt(async () => (await this.wire.call("cancel"), ""));
  }

  /** Where work was stopped, or has failed: what became of it, and a button to go on. */
  private unfinished(board: Board) {
    const { busy, error, work } = this.status ?? {};
    if (busy || !board.scenes.length || (board.made && !error)) return nothing;
    const writing = work?.startsWith("write ");
    return html`<p class="bar" role="status">${error || "This storyboard is not finished."}
      ${writing ? nothing : html`<button @click=${() => this.begin("go_on", {})}>Go on</button>`}</p>`;
  }

  /** The view that is chosen. */
  private shown(board: Board) {
    // Fields send an event of the same name when their text is selected.
    const select = (event: CustomEvent<string[]>) => Array.isArray(event.detail) && (this.selected = event.detail);
    switch (this.view) {
      case "stage":
        if (!this.selected.length) break;
        return html`<sb-stage .board=${board} .shot=${this.selected[0]} .wire=${this.wire}
          @edit=${(event: CustomEvent<{ edits: Edit[]; settled: (done: boolean) => void }>) =>
            this.edit(event.detail.edits).then(event.detail.settled)}
          @select=${select}></sb-stage>`;
      case "assets":
        return html`<sb-assets .board=${board} .wire=${this.wire} .chosen=${this.asset} @chose=${(event: CustomEvent<string>) => (this.asset = event.detail)} @edit=${(event: CustomEvent<Edit[]>) => this.edit(event.detail)}
          @take=${(event: CustomEvent<Take>) => this.call(event.detail.name, event.detail.call).then(event.detail.settled)}
          @goto=${(event: CustomEvent<string>) => ([this.selected, this.view] = [[event.detail], "board"])}></sb-assets>`;
      case "library":
        return html`<sb-library .wire=${this.wire}></sb-library>`;
      case "set":
        return html`<sb-set .board=${board} .selected=${this.selected} .wire=${this.wire} @select=${select}
          @edit=${(event: CustomEvent<Edit[]>) => this.edit(event.detail)}
          @panorama=${(event: CustomEvent<object>) => this.call("panorama", event.detail)}
          @surface=${(event: CustomEvent<object>) => this.call("surface", event.detail)}></sb-set>`;
      case "cut":
        return html`<sb-cut .board=${board} .selected=${this.selected} .wire=${this.wire} @select=${select}
          @goto=${() => (this.view = "board")} @refuse=${(event: CustomEvent<string>) => this.say(event.detail, true)}
          @edit=${(event: CustomEvent<{ edits: Edit[]; settled: (done: boolean) => void }>) =>
            this.edit(event.detail.edits).then(event.detail.settled)}></sb-cut>`;
      case "deliver":
        return html`<sb-deliver .board=${board} .status=${this.status} .blender=${this.blender} .wire=${this.wire} @stop=${() => this.stop()}
          @write=${(event: CustomEvent<object>) =>
            this.attempt(async () => ((this.status = await this.wire.call<Status>("write", event.detail)), ""))}></sb-deliver>`;
      case "pull":
        return html`<sb-pull .wire=${this.wire} @take-over=${(event: CustomEvent<object>) => this.takeOver(event.detail)}></sb-pull>`;
      case "revise":
        return html`<sb-revise .wire=${this.wire} @revise=${(event: CustomEvent<object>) => this.begin("revise", event.detail)}></sb-revise>`;
    }
    return html`<sb-board .board=${board} .selected=${this.selected} @select=${select}
      @edit=${(event: CustomEvent<Edit[]>) => this.edit(event.detail)}></sb-board>`;
  }

  private async leave(): Promise<void> {
    this.board = null;
    this.status = null;
    this.selected = [];
    this.said = null;
    this.places = await this.wire.call<Places>("places");
    document.title = "StoryBlender";
  }
}
