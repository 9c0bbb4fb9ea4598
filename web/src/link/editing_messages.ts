// Written by tools/messages.py from src/omote/edit/protocol/messages.py. Do not edit: run `python tools/messages.py`.

export const EDITING_VERSION = 10;
export const EDITING_PATH = "/editing";
/** Bytes; no message of an editor is longer. */
export const EDITING_LIMIT = 65536;

/**
 * An arm, degrees: raised forward and spread to the side, which add up as the sides of a right angle do (both 90:
 * up by 127 degrees, half forward, half aside); twist it inward about itself; elbow bends; forearm turns the palm
 * inward and down (+) or up; wrist bends to the palm and to the thumb's side; shrug lifts the shoulder, reach brings
 * it forward.
 * curls: of thumb, index, middle, ring and little finger, -0.2 (stretched) to 1 (a fist); fan: fingers apart, -0.5 to
 * 1.
 */
export type Arm = {
  raised: number;
  spread: number;
  twist: number;
  elbow: number;
  forearm: number;
  wrist: [number, number];
  shrug: number;
  reach: number;
  curls: [number, number, number, number, number];
  fan: number;
};

/**
 * A leg: where its ankle is, leg lengths out, up and ahead of the stand; where its foot points, degrees: toes up,
 * outward, and its inner edge up; knee: how far the knee points outward, degrees; toes bend up, degrees.
 */
export type Leg = { at: [number, number, number]; foot: [number, number, number]; knee: number; toes: number };

/**
 * A pose of any body.
 * hips: where they go, leg lengths to the character's left, up and ahead; turn: of the hips; trunk: of the spine;
 * head: of neck and head; each bent forward, turned to the character's left and leant to its left, degrees. left,
 * right: arms; left_leg, right_leg.
 */
export type PoseRecipe = {
  kind: "pose";
  hips: [number, number, number];
  turn: [number, number, number];
  trunk: [number, number, number];
  head: [number, number, number];
  left: Arm;
  right: Arm;
  left_leg: Leg;
  right_leg: Leg;
};

/**
 * A face made from faces (`compose_face`): a mix, regions from others, caricature, then handles.
 * base: faces by weight, summing to one (sources as in `Layer`); regions: for a region the source it comes from;
 * amount: of caricature, 1 for none; points: rows of the sheet under the handles; moves: metres, from where base,
 * regions and amount put them; gains: in place of those that base and regions bring; look: colours, traits and hair
 * style by the names that `cast.Look` has for them, in place of those that base and regions bring.
 */
export type FaceRecipe = {
  kind: "face";
  base: Record<string, number>;
  regions: Record<string, string>;
  amount: number;
  points: number[];
  moves: [number, number, number][];
  gains: GainRow[];
  look: Record<string, string | number>;
};

/**
 * A gain that a recipe sets: its region (`space.gain.GAIN_REGIONS`), value, and the expression that alone it is
 * for, by name, or None.
 */
export type GainRow = { region: string; value: number; expression: string | null };

/**
 * A weighted expression (a blendshape) under the control points.
 * source: a name of the built-in cast, or `#` and a content key; label: what people read; region: one of
 * `sculpting.regions.REGIONS`, or None for the whole face; mirrored: left and right exchanged; muted: kept, but not
 * added (`compose_expression`).
 */
export type Layer = {
  source: string;
  label: string;
  weight: number;
  region: string | null;
  mirrored: boolean;
  muted: boolean;
};

/** A muscle's contraction, 0 at rest, 1 as far as it goes. */
export type Pull = { muscle: string; contraction: number };

/**
 * An expression as an artist made it; `compose_expression` adds up its fields.
 * net: rows of the generic face's sheet under the control points; vectors: dtheta (radians), dh (metres), R (1 on the
 * surface) of each; ground: `#` and the key of a field that the net cannot say, or None; eyes: left yaw, pitch, right
 * yaw, pitch, radians, pupil and complexion (`space.complexion`): what is added to those of ground and layers.
 */
export type Recipe = {
  kind: "expression";
  net: number[];
  vectors: [number, number, number][];
  ground: string | null;
  layers: Layer[];
  pulls: Pull[];
  eyes: [number, number, number, number];
  pupil: number;
  complexion: [number, number, number, number, number, number, number];
};

/**
 * Ends a long request, which then changes nothing: an import or export sent over HTTP with `?request=` and an id of
 * the page's own. One that has ended is left as it is.
 */
export type Cancel = { type: "cancel"; request: string };

