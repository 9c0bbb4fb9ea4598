// Written by tools/messages.py from src/omote/show/messages.py. Do not edit: run `python tools/messages.py`.

export const PROTOCOL_VERSION = 14;
export const LINK_PATH = "/link";
/** States per second. */
export const STATE_RATE = 60;

/**
 * A control of a device, and what it plays (`inputs/bindings`).
 * `control`: as a reading names it (`1/cc7`, `1/note60`, `axis0`); `to`: an address of OSC with its character, or
 * `bank:NAME`. `axis`: `yaw` of a head; `arguments`: of a call. `low`, `high`: values at both ends of the control
 * (nil: the target's own); `curve`: exponent between them; `pick_up`: a fader acts once it has crossed the value on
 * air. `button`: how a key moves a level, `relative`: how an encoder counts, "" for neither; `step`: the part of the
 * range that one step moves. `bank`: where it plays, "" in all. `dead_zone`: how far from its middle a stick counts as
 * there, 0..0.45 of its way.
 */
export type BindingDocument = {
  device: string;
  control: string;
  to: string;
  axis: string;
  arguments: (number | string)[];
  low: number | null;
  high: number | null;
  curve: number;
  pick_up: boolean;
  button: "" | "momentary" | "toggle";
  relative: "" | "twos_complement" | "binary_offset" | "sign_magnitude";
  step: number;
  bank: string;
  dead_zone: number;
};

/**
 * Binds a control, in the place of the same one with the same target, and of `replaces`. An `id` executes once;
 * answered, as the messages below that have one, with `bindings_changed`.
 */
export type Bind = { type: "bind"; id: string; binding: BindingDocument; replaces?: BindingDocument | null };

/** Takes a binding away. */
export type Unbind = { type: "unbind"; id: string; binding: BindingDocument };

/**
 * Binds the next control that moves to an address, in the place of nothing; `to` "" stops. Ends by itself after
 * half a minute.
 */
export type Learn = {
  type: "learn";
  id: string;
  to: string;
  axis?: string;
  arguments?: (number | string)[];
  bank?: string;
};

/** Binds a device as a preset has it, in the place of all its bindings; `character`: whom it plays, `*` all. */
export type LoadPreset = { type: "load_preset"; id: string; device: string; preset: string; character?: string };

/** Takes back what the message of the id `change` did to the bindings; that can be taken back itself. */
export type RestoreBindings = { type: "restore_bindings"; id: string; change: string };

/** Turns a device to one of its banks, "" to none. */
export type ChooseBank = { type: "choose_bank"; device: string; bank: string };

/** What the next control that moves will be bound to, and who asked for it (a console's name). */
export type LearningState = { id: string; to: string; axis: string; arguments: (number | string)[]; who: string };

/**
 * A preset: its name, what people call the device, and whether it is made for it (`matches`: device names, as
 * regular expressions in any case).
 */
export type PresetDocument = {
  name: string;
  label: string;
  kind: "midi" | "gamepad" | "space_mouse" | "osc" | "sacn" | "artnet" | "tracker";
  matches: string[];
};

/**
 * All bindings in their order: complete, to consoles after the welcome and with each change. `fixed`: those of
 * these that a file of the command line has made, which no page changes. `missing`: for each of the bindings why it
 * waits, where it names a face, an expression or a character that is not there, else "".
 */
export type BindingList = {
  type: "binding_list";
  bindings: BindingDocument[];
  fixed: BindingDocument[];
  learning: LearningState | null;
  presets: PresetDocument[];
  missing: string[];
};

/**
 * Answers bind, unbind, learn (when a control has been bound), load_preset and restore_bindings: what is new and
 * what is gone; `restore_bindings` takes it back. `preset`: nobody asked, the preset of this label was loaded when its
 * device was plugged in for the first time: all consoles are told, `here` says whether it was at this one.
 */
export type BindingsChanged = {
  type: "bindings_changed";
  id: string;
  added: BindingDocument[];
  removed: BindingDocument[];
  preset: string;
  here: boolean;
};

/** Brings a face on air in `seconds`, or by hand (`None`: the T-bar moves it). An `id` executes once. */
export type CallFace = {
  type: "call_face";
  character: string;
  id: string;
  name: string;
  seconds?: number | null;
  easing?: string;
};

/**
 * Brings an expression on air in `seconds`, or by hand (`None`: the T-bar moves it). An `id` executes once.
 * `region`: where alone it is called, in its own time, which no T-bar moves; `None`: on the whole face. `strength`:
 * how much of it, 0 (neutral) to 1; no T-bar moves a call of less than all.
 */
export type CallExpression = {
  type: "call_expression";
  character: string;
  id: string;
  name: string;
  seconds?: number | null;
  easing?: string;
  region?: "brows" | "eyes" | "mouth" | "rest" | null;
  strength?: number;
};

/** The position of the face T-bar, 0..1. */
export type FadeFace = { type: "fade_face"; character: string; value: number };

/** The operator lets go of the face T-bar. */
export type ReleaseFace = { type: "release_face"; character: string };

/** The position of the expression T-bar, 0..1. */
export type FadeExpression = { type: "fade_expression"; character: string; value: number };

/** The operator lets go of the expression T-bar. */
export type ReleaseExpression = { type: "release_expression"; character: string };

/**
 * Brings a pose on air in `seconds`, or by hand (`None`: the T-bar moves it). An `id` executes once.
 * `region`: where alone it is called, in its own time, which no T-bar moves; `None`: of the whole figure.
 */
export type CallPose = {
  type: "call_pose";
  character: string;
  id: string;
  name: string;
  seconds?: number | null;
  easing?: string;
  region?: "head" | "trunk" | "arm_left" | "arm_right" | "stance" | null;
};

/** The position of the pose T-bar, 0..1. */
export type FadePose = { type: "fade_pose"; character: string; value: number };

/** The operator lets go of the pose T-bar. */
export type ReleasePose = { type: "release_pose"; character: string };

/**
 * Brings a body on air in `seconds`, apart from the face; `name` "own": each face has its own again. An `id`
 * executes once.
 */
export type CallBody = {
  type: "call_body";
  character: string;
  id: string;
  name: string;
  seconds?: number | null;
  easing?: string;
};

/**
 * The face on air goes neutral and holds still, now; while `CharacterState.home_next` is true it brings the home
 * face. An `id` executes once: a page sends it again where its link breaks.
 */
export type Panic = { type: "panic"; character: string; id?: string };

/** The face that a second panic brings on air, and the seconds that it takes; it stays with the show. */
export type SetHome = { type: "set_home"; character: string; face: string; seconds?: number };

/**
 * Adds a character, which waits off stage at a free place until it enters; it is as lively as the liveliest there.
 * `character`: its name for ever, lower case letters, digits, `_` and `-`; `label`: what people call it. `face` is its
 * home face too. An `id` executes once, as of the messages below.
 */
export type AddCharacter = { type: "add_character"; id: string; character: string; label: string; face: string };

/**
 * Takes a character out of the scene: it leaves the stage first, in `seconds`, and no shot holds it any more; until
 * it is gone an `enter_character` keeps it. The last one stays. `key`: what `restore_character` finds it by, "" for
 * its name.
 */
export type RemoveCharacter = {
  type: "remove_character";
  id: string;
  character: string;
  seconds?: number;
  key?: string;
};

/**
 * Brings back a character that was removed, one of the last sixteen: all that it had on air, its place, rank and
 * shot, unless another was called since. It enters in `seconds`, if it was on the stage.
 */
export type RestoreCharacter = { type: "restore_character"; id: string; key: string; seconds?: number };

/** Gives a character another label. */
export type RenameCharacter = { type: "rename_character"; id: string; character: string; label: string };

/**
 * Moves a character to a place in `seconds`, from wherever it is: the fields are those of `Place`. A hand that
 * drags sends many, the newest wins.
 */
export type PlaceCharacter = {
  type: "place_character";
  character: string;
  x: number;
  depth: number;
  size: number;
  turn: number;
  seconds?: number;
  id?: string;
};

/** Brings a character onto the stage in `seconds`. */
export type EnterCharacter = { type: "enter_character"; id: string; character: string; seconds?: number };

/** Takes a character off the stage in `seconds`; it stays in the scene. */
export type LeaveCharacter = { type: "leave_character"; id: string; character: string; seconds?: number };

/**
 * The names of all clips in the show file, sorted: complete, to consoles after the welcome and with each change.
 * `GET /clips/NAME` gives one, its lanes with all that is set of them.
 */
export type Clips = { type: "clips"; names: string[] };

/**
 * A pass that is recorded. `name`: of the clip; `parts`, `lane`: of the new lane; `by`: who records it. It began at
 * `began`, of `State.time`, where the time of the clip was `start`, and a second of the show is `speed` of it.
 */
export type ClipPass = {
  character: string;
  name: string;
  parts: ("brows" | "eyes" | "mouth" | "rest" | "head" | "gaze" | "body")[];
  lane: string;
  by: string;
  began: number;
  start: number;
  speed: number;
};

/**
 * What is done with clips: complete, to consoles after the welcome and with each change. `passes`: those that are
 * recorded; `edits`: changes with each edit of a clip, and `/clip_outlines/NAME` has it.
 */
export type ClipWork = { type: "clip_work"; passes: ClipPass[]; edits: number };

/**
 * A lane to be drawn: `start`, `stop`: seconds of the clip, with its shift; `spans`: from where to where another
 * pass replaces it; `moves`: the few columns that it moves most, each at equal steps from start to stop, weights and
 * parts of the most that head or gaze turn.
 */
export type LaneOutline = {
  name: string;
  parts: ("brows" | "eyes" | "mouth" | "rest" | "head" | "gaze" | "body")[];
  weight: number;
  muted: boolean;
  shift: number;
  start: number;
  stop: number;
  spans: [number, number][];
  moves: Record<string, number[]>;
};

/**
 * A clip to be drawn, as `/clip_outlines/NAME` returns it (JSON): as of `StoredClip`, but its lanes without their
 * motion; `stop`: where it ends in any case, with its last lane where it is not `trimmed`. `edits`: as of
 * `clip_work`.
 */
export type ClipOutline = {
  name: string;
  start: number;
  stop: number;
  trimmed: boolean;
  blend_in: number;
  blend_out: number;
  loop: boolean;
  speed: number;
  sound: string;
  sound_at: number;
  lanes: LaneOutline[];
  edits: number;
};

/**
 * A character plays a clip on the layer playback, from whatever shows, in `seconds` (`None`: as the clip says). It
 * begins `start` seconds from its start; `speed` and `loop`: `None` as the clip says. `weights`: how much of it shows
 * in brows, eyes, mouth, rest, head and gaze, 0..1; what is not named is left alone; all of it where none is. An `id`
 * executes once. A clip that plays already makes way, and a panic ends it.
 */
export type PlayClip = {
  type: "play_clip";
  character: string;
  id: string;
  name: string;
  seconds?: number | null;
  start?: number;
  speed?: number | null;
  loop?: boolean | null;
  weights?: Record<string, number>;
};

