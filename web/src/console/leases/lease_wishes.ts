/** Who wants what others hold, as the show tells it: what stands in the bar until somebody answers. */

import type { Leases, LeaseWish, SeatState } from "../../link/messages";
import { heldByOthers } from "./held_parts";

/** Parts that a seat wants, the longest wish's seconds. */
export interface Wish {
  readonly by: SeatState;
  readonly parts: readonly string[];
  readonly seconds: number;
}

/** What other seats want of this one's, whoever waits longest first. */
export function askedHere(leases: Leases): readonly Wish[] {
  const others = leases.wishes.filter(({ by, part }) => by !== leases.you && isHeldHere(leases, part));
  const wishes = leases.seats.map((by) => wishOf(by, others)).filter(({ parts }) => parts.length > 0);
  return wishes.sort((wish, other) => other.seconds - wish.seconds);
}

/** What this seat wants of others'; null for nothing. */
export function wantedHere(leases: Leases): Wish | null {
  const seat = leases.seats.find(({ number }) => number === leases.you);
  const wish = seat === undefined ? null : wishOf(seat, leases.wishes);
  return wish === null || wish.parts.length === 0 ? null : wish;
}

/** Who wants a part. */
export const wanting = (leases: Leases, key: string): readonly Wish[] =>
  leases.seats
    .map((by) =>
      wishOf(
        by,
        leases.wishes.filter(({ part }) => part === key),
      ),
    )
    .filter(({ parts }) => parts.length > 0);

/** A time in words: `12 s`, `3 min`. */
export const waited = (seconds: number): string => (seconds < 120 ? `${seconds} s` : `${Math.floor(seconds / 60)} min`);

function wishOf(by: SeatState, wishes: readonly LeaseWish[]): Wish {
  const own = wishes.filter((wish) => wish.by === by.number);
  return { by, parts: own.map(({ part }) => part), seconds: Math.max(0, ...own.map(({ seconds }) => seconds)) };
}

/** Whether this seat holds a part, or the expression whose region it is. */
const isHeldHere = (leases: Leases, key: string): boolean =>
  heldByOthers(leases, [key]).size === 0 && heldByOthers({ ...leases, you: -1 }, [key]).size > 0;
