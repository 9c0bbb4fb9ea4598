// Written by tools/messages.py from src/omote/show/messages.py. Do not edit: run `python tools/messages.py`.

export const PROTOCOL_VERSION = 4;
export const LINK_PATH = "/link";
/** States per second. */
export const STATE_RATE = 60;

/**
 * Opens a link; other messages are rejected before it. `name`: what a console's operator calls it, or what it was
 * called the last time; a second hello changes it. `page`: the same for each link of one page, another for each page.
 */
export interface Hello {
  type: "hello";
  role: "stage" | "console";
  version: number;
  name: string;
  page: string;
}

/** Brings a face on air in `seconds`, or by hand (`None`: the T-bar moves it). An `id` executes once. */
export interface CallFace {
  type: "call_face";
  id: string;
  name: string;
  seconds: number | null;
  easing: string;
}

/** Brings an expression on air in `seconds`, or by hand (`None`: the T-bar moves it). An `id` executes once. */
export interface CallExpression {
  type: "call_expression";
  id: string;
  name: string;
  seconds: number | null;
  easing: string;
}

/** Brings a light on air in `seconds`, from whatever light shows. An `id` executes once. */
export interface CallLight {
  type: "call_light";
  id: string;
  name: string;
  seconds: number;
  easing: string;
}

/** The position of the face T-bar, 0..1. */
export interface FadeFace {
  type: "fade_face";
  value: number;
}

/** The operator lets go of the face T-bar. */
export interface ReleaseFace {
  type: "release_face";
}

/** The position of the expression T-bar, 0..1. */
export interface FadeExpression {
  type: "fade_expression";
  value: number;
}

/** The operator lets go of the expression T-bar. */
export interface ReleaseExpression {
  type: "release_expression";
}

/** The weight of one channel (a blendshape weight; any expression's name), -0.5..1.5. */
export interface SetChannel {
  type: "set_channel";
  name: string;
  value: number;
}

/** The head's direction in radians: + is the character's left, up, tilt to its left. */
export interface SetHead {
  type: "set_head";
  yaw: number;
  pitch: number;
  roll: number;
}

/**
 * The gaze relative to the head in radians: + is the character's left, up.
 * At most 0.698 sideways, 0.524 up or down: beyond, the iris would go out of sight.
 */
export interface SetGaze {
  type: "set_gaze";
  yaw: number;
  pitch: number;
}

/** The face on air goes neutral and holds still, now; while `State.home_next` is true it brings the home face. */
export interface Panic {
  type: "panic";
}

/** The face that a second panic brings on air, and the seconds that it takes; it stays with the show. */
export interface SetHome {
  type: "set_home";
  face: string;
  seconds: number;
}

/** Keeps the mix of faces on air as a new own face. An `id` executes once; answered with `kept`. */
export interface KeepFace {
  type: "keep_face";
  id: string;
}

/**
 * Keeps expressions, channels and gaze on air as a new own expression. An `id` executes once; answered with
 * `kept`.
 */
export interface KeepExpression {
  type: "keep_expression";
  id: string;
}

/**
 * Gives an own face or expression another label, which no other of its kind has. An `id` executes once; answered,
 * as the two below, with `item_changed`.
 */
export interface RenameItem {
  type: "rename_item";
  id: string;
  kind: "face" | "expression";
  name: string;
  label: string;
}

/**
 * Takes an own face or expression out of the cast; rejected while it is on air or the home face. `unedited`:
 * rejected too once somebody has worked on what a console kept.
 */
export interface DeleteItem {
  type: "delete_item";
  id: string;
  kind: "face" | "expression";
  name: string;
  unedited: boolean;
}

/** Puts a deleted face or expression back into the cast. */
export interface RestoreItem {
  type: "restore_item";
  id: string;
  kind: "face" | "expression";
  name: string;
}

/**
 * Copies an own face or expression to a new one under a label of its own. An `id` executes once; answered with
 * `kept`.
 */
export interface CopyItem {
  type: "copy_item";
  id: string;
  kind: "face" | "expression";
  name: string;
}

/**
 * Stores a page's layout (JSON) in the show file under a name; `/layouts/NAME` returns it. Answered, as the two
 * below, with `layouts`; `id`: named where it is rejected.
 */
