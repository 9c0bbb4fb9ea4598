/** What hands hold of a character, apart from what sources and calls make of it. */

import type { CharacterState, HeldState } from "../../link/messages";

/** Channels, head and gaze as the faders stand: what is on air, unless layers mix it with what sources send. */
export function handsOf(state: CharacterState): HeldState {
  return state.held ?? state;
}