/** A character ends a clip (`name`; "": all that it plays) in `seconds` (`None`: as the clip says). */
export type StopClip = { type: "stop_clip"; character: string; name?: string; seconds?: number | null; id?: string };

/**
 * Records a pass of what shows of a character from now on: some `parts` of it (none: all), as a new lane of a clip
 * (`name`), which is made where there is none. What else the clip has plays meanwhile, from its start, or from
 * `start`, seconds of the clip; and its sound without lips. It ends by `keep_pass`, and by itself after ten minutes.
 * `lane`: what to call it. `sound`: the key of one that the clip has from this pass on, as of `edit_clip`; it begins
 * in .4 s. `speed`: .25 to 1 seconds of the clip a second; what it has plays so, what is recorded is kept in the
 * clip's own time, and below 1 no sound is heard.
 */
export type RecordClip = {
  type: "record_clip";
  id: string;
  character: string;
  name: string;
  parts?: ("brows" | "eyes" | "mouth" | "rest" | "head" | "gaze" | "body")[];
  lane?: string;
  sound?: string;
  start?: number | null;
  speed?: number;
};

/** Ends the pass of a character and keeps it; `keep`: or forgets it. */
export type KeepPass = { type: "keep_pass"; id: string; character: string; keep?: boolean };

/**
 * Changes what is given of a clip: where it begins and ends (seconds of its lanes), in how many seconds it comes
 * and goes, whether it begins again at its end, and its speed. `sound`: the key of one that was sent to `/sounds`,
 * which is heard with it, without lips, from `sound_at` on (seconds of its lanes); "": none. At another speed than 1
 * nothing is heard; the state's `clips` say why.
 */
export type EditClip = {
  type: "edit_clip";
  id: string;
  name: string;
  start?: number | null;
  stop?: number | null;
  blend_in?: number | null;
  blend_out?: number | null;
  loop?: boolean | null;
  speed?: number | null;
  sound?: string | null;
  sound_at?: number | null;
};

/**
 * Changes what is given of a lane of a clip (`lane`: its name, or its number from 1): its name, its parts, how much
 * of it shows, whether it is muted, and by how many seconds it comes later.
 */
export type EditLane = {
  type: "edit_lane";
  id: string;
  name: string;
  lane: string;
  to?: string | null;
  parts?: ("brows" | "eyes" | "mouth" | "rest" | "head" | "gaze" | "body")[] | null;
  weight?: number | null;
  muted?: boolean | null;
  shift?: number | null;
};

/**
 * Replaces a lane of a clip from `start` to `stop`, seconds of the clip, by another lane of it (`by`), which is no
 * lane of its own any more.
 */
export type ReplaceSpan = {
  type: "replace_span";
  id: string;
  name: string;
  lane: string;
  by: string;
  start: number;
  stop: number;
};

/** Takes a lane out of a clip; the last one stays. */
export type DropLane = { type: "drop_lane"; id: string; name: string; lane: string };

/** Gives a clip another name, which none has yet. Cues call it by its name: they are to be changed too. */
export type RenameClip = { type: "rename_clip"; id: string; name: string; to: string };

/** Copies a clip under another name, which none has yet. */
export type CopyClip = { type: "copy_clip"; id: string; name: string; to: string };

/** Takes a clip out of the show; `restore_clip` brings it back until the server restarts. */
export type DropClip = { type: "drop_clip"; id: string; name: string };

/** Brings back the clip that was dropped last under a name. */
export type RestoreClip = { type: "restore_clip"; id: string; name: string };

/**
 * Calls the cue that stands by, or the one of a number (`cue`), each once however often the message comes. `seen`:
 * the identity of the cue that its presser saw standing by; where another does, nothing is called, and every console
 * reads so. While cues are paused it lets them go on instead. An `id` executes once, as of all that follow.
 * `cue_list`: of several lists; "" for the one that is chosen.
 */
export type Go = { type: "go"; id: string; cue?: string; seen?: string; cue_list?: string };

/** Brings back what stood before the last cue was called, in a second; that cue stands by again. */
export type GoBack = { type: "go_back"; id: string; cue_list?: string };

/**
 * Calls a cue out of its order; what waits is forgotten. `whole`: with all that the cues before it leave
 * standing.
 */
export type GoToCue = { type: "go_to_cue"; id: string; cue: string; whole?: boolean; cue_list?: string };

/** Calls all that the cues have left standing again, whoever has moved it since, in a second. */
export type AssertLook = { type: "assert_look"; id: string; cue_list?: string };

/** Has another cue stand by; nothing moves. */
export type SetStandby = { type: "set_standby"; id: string; cue: string; cue_list?: string };

/**
 * Pauses the cues of all lists, or lets them go on: their waits, what follows, and what they have called comes to a
 * stand in .2 s. Hands, trackers and what moves by itself go on.
 */
export type PauseCues = { type: "pause_cues"; id: string; on?: boolean };

/** Chooses the list that is meant where a message names none. */
export type ChooseCueList = { type: "choose_cue_list"; id: string; cue_list: string };

/**
 * Writes a new cue, or changes what is given of the one of an identity (`cue`). `number`: "" for the next free one;
 * `actions`: all that it sends and has said; `after`: the identity of the cue that a new one comes behind, "" for
 * where its number belongs.
 */
export type PutCue = {
  type: "put_cue";
  id: string;
  cue?: string;
  number?: string | null;
  label?: string | null;
  note?: string | null;
  colour?: string | null;
  pre_wait?: number | null;
  post_wait?: number | null;
  goes_on?: "" | "continue" | "follow" | null;
  skip?: boolean | null;
  actions?: CueAction[] | null;
  after?: string;
  cue_list?: string;
};

/**
 * Writes the move of a part in a cue (an identity), or takes its place. `goal`: a mix, or numbers by name; as of
 * the parts of cues.
 */
export type PutMove = {
  type: "put_move";
  id: string;
  cue: string;
  part: string;
  goal: Record<string, number>;
  seconds?: number;
  easing?: string;
  delay?: number;
};

/** Takes the move of a part out of a cue (an identity). */
export type DropMove = { type: "drop_move"; id: string; cue: string; part: string };

/**
 * Writes a new cue of what shows to its sender, on air or in preview: the parts that stand otherwise than the cues
 * before it leave them, or those that `parts` names (`one/face`, `one` for all of a character). `number`: "" for the
 * next free one behind the cue that was called last, in preview behind the one that is looked at, which is the new one
 * from then on.
 */
export type RecordCue = {
  type: "record_cue";
  id: string;
  cue?: string;
  label?: string;
  seconds?: number;
  parts?: string[];
  cue_list?: string;
};

/**
 * Writes what shows to its sender, on air or in preview, into a cue (an identity; "" for the one that was called
 * last, in preview for the one that is looked at): each part that stands otherwise than the list leaves it there.
 */
export type UpdateCue = { type: "update_cue"; id: string; cue?: string; cue_list?: string };

/** Copies a cue (an identity) behind itself, or behind another (`after`), under the next free number. */
export type CopyCue = { type: "copy_cue"; id: string; cue: string; after?: string };

/** Moves a cue (an identity) behind another one of its list (`after`; "" for the first place); its number stays. */
export type MoveCue = { type: "move_cue"; id: string; cue: string; after?: string };

/** Takes a cue (an identity) out of its list. */
export type DropCue = { type: "drop_cue"; id: string; cue: string };

/** Numbers the cues of a list anew, in their order: `first`, then each by `step` more. */
export type RenumberCues = { type: "renumber_cues"; id: string; first?: string; step?: string; cue_list?: string };

/** Begins a list of cues. */
export type AddCueList = { type: "add_cue_list"; id: string; cue_list: string };

/** Gives a list of cues another name. */
export type RenameCueList = { type: "rename_cue_list"; id: string; cue_list: string; to: string };

/** Takes a list with its cues out of the show; the last one stays. */
export type DropCueList = { type: "drop_cue_list"; id: string; cue_list: string };

/**
 * Takes the last edit of cues back, whoever made it; again, the one before it. `seen`: how many edits its presser
 * saw in `CueStatus.edits`; where there are others now, nothing is taken back.
 */
export type UndoCues = { type: "undo_cues"; id: string; seen?: number | null };

/** Does the edit again that was taken back last. `seen`: as of `undo_cues`. */
export type RedoCues = { type: "redo_cues"; id: string; seen?: number | null };

/** Locks the cues for a performance, or opens them: while the show mode is on nobody edits them. */
export type SetShowMode = { type: "set_show_mode"; id: string; on: boolean };

/** A cue as consoles name it. */
export type CueName = { identity: string; number: string; label: string; note: string; colour: string };

/** A move that waits: the number of its cue, its part, and in how many seconds it is called. */
export type CueWait = { number: string; part: string; seconds: number };

/**
 * A part that is moved: the number of the cue that moves it, or the `act` that does, "Back" or "Assert", and in how
 * many seconds it arrives.
 */
export type CueMotion = { number: string; part: string; seconds: number; act: string };

/**
 * How far a list is. `current`: the cue that was called last; `standby`: the one that GO calls; `waits`, `moving`:
 * the next first; `follows`: the cue that follows by itself, in `follows_in` seconds; `since`: seconds since
 * somebody pressed last, None before that; `pressed`: what that was ("GO 12", "Back", "Assert" or "Go to 12"), `by`
 * whom.
 */
export type CueListStatus = {
  current: CueName | null;
  standby: CueName | null;
  waits: CueWait[];
  moving: CueMotion[];
  follows: CueName | null;
  follows_in: number;
  since: number | null;
  by: string;
  pressed: string;
};

/**
 * The lists of cues by name, in their order. `chosen`: the one that is meant where none is named; `rate`: of their
 * time, 0 paused; `edits`: how many edits there were: `/cue_lists/NAME` has the cues; `undo`, `redo`: what would be
 * taken back or done again, "" for nothing. `ignored`: the last GO that was not obeyed, and why, with the number of
 * such; `rejected`: what of the last cue could not be called. `locked`: the show mode is on.
 */
export type CueStatus = {
  chosen: string;
  lists: Record<string, CueListStatus>;
  rate: number;
  edits: number;
  undo: string;
  redo: string;
  ignored: string;
  ignored_count: number;
  rejected: string[];
  locked: boolean;
};

/**
 * A list of cues as `/cue_lists/NAME` returns it (JSON): its cues in the order of GO. `edits`: as of
 * `CueStatus`.
 */
export type CueListDocument = { edits: number; cues: Cue[] };

/**
 * A device is at this page from now on, until `unplug` or the end of the link. Rejected while another page has one
 * of that name: two of a kind need two names.
 */
export type Plug = { type: "plug"; device: string; kind: "midi" | "gamepad" | "space_mouse"; id?: string };

/** A device is gone; its bindings wait for it. */
export type Unplug = { type: "unplug"; device: string };

/** What a MIDI device has sent, as it came. */
export type MidiBytes = { type: "midi_bytes"; device: string; data: Uint8Array };

/**
 * Where controls of a gamepad or a space mouse stand now, those that have moved: 0..1, an axis rests at .5; one
 * whose name begins with `button` is a key.
 */