/**
 * What the crew must know until each has dismissed it; `id` is its own for ever, `time` seconds since 1970.
 * `solved`: it says that something is well again, and goes by itself.
 */
export type Notice = { id: string; time: number; text: string; solved: boolean };

/**
 * All notices of this show, oldest first: complete, so any may be lost. Consoles and editors get them after the
 * welcome, with each new one, and once a second while there are any.
 */
export type Notices = { type: "notices"; notices: Notice[] };

/**
 * How far a long request (an import, an export) is: steps done of `total` (0: not known yet), and what is done now,
 * for people. To consoles and editors; any may be lost, and the request's own answer says that it has ended.
 */
export type Progress = { type: "progress"; request: string; done: number; total: number; what: string };

/**
 * Opens the link; other messages before it are rejected. `editor` is stored by the browser, so a reload finds its
 * draft.
 */
export type Greet = { type: "greet"; editor: string; name: string; version: number };

/**
 * A new expression, opened at once; start: what it begins from, by weight (built-in names, or `#` and a content
 * key; empty: neutral); on_air: from what is on air now instead.
 */
export type CreateExpression = {
  type: "create_expression";
  request: number;
  label: string;
  start: Record<string, number>;
  on_air: boolean;
};

/** A new face, opened at once, from a mix of faces (sources by weight); on_air: from what is on air now instead. */
export type CreateFace = {
  type: "create_face";
  request: number;
  label: string;
  base: Record<string, number>;
  on_air: boolean;
};

/** A new pose, opened at once; start: the pose that it begins from (a built-in name, or `#` and a content key). */
export type CreatePose = { type: "create_pose"; request: number; label: string; start: string };

/** Opens an item: this editor's draft of it, made from its newest revision where there is none. */
export type OpenItem = { type: "open_item"; request: number; item: number };

/** Leaves an item; the draft stays. */
export type CloseItem = { type: "close_item"; request: number; item: number };

/**
 * Control points (indices in the net) dropped at targets (metres, on this face): solved until they lie there.
 * `vectors`: where the page's linearisation puts all points of the net, the start of the solve.
 */
export type DragPoints = {
  type: "drag_points";
  request: number;
  item: number;
  face: string;
  points: number[];
  targets: [number, number, number][];
  vectors: [number, number, number][];
};

/** Vectors of the whole net at once: numeric entry, nudges, mirror, reset. `what` goes into the history. */
export type SetVectors = {
  type: "set_vectors";
  request: number;
  item: number;
  vectors: [number, number, number][];
  what: string;
};

/** Other control points (rows of the sheet): the field stays, the net is built anew. */
export type SetNet = { type: "set_net"; request: number; item: number; net: number[] };

/** The layers (weighted expressions, as of blendshapes) under the control points. */
export type SetLayers = { type: "set_layers"; request: number; item: number; layers: Layer[] };

/**
 * Asks for the draft as it would be with other layers; no step. alone: these layers and nothing else, no control
 * points, muscles, eyes or ground.
 */
export type PreviewLayers = { type: "preview_layers"; request: number; item: number; layers: Layer[]; alone: boolean };

/** The muscles' contractions. */
export type SetPulls = { type: "set_pulls"; request: number; item: number; pulls: Pull[] };

/** Eyeballs' angles (left yaw, pitch, right yaw, pitch, radians) and pupils. */
export type SetEyes = {
  type: "set_eyes";
  request: number;
  item: number;
  eyes: [number, number, number, number];
  pupil: number;
};

/**
 * Blood of cheeks, nose, forehead, eyes and the whole face, 1 a strong flush, below 0 pallor, and tears and sweat,
 * 1 as they run.
 */
export type SetComplexion = {
  type: "set_complexion";
  request: number;
  item: number;
  complexion: [number, number, number, number, number, number, number];
};

/**
 * Bakes layers, muscles and control points into one field, on which the points stand at rest again; muted layers
 * stay as they are.
 */
export type Flatten = { type: "flatten"; request: number; item: number };

/** The whole recipe of a face. `what` goes into the history. */
export type SetFace = { type: "set_face"; request: number; item: number; recipe: FaceRecipe; what: string };

/** The whole recipe of a pose. `what` goes into the history. */
export type SetPose = { type: "set_pose"; request: number; item: number; recipe: PoseRecipe; what: string };

/** One step back in the draft. */
export type Undo = { type: "undo"; request: number; item: number };

/** One step forward again. */
export type Redo = { type: "redo"; request: number; item: number };

/**
 * Makes the draft a revision, which plays from now on, unless another editor saved meanwhile: then it is kept
 * aside.
 */
