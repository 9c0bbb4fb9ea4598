/** Which cues call a clip. */

import type { Cue, CueListDocument } from "../../link/messages";

/** The cues of some lists that call a clip, in words; of a list that cannot be read none. */
export async function findCallers(clip: string, lists: readonly string[], request: typeof fetch): Promise<string[]> {
  const calls = ({ moves }: Cue): boolean =>
    Object.entries(moves).some(([part, { goal }]) => part.endsWith("/clip") && Object.hasOwn(goal, clip));
  const found = lists.map(async (list) => {
    try {
      const answer = await request(`/cue_lists/${encodeURIComponent(list)}`, { cache: "no-store" });
      const { cues } = (answer.status === 200 ? await answer.json() : { cues: [] }) as Pick<CueListDocument, "cues">;
      return cues.filter(calls).map(({ number }) => `cue ${number}${lists.length > 1 ? ` of ${list}` : ""}`);
    } catch {
      return [];
    }
  });
  return (await Promise.all(found)).flat();
}