export type Controls = { type: "controls"; device: string; values: Record<string, number> };

/** This page shows devices from now on, or no more: while it does it hears of them ten times a second. */
export type WatchDevices = { type: "watch_devices"; on: boolean };

/**
 * Switches on or off what is heard (`listen`: a tracker) or told (`send`: a receiver of faces), by the word that
 * stands after `--listen` or `--send`.
 */
export type SwitchDevice = {
  type: "switch_device";
  direction: "listen" | "send";
  word: string;
  on: boolean;
  id?: string;
};

/**
 * A device, or another source of a show: where it is (a console's name, a host), whether it is there now.
 * `rate`: readings or packets a second; `heard`, `rejected`: counts since the server began. `values`: where its
 * controls stood last, 0..1, the newest sixty-four; `waiting`: controls that wait to be picked up, and the position
 * at which they will be. `bank`: the one that it is turned to, of its `banks`; `preset`: the one it was given.
 * `advice`: what to do at whoever sends it, such as what to type into a phone.
 */
export type DeviceState = {
  name: string;
  kind: "midi" | "gamepad" | "space_mouse" | "osc" | "sacn" | "artnet" | "tracker";
  where: string;
  plugged: boolean;
  rate: number;
  heard: number;
  rejected: number;
  values: Record<string, number>;
  waiting: Record<string, number>;
  bank: string;
  banks: string[];
  preset: string;
  advice: string;
};

/**
 * A tracker that can be heard. name: as `--listen` spells it; port: its usual one, or where it is heard, None where
 * it comes to the port of the pages; asks: what its word may name behind "@": a phone that is asked for frames, a
 * computer that we connect to, a sender that may play beside this machine, or "".
 * word: what it is switched on by, "" while it is off; fixed: the command line has; advice: what to do at the sender.
 * stranger: a host that has sent and may not, or ""; strange: the word by which it may. fault: why it is off though
 * the start has asked for it, or ""; again: the word by which it is switched on then.
 */
export type TrackerOffer = {
  name: string;
  title: string;
  port: number | null;
  asks: "" | "phone" | "computer" | "sender";
  word: string;
  fixed: boolean;
  advice: string;
  stranger: string;
  strange: string;
  fault: string;
  again: string;
};

/** A program that has announced itself, and the word by which it is heard. */
export type FoundTracker = { word: string; title: string; where: string };

/**
 * A program that faces are sent to. word: as after `--send`; character: whose face, "" where nobody is called so;
 * sent: packets since it was switched on; fault: why it does not arrive, or ""; fixed: the command line has it.
 */
export type ReceiverState = {
  word: string;
  title: string;
  where: string;
  character: string;
  sent: number;
  fault: string;
  fixed: boolean;
};

/** A way to send a face: its name as `--send` spells it, and the port where receivers usually hear it. */
export type SendWay = { name: string; title: string; port: number };

/**
 * All sources: complete, to consoles when one comes or goes and once a second, to pages that watch ten times a
 * second. trackers: what can be heard; found: what has announced itself; receivers: to whom faces are sent, in one of
 * these ways; phone_page: the address that a phone opens to copy what to type, "" where the show listens on its own
 * machine alone; host: that machine's address in its network, to which trackers send, "" where it is in none.
 */
export type Devices = {
  type: "devices";
  devices: DeviceState[];
  trackers: TrackerOffer[];
  found: FoundTracker[];
  receivers: ReceiverState[];
  ways: SendWay[];
  phone_page: string;
  host: string;
};

/**
 * What came from a source, or why it was rejected; `count`: how often the same within a second; `time`: seconds
 * since 1970. Of a sender of a face there is one line while it sends: `rate` a second, `bars`: the channels that move
 * most, and where each stands.
 */
export type InputLine = {
  number: number;
  time: number;
  source: string;
  text: string;
  rejected: boolean;
  count: number;
  rate: number;
  bars: Record<string, number>;
};

/** What came in last, the oldest first, at most two hundred lines: complete, to pages that watch devices. */
export type InputLog = { type: "input_log"; lines: InputLine[] };

/**
 * What a device is to be sent (MIDI): to the page that has it. `cue`: a cue sends it, so the page says where it
 * does not arrive.
 */
export type DeviceBytes = { type: "device_bytes"; device: string; data: Uint8Array; cue: boolean };

/** The weight of one channel (a blendshape weight; any expression's name), -0.5..1.5. */
export type SetChannel = { type: "set_channel"; character: string; name: string; value: number };

/** The head's direction in radians: + is the character's left, up, tilt to its left. */
export type SetHead = { type: "set_head"; character: string; yaw: number; pitch: number; roll: number };

/**
 * The gaze relative to the head in radians: + is the character's left, up.
 * At most 0.698 sideways, 0.524 up or down: beyond, the iris would go out of sight.
 */
export type SetGaze = { type: "set_gaze"; character: string; yaw: number; pitch: number };

/**
 * What hands at other consoles have moved within the last second, and the name of the console: complete, to each
 * console when it changes, and once a second. Keys are a character and the tag of a message
 * (`one/fade_face`, `one/set_head`), of a channel with its name (`one/set_channel:jawOpen`), of a layer with its name
 * and its region (`one/set_layer:tracker:mouth`).
 */
export type Hands = { type: "hands"; hands: Record<string, string> };

/**
 * Names a point of the house that eyes may look at, such as a seat, or moves it: metres as of `look_at`. It is kept
 * with the show. An `id` executes once, as of the one below.
 */
export type SetGazePoint = { type: "set_gaze_point"; id: string; name: string; x: number; y: number; z: number };

/** Forgets a gaze point; who looked at it looks ahead. */
export type DeleteGazePoint = { type: "delete_gaze_point"; id: string; name: string };

/**
 * Says what a macro plays from now on, in the place of the mapping of that name; one that plays goes on without a
 * jump. `restore_mapping` with the `key` (the name without one) takes that back. It is kept with the show. An `id`
 * executes once, as of those below.
 */
export type SetMapping = { type: "set_mapping"; character: string; id: string; mapping: MacroMapping; key?: string };

/**
 * Changes all mappings of a character at once: macros that are still there stay where they are, what others gave
 * fades out in .2 s. `restore_mapping` with the `key` ("*" without one) takes that back.
 */
export type SetMappings = {
  type: "set_mappings";
  character: string;
  id: string;
  mappings: MacroMapping[];
  key?: string;
};

/** Gives a macro another name, in the conditions of others too; nothing changes on air. */
export type RenameMapping = {
  type: "rename_mapping";
  character: string;
  id: string;
  name: string;
  to: string;
  key?: string;
};

/** Forgets a macro and its mapping; what it gives fades out in .2 s. */
export type DropMapping = { type: "drop_mapping"; character: string; id: string; name: string; key?: string };

/** Takes back that mappings were set, renamed or dropped under this `key`; asked again, it is as after that. */
export type RestoreMapping = { type: "restore_mapping"; character: string; id: string; key: string };

/**
 * Moves a macro, -1..1: all of its targets follow, each by its own curve. Where others hold the part of one of
 * them, it is rejected whole.
 */
export type MoveMacro = { type: "move_macro"; character: string; name: string; value: number };

/**
 * Learns the targets of a macro by touch: what its sender moves of the character from now on, by faders of
 * channels, head and gaze, up to eight, becomes the mapping, each from where it was to where it is left. Ends by
 * `finish_mapping`, or after a minute in which nothing is touched. One console teaches at a time.
 */
export type LearnMapping = { type: "learn_mapping"; id: string; character: string; name: string };

/**
 * Ends what `learn_mapping` began: the macro stands at 1 and holds what was touched, and the faders go back to
 * where they were, so that nothing moves on air. Not to `keep` it forgets what was touched, and leaves it there.
 */
export type FinishMapping = { type: "finish_mapping"; id: string; keep?: boolean };

/**
 * What is learned by touch now, to consoles with each change: of which macro (`name`, "" while nothing is), at
 * whose console (`by`), and the targets that it has so far.
 */
export type MappingLearned = {
  type: "mapping_learned";
  character: string;
  name: string;
  by: string;
  targets: MacroTarget[];
};

/**
 * The mappings of all characters that have some, in their order: complete, to consoles after the welcome and with
 * each change. `missing`: by character, the targets of them that there are not, which give nothing.
 */
export type MappingList = {
  type: "mapping_list";
  mappings: Record<string, MacroMapping[]>;
  missing: Record<string, string[]>;
};

/**
 * Keeps a pad: the `part` that it plays (`face`, `expression`, a region of that, or `pose`), 1 to 3 `dimensions`, 2
 * to 12 `looks` at places -1..1 for each dimension, 0.06 apart at least; each is a mix by name whose weights sum to 1.
 * One of its name makes way, and what that plays follows the new one without a jump. It is kept with the show.
 * `restore_pad` with the `key` (the name without one) takes it back; with a key several changes, one after the other,
 * together. An `id` executes once, as of those below.
 */
export type SetPad = {
  type: "set_pad";
  id: string;
  name: string;
  part: "face" | "expression" | "brows" | "eyes" | "mouth" | "rest" | "pose";
  dimensions: number;
  looks: PadLook[];
  key?: string;
};

/**
 * Gives a pad another name (`to`); what it plays it plays on. Cues that move it follow, as one edit of cues,
 * and macros, bindings and set-ups.
 */
export type RenamePad = { type: "rename_pad"; id: string; name: string; to: string; key?: string };

/** Keeps a copy of a pad under another name (`to`). */
export type CopyPad = { type: "copy_pad"; id: string; name: string; to: string; key?: string };

/** Forgets a pad; what it shows stays on air. A notice names the cues, macros and bindings that move it. */
export type DropPad = { type: "drop_pad"; id: string; name: string; key?: string };

/**
 * Keeps the pads that come with the cast, as a new show has them; pads of the same names make way. Without a `key`
 * `restore_pad` finds those before by `cast pads`.
 */
export type AddCastPads = { type: "add_cast_pads"; id: string; key?: string };

/**
 * Takes the change of pads back that was made under this `key`; asked again, it is as after that. Cues follow a
 * name.
 */
export type RestorePad = { type: "restore_pad"; id: string; key: string };

/** A pad, as of `set_pad`. `missing`: the names of its looks that the cast does not have; they count as neutral. */
export type PadState = {
  name: string;
  part: "face" | "expression" | "brows" | "eyes" | "mouth" | "rest" | "pose";
  dimensions: number;
  looks: PadLook[];
  missing: string[];
};

/**
 * The pads of the show, in the order in which they came: complete, to consoles after the welcome and with each
 * change, ten times a second at most. Where the points of a character are stands in its state.
 */
export type PadList = { type: "pad_list"; pads: PadState[] };

/**
 * Moves the point of a pad on a character, -1..1 for each of its dimensions; `None` leaves one where it is. What
 * the pad plays shows the mixture of its looks there, from whatever shows, without a jump. It needs all parts that the
 * pad plays.
 */
export type MovePad = {
  type: "move_pad";
  character: string;
  name: string;
  x?: number | null;
  y?: number | null;
  z?: number | null;
};