export type Save = { type: "save"; request: number; item: number; note: string };

/** Makes an old revision (one aside too) the newest step of the draft; saving it makes it play. */
export type BringBack = { type: "bring_back"; request: number; item: number; revision: number };

/** The label, tags and place of an item. */
export type Describe = {
  type: "describe";
  request: number;
  item: number;
  label: string;
  tags: string[];
  place: number;
};

/** A new item with the newest revision of another, under another label. */
export type Duplicate = { type: "duplicate"; request: number; item: number; label: string };

/** Takes an item out of the cast; its revisions stay. Refused while it is on air. */
export type Delete = { type: "delete"; request: number; item: number };

/** Undoes a deletion. */
export type Restore = { type: "restore"; request: number; item: number };

/** Asks for the revisions of an item. */
export type AskHistory = { type: "ask_history"; request: number; item: number };

/**
 * An own item as lists show it; `content`: `#` and the key of what plays, "" before its first save; `editors`:
 * names of those who have it open.
 */
export type ItemDocument = {
  id: number;
  kind: "expression" | "face" | "pose";
  name: string;
  label: string;
  tags: string[];
  place: number;
  head: number;
  content: string;
  deleted: boolean;
  editors: string[];
};

/** A revision as the history shows it; `content`: `#` and a key: any face can be asked to wear it. */
export type RevisionDocument = {
  number: number;
  parent: number;
  content: string;
  written: number;
  editor: string;
  note: string;
  aside: boolean;
};

/**
 * A muscle: its field at full contraction, little-endian f32 (V, 3): dtheta, dh, R - 1; its line on S as rows of
 * the skin, from the bone to the skin (a sphincter: its ring).
 */
export type MuscleDocument = {
  name: string;
  label: string;
  kind: "linear" | "sheet" | "sphincter";
  line: number[];
  field: Uint8Array;
};

/**
 * A control net: `net` (n,) rows of the skin under its points; `triangles` (t, 3) u16 places, rings beyond n;
 * `corners` (V, 3) u16 places and `weights` (V, 3) f32: the field at vertex v is the weighted sum of its corners'
 * vectors (places from n on rest); off the sheet all weights are zero. All little-endian. `mirror`: for each point
 * the place of its mirror image, its own on the midline, -1 for none.
 */
export type NetDocument = {
  net: number[];
  triangles: Uint8Array;
  corners: Uint8Array;
  weights: Uint8Array;
  mirror: number[];
};

/**
 * Answers greet: the muscles, the regions, `masks`: how much each region owns of each vertex of the skin,
 * (regions, V) u8 little-endian, 255 all; `followers`, `anchors`, `shares`: the rows (skin, then parts, as in the
 * manifest) that follow the sheet, (f,) u32, (f, k) u32, (f, k) f32; all items; `show`: which show this is, as in
 * `Welcome`: requests that wait for answers of another one are not sent again; `unsaved`: the items of which this
 * editor has a draft that is not saved; `unwritable`: the endings of downloads that the show's computer cannot make,
 * and why.
 */
export type Greeted = {
  type: "greeted";
  version: number;
  digest: string;
  show: string;
  muscles: MuscleDocument[];
  regions: string[];
  masks: Uint8Array;
  followers: Uint8Array;
  anchors: Uint8Array;
  shares: Uint8Array;
  items: ItemDocument[];
  unsaved: number[];
  unwritable: Record<string, string>;
};

/** All items, whenever one has changed, and the digest of the cast that pages may load now. */
export type Items = { type: "items"; digest: string; items: ItemDocument[] };

/**
 * The draft as it is after a request: its recipe, `content` (`#` and a key that `/compounds/` serves), how many
 * steps can be undone and redone, whether it differs from revision `base`, what the last step was.
 * `net` goes with the first draft of an expression and whenever the net changed. `miss`: how far the worst dragged
 * point is from where it was put, metres. `others`: names of other editors at this item.
 */
export type DraftState = {
  type: "draft";
  request: number;
  item: number;
  recipe: Recipe | FaceRecipe | PoseRecipe;
  content: string;
  undo: number;
  redo: number;
  base: number;
  dirty: boolean;
  what: string;
  net: NetDocument | null;
  miss: number;
  others: string[];
};

/** Answers preview_layers; `content`: `#` and the key that `/compounds/` serves. */
export type Previewed = { type: "previewed"; request: number; item: number; content: string };

