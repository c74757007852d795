/** The wire to the studio: calls with their answers, news for all, and a new connection when one breaks. */

import type { News } from "./messages";

interface Answer {
  id: number;
  ok: boolean;
  value: unknown;
  error: string;
}

type Waiting = { done: (value: any) => void; failed: (error: Error) => void };

export class Wire {
  private socket!: WebSocket;
  private number = 0;
  private waiting = new Map<number, Waiting>();
  private ready!: Promise<void>;

  /**
   * @param news Hears what changed.
   * @param joined Hears of each new connection; what is shown may be old then.
   * @param lost Hears that the connection broke.
   */
  constructor(
    private news: (news: News) => void,
    private joined: () => void,
    private lost: () => void,
  ) {
    this.connect();
  }

  /** Make a call; rejects with the studio's sentence if it cannot be done. */
  async call<T>(call: string, values: object = {}): Promise<T> {
    await this.ready;
    const id = ++this.number;
    return new Promise<T>((done, failed) => {
      this.waiting.set(id, { done, failed });
      this.socket.send(JSON.stringify({ id, call, ...values }));
    });
  }

  private connect(): void {
    this.socket = new WebSocket(`ws://${location.host}/wire`);
    this.ready = new Promise((open) => this.socket.addEventListener("open", () => open(), { once: true }));
    this.socket.onopen = () => this.joined();
    this.socket.onmessage = (message) => this.hear(JSON.parse(message.data));
    this.socket.onclose = () => {
      for (const call of this.waiting.values()) call.failed(new Error("the connection to the studio broke"));
      this.waiting.clear();
      this.lost();
      setTimeout(() => this.connect(), 1000);
    };
  }

  private hear(message: News | Answer): void {
    if ("news" in message) {
      this.news(message);
      return;
    }
    const call = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (message.ok) call?.done(message.value);
    else call?.failed(new Error(message.error));
  }
}