/**
 * Keeps all mappings and all bindings as they are under a name; one of that name is kept anew. An `id` executes
 * once.
 */
export type KeepSetup = { type: "keep_setup"; id: string; name: string };

/**
 * Plays by a set-up from now on: its mappings and its bindings in the place of all that there are. Nothing jumps:
 * macros that are still there stay where they are, what others gave fades out in .2 s, and faders wait to be picked
 * up. `restore_setup` with this `id` takes it back.
 */
export type CallSetup = { type: "call_setup"; id: string; name: string };

/** Forgets a set-up; what plays goes on. `restore_setup` with this `id` takes it back. */
export type DropSetup = { type: "drop_setup"; id: string; name: string };

/**
 * Takes back what the message of the id `change` did: what was kept under the name, or what played, is as before
 * it; that can be taken back itself.
 */
export type RestoreSetup = { type: "restore_setup"; id: string; change: string };

/**
 * The names of all set-ups, in the order in which they were kept first: complete, to consoles after the welcome and
 * with each change. `called`: the one that was called last, "" where mappings or bindings have changed since.
 */
export type SetupList = { type: "setup_list"; names: string[]; called: string };

/** Answers a message about set-ups. `missing`: characters of it that are not there, whose macros are left out. */
export type SetupChanged = { type: "setup_changed"; id: string; name: string; missing: string[] };

/** Keeps the mix of faces on air as a new own face. An `id` executes once; answered with `kept`. */
export type KeepFace = { type: "keep_face"; character: string; id: string };

/**
 * Keeps expressions, channels and gaze on air as a new own expression. An `id` executes once; answered with
 * `kept`.
 */
export type KeepExpression = { type: "keep_expression"; character: string; id: string };

/**
 * Gives an own face or expression another label, which no other of its kind has. An `id` executes once; answered,
 * as the two below, with `item_changed`.
 */
export type RenameItem = { type: "rename_item"; id: string; kind: "face" | "expression"; name: string; label: string };

/**
 * Takes an own face or expression out of the cast; rejected while it is on air or the home face. `unedited`:
 * rejected too once somebody has worked on what a console kept.
 */
export type DeleteItem = {
  type: "delete_item";
  id: string;
  kind: "face" | "expression";
  name: string;
  unedited?: boolean;
};

/** Puts a deleted face or expression back into the cast. */
export type RestoreItem = { type: "restore_item"; id: string; kind: "face" | "expression"; name: string };

/**
 * Copies an own face or expression to a new one under a label of its own. An `id` executes once; answered with
 * `kept`.
 */
export type CopyItem = { type: "copy_item"; id: string; kind: "face" | "expression"; name: string };

/** Answers keep_face, keep_expression and copy_item: the new name in the cast, and its label. */
export type Kept = { type: "kept"; id: string; name: string; label: string };

/** Answers rename_item, delete_item and restore_item: the label of the item now, and before. */
export type ItemChanged = { type: "item_changed"; id: string; label: string; before: string };

/**
 * How much of a layer of a character shows, 0..1, in a region of it (`None`: everywhere), and whether it is on;
 * `None` leaves either as it is. What is on air follows.
 */
export type SetLayer = {
  type: "set_layer";
  character: string;
  layer: "breath" | "gaze" | "emotion" | "blink" | "tracker" | "lips" | "playback" | "hands";
  region?: "brows" | "eyes" | "mouth" | "rest" | "head" | "gaze" | null;
  influence?: number | null;
  on?: boolean | null;
  id?: string;
};

/**
 * Stores a page's layout (JSON) in the show file under a name; `/layouts/NAME` returns it. Answered, as the two
 * below, with `layouts`; `id`: named where it is rejected.
 */
export type SetLayout = { type: "set_layout"; name: string; document: string; id?: string };

/** Gives a layout of the show file another name, which none has yet. */
export type RenameLayout = { type: "rename_layout"; name: string; to: string; id?: string };

/** Takes a layout out of the show file. */
export type DropLayout = { type: "drop_layout"; name: string; id?: string };

/**
 * The names of all layouts in the show file, sorted: complete, to consoles after the welcome and with each
 * change.
 */
export type Layouts = { type: "layouts"; names: string[] };

/**
 * Holds a part of a character: nobody else may play it until it is released; of one that the seat holds already,
 * answers those who want it that it is kept. Rejected where another seat holds it, but for `take_over`; all parts of
 * others are the stage manager's to take over. An `id` executes once, as of the messages below.
 */
export type Lease = {
  type: "lease";
  id: string;
  character: string;
  part: "face" | "expression" | "brows" | "eyes" | "mouth" | "channels" | "head" | "gaze" | "pose" | "place" | "light" | "framing" | "black" | "cues" | "*";
  take_over?: boolean;
};

/** Releases a part, or takes back the wish for one that another holds; "*": all of a character, or of all. */
export type ReleaseLease = {
  type: "release_lease";
  id: string;
  character: string;
  part: "face" | "expression" | "brows" | "eyes" | "mouth" | "channels" | "head" | "gaze" | "pose" | "place" | "light" | "framing" | "black" | "cues" | "*";
};

/**
 * Switches leases on, which makes the sender's seat the stage manager, or off, which releases all; on again, while
 * no stage manager is there, makes the sender the stage manager.
 */
export type SetLeases = { type: "set_leases"; id: string; on: boolean };

/** Makes another seat the stage manager, by its number; the stage manager alone may. */
export type AppointManager = { type: "appoint_manager"; id: string; seat: number };

/**
 * An operator, or a source that holds something: its number, its name and its colour, `#rrggbb`. `manager`: the
 * stage manager; `here`: a link of it is there.
 */
export type SeatState = { number: number; name: string; colour: string; manager: boolean; here: boolean };

/**
 * A part that somebody holds, as in `Leases.held`, the number of the seat that wants it, and for how many seconds.
 * It stands until the part is released or taken over, its holder holds it again (`lease`), or the seat takes the wish
 * back (`release_lease`) or has gone.
 */
export type LeaseWish = { part: string; by: number; seconds: number };

/**
 * Who holds what, complete, to consoles once leases have been switched on: when it changes and once a second.
 * `held`: by character and part (`one/face`; the character of light, framing and black is `*`); `seats`: all
 * operators, and what else holds or wants something; `you`: the number of this console's own. While leases are not
 * `on` the last touch wins.
 */
export type Leases = {
  type: "leases";
  on: boolean;
  held: Record<string, SeatState>;
  seats: SeatState[];
  you: number;
  wishes: LeaseWish[];
};

/**
 * To the consoles of a seat: another touched parts that it holds, or has `taken` them over, or, holding what it
 * wanted, has `kept` them. `parts`: as in `Leases.held`.
 */
export type LeaseClaim = { type: "lease_claim"; parts: string[]; by: SeatState; taken: boolean; kept: boolean };

/**
 * Opens a link; other messages are rejected before it. `name`: what a console's operator calls it, or what it was
 * called the last time; a second hello changes it. `page`: the same for each link of one page, another for each page.
 * `seat`: of the operator, whom a reload and a lost link do not change; without one it is the page's. `bus`: what it
 * looks at: what is on air, or the preview, on which what it plays is not seen; a second hello changes that.
 */
export type Hello = {
  type: "hello";
  role: "stage" | "console";
  version: number;
  name?: string;
  page?: string;
  seat?: string;
  bus?: "air" | "preview";
};

/**
 * Ends a long request, which then changes nothing: an import or export sent over HTTP with `?request=` and an id of
 * the page's own. One that has ended is left as it is.
 */
export type Cancel = { type: "cancel"; request: string };

/** Asks for a pong; `sent` is the client's own clock and comes back unchanged. */
export type Ping = { type: "ping"; sent: number };

/** Answers ping: `time` is the show's clock at that moment, as in `State.time`. */
export type Pong = { type: "pong"; sent: number; time: number };

/**
 * Answers hello: `epoch` rises with each server start, `revision` with each change of the documents. `name`: what
 * the others call this console. `show`: which show file is played, "" for none; another one has another.
 */
export type Welcome = {
  type: "welcome";
  version: number;
  epoch: number;
  revision: number;
  digest: string;
  name: string;
  show: string;
};

/**
 * A message was rejected, and why, in one sentence for the operator. `id`: of the message, where it had one, also
 * where nothing else of it could be read. `held`: the parts that others hold, where that was the reason.
 */
export type Refused = { type: "refused"; reason: string; id: string; held: string[] };

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
 * Keeps the whole look that shows to its sender, on air or in preview, under a name: faces, expressions, poses,
 * head and gaze of all characters, light and framing. One of that name is kept anew; `restore_memory` with the `key`
 * (the name without one) takes that back. It is kept with the show. An `id` executes once, as of those below.
 */
export type KeepMemory = { type: "keep_memory"; id: string; name: string; key?: string };

/**
 * Brings a memory on air in `seconds`, all its parts in the same time, from whatever shows. Where others hold one
 * of them, it is rejected whole; it holds none of them afterwards.
 */
export type CallMemory = { type: "call_memory"; id: string; name: string; seconds?: number; easing?: string };

/** Forgets a memory; `restore_memory` with the `key` (the name without one) takes that back. */
export type DeleteMemory = { type: "delete_memory"; id: string; name: string; key?: string };

/** Takes back that a memory was kept or deleted under this `key`; asked again, it is as after that. */
export type RestoreMemory = { type: "restore_memory"; id: string; key: string };

/**
 * A memory as its picture shows it. `goals`: of the faces and expressions of its characters, by part, as cues have
 * them.
 */
export type MemoryState = { name: string; goals: Record<string, Record<string, number>> };

/**
 * What the memories of the show look like, in the order in which they came: complete, to consoles after the welcome
 * and with each change. Their names alone stand in each state.
 */
export type MemoryList = { type: "memory_list"; memories: MemoryState[] };

/**
 * How much a character moves by itself: `liveliness` 0 (nothing) to 1, 0.5 as people move; `blinks`, `gaze` and
 * `breath` each beside the others, 0..2; `seed`: which of all ways to move; `idle`: whether it moves as people do
 * while its tracker is lost, where the liveliness is 0 too. `None` leaves a setting as it is.
 */
export type SetMotion = {
  type: "set_motion";
  character: string;
  liveliness?: number | null;
  blinks?: number | null;
  gaze?: number | null;
  breath?: number | null;
  seed?: number | null;
  id?: string;
  idle?: boolean | null;
};

/**
 * Whom or what the eyes of a character look at by its automatic motion: `ahead`, nothing; `direction`, `yaw` and
 * `pitch` of the house in radians, + to the picture's right and up; `point`, `x` metres to the picture's right, `y`
 * above the eyes, `z` before the front line; by `name`: a `gaze_point`, a `character`, the camera of a `stage` ("" for
 * any). Rejected where there is none of that name.
 */
export type LookAt = {
  type: "look_at";
  character: string;
  kind: "ahead" | "direction" | "point" | "gaze_point" | "character" | "stage";
  name?: string;
  yaw?: number;
  pitch?: number;
  x?: number;
  y?: number;
  z?: number;
  id?: string;
};

