/** What can be carried in and out of a show file, as commands for a terminal. */

import type { ItemDocument } from "../../link/editing_messages";

export interface CliHint {
  readonly what: string;
  readonly command: string;
}

const FILE = "SHOW.omote";

/** The commands for an item, with the face under work; all names are slugs, so nothing needs quotes. */
export function cliHintsOf({ kind, name }: Pick<ItemDocument, "kind" | "name">, work: string): CliHint[] {
  if (kind === "face")
    return [
      {
        what: "This face with the 52 ARKit shapes, for Blender, three.js or a game engine (GLB)",
        command: `omote export ${name} -o ${name}.glb --show ${FILE}`,
      },
      {
        what: "In: a head of our topology as an own face (while no show plays the file)",
        command: `omote file import ${FILE} head.obj --as face`,
      },
    ];
  return [
    {
      what: "A document that any crew can take in and play on its own faces (JSON)",
      command: `omote file export ${FILE} ${name} -o ${name}.json`,
    },
    {
      what: "The face under work with this expression as a morph target (GLB)",
      command: `omote export ${work} -o ${work}.glb --expressions ${name} --show ${FILE}`,
    },
    {
      what: "In: an expression of another crew (while no show plays the file)",
      command: `omote file import ${FILE} their_smile.json`,
    },
  ];
}