export interface SetLayout {
  type: "set_layout";
  name: string;
  document: string;
  id: string;
}

/** Gives a layout of the show file another name, which none has yet. */
export interface RenameLayout {
  type: "rename_layout";
  name: string;
  to: string;
  id: string;
}

/** Takes a layout out of the show file. */
export interface DropLayout {
  type: "drop_layout";
  name: string;
  id: string;
}

/**
 * Ends a long request, which then changes nothing: an import or export sent over HTTP with `?request=` and an id of
 * the page's own. One that has ended is left as it is.
 */
export interface Cancel {
  type: "cancel";
  request: string;
}

/** Asks for a pong; `sent` is the client's own clock and comes back unchanged. */
export interface Ping {
  type: "ping";
  sent: number;
}

/** A stage's heartbeat, once a second: the rate of frames that it really drew, and its level of quality. */
export interface Drawing {
  type: "drawing";
  fps: number;
  level: "lowest" | "low" | "medium" | "high";
}

/**
 * Answers hello: `epoch` rises with each server start, `revision` with each change of the documents. `name`: what
 * the others call this console.
 */
export interface Welcome {
  type: "welcome";
  version: number;
  epoch: number;
  revision: number;
  digest: string;
  name: string;
}

/** The cast has changed: pages fetch the manifest again and go on. */
export interface CastChanged {
  type: "cast";
  revision: number;
  digest: string;
}

/** Answers keep_face, keep_expression and copy_item: the new name in the cast, and its label. */
export interface Kept {
  type: "kept";
  id: string;
  name: string;
  label: string;
}

/** Answers rename_item, delete_item and restore_item: the label of the item now, and before. */
export interface ItemChanged {
  type: "item_changed";
  id: string;
  label: string;
  before: string;
}

/**
 * The names of all layouts in the show file, sorted: complete, to consoles after the welcome and with each
 * change.
 */
export interface Layouts {
  type: "layouts";
  names: string[];
}

/**
 * What hands at other consoles have moved within the last second, and the name of the console: complete, to each
 * console when it changes, and once a second. Keys are tags of messages (`fade_face`, `set_head`), of a channel with
 * its name (`set_channel:jawOpen`).
 */
export interface Hands {
  type: "hands";
  hands: Record<string, string>;
}

/**
 * A running call: `progress` 0..1, `remaining` seconds (`None`: the T-bar decides).
 * `fader`: where its T-bar stands; `pickup`: where that takes over. Both 0..1. `start`: the mix that it left.
 */
export interface CallState {
  target: string;
  progress: number;
  remaining: number | null;
  by_hand: boolean;
  fader: number;
  pickup: number;
  start: Record<string, number>;
}

/**
 * All that is on air: complete and absolute; the highest (epoch, number) wins, any may be lost.
 * `time`: the show's clock, seconds. `head`: yaw, pitch, roll; `gaze`: yaw, pitch; `eyes`: left yaw, pitch, right yaw,
 * pitch (radians), as the eyeballs stand. `lids`: what the gaze adds to the channels.
 * `face_fader`, `expression_fader`: where the T-bars stand, 0..1, with or without a call. `light`: sums to one.
 * `panics` counts them: when it rises, hands are off. `home_next`: the next one brings `home_face` in `home_seconds`.
 */
export interface State {
  type: "state";
  epoch: number;
  number: number;
  time: number;
  revision: number;
  faces: Record<string, number>;
  expressions: Record<string, number>;
  channels: Record<string, number>;
  head: [number, number, number];
  gaze: [number, number];
  eyes: [number, number, number, number];
  lids: Record<string, number>;
  face_call: CallState | null;
  expression_call: CallState | null;
  face_fader: number;
  expression_fader: number;
  light: Record<string, number>;
  light_call: CallState | null;
  panics: number;
  home_face: string;
  home_seconds: number;
  home_next: boolean;
}

/** Answers ping: `time` is the show's clock at that moment, as in `State.time`. */
export interface Pong {
  type: "pong";
  sent: number;
  time: number;
}

/**
 * A message was rejected, and why, in one sentence for the operator. `id`: of the message, where it had one, also
 * where nothing else of it could be read.
 */
export interface Refused {
  type: "refused";
  reason: string;
  id: string;
}