/**
 * A short motion on top of all that plays: nod, shake, tilt, bow, shrug, brows or wink. `amplitude`: -2..2, 1 as it
 * is, below 0 to the other side; `seconds`: 0.2..10, `None` as long as it takes. An `id` executes once.
 */
export type MakeGesture = {
  type: "make_gesture";
  character: string;
  id: string;
  name: "nod" | "shake" | "tilt" | "bow" | "shrug" | "brows" | "wink";
  amplitude?: number;
  seconds?: number | null;
};

/**
 * How much of a spring of a character shows, 0..2, 1 at first: of the ears of animals that sway and flap, of jowls
 * that sway, of cheeks that bounce as the head moves. It is multiplied by twice the liveliness of `set_motion`.
 */
export type SetSpring = {
  type: "set_spring";
  character: string;
  name: "ears-sway" | "ears-flap" | "jowls-sway" | "cheeks-bounce";
  amount: number;
  id?: string;
};

/**
 * How much of the folds that skin under pressure makes (`folds`), or of the flush and the pallor of expressions
 * (`blood`), a character shows: 0..1.5, 1 at first.
 */
export type SetSkin = { type: "set_skin"; character: string; name: "folds" | "blood"; amount: number; id?: string };

/** Brings a light on air in `seconds`, from whatever light shows. An `id` executes once. */
export type CallLight = { type: "call_light"; id: string; name: string; seconds?: number; easing?: string };

/**
 * Brings a framing on air in `seconds`, from whatever the picture shows: a shot of these characters, of all that
 * are on the stage where none is named, of whom it holds now where `characters` is left out; as much of their figures
 * as `size` says, heads alone in a portrait, else as much as now.
 */
export type CallFraming = {
  type: "call_framing";
  id: string;
  characters?: string[] | null;
  seconds?: number;
  easing?: string;
  size?: "portrait" | "head" | "bust" | "half" | "full" | null;
};

/**
 * Fades the picture of all stages to black (1) or up again (0) in `seconds`, from whatever shows; 0 seconds are a
 * blackout. A fader sends many values between, the newest wins.
 */
export type CallBlack = { type: "call_black"; black: number; seconds?: number; easing?: string; id?: string };

/**
 * Brings on air, in `seconds` and from whatever shows, each part that goes otherwise in preview: afterwards both
 * look the same. What eyes look at and how much of layers shows is set at once; gestures and speech are no part of it.
 * `parts`: only these (`one/face`, `one` for all of a character). Where others hold one of them, it is rejected whole;
 * it holds none of them afterwards. An `id` executes once, as of those below.
 */
export type Take = { type: "take"; id: string; seconds?: number; easing?: string; parts?: string[] };

/** The preview is what is on air now; what was built up there is forgotten. */
export type ResetPreview = { type: "reset_preview"; id: string };

/**
 * Shows a cue in preview as it will stand, with all that the cues before it leave: `update_cue` of somebody who
 * looks at the preview then writes what is changed there into it, whatever runs on air. `run`: the cue's own moves go
 * in their times. What was built up in preview is forgotten; what no cue of the list moves is as it goes on air.
 * `cue_list`: as of `go`.
 */
export type PreviewCue = { type: "preview_cue"; id: string; cue: string; run?: boolean; cue_list?: string };

/**
 * Marks this moment of the recording by a name, for whoever looks at it later. An `id` executes once, as of all
 * that follow.
 */
export type MarkMoment = { type: "mark_moment"; id: string; text: string };

/**
 * Keeps what was played in the last `minutes` under a name, which the ring of 100 minutes would lose. Answered with
 * `recording_kept`.
 */
export type KeepRecording = { type: "keep_recording"; id: string; name: string; minutes?: number };

/**
 * Keeps what showed of a character in the last `seconds` as a motion clip; one of that name gets one more lane, of
 * `parts` (none: all), called `lane`. Answered with `recording_kept`, once it is cut.
 */
export type KeepClip = {
  type: "keep_clip";
  id: string;
  name: string;
  character: string;
  seconds?: number;
  parts?: ("brows" | "eyes" | "mouth" | "rest" | "head" | "gaze")[];
  lane?: string;
};

/** Keeps a recording no longer. Answered with `recording_kept`. */
export type DeleteRecording = { type: "delete_recording"; id: string; name: string };

/** Answers keep_recording, keep_clip and delete_recording: it is done. `name`: of the recording, or of the clip. */
export type RecordingKept = { type: "recording_kept"; id: string; name: string };

/**
 * What was recorded without a break: from when, seconds since 1970, and how long, seconds. `start`: which start of
 * the show; `first`: seconds of its clock; `name`: of one that is kept.
 */
export type RecordedSpan = { start: number; first: number; written: number; seconds: number; name: string };

/**
 * A moment that somebody (`who`) marked: when, seconds since 1970, and seconds of the clock of a start of the show;
 * `name`: what it says; `cue`: the number of the cue that was called last then, "" for none. `id`: of the marker.
 */
export type MarkedMoment = {
  id: number;
  start: number;
  at: number;
  written: number;
  name: string;
  who: string;
  cue: string;
};

/**
 * What is recorded, as `/recordings` returns it (JSON): the ring, what is kept of it, and markers; the oldest
 * first. `files`: the names of the show files; `?file=1` asks for what is recorded of the second. `name`: of who asks,
 * as the show knows it; `role`: what it may do; `now`: seconds since 1970, where the show plays; `cue`: the one
 * that was called last of all.
 */
export type RecordingsDocument = {
  spans: RecordedSpan[];
  kept: RecordedSpan[];
  markers: MarkedMoment[];
  files: string[];
  name: string;
  role: "view" | "operate" | "edit" | "admin";
  now: number | null;
  cue: string;
};

/**
 * What a page asks of markers, as `/markers` takes it (JSON): a new one (POST), or other words for one that is
 * there (POST to `/markers/ID`). `start` and `at`: when, as of `MarkedMoment`; left out, while the show plays, it
 * is now, or `before` so many seconds. `who`: who marks it, where the show asks nobody for a token.
 */
export type MarkerRequest = { name: string; before: number; start: number; at: number; who: string };

/** A cue that was called: when, seconds from the beginning of the run, of which list, by number. */
export type CalledCue = { at: number; cue_list: string; number: string };

/**
 * What showed in a part of a recording, as `/curves?start=1&first=12.5&last=90` returns it (MessagePack): `start`,
 * `first`, `seconds` as of `RecordedSpan`; the cues that were called; and the curves as they are kept, a piece a
 * minute, which may have more than was asked for. None: it was recorded without.
 * A piece is deflated (zlib), MessagePack, a list: seconds of its first sample; milliseconds between samples (unsigned
 * 32 bits, little endian, the first 0); names; by character the steps between samples (16 bits, little endian, which
 * wrap; the first from 0), column by column: those of `quantities`, which says how many steps are one, then two places
 * in the names, of the face and of the expression that showed most. A sum of -32768: it was not there. Weights are
 * those of `face`, `expression`, and of the strongest expression or channel of a region; head and gaze are in degrees,
 * `x` and `depth` in metres.
 */
export type RunDocument = {
  start: number;
  first: number;
  seconds: number;
  quantities: Record<string, number>;
  pieces: Uint8Array[];
  cues: CalledCue[];
};

/** The line of notes, and when the show began: seconds of its clock (`State.time`). */
export type ShowNotes = { note: string; began: number };

/**
 * Writes the line of notes that every console shows; it is kept with the show. An `id` executes once, as of the one
 * below.
 */
export type SetNote = { type: "set_note"; id: string; text: string };

/**
 * The show begins: the time that consoles show counts from now, or from `at` (seconds of `State.time`) where that
 * is given.
 */
export type BeginShow = { type: "begin_show"; id: string; at?: number | null };

/**
 * Something that sends values all the time: a tracker, a microphone, a program. `names`: the expressions (channels)
 * that each of its frames has a value for. `characters`: whom it drives, where it says so; else the route that was
 * made for its name the last time. `performer`: whose face it sees, by whose calibration it is read; "" for one of its
 * own. `smoothing`: seconds, to 2, in which its steps are followed, 0 as its layer is. `direct`: its frames are smooth
 * already and show as they are. Answered with `source_is`; the end of its link is its end.
 */
export type Source = {
  type: "source";
  name: string;
  kind: "tracker" | "lips" | "playback" | "program" | "breath" | "gaze" | "blink";
  names: string[];
  characters?: string[];
  performer?: string;
  id?: string;
  smoothing?: number;
  direct?: boolean;
};

/**
 * One frame of a source, the newest wins: `values` as float32, little-endian, in the order of its names, -0.5..1.5;
 * `head` (yaw, pitch, roll) and `gaze` (yaw, pitch) in radians, or `None`. `found`: false while it does not see its
 * performer. Half a second without one that is found, and its layers fade out. `share`, of a direct source: how much
 * of its layer it takes, 0..1; none while a voice is silent, so that what lies below shows. `body`: what the
 * performer's body does, beside where the head looks, as `pose` of the state has it, `b""` for none; `seen`: which
 * regions of it.
 */
export type Drive = {
  type: "drive";
  index: number;
  values: Uint8Array;
  head?: [number, number, number] | null;
  gaze?: [number, number] | null;
  found?: boolean;
  share?: number;
  body?: Uint8Array;
  seen?: ("head" | "trunk" | "arm_left" | "arm_right" | "stance")[];
};

/** A source of this link ends; its layers fade out. */
export type LeaveSource = { type: "leave_source"; index: number };

/**
 * Which characters a source drives, on which layer, in which regions (none named: all). It stays with the show
 * under the source's name. An `id` executes once, as of the two below.
 */
export type RouteSource = {
  type: "route_source";
  id: string;
  source: string;
  characters: string[];
  layer: "breath" | "gaze" | "emotion" | "blink" | "tracker" | "lips" | "playback" | "hands";
  regions?: ("brows" | "eyes" | "mouth" | "rest" | "head" | "gaze" | "body")[];
};

/**
 * Measures the performer before a source: `neutral` takes what it sends now as the face at rest, `range` listens to
 * the performer's largest moves until `done`, `reset` forgets both. `channels`: those that a range is of; none named:
 * all. It stays with the show under the performer.
 */
export type CalibrateSource = {
  type: "calibrate_source";
  id: string;
  source: string;
  step: "neutral" | "range" | "done" | "reset";
  channels?: string[];
};

/**
 * Sets what was measured of the performer before a source, by channel: the face at rest and the largest moves, as
 * `SourceState` tells them. So a measure is taken back, or comes from a program.
 */
export type MeasureSource = {
  type: "measure_source";
  id: string;
  source: string;
  neutral: Record<string, number>;
  highest: Record<string, number>;
};

/**
 * How a source is read: `mirror` swaps left and right; less than `dead_zone` (0..0.5) is nothing; `curve` -1..1:
 * above 0 small moves grow, below they shrink; `gain` 0..4 of all channels, `lids` 0..4 beside it of those that shut
 * the eyes; `smoothing` 0..2: seconds in which a step is followed, 0 as the source asks or its layer is.
 */