/** A draft became a revision; `aside`: another editor had saved meanwhile, and what plays is `head`, theirs. */
export type Saved = {
  type: "saved";
  request: number;
  item: number;
  revision: number;
  head: number;
  aside: boolean;
  sentence: string;
};

/** The revisions of an item, oldest first. */
export type History = { type: "history"; request: number; item: number; revisions: RevisionDocument[] };

/** A request was carried out. */
export type Done = { type: "done"; request: number };

/** A request was rejected, and why, in one sentence; request -1: what came was no valid request. */
export type EditRefused = { type: "refused"; request: number; reason: string };

/**
 * The tangents of a face, its derivative by the field, `/tangents/FACE-CONTENT`: (3, V, 3) f32 little-endian,
 * metres on the face per radian of dtheta, per metre of dh and per unit of R - 1, at each vertex of the sheet (zero
 * off it).
 */
export type TangentsAsset = { tangents: Uint8Array };

/** Handles of the face editor, `/handles`: rows of the skin, their labels, `mirror` places as in a net. */
export type HandlesAsset = { points: number[]; labels: string[]; mirror: number[] };

/**
 * How far a fitted face is from its scan, millimetres: half of what was seen of the face lies within `median`, 95 %
 * of it within `p95`; `seen`: the part of the face that the scan shows, 0 to 1.
 */
export type ScanFigures = { median: number; p95: number; seen: number };

/** What is not sure of a fitted scan; kind: what it is about, and so what ends it. */
export type ScanDoubt = { kind: "place" | "sides" | "eyes" | "shape"; sentence: string };

/**
 * A scan that an editor looks at before its face is taken, `/scans`.
 * token: names it until it is taken or thrown away. placement: from the scan's own frame and unit to the face's
 * metres: the scale, the rotation row by row, the shift. unit: the scan's, in words; doubts: what to look at,
 * none when sure; notes: what of the file could not be used. given: points that people clicked, found:
 * those that were found, by name, in the scan's own frame.
 * positions (n, 3) float32 in the face's metres, triangles (t, 3) uint32 (none of a cloud), colours (n, 3) uint8
 * (sRGB; none where the file has none): a thinned copy of the scan. face (v, 3) float32, residual (v,) float32 in
 * millimetres (nan: not seen): the fitted face; None where none could be made. shut: what was said of the eyes.
 * hair_style, hair: the style and the colour that are proposed.
 */
export type ScanPreview = {
  token: string;
  file: string;
  placement: number[];
  unit: string;
  doubts: ScanDoubt[];
  notes: string[];
  given: Record<string, number[]>;
  found: Record<string, number[]>;
  positions: Uint8Array;
  triangles: Uint8Array;
  colours: Uint8Array;
  face: Uint8Array | null;
  residual: Uint8Array | null;
  figures: ScanFigures | null;
  shut: boolean | null;
  hair_style: string;
  hair: string;
};

/**
 * A face made of photographs that an editor looks at before it is taken, `/photographs`.
 * token: as a scan's, whose addresses take it and throw it away. doubts: what to look at, in sentences. off: how far
 * the landmarks of each photograph lie from the face, pixels; spread: how far the face may lie from the person's,
 * millimetres; seen: which share of its skin a photograph shows.
 * positions (n, 3) float32 metres, triangles (t, 3) uint32, colours (n, 3) uint8 (sRGB): its skin as photographed.
 * face (v, 3) float32: skin and parts; shown (s,) uint8: how well a photograph shows each vertex of the skin, 0 to
 * 255. hair_style, hair: the style and the colour that are proposed.
 */
export type PhotographPreview = {
  token: string;
  doubts: string[];
  off: number[];
  spread: number;
  seen: number;
  positions: Uint8Array;
  triangles: Uint8Array;
  colours: Uint8Array;
  face: Uint8Array;
  shown: Uint8Array;
  hair_style: string;
  hair: string;
};

export type FromEditor =
  | Greet
  | CreateExpression
  | CreateFace
  | CreatePose
  | OpenItem
  | CloseItem
  | DragPoints
  | SetVectors
  | SetNet
  | SetLayers
  | PreviewLayers
  | SetPulls
  | SetEyes
  | SetComplexion
  | Flatten
  | SetFace
  | SetPose
  | Undo
  | Redo
  | Save
  | BringBack
  | Describe
  | Duplicate
  | Delete
  | Restore
  | AskHistory
  | Cancel;

export type ToEditor =
  | Greeted
  | Items
  | DraftState
  | Previewed
  | Saved
  | History
  | Done
  | EditRefused
  | Notices
  | Progress;
