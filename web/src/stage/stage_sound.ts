/** The sounds that characters speak with, played on the stage's playout clock: in time with the lips that it draws. */

import { fetchWithRetry } from "../link/assets";
import type { Drawing, State } from "../link/messages";

/** Seconds within which sounds that begin are one. */
const TOGETHER = 0.08;
/** Seconds that a sound may be away from its lips, and for how long, before it is started anew at the right place. */
const FARTHEST = 0.12;
const PATIENCE = 1;
/** Seconds in which a sound that is interrupted fades. */
const FADE = 0.03;
/** Seconds in which the show says again that this stage plays. */
const CONFIRMATION = 1.5;
/** Seconds after which a sound that did not come is fetched again, while it is wanted. */
const AGAIN = 0.5;
/** Sounds that are kept decoded. */
const KEPT = 16;

/** A sound that is to be heard: `begin` is the server's time of its first sample. */
export interface WantedSound {
  id: string;
  key: string;
  begin: number;
}

/** Whether this stage may play sounds: never, where the show asks it to, or before all others. */
export type SoundWish = "never" | "may" | "here";

/**
 * The sounds of a state, of what is said and of clips; those that begin together with the same one, of several characters
 * or of a clip and the pass that is played to it, make one. `only`: the character that is shown.
 */
export function wantedSounds(state: State, only: string | undefined): WantedSound[] {
  const sounds: WantedSound[] = [];
  const want = (id: string, key: string, begin: number): void => {
    const twin = sounds.some((sound) => sound.key === key && Math.abs(sound.begin - begin) < TOGETHER);
    if (key !== "" && !twin) sounds.push({ id, key, begin });
  };
  for (const [name, { speech, clips }] of Object.entries(state.characters)) {
    if (only !== undefined && only !== name) continue;
    if (speech) want(`${name} ${speech.number}`, speech.sound, state.time - speech.elapsed);
    for (const clip of clips) want(`${name} clip ${clip.number} ${clip.turn}`, clip.sound, state.time - clip.heard);
  }
  return sounds;
}

/** The sounds that a state will need. */
export function comingSounds(state: State): string[] {
  const keys = Object.values(state.characters).flatMap(({ speech, clips }) => [
    ...(speech ? [speech.sound, speech.next_sound] : []),
    ...clips.map(({ sound }) => sound),
  ]);
  return keys.filter((key) => key !== "");
}

interface Playing {
  key: string;
  source: AudioBufferSourceNode;
  gain: GainNode;
  /** The context's time of the sound's first sample. */
  origin: number;
  /** The context's time since when it has been too far away, and the origins that it should have had since then. */
  away: { since: number; origins: number[] } | undefined;
}

/**
 * Where a sound should begin that has been too far from there for too long: the mean, since single pictures of a busy
 * machine come early and late. Undefined while it is near, or behind for a moment only.
 */
function newOrigin(playing: Playing, origin: number, time: number): number | undefined {
  if (Math.abs(playing.origin - origin) < FARTHEST) {
    playing.away = undefined;
    return undefined;
  }
  playing.away ??= { since: time, origins: [] };
  const { since, origins } = playing.away;
  origins.push(origin);
  return time - since > PATIENCE ? origins.reduce((sum, each) => sum + each, 0) / origins.length : undefined;
}

/** What tests ask of the sounds of a stage. */
export interface SoundReport {
  state: NonNullable<Drawing["sound"]>;
  plays: boolean;
  /** How many sounds were begun. */
  begun: number;
  playing: string[];
  /** How loud it will be in `latency` seconds: the largest sample of the last few milliseconds. */
  level: number;
  /** Seconds until what the page plays now is heard. */
  latency: number;
}

/** Plays sounds while the show says that this stage does; `changed`: it can play now, or cannot any more. */
export class StageSound {
  /** Whether this is the stage that plays. */
  plays = false;
  private context: AudioContext | undefined;
  private analyser: AnalyserNode | undefined;
  private readonly buffers = new Map<string, Promise<void> | AudioBuffer>();
  private readonly playing = new Map<string, Playing>();
  private wanted: WantedSound[] = [];
  private begun = 0;
  /** Until when the show must say again that this stage plays, after the link broke. */
  private confirmed = Infinity;

  constructor(
    private readonly wish: SoundWish,
    private readonly changed: () => void,
  ) {
    const unblock = (): void => void this.context?.resume();
    for (const event of ["pointerdown", "keydown"] as const) addEventListener(event, unblock);
  }

