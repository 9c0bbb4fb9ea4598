/** What a page of clips remembers through a reload: the clip and lane that are chosen, what is armed, the count, the speed of passes. */

import { CLIP_PARTS } from "../../link/constants";
import { type BrowserStorage, keep, readKept, readRecord } from "../../ui/browser_storage";
import { PASS_SPEEDS } from "./clip_passes";

type Part = (typeof CLIP_PARTS)[number];

export interface Marks {
  readonly clip: string;
  readonly lane: number;
  readonly armed: readonly Part[];
  readonly countsIn: boolean;
  readonly passSpeed: number;
  readonly character: string;
}

const KEY = "omote clips";

/** The marks of this tab; another tab of the same browser begins with those that were made last in any. */
export class PageMarks {
  /** `browser`: what all tabs share; `tab`: what this one keeps through a reload. */
  constructor(
    private readonly browser: BrowserStorage,
    private readonly tab: BrowserStorage,
  ) {}

  /** What was kept, as far as it can be read. */
  read(): Partial<Marks> {
    const { clip, lane, armed, countsIn, passSpeed, character } = readRecord(
      readKept(this.tab, KEY) || readKept(this.browser, KEY),
    );
    return {
      ...(typeof clip === "string" ? { clip } : {}),
      ...(Number.isSafeInteger(lane) && (lane as number) >= 0 ? { lane: lane as number } : {}),
      ...(Array.isArray(armed) ? { armed: CLIP_PARTS.filter((part) => armed.includes(part)) } : {}),
      ...(typeof countsIn === "boolean" ? { countsIn } : {}),
      ...(PASS_SPEEDS.some((speed) => speed === passSpeed) ? { passSpeed: passSpeed as number } : {}),
      ...(typeof character === "string" ? { character } : {}),
    };
  }

  write(marks: Marks): void {
    for (const storage of [this.tab, this.browser]) keep(storage, KEY, JSON.stringify(marks));
  }
}