/** What the crew must know until each has dismissed it; `id` is its own for ever, `time` seconds since 1970. */
export interface Notice {
  id: string;
  time: number;
  text: string;
}

/**
 * All notices of this show, oldest first: complete, so any may be lost. Consoles and editors get them after the
 * welcome, with each new one, and once a second while there are any.
 */
export interface Notices {
  type: "notices";
  notices: Notice[];
}

/**
 * How far a long request (an import, an export) is: steps done of `total` (0: not known yet), and what is done now,
 * for people. To consoles and editors; any may be lost, and the request's own answer says that it has ended.
 */
export interface Progress {
  type: "progress";
  request: string;
  done: number;
  total: number;
  what: string;
}

/** The last report of a stage: frames per second, and the level of quality. */
export interface StageReport {
  fps: number;
  level: "lowest" | "low" | "medium" | "high";
}

/**
 * Who is connected, once a second, with each stage's last report (`None`: it is silent).
 * `lost`: stages whose link broke while their page was open, and that have not come back.
 */
export interface Crew {
  type: "crew";
  stages: (StageReport | null)[];
  consoles: number;
  lost: number;
}

/** Colours of a face, each `#rrggbb`, the hair style, and the traits, plain numbers (`model.cast.Look`). */
export interface Look {
  skin: string;
  lip: string;
  brow: string;
  blush: string;
  iris: string;
  hair: string;
  hair_style: string;
  iris_size: number;
  slit: number;
  lashes: number;
  coat: string;
  pores: number;
  age: number;
  freckles: number;
  stubble: number;
  brows: number;
  makeup: number;
  gloss: number;
  fur: number;
  stripes: number;
  lacquer: number;
  scalp: number;
}

/**
 * A line around an opening, `lid_left`, `lid_right` or `lips`: `loop` (n,) u32 little-endian, rows of the skin in
 * walking order.
 */
export interface LineDocument {
  name: string;
  loop: Uint8Array;
}

/**
 * A drawn mesh, little-endian: `source` (n,) u32 rows of the positions, `uv` (n, 2) f32, `triangles` (t, 3) u32.
 * `openness` (n,) u8: how much of the sky each vertex of the generic face sees.
 */
export interface MeshDocument {
  name: string;
  source: Uint8Array;
  uv: Uint8Array;
  triangles: Uint8Array;
  openness: Uint8Array;
}

/** In which strength a face answers expressions in a region, 0 to 4; `expression`: the one that alone it is for. */
export interface FaceGain {
  region: string;
  value: number;
  expression: string | null;
}

/**
 * A face: where its positions are, its eyeballs' centres (left, right) and radius in metres, its colours.
 * `ball_radii`: of the left and the right eyeball, what lids must leave. `extremes`: the farthest points
 * of skin and hair, least then greatest x, y and z, metres: what a picture has to hold. `source`: its name in the
 * addresses of compounds, `#` and a content key for an own face; `tags`, `place`: for palettes.
 * `gains`: those that differ from a person's.
 */
export interface FaceDocument {
  name: string;
  label: string;
  url: string;
  centres: [[number, number, number], [number, number, number]];
  eye_radius: number;
  ball_radii: [number, number];
  extremes: [number, number, number][];
  look: Look;
  source: string;
  tags: string[];
  place: number;
  gains: FaceGain[];
}

/**
 * An expression: its palette, its region, its eyeball angles in radians (left yaw, pitch, right yaw, pitch), and
 * what it adds to the pupils (1 as wide as they go, -1 as narrow). `source`, `tags`, `place`: as of a face. `head`:
 * yaw, pitch and roll, radians, of a face that answers with its head.
 */
export interface ExpressionDocument {
  name: string;
  label: string;
  kind: "neutral" | "performed" | "arkit" | "makehuman" | "omote" | "own";
  region: string;
  eyes: [number, number, number, number];
  pupil: number;
  source: string;
  tags: string[];
  place: number;
  head: [number, number, number];
}

/** A hair style: where its strands are. */
export interface HairDocument {
  name: string;
  url: string;
}

/**
 * Where two lids or the lips may cross (`model.transfer.corrective_regions.Crossing`), little-endian.
 * `upward`: rungs open along +y, else as at rest. `vertices` (32, 4) u32 and `near` (p,) u32: places in the settling's
 * rows; `weights` (32, 4), `side`, `share` (p,) f32.
 */
