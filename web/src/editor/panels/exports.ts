/** What of an item can be downloaded, and the download itself. */

import type { ItemDocument } from "../../link/editing_messages";
import type { LongRequests } from "../../ui/long_requests";

export interface Export {
  /** What the file is, for people. */
  readonly what: string;
  readonly address: string;
  readonly file: string;
  /** Whether it names who made it and who may use it. */
  readonly credited?: boolean;
  /** Why the show's computer cannot make it; left out: it can. */
  readonly unwritable?: string;
}

/** Who made an avatar, by commas, and who may use it: one of `LICENCES`. */
export interface Credit {
  readonly author: string;
  readonly licence: string;
}

/** Who may use an avatar: what the server reads, and what people do. */
export const LICENCES: readonly (readonly [string, string])[] = [
  ["strict", "Its author alone may use it"],
  ["avatarPermission=everyone", "Anyone may play it, unchanged"],
  ["cc0", "Anyone, for anything (CC0)"],
];

/**
 * The files that an item goes out as; `work`: the name of the face under work, which wears an expression;
 * `unwritable`: the endings that the show's computer cannot make, and why.
 */
export function exportsOf(
  { kind, name, label }: Pick<ItemDocument, "kind" | "name" | "label">,
  work: string,
  unwritable: Readonly<Record<string, string>> = {},
): Export[] {
  const called = fileName(label) || name;
  const worn = (face: string, expressions: string, file: string, what: string, kind = "glb"): Export => ({
    what,
    address: `/exports/${encodeURIComponent(face)}.${kind}?expressions=${encodeURIComponent(expressions)}`,
    file: `${file}.${kind === "obj" ? "zip" : kind}`,
    ...(kind in unwritable ? { unwritable: unwritable[kind] as string } : {}),
  });
  if (kind === "face")
    return [
      worn(name, "arkit", called, "This face with the ARKit shapes, for Blender, three.js or a game engine (GLB)"),
      worn(name, "performed", `${called}-performed`, "This face with the performed expressions (GLB)"),
      { ...worn(name, "arkit", called, "An avatar for VTuber programs (VRM)", "vrm"), credited: true },
      worn(name, "arkit", called, "This face with the ARKit shapes, for Houdini, Maya or Unreal (USDZ)", "usdz"),
      worn(name, "neutral", called, "This face at rest with its pictures (OBJ, in a ZIP)", "obj"),
    ];
  return [
    {
      what: "A document that any crew can take in and play on its own faces (JSON)",
      address: `/exports/${encodeURIComponent(name)}.json`,
      file: `${called}.json`,
    },
    worn(work, name, `${work}-${called}`, "The face under work with this expression as a morph target (GLB)"),
  ];
}

/** An export with what it names: who made it, and who may use it; an Error with a sentence where nobody is named. */
export function credit(exported: Export, { author, licence }: Credit): Export {
  if (exported.credited !== true) return exported;
  if (author.replaceAll(",", "").trim() === "") throw new Error("An avatar names who made it: fill in its author.");
  const said = `author=${encodeURIComponent(author.trim())}&licence=${encodeURIComponent(licence)}`;
  return { ...exported, address: `${exported.address}&${said}` };
}

/** A file is called as people call the item now; its name in the show is the first that it had. */
const fileName = (label: string): string =>
  label
    .toLowerCase()
    .replace(/[^\p{L}\p{N}]+/gu, "_")
    .replace(/^_+|_+$/g, "");

/** The command that takes in several shapes of one head, which belong together. */
export const IMPORT_COMMAND = "omote file import SHOW.omote neutral.obj grin.obj frown.obj";

/** Fetches an export and hands it to the browser as a download; an Error with a sentence where there is none. */
export async function download({ address, file }: Export, requests: LongRequests): Promise<void> {
  const answer = await requests.fetch(`Export of ${file}`, address, { cache: "no-store" });
  if (answer === null) throw new Error("The show's computer does not answer; try again when it is back.");
  if (!answer.ok) throw new Error(sentence(await answer.text()));
  const url = URL.createObjectURL(await answer.blob());
  const link = Object.assign(document.createElement("a"), { href: url, download: file });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 60_000); // the browser still reads it after the click
}

const sentence = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);
