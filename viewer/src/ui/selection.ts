// What is looked at: a body, a joint, a spring, or nothing.

import type { Body, Link, Recording } from "../recording";

export type Subject =
  | { readonly what: "body"; readonly body: Body }
  | { readonly what: "joint" | "spring"; readonly link: Link };

export class Selection {
  subject: Subject | null = null;
  /** The body that the camera moves with. */
  followed: number | null = null;
  private readonly calls: (() => void)[] = [];

  constructor(private readonly recording: Recording) {}

  /** Number of the selected body, null when none is. */
  get body(): number | null {
    return this.subject?.what === "body" ? this.subject.body.index : null;
  }

  selectBody(index: number | null): void {
    const body = index === null ? undefined : this.recording.bodies[index];
    this.select(body ? { what: "body", body } : null);
  }

  select(subject: Subject | null): void {
    this.subject = subject;
    this.tell();
  }

  /** Follows the selected body, or lets go when something is followed. */
  toggleFollow(): void {
    this.follow(this.followed === null ? this.body : null);
  }

  follow(body: number | null): void {
    this.followed = body;
    this.tell();
  }

  onChange(call: () => void): void {
    this.calls.push(call);
  }

  private tell(): void {
    for (const call of this.calls) call();
  }
}