export interface CrossingDocument {
  upward: boolean;
  vertices: Uint8Array;
  weights: Uint8Array;
  near: Uint8Array;
  side: Uint8Array;
  share: Uint8Array;
}

/**
 * Correctives: how stages repair sums that fold or pierce (`perform.blending.correctives`), little-endian.
 * `rows` (m,) u32: rows of the positions, all else counts in them: `triangles` (t, 3) u32, `lids` and `eye` (r,) u32
 * (0 left), `anchors` (f, k) u32; but `followers` (f,) u32 are rows of the positions too; `weights` (f, k) f32.
 * An allowance counts triangles, then 32 rungs a crossing, then lids.
 */
export interface SettlingDocument {
  rounds: number;
  upright: number;
  eager: number;
  flattest: number;
  full: number;
  bulge: number;
  cornea: number;
  rows: Uint8Array;
  triangles: Uint8Array;
  crossings: CrossingDocument[];
  lids: Uint8Array;
  eye: Uint8Array;
  followers: Uint8Array;
  anchors: Uint8Array;
  weights: Uint8Array;
}

/** A light that can be called. */
export interface LightDocument {
  name: string;
  label: string;
}

/**
 * All that a page needs to know of the cast; `vertices` counts skin then parts in the order of the meshes.
 * `base`: the digest of the built-in cast, which stays as long as the server does; `digest`: with own things.
 */
export interface Manifest {
  version: number;
  base: string;
  digest: string;
  vertices: number;
  skin: number;
  meshes: MeshDocument[];
  lines: LineDocument[];
  mask: string;
  faces: FaceDocument[];
  expressions: ExpressionDocument[];
  lights: LightDocument[];
  hair: HairDocument[];
  settling: SettlingDocument | null;
}

/** The positions of a face, (vertices, 3) f32 little-endian, metres. */
export interface FaceAsset {
  positions: Uint8Array;
}

/** An own face by its content, as `FaceDocument` and `FaceAsset` have it; its name is its content's key. */
export interface ContentAsset {
  face: FaceDocument;
  positions: Uint8Array;
}

/**
 * Strands of hair on the generic face (`model.hair.HairStyle`), little-endian; n strands of `stations` places.
 * `scale`: metres per count of `points` (n, stations, 3) i16; `rows` (n, stations, links) u32 and `weights` u8 (counts
 * that are to be divided by their sum); `anchors` (n,) u32; `facing` (n, stations, 3) i8, 127 is one; `light`
 * (n, stations) u8, 255 is one; `width` metres.
 */
export interface HairAsset {
  stations: number;
  links: number;
  width: number;
  scale: number;
  points: Uint8Array;
  rows: Uint8Array;
  weights: Uint8Array;
  anchors: Uint8Array;
  facing: Uint8Array;
  light: Uint8Array;
}

/**
 * What one compound alone uses up of the correctives' limits (`perform.blending.correctives`), little-endian:
 * `places` (n,) u32, `values` (n,) f32.
 */
export interface AllowanceDocument {
  places: Uint8Array;
  values: Uint8Array;
}

/**
 * A retargeted expression: a compound minus its face at rest, little-endian: `scale` metres per count, `indices`
 * (n,) u32, `deltas` (n, 3) i16.
 */
export interface CompoundAsset {
  scale: number;
  indices: Uint8Array;
  deltas: Uint8Array;
  allowed: AllowanceDocument | null;
}

export type FromClient =
  | Hello
  | CallFace
  | CallExpression
  | CallLight
  | FadeFace
  | ReleaseFace
  | FadeExpression
  | ReleaseExpression
  | SetChannel
  | SetHead
  | SetGaze
  | Panic
  | SetHome
  | KeepFace
  | KeepExpression
  | RenameItem
  | DeleteItem
  | RestoreItem
  | CopyItem
  | SetLayout
  | RenameLayout
  | DropLayout
  | Cancel
  | Ping
  | Drawing;

export type FromServer =
  | Welcome
  | CastChanged
  | State
  | Pong
  | Kept
  | ItemChanged
  | Refused
  | Notices
  | Layouts
  | Hands
  | Progress
  | Crew;