export type TuneSource = {
  type: "tune_source";
  id: string;
  source: string;
  mirror?: boolean;
  dead_zone?: number;
  curve?: number;
  gain?: number;
  smoothing?: number;
  lids?: number;
};

/** Asks for what a source sends, as it comes (`SourceValues`): for a page that shows it; "" ends it. */
export type WatchSource = { type: "watch_source"; source: string };

/** Answers source: the index by which this link's frames name it. */
export type SourceIs = { type: "source_is"; index: number; name: string };

/**
 * A source that sends: `console` is the name of the link that it comes by; its route; `rate`: frames in the last
 * second; `found`: whether it sees its performer. `ranging`: it listens to the performer's largest moves. `neutral`,
 * `highest`: what was measured, by channel. `body`: it sees a body.
 */
export type SourceState = {
  name: string;
  kind: "tracker" | "lips" | "playback" | "program" | "breath" | "gaze" | "blink";
  console: string;
  characters: string[];
  layer: "breath" | "gaze" | "emotion" | "blink" | "tracker" | "lips" | "playback" | "hands";
  regions: ("brows" | "eyes" | "mouth" | "rest" | "head" | "gaze" | "body")[];
  performer: string;
  rate: number;
  found: boolean;
  calibrated: boolean;
  ranging: boolean;
  mirror: boolean;
  dead_zone: number;
  curve: number;
  gain: number;
  smoothing: number;
  lids: number;
  neutral: Record<string, number>;
  highest: Record<string, number>;
  body: boolean;
};

/** All sources that send: complete, to consoles once a second and with each change. */
export type Sources = { type: "sources"; sources: SourceState[] };

/**
 * What a source that is watched sends now, and what its measure makes of it: `sent` and `weights` as float32,
 * little-endian, in the order of `names`; up to twenty times a second.
 */
export type SourceValues = {
  type: "source_values";
  source: string;
  names: string[];
  sent: Uint8Array;
  weights: Uint8Array;
};

/**
 * A character says a text by a voice of the show (`GET /voices`), which speaks it first: the sound begins a moment
 * later, on the stage that plays sounds, with lips in time. What it says meanwhile, a stop and a panic end the
 * waiting. An `id` executes once. A program speaks by `say(voice=...)`, which tells it when it is over.
 */
export type SayByVoice = { type: "say_by_voice"; character: string; id: string; text: string; voice?: string };

/**
 * A character speaks: its lips move in time with a sound. `timing`: what `marks` are, each beginning at its place
 * of `times` (float32, little-endian, seconds from the beginning of the sound; one more is the end of the last):
 * words, characters, visemes (Oculus), azure (ids), rhubarb (letters); `text`: none, the text's letters are timed by
 * rule, in `language`. `seconds`: the length, where it is known. `sound`: the key of one that was sent to `/sounds`,
 * which one stage plays; "": something else does. `delay`: seconds until the sound begins; `offset`: by which the
 * mouth is later. `queue`: after all that is said already, else in its place. `key`: what to call it: the
 * state's `speech.keys` have it until it is over, and `spoken` once it was said to its end. An `id` executes once.
 */
export type Say = {
  type: "say";
  character: string;
  id: string;
  text?: string;
  timing?: "text" | "words" | "characters" | "visemes" | "azure" | "rhubarb";
  marks?: string[];
  times?: Uint8Array;
  language?: "en" | "de";
  seconds?: number | null;
  sound?: string;
  delay?: number;
  offset?: number;
  queue?: boolean;
  key?: string;
};

/**
 * A sound is heard without lips, in the place of what a character says: who plays its mouth goes on, so that it can
 * be performed to a line. `sound`: the key of one that was sent to `/sounds`; `delay`: seconds until it begins, below
 * 0: so long ago; `key`: as of `say`. `stop_speaking` and a panic end it. An `id` executes once.
 */
export type PlaySound = {
  type: "play_sound";
  character: string;
  id: string;
  sound: string;
  delay?: number;
  seconds?: number | null;
  key?: string;
};

/** Ends what a character says, and all that it would say after: its mouth goes to rest. */
export type StopSpeaking = { type: "stop_speaking"; character: string; id?: string };

/**
 * A sound that the show file keeps: its name, its key and its seconds. `former`: names that it had before, by which
 * clips and cues find it still.
 */
export type NamedSound = { name: string; sound: string; seconds: number; former: string[] };

/**
 * The sounds that the show file keeps, sorted by name: complete, to consoles after the welcome and with each
 * change. One is sent to `/sounds?name=NAME`, and `GET /sounds/KEY` gives its bytes.
 */
export type Sounds = { type: "sounds"; sounds: NamedSound[] };

/** Answers drop_sound: who needs the sound, clips and cues in words, and is silent now. */
export type SoundDropped = { type: "sound_dropped"; name: string; needed_by: string[] };

/** Gives a sound another name, which none has yet. Clips and cues that name it find it still. */
export type RenameSound = { type: "rename_sound"; id: string; name: string; to: string };

/**
 * Takes a sound out of the show; `restore_sound` brings it back until the server restarts. Answered with
 * `sound_dropped` too: clips and cues that need it are silent.
 */
export type DropSound = { type: "drop_sound"; id: string; name: string };

/** Brings back the sound that was dropped last under a name. */
export type RestoreSound = { type: "restore_sound"; id: string; name: string };

/**
 * A stage's heartbeat, once a second: the rate of frames that it really drew, and its level of quality. `name`: as
 * its address has it; `camera`: where that is, metres as of `look_at`. `sound`: whether it can play sounds: "" never,
 * `blocked` until somebody clicks it, `ready`; `sound_here`: its address asks that it plays them. `dark`: seconds for
 * which it has had no graphics context, and so draws nothing. `awake`: whether its browser keeps the screen on:
 * `kept`, `refused`, `insecure` where the address is neither https nor of its own machine; "" before it has said.
 * Nobody looks at the camera of a stage of the preview.
 */
export type Drawing = {
  type: "drawing";
  fps: number;
  level: "lowest" | "low" | "medium" | "good" | "high";
  name?: string;
  camera?: [number, number, number] | null;
  sound?: "" | "blocked" | "ready";
  sound_here?: boolean;
  dark?: number;
  awake?: "" | "kept" | "insecure" | "refused";
};

/**
 * The last report of a stage: frames per second, the level of quality, and its name, where its address has one; of
 * sounds, darkness and the screen that stays on as in `drawing`.
 */
export type StageReport = {
  fps: number;
  level: "lowest" | "low" | "medium" | "good" | "high";
  name: string;
  sound: "" | "blocked" | "ready";
  sound_here: boolean;
  dark: number;
  awake: "" | "kept" | "insecure" | "refused";
};

/**
 * Who is connected, once a second, with each stage's last report (`None`: it is silent).
 * `lost`: stages whose link broke while their page was open, and that have not come back.
 */
export type Crew = { type: "crew"; stages: (StageReport | null)[]; consoles: number; lost: number };

/** To a stage: whether it is the one that plays sounds, when that changes. One does at a time. */
export type PlaysSound = { type: "plays_sound"; on: boolean };

/** The cast has changed: pages fetch the manifest again and go on. */
export type CastChanged = { type: "cast"; revision: number; digest: string };

/**
 * A running call: `progress` 0..1, `remaining` seconds (`None`: the T-bar decides).
 * `fader`: where its T-bar stands; `pickup`: where that takes over. Both 0..1. `start`: the mix that it left.
 */
export type CallState = {
  target: string;
  progress: number;
  remaining: number | null;
  by_hand: boolean;
  fader: number;
  pickup: number;
  start: Record<string, number>;
};

/**
 * Where a character is, in the eyes of the audience: `x` metres to the picture's right, `depth` metres behind the
 * front line, `size` a factor, `turn` radians about the vertical, + to the character's own left, as the head's yaw.
 */
export type Place = { x: number; depth: number; size: number; turn: number };

/** One of the sources of a layer: how far it is trusted, and the parts that it has. */
export type LayerSource = { source: string; trust: number; parts: string[] };

/**
 * A layer: its influence on brows, eyes, mouth, rest, head and gaze, and its switch, as set. `source`: what drives
 * it, of several the one with the most parts, "" for nothing; `trust`: 0 lost, 1 followed. `share`: how much of it is
 * on air where it shows most, 0..1; `strongest`: the few channels that it moves most now. `sources`: all of them where
 * there are several, the newest first.
 */
export type LayerState = {
  influence: number[];
  on: boolean;
  trust: number;
  source: string;
  share: number;
  strongest: Record<string, number>;
  sources: LayerSource[];
};

/** What hands hold, where layers mix it with what sources send: channels, head and gaze as faders stand. */
export type HeldState = { channels: Record<string, number>; head: [number, number, number]; gaze: [number, number] };

/** Whom or what a character looks at, as of `look_at`. */
export type GazeTargetState = {
  kind: "ahead" | "direction" | "point" | "gaze_point" | "character" | "stage";
  name: string;
  yaw: number;
  pitch: number;
  x: number;
  y: number;
  z: number;
};

/** What is set of a character's automatic motion, as of `set_motion` and `look_at`. */
export type MotionState = {
  liveliness: number;
  blinks: number;
  gaze: number;
  breath: number;
  seed: number;
  idle: boolean;
  target: GazeTargetState;
};

/**
 * What a character says. `number`: counts all that it has said; `text`: its first 120 characters; `elapsed`:
 * seconds since its sound began, below 0 before; `seconds`: its length. `sound`: the key of what a stage plays, ""
 * for none; `waiting`: how many speeches follow, `next_sound`: the key of the next one's. `keys`: what
 * programs call this one and those that follow, in their order.
 */
export type SpeechState = {
  number: number;
  text: string;
  elapsed: number;
  seconds: number;
  sound: string;
  waiting: number;
  next_sound: string;
  keys: string[];
};

/**
 * A clip that a character plays: `elapsed` seconds from its start, of `seconds`; `share`: how much of it shows,
 * 0..1; `loop`: whether it begins again; `missing`: expressions and channels of it that the cast does not have.
 * `number` counts what the character has played, `turn` how often this has begun again. `sound`: the key of what is
 * heard with it, "" for nothing, `heard` seconds since the sound began (below 0: until then); `silent`: why a clip
 * that has a sound is not heard.
 */
export type ClipState = {
  name: string;
  elapsed: number;
  seconds: number;
  share: number;
  loop: boolean;
  missing: string[];
  number: number;
  sound: string;
  heard: number;
  turn: number;
  silent: string;
};

/**
 * A macro: `value` -1..1, where its hand has it; `share`: how much of it shows, 0..1, by its condition, 0 until a
 * hand moves it after a panic.
 */
export type MacroState = { value: number; share: number };

/**
 * The point of a pad on a character: its `place`, -1..1 for each dimension; `plays`: what shows follows it, and
 * nothing else has taken over since.
 */
export type PadPointState = { place: number[]; plays: boolean };

/**
 * The body of a performer whom a source sees. `shares`: how much of it shows in the head, the trunk, the left arm,
 * the right arm and the stance, 0..1; `pose`: 16 bits a number, little-endian: the turns of the bones (a step of
 * 3.5 / 32767 radians), where the hips and both feet are (3 / 32767 leg lengths), the turns of the feet.
 */
