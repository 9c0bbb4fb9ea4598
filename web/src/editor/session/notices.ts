/** Sentences that stay until they are read. */

/** `actions`: what can be done about it. */
export interface EditorNotice {
  readonly id: number;
  readonly text: string;
  readonly kind: "refusal" | "conflict" | "done";
  readonly actions: readonly { readonly label: string; readonly act: () => void }[];
}

export class EditorNotices {
  /** The newest first: where many do not fit, it is what is seen. */
  all: readonly EditorNotice[] = [];
  #said = 0;

  /** Says a sentence; the same one again takes the place of the former, and good news that of other good news. */
  say(text: string, kind: EditorNotice["kind"], actions: EditorNotice["actions"]): void {
    this.#said += 1;
    const others = this.all.filter((notice) => notice.text !== text && !(kind === "done" && notice.kind === "done"));
    this.all = [{ id: this.#said, text, kind, actions }, ...others];
  }

  /** What of a kind was said is over. */
  clear(kind: EditorNotice["kind"]): void {
    this.all = this.all.filter((notice) => notice.kind !== kind);
  }

  dismiss(id: number): void {
    this.all = this.all.filter((notice) => notice.id !== id);
  }
}
