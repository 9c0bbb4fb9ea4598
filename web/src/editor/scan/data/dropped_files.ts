/** Which files dropped on the page are a scan, and which are taken in as they are. */

/** What a scan may be, as a file dialog has it, with what may lie beside it. */
export const SCAN_SUFFIXES = [".ply", ".stl", ".obj", ".glb", ".gltf", ".vrm", ".xyz", ".pts", ".asc"] as const;
const BESIDE = [".mtl", ".bin", ".png", ".jpg", ".jpeg", ".webp", ".bmp", ".tga"] as const;
export const ACCEPTED_SCANS = [...SCAN_SUFFIXES, ...BESIDE].join(",");

/** These may be a head with our own topology as well, which comes in as it is. */
const MAYBE_OURS: ReadonlySet<string> = new Set([".obj", ".glb"]);

/** Photographs of a person, where they come without a scan. */
const PHOTOGRAPHS: ReadonlySet<string> = new Set([".jpg", ".jpeg", ".png"]);
export const ACCEPTED_PHOTOGRAPHS = [...PHOTOGRAPHS].join(",");

/** Whether files are pictures, and nothing else. */
export const arePhotographs = (names: readonly string[]): boolean =>
  names.length > 0 && names.every((name) => PHOTOGRAPHS.has(suffixOf(name)));

/** "scan": a person, to be fitted; "either": taken in as it is where that can be, else a scan; "import": to be taken in
 * as it is. */
export type ImportWay = "scan" | "either" | "import";

/** What to do with files that were dropped while an item of a kind is open, or none. */
export function comingOf(names: readonly string[], open: "expression" | "face" | null): ImportWay {
  const suffixes = names.map(suffixOf);
  if (suffixes.includes(".json")) return "import";
  if (arePhotographs(names)) return "scan";
  const scans = suffixes.filter((suffix) => (SCAN_SUFFIXES as readonly string[]).includes(suffix));
  if (scans.some((suffix) => !MAYBE_OURS.has(suffix))) return "scan";
  if (scans.length > 0 && scans.length < suffixes.length) return "scan"; // with materials and pictures beside it
  return open !== "expression" && scans.length === 1 ? "either" : "import";
}

const suffixOf = (name: string): string => {
  const dot = name.lastIndexOf(".");
  return dot < 0 ? "" : name.slice(dot).toLowerCase();
};

/** What a face made of files is called at first; of none: the camera takes them. */
export function nameOf(names: readonly string[]): string {
  if (names.length === 0) return "Face from the camera";
  const scan = names.find((name) => (SCAN_SUFFIXES as readonly string[]).includes(suffixOf(name))) ?? names[0] ?? "";
  const plain = scan
    .replace(/\.[^.]*$/, "")
    .replace(/[_\s]+/g, " ")
    .trim()
    .slice(0, 60);
  return plain === "" ? "Scanned face" : (plain[0] as string).toUpperCase() + plain.slice(1);
}
