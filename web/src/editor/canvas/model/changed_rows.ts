/** Which rows change from one frame to the next: the passes draw only those. */

import type { Fans } from "../../../face/anatomy/topology";
import type { Followers } from "../../session/control_net";

export class ChangedRows {
  private readonly marks: Uint8Array;
  private readonly before: Uint8Array;
  private followers: Followers | null = null;

  constructor(private readonly fans: Fans) {
    const rows = fans.starts.length - 1;
    [this.marks, this.before] = [new Uint8Array(rows), new Uint8Array(rows)];
  }

  setFollowers(followers: Followers | null): void {
    this.followers = followers;
  }

  /** All rows, as lists. */
  get all(): { moved: Uint32Array; turned: Uint32Array } {
    const every = Uint32Array.from(this.marks, (_, row) => row);
    return { moved: every, turned: every };
  }

  /** Rows that fields (V, 4) and offsets (rows, 3) move, what follows them, what moved the time before; and around. */
  after(
    fields: readonly Float32Array[],
    offsets: readonly Float32Array[],
  ): { moved: Uint32Array; turned: Uint32Array } {
    const { marks, before } = this;
    marks.fill(0);
    for (const field of fields)
      for (let at = 0; at < field.length; at += 4)
        if (field[at] !== 0 || field[at + 1] !== 0 || field[at + 2] !== 0) marks[at >> 2] = 1;
    this.markFollowers();
    for (const offset of offsets)
      for (let at = 0, row = 0; at < offset.length; at += 3, row++)
        if (offset[at] !== 0 || offset[at + 1] !== 0 || offset[at + 2] !== 0) marks[row] = 1;
    const moved: number[] = [];
    for (let row = 0; row < marks.length; row++) {
      if (marks[row] === 1 || before[row] === 1) moved.push(row);
      before[row] = marks[row] as number;
    }
    return { moved: new Uint32Array(moved), turned: this.around(moved) };
  }

  private markFollowers(): void {
    if (this.followers === null) return;
    const { rows, anchors, shares, links } = this.followers;
    for (let place = 0; place < rows.length; place++)
      for (let link = place * links; link < (place + 1) * links; link++)
        if (shares[link] !== 0 && this.marks[anchors[link] as number] === 1) {
          this.marks[rows[place] as number] = 1;
          break;
        }
  }

  private around(moved: readonly number[]): Uint32Array {
    const { starts, pairs } = this.fans;
    const near = this.marks.fill(0);
    for (const row of moved) {
      near[row] = 1;
      for (let slot = 2 * (starts[row] as number); slot < 2 * (starts[row + 1] as number); slot++)
        near[pairs[slot] as number] = 1;
    }
    const turned: number[] = [];
    for (let row = 0; row < near.length; row++) if (near[row] === 1) turned.push(row);
    return new Uint32Array(turned);
  }
}