export type TrackedState = { shares: number[]; pose: Uint8Array };

/**
 * What a figure does. `poses`: the mix, which sums to one, as those of `regions` that do another; `bodies`: the mix
 * of bodies, in which "own" stands for those of the faces. `pose_call`, `region_calls`, `body_call`: what is called;
 * `fader`: where the T-bar of the poses stands, 0..1. `tracked`: a performer's body, which shows in place of the mix;
 * it is left out while there is none.
 */
export type FigureState = {
  poses: Record<string, number>;
  regions: Partial<Record<"head" | "trunk" | "arm_left" | "arm_right" | "stance", Record<string, number>>>;
  bodies: Record<string, number>;
  pose_call: CallState | null;
  region_calls: Partial<Record<"head" | "trunk" | "arm_left" | "arm_right" | "stance", CallState>>;
  body_call: CallState | null;
  fader: number;
  tracked?: TrackedState | null;
};

/**
 * All that a character has on air.
 * `head`: yaw, pitch, roll; `gaze`: yaw, pitch; `eyes`: left yaw, pitch, right yaw, pitch (radians), as the eyeballs
 * stand. `added`: to the channels, by name: what the gaze makes of lids, and below 0 what
 * other expressions open or shut already. `face_fader`, `expression_fader`: where the T-bars stand, 0..1,
 * with or without a call. `panics` counts them: when it rises, hands are off. `home_next`: the next one brings
 * `home_face` in `home_seconds`. `place`: as it is now, on its way; `presence`: 0 off stage, 1 on it. `leaves`: it has
 * been removed and will be gone. `regions`: the mixes of the regions that show another expression than the face does;
 * `region_calls`: their own calls. `layers`: those that a source drives or that are set otherwise than at first, the
 * lowest first; all else is what they make together. `held`: what hands hold, `None` where that is what is on air.
 * `motion`: what is set of its automatic motion, `None` where nothing was. `speech`: what it says, `None` while it
 * says nothing; `spoken`: the key of what it said to its end last. `clips`: those that it plays, the newest last.
 * `macros`: all that it has. `pads`: where the points of pads are, by name, of those that have been moved since the
 * last panic. `springs`: how much of each is set, of those that are not 1. `complexion`: the blood that shows in
 * cheeks, nose, forehead, around the eyes and in the whole face, tears, sweat, and the metres that these have run;
 * empty where the skin is as ever. `folds`: how much of its folds shows; `skin`: its faders as set, of those that are
 * not 1.
 * `figure`: its poses and its body, `None` while it stands and each face has its own; `idle`: how much of a breath is
 * in its chest, how far its weight is on the left foot, and how far its chest has followed the head to its left, both
 * -1..1.
 */
export type CharacterState = {
  faces: Record<string, number>;
  expressions: Record<string, number>;
  channels: Record<string, number>;
  head: [number, number, number];
  gaze: [number, number];
  eyes: [number, number, number, number];
  added: Record<string, number>;
  face_call: CallState | null;
  expression_call: CallState | null;
  face_fader: number;
  expression_fader: number;
  panics: number;
  home_face: string;
  home_seconds: number;
  home_next: boolean;
  label: string;
  place: Place;
  presence: number;
  leaves: boolean;
  regions: Partial<Record<"brows" | "eyes" | "mouth" | "rest", Record<string, number>>>;
  region_calls: Partial<Record<"brows" | "eyes" | "mouth" | "rest", CallState>>;
  layers: Partial<Record<"breath" | "gaze" | "emotion" | "blink" | "tracker" | "lips" | "playback" | "hands", LayerState>>;
  held: HeldState | null;
  motion: MotionState | null;
  speech: SpeechState | null;
  spoken: string;
  clips: ClipState[];
  macros: Record<string, MacroState>;
  pads: Record<string, PadPointState>;
  springs: Partial<Record<"ears-sway" | "ears-flap" | "jowls-sway" | "cheeks-bounce", number>>;
  complexion: number[];
  folds: number;
  skin: Partial<Record<"folds" | "blood", number>>;
  figure: FigureState | null;
  idle: [number, number, number];
};

/**
 * All that is on air: complete and absolute; the highest (epoch, number) wins, any may be lost.
 * `time`: the show's clock, seconds. `characters`: at least one, in the order in which they were added. `light` sums
 * to one, and so does `framing`: a framing is `*`, all that are on the stage, or names joined by `+`, sorted; behind a
 * `:` the size of its shot, where that is no portrait. `gaze_points`: the named points that eyes may look at, metres
 * as of `look_at`. `black`: how far stages fade their picture to black, 0..1; `black_goal`: where that goes. A record
 * without them has the picture up. `memories`: the names of the looks that were kept, in the order in which they were
 * kept first. `note`: the line of notes of the crew; `began`: when the show began, of `time`. `cues`: how far its
 * lists of cues are, `None` where it has had none. `bus`: whose state it is; that of the preview has panics and homes
 * of air. `looked_at`: the cue that is looked at in preview.
 */
export type State = {
  type: "state";
  epoch: number;
  number: number;
  time: number;
  revision: number;
  characters: Record<string, CharacterState>;
  light: Record<string, number>;
  light_call: CallState | null;
  framing: Record<string, number>;
  framing_call: CallState | null;
  gaze_points: Record<string, [number, number, number]>;
  black: number;
  black_goal: number;
  memories: string[];
  note: string;
  began: number;
  cues: CueStatus | null;
  bus: "air" | "preview";
  looked_at: CueName | null;
};

/** Colours of a face, each `#rrggbb`, hair style, garment, and the traits, plain numbers (`model.cast.Look`). */
export type Look = {
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
  milk: number;
  garment: string;
  cloth: string;
  trim: string;
  pinstripes: number;
  checks: number;
  dots: number;
};

/**
 * A line around an opening, `lid_left`, `lid_right` or `lips`: `loop` (n,) u32 little-endian, rows of the skin in
 * walking order.
 */
export type LineDocument = { name: string; loop: Uint8Array };

/**
 * A drawn mesh, little-endian: `source` (n,) u32 rows of the positions, `uv` (n, 2) f32, `triangles` (t, 3) u32.
 * `openness` (n,) u8: how much of the sky each vertex of the generic face sees.
 */
export type MeshDocument = {
  name: string;
  source: Uint8Array;
  uv: Uint8Array;
  triangles: Uint8Array;
  openness: Uint8Array;
};

/** In which strength a face answers expressions in a region, 0 to 4; `expression`: the one that alone it is for. */
export type FaceGain = { region: string; value: number; expression: string | null };

/**
 * A face: where its positions are, its eyeballs' centres (left, right) and radius in metres, its colours.
 * `ball_radii`: of the left and the right eyeball, what lids must leave. `extremes`: the farthest points
 * of skin and hair, least then greatest x, y and z, metres: what a picture has to hold. `source`: its name in the
 * addresses of compounds, `#` and a content key for an own face; `tags`, `place`: for palettes.
 * `gains`: those that differ from a person's. `albedo`: the digest of its picture, a PNG of sRGB and coverage at
 * `/albedos/DIGEST/SOURCE`, "" for none.
 */
export type FaceDocument = {
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
  albedo: string;
};

/**
 * An expression: its palette, its region, its eyeball angles in radians (left yaw, pitch, right yaw, pitch), and
 * what it adds to the pupils (1 as wide as they go, -1 as narrow). `source`, `tags`, `place`: as of a face. `head`:
 * yaw, pitch and roll, radians, of a face that answers with its head. `complexion`: what it does to the blood of
 * cheeks, nose, forehead, eyes and the whole face, 1 a strong flush, below 0 pallor, to tears and to sweat.
 */
export type ExpressionDocument = {
  name: string;
  label: string;
  kind: "neutral" | "performed" | "arkit" | "makehuman" | "omote" | "spring" | "limb" | "own";
  region: string;
  eyes: [number, number, number, number];
  pupil: number;
  source: string;
  tags: string[];
  place: number;
  head: [number, number, number];
  complexion: [number, number, number, number, number, number, number];
};

/** A hair style: where its strands are, and the shade on the skin that goes with it, 0..1. */
export type HairDocument = { name: string; url: string; scalp: number };

/**
 * Where two lids or the lips may cross (`model.transfer.corrective_regions.Crossing`), little-endian.
 * `upward`: rungs open along +y, else as at rest. `vertices` (32, 4) u32 and `near` (p,) u32: places in the
 * document's rows; `weights` (32, 4), `side`, `share` (p,) f32.
 */
export type CrossingDocument = {
  upward: boolean;
  vertices: Uint8Array;
  weights: Uint8Array;
  near: Uint8Array;
  side: Uint8Array;
  share: Uint8Array;
};

/**
 * How stages correct sums that fold or pierce (`perform.blending.correctives`), little-endian.
 * `rows` (m,) u32: rows of the positions, all else counts in them: `triangles` (t, 3) u32, `lids` and `eye` (r,) u32
 * (0 left), `anchors` (f, k) u32; but `followers` (f,) u32 are rows of the positions too; `weights` (f, k) f32.
 * An allowance counts triangles, then 32 rungs a crossing, then lids. Folds are damped in patches: `patch_triangles`
 * (n,) u32, patch after patch, `patch_ends` (p,) u32; `row_patches` (m, j) u32 patches of a row, `row_shares` f32.
 */
export type CorrectivesDocument = {
  rounds: number[];
  least_area: number;
  floor: number;
  over_relaxation: number;
  least_slope: number;
  full: number;
  momentum: number;
  margin: number;
  farthest: number;
  bulge: number;
  cornea: number;
  deep: number;
  kept: number;
  sliver: number;
  rows: Uint8Array;
  triangles: Uint8Array;
  crossings: CrossingDocument[];
  lids: Uint8Array;
  eye: Uint8Array;
  patch_triangles: Uint8Array;
  patch_ends: Uint8Array;
  row_patches: Uint8Array;
  row_shares: Uint8Array;
  followers: Uint8Array;
  anchors: Uint8Array;
  weights: Uint8Array;
};

/**
 * How much of everything belongs to each region in which an expression can be called alone, brows, eyes, mouth,
 * rest; 65535 is all. Little-endian: `rows` (n, 4) u16 of the positions, `allowances` (m, 4) u16 of the numbers of an
 * allowance.
 */
export type RegionDocument = { rows: Uint8Array; allowances: Uint8Array };

/** A light that can be called. */
export type LightDocument = { name: string; label: string };

/** A body: where its rows are, and by how much it is drawn larger than its person is. */
export type BodyDocument = { name: string; label: string; url: string; size: number };

/**
 * A pose (`model.body.pose`), f32 little-endian: `turns` (bones, 3) radians, `feet` (2, 3) leg lengths,
 * `feet_turns` (2, 3) radians; `travel` leg lengths. `source`: changes when an own pose is saved, as a face's.
 */
export type PoseDocument = {
  name: string;
  label: string;
  source: string;
  turns: Uint8Array;
  travel: [number, number, number];
  feet: Uint8Array;
  feet_turns: Uint8Array;
};

