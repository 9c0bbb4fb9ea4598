/** Which files dropped on the page are a scan, and which are taken in as they are. */

import { contentsOf, type FileContent, suffixesOf } from "../../../ui/file_contents";

/** What a scan may be, as a file dialog has it, with what may lie beside it. */
export const ACCEPTED_SCANS = suffixesOf("head", "companion").join(",");
/** Photographs of a person, where they come without a scan. */
export const ACCEPTED_PHOTOGRAPHS = suffixesOf("photograph").join(",");

const holds = (name: string, content: FileContent): boolean => contentsOf(name).includes(content);

/** Whether files are pictures, and nothing else. */
export const arePhotographs = (names: readonly string[]): boolean =>
  names.length > 0 && names.every((name) => holds(name, "photograph"));

/** "scan": a person, to be fitted; "either": taken in as it is where that can be, else a scan; "import": to be taken in
 * as it is. */
export type ImportWay = "scan" | "either" | "import";

/** What to do with files that were dropped while an item of a kind is open, or none. */
export function comingOf(names: readonly string[], open: "expression" | "face" | null): ImportWay {
  if (names.some((name) => holds(name, "document"))) return "import";
  if (arePhotographs(names)) return "scan";
  const scans = names.filter((name) => holds(name, "head"));
  if (scans.some((name) => contentsOf(name)[0] === "head")) return "scan";
  if (open === "expression" && scans.length > 0 && names.every(isOfGltf)) return "import"; // its shapes, as of a GLB
  if (scans.length > 0 && scans.length < names.length) return "scan"; // with materials and pictures beside it
  return open !== "expression" && scans.length === 1 ? "either" : "import";
}

/** Whether a file is a .gltf, or may lie beside one. */
const isOfGltf = (name: string): boolean => /\.gltf$/i.test(name) || holds(name, "companion");

/** What a face made of files is called at first; of none: the camera takes them. */
export function nameOf(names: readonly string[]): string {
  if (names.length === 0) return "Face from the camera";
  const scan = names.find((name) => holds(name, "head")) ?? names[0] ?? "";
  const plain = scan
    .replace(/\.[^.]*$/, "")
    .replace(/[_\s]+/g, " ")
    .trim()
    .slice(0, 60);
  return plain === "" ? "Scanned face" : (plain[0] as string).toUpperCase() + plain.slice(1);
}