  /** Whether it can play, as a heartbeat says it. Before the first sound nobody knows: a click would make sure. */
  get state(): NonNullable<Drawing["sound"]> {
    if (this.wish === "never") return "";
    const allowed = this.context ? this.context.state === "running" : navigator.userActivation?.hasBeenActive;
    return allowed ? "ready" : "blocked";
  }

  /** Why nothing is heard here that should be; "" where all is well. */
  get notice(): string {
    if (!this.plays || this.wanted.length === 0 || this.context === undefined || this.state !== "blocked") return "";
    return "No sound before a click on this page: click it once. Nobody there to click? Open a stage with ?\u2060sound=1.";
  }

  /** The show says whether this stage plays. */
  choose(on: boolean): void {
    this.plays = on;
    this.confirmed = Infinity;
  }

  /** The link is back: what plays goes on, unless the show has chosen another stage meanwhile. */
  relinked(time: number): void {
    this.confirmed = time + CONFIRMATION;
  }

  /** A state has come: fetches what will be needed, and stops what is no longer said. */
  follow(state: State, only: string | undefined, time: number): void {
    if (this.wish === "never") return;
    if (time > this.confirmed) this.choose(false);
    this.wanted = wantedSounds(state, only);
    for (const key of comingSounds(state)) this.load(key);
    for (const [id, playing] of this.playing) {
      if (!this.plays || !this.wanted.some((sound) => sound.id === id)) this.stop(id, playing);
    }
  }

  /** Begins what is due; `place`: where in server time the picture is that is seen now, seconds: not the one that is being drawn. */
  play(place: number): void {
    const { context } = this;
    if (!this.plays || context === undefined || context.state !== "running") return;
    for (const { id, key, begin } of this.wanted) {
      const buffer = this.buffers.get(key);
      if (!(buffer instanceof AudioBuffer)) continue;
      const seen = context.currentTime - (place - begin) - (context.outputLatency || 0);
      const playing = this.playing.get(id);
      const origin = playing === undefined ? seen : newOrigin(playing, seen, context.currentTime);
      if (origin === undefined) continue;
      if (playing !== undefined) this.stop(id, playing);
      if (origin + buffer.duration > context.currentTime) this.begin(context, id, key, buffer, origin);
    }
  }

  report(): SoundReport {
    const samples = new Float32Array(this.analyser?.fftSize ?? 0);
    this.analyser?.getFloatTimeDomainData(samples);
    const level = samples.reduce((most, sample) => Math.max(most, Math.abs(sample)), 0);
    const playing = [...this.playing.keys()];
    const latency = this.context?.outputLatency || 0;
    return { state: this.state, plays: this.plays, begun: this.begun, playing, level, latency };
  }

  private begin(context: AudioContext, id: string, key: string, buffer: AudioBuffer, origin: number): void {
    const source = new AudioBufferSourceNode(context, { buffer });
    const gain = new GainNode(context);
    source.connect(gain).connect(this.analyser as AnalyserNode);
    source.start(Math.max(origin, 0), Math.max(context.currentTime - origin, 0));
    source.onended = () => this.playing.get(id)?.source === source && this.playing.delete(id);
    this.playing.set(id, { key, source, gain, origin, away: undefined });
    this.begun += 1;
  }

  private stop(id: string, { source, gain }: Playing): void {
    this.playing.delete(id);
    const at = this.context?.currentTime ?? 0;
    gain.gain.setTargetAtTime(0, at, FADE / 3);
    source.stop(at + FADE * 2);
  }

  /** Fetches and decodes a sound, once. */
  private load(key: string): void {
    const context = this.open();
    if (this.buffers.has(key)) return;
    const loading = fetchWithRetry(`/sounds/${encodeURIComponent(key)}`)
      .then((bytes) => context.decodeAudioData(bytes.slice().buffer))
      .then((buffer) => void this.buffers.set(key, buffer))
      .catch((error: unknown) => {
        console.warn(`The sound ${key} cannot be played: ${String(error)}`);
        setTimeout(() => this.buffers.delete(key), AGAIN * 1000); // a show that was started again gets it again
      });
    this.buffers.set(key, loading);
    const oldest = this.buffers.keys().next().value;
    if (this.buffers.size > KEPT && oldest !== undefined) this.buffers.delete(oldest);
  }

  /** The context, made with the first sound: a page that never plays one needs no leave. */
  private open(): AudioContext {
    if (this.context !== undefined) return this.context;
    const context = new AudioContext({ latencyHint: "interactive" });
    this.analyser = new AnalyserNode(context, { fftSize: 256 });
    this.analyser.connect(context.destination);
    this.context = context;
    context.onstatechange = () => this.changed();
    this.changed();
    return context;
  }
}