/** A garment that looks may name. */
export type GarmentDocument = { name: string; label: string };

/** The bodies, poses and garments of a cast; `url`: where its `FigureAsset` is. */
export type FiguresDocument = {
  url: string;
  bodies: BodyDocument[];
  poses: PoseDocument[];
  garments: GarmentDocument[];
};

/**
 * All that a page needs to know of the cast; `vertices` counts skin then parts in the order of the meshes.
 * `base`: the digest of the built-in cast, which stays as long as the server does; `digest`: with own things.
 * `folding` (skin,) u8: how far expressions press each vertex together at most, of 255; empty: nothing folds.
 */
export type Manifest = {
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
  correctives: CorrectivesDocument | null;
  regions: RegionDocument | null;
  folding: Uint8Array;
  figures: FiguresDocument | null;
};

/** The positions of a face, (vertices, 3) f32 little-endian, metres. */
export type FaceAsset = { positions: Uint8Array };

/** An own face by its content, as `FaceDocument` and `FaceAsset` have it; its name is its content's key. */
export type ContentAsset = { face: FaceDocument; positions: Uint8Array };

/**
 * Strands of hair on the generic face (`model.hair.HairStyle`), little-endian; n strands of `stations` places.
 * `scale`: metres per count of `points` (n, stations, 3) i16; `rows` (n, stations, links) u32 and `weights` u8 (counts
 * that are to be divided by their sum); `anchors` (n,) u32; `facing` (n, stations, 3) i8, 127 is one; `light`
 * (n, stations) u8, 255 is one; `fullness` (n,) u8, 255 is one: of `width`, metres.
 */
export type HairAsset = {
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
  fullness: Uint8Array;
};

/**
 * A limb field: its channel's name, what drives it (`model.body.limb_field`); `places` (k,) u32 among the rows that
 * lie on limbs, `values` (k, 3) f32: out (a ratio of the radius), round (radians), along (a ratio of the length).
 */
export type LimbFieldAsset = { name: string; driver: string; places: Uint8Array; values: Uint8Array };

/**
 * What all bodies share (`model.body.figure_space`), little-endian; V rows of the head's skin, B of the body.
 * `bones`: their names, `parents` (bones,) i32 -1 for the first; `row_bones` (V + B, 8) u8, `row_weights` u16 of
 * 65535; `shares` (V + B,) u8, 255 is all of dual quaternions; `triangles` (t, 3) u32; `edge` (e,) u32 rows of the
 * head, the first `rim` of them the rim; `joined` (n,) u32 rows of the body, `join` (n, e) f32; `head_joint` (h,) u32,
 * `head_joint_offset` metres; `uvs` (k, 2) f32, `uv_rows` (t, 3) u32; `skirt` (s, 3) u32: its triangles, whose rows
 * are the last of the body; `bending` (c,) u32 rows with correctives, `bending_hinges` (c,) u8; `garments` (g, V + B,
 * 4) f32, metres: cover, thick, trim and hidden of each garment, in the manifest's order (`model.body.garment`);
 * `limb_rows` (l,) u32 rows that lie on limbs, `limbs` (l,) u8 which one, `limb_ways` (l,) f32 how far along it.
 */
export type FigureAsset = {
  bones: string[];
  parents: Uint8Array;
  head_rows: number;
  row_bones: Uint8Array;
  row_weights: Uint8Array;
  shares: Uint8Array;
  triangles: Uint8Array;
  edge: Uint8Array;
  rim: number;
  joined: Uint8Array;
  join: Uint8Array;
  head_joint: Uint8Array;
  head_joint_offset: [number, number, number];
  uvs: Uint8Array;
  uv_rows: Uint8Array;
  skirt: Uint8Array;
  bending: Uint8Array;
  bending_hinges: Uint8Array;
  garments: Uint8Array;
  limb_rows: Uint8Array;
  limbs: Uint8Array;
  limb_ways: Uint8Array;
  limb_fields: LimbFieldAsset[];
};

/**
 * A body, f32 little-endian, metres: `positions` (B, 3), `edge` (e, 3), `joints` and `ends` (bones, 3),
 * `correctives` (4 c, 3) of the rows that bend.
 */
export type BodyAsset = {
  positions: Uint8Array;
  edge: Uint8Array;
  joints: Uint8Array;
  ends: Uint8Array;
  correctives: Uint8Array;
};

/**
 * What one compound alone uses up of the correctives' limits (`perform.blending.correctives`), little-endian:
 * `places` (n,) u32, `values` (n,) f32.
 */
export type AllowanceDocument = { places: Uint8Array; values: Uint8Array };

/**
 * A retargeted expression: a compound minus its face at rest, little-endian: `scale` metres per count, `indices`
 * (n,) u32, `deltas` (n, 3) i16.
 */
export type CompoundAsset = {
  scale: number;
  indices: Uint8Array;
  deltas: Uint8Array;
  allowed: AllowanceDocument | null;
};

/**
 * Who a page is to the show: a role, and a name where the token is somebody's own. `asked`: whether the show asks
 * for tokens at all.
 */
export type AccessDocument = { role: "view" | "operate" | "edit" | "admin"; name: string; asked: boolean };

/**
 * Somebody who has a token: `made` and `until` in seconds since 1970, `until` `None` for ever. `links`: how many of
 * their pages and programs are connected; `own`: it is who asks.
 */
export type PersonDocument = {
  id: string;
  name: string;
  role: "view" | "operate" | "edit" | "admin";
  made: number;
  until: number | null;
  links: number;
  own: boolean;
};

/** Everybody who has a token. */
export type PeopleDocument = { people: PersonDocument[] };

/** Asks for a token: for a name, with a role, and for how many hours (`None`: for ever). */
export type NewPerson = { name: string; role: "view" | "operate" | "edit" | "admin"; hours: number | null };

/** The address by which somebody enters, with their token, and a QR code of it: a picture in a `data:` address. */
export type CodeDocument = { id: string; address: string; picture: string };

export type FromClient =
  | Bind
  | Unbind
  | Learn
  | LoadPreset
  | RestoreBindings
  | ChooseBank
  | CallFace
  | CallExpression
  | FadeFace
  | ReleaseFace
  | FadeExpression
  | ReleaseExpression
  | CallPose
  | FadePose
  | ReleasePose
  | CallBody
  | Panic
  | SetHome
  | AddCharacter
  | RemoveCharacter
  | RestoreCharacter
  | RenameCharacter
  | PlaceCharacter
  | EnterCharacter
  | LeaveCharacter
  | PlayClip
  | StopClip
  | RecordClip
  | KeepPass
  | EditClip
  | EditLane
  | ReplaceSpan
  | DropLane
  | RenameClip
  | CopyClip
  | DropClip
  | RestoreClip
  | Go
  | GoBack
  | GoToCue
  | AssertLook
  | SetStandby
  | PauseCues
  | ChooseCueList
  | PutCue
  | PutMove
  | DropMove
  | RecordCue
  | UpdateCue
  | CopyCue
  | MoveCue
  | DropCue
  | RenumberCues
  | AddCueList
  | RenameCueList
  | DropCueList
  | UndoCues
  | RedoCues
  | SetShowMode
  | Plug
  | Unplug
  | MidiBytes
  | Controls
  | WatchDevices
  | SwitchDevice
  | SetChannel
  | SetHead
  | SetGaze
  | SetGazePoint
  | DeleteGazePoint
  | SetMapping
  | SetMappings
  | RenameMapping
  | DropMapping
  | RestoreMapping
  | MoveMacro
  | LearnMapping
  | FinishMapping
  | SetPad
  | RenamePad
  | CopyPad
  | DropPad
  | AddCastPads
  | RestorePad
  | MovePad
  | KeepSetup
  | CallSetup
  | DropSetup
  | RestoreSetup
  | KeepFace
  | KeepExpression
  | RenameItem
  | DeleteItem
  | RestoreItem
  | CopyItem
  | SetLayer
  | SetLayout
  | RenameLayout
  | DropLayout
  | Lease
  | ReleaseLease
  | SetLeases
  | AppointManager
  | Hello
  | Cancel
  | Ping
  | KeepMemory
  | CallMemory
  | DeleteMemory
  | RestoreMemory
  | SetMotion
  | LookAt
  | MakeGesture
  | SetSpring
  | SetSkin
  | CallLight
  | CallFraming
  | CallBlack
  | Take
  | ResetPreview
  | PreviewCue
  | MarkMoment
  | KeepRecording
  | KeepClip
  | DeleteRecording
  | SetNote
  | BeginShow
  | Source
  | Drive
  | LeaveSource
  | RouteSource
  | CalibrateSource
  | MeasureSource
  | TuneSource
  | WatchSource
  | SayByVoice
  | Say
  | PlaySound
  | StopSpeaking
  | RenameSound
  | DropSound
  | RestoreSound
  | Drawing;

export type FromServer =
  | BindingList
  | BindingsChanged
  | Clips
  | ClipWork
  | Devices
  | InputLog
  | DeviceBytes
  | Hands
  | MappingLearned
  | MappingList
  | PadList
  | SetupList
  | SetupChanged
  | Kept
  | ItemChanged
  | Layouts
  | Leases
  | LeaseClaim
  | Pong
  | Welcome
  | Refused
  | Notices
  | Progress
  | MemoryList
  | RecordingKept
  | SourceIs
  | Sources
  | SourceValues
  | Sounds
  | SoundDropped
  | Crew
  | PlaysSound
  | CastChanged
  | State;

/** A part's way to a goal, in a cue. */

export type Move = {
  goal: Record<string, number>;
  seconds: number;
  easing: string;
  delay: number;
};

/** What a cue does once when it is called: a message to another program, or a line that somebody says. */

export type CueAction = {
  does: "osc" | "midi" | "say";
  to: string;
  what: string;
  delay: number;
  voice: string;
  sound: string;
};

/** What one GO plays: it says what it moves, and all else goes on as the cues before it have left it. */

export type Cue = {
  identity: string;
  number: string;
  moves: Record<string, Move>;
  label: string;
  note: string;
  colour: string;
  pre_wait: number;
  post_wait: number;
  goes_on: "" | "continue" | "follow";
  skip: boolean;
  actions: CueAction[];
};

/** What a pad shows at one place. */

export type PadLook = {
  label: string;
  mix: Record<string, number>;
  place: number[];
};

/** The half of a target below the middle of its macro. */

export type HalfBelow = {
  high: number;
  curve: [number, number][];
};

/** One of the targets of a macro: what it gives of it, and how that follows. */

export type MacroTarget = {
  to: string;
  low: number;
  high: number;
  curve: [number, number][];
  below: HalfBelow | null;
  rise: number;
  fall: number;
};

/** Where a macro plays at all: while something is above a level, or below it. */

export type MacroCondition = {
  reads: string;
  level: number;
  above: boolean;
  hysteresis: number;
};

/** What a macro plays: one number under a hand, several targets. */

export type MacroMapping = {
  name: string;
  targets: MacroTarget[];
  when: MacroCondition | null;
};
