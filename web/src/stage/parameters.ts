/** Reads and checks the parameters of a stage's address. */

import type { WallTile } from "../face/framing";
import type { Triple } from "../face/light/tone";
import { decodeSrgb } from "../face/light/tone";
import type { Level } from "../face/quality/quality_levels";
import type { Bus } from "../link/bus";
import { BACKGROUNDS, LEVELS, LIGHTS, SHOT_SIZES } from "../link/constants";
import type { ShotSize } from "../link/framings";
import type { SoundWish } from "./stage_sound";

/** Everything a stage is told by its address. */
export interface StageParameters {
  transparent: boolean;
  /** One colour behind the head, in linear light; undefined: what the light brings. */
  background: Triple | undefined;
  /** A light of this stage alone; undefined: the one on air. */
  light: string | undefined;
  /** Whether heads wear their hair. */
  hair: boolean;
  hud: boolean;
  /** What the picture may cost; "auto": as much as the machine draws in time. */
  quality: Level | "auto";
  tile: WallTile | undefined;
  /** What it shows: what is on air, or the preview. */
  bus: Bus;
  /** Whether this stage plays the sounds that characters speak with. */
  sound: SoundWish;
  /** The one character that is shown, alone; undefined: the scene. */
  character: string | undefined;
  /** How much of its figures the picture shows; undefined: heads alone. */
  shotSize: ShotSize | undefined;
  /** What the crew calls this stage; "" for none. */
  name: string;
}

/** Letters of a label; the show keeps none that are longer. */
const LONGEST_LABEL = 80;
const PARAMETERS = [
  "transparent",
  "background",
  "light",
  "hair",
  "tile",
  "of",
  "bezel",
  "quality",
  "hud",
  "character",
  "name",
  "sound",
  "bus",
  "shot",
];
const QUALITIES: readonly string[] = ["auto", ...LEVELS];

/** A parameter that cannot be obeyed; its message is a sentence for the page. */
export class ParameterError extends Error {}

/** The parameters of an address, with what follows its "#", e.g. `?tile=0,1&of=3x3&bezel=2`; ParameterError when one makes no sense. */
export function readParameters(query: string): StageParameters {
  const parameters = new URLSearchParams(query);
  for (const name of parameters.keys())
    if (!PARAMETERS.includes(name))
      throw new ParameterError(`There is no parameter "${name}"; a stage knows ${PARAMETERS.join(", ")}.`);
  const tile = readTile(parameters);
  const bus = readBusOf(parameters.get("bus"));
  if (tile !== undefined && bus === "preview")
    throw new ParameterError("bus=preview and tile exclude each other: a wall shows what is on air.");
  return {
    transparent: readSwitch(parameters, "transparent"),
    background: readBackground(parameters),
    light: readLight(parameters.get("light")),
    hair: !parameters.has("hair") || readSwitch(parameters, "hair"),
    hud: readSwitch(parameters, "hud"),
    quality: readQuality(parameters.get("quality")),
    tile,
    bus,
    character: readCharacter(parameters.get("character")),
    sound: !parameters.has("sound") ? "may" : readSwitch(parameters, "sound") ? "here" : "never",
    shotSize: readShot(parameters.get("shot")),
    name: readName(parameters.get("name")),
  };
}

function readSwitch(parameters: URLSearchParams, name: string): boolean {
  const value = parameters.get(name);
  if (value === null || value === "0") return false;
  if (value === "" || value === "1") return true;
  throw new ParameterError(`${name}=${value} is neither on nor off; write ${name}=1 or leave it out.`);
}

function readBusOf(value: string | null): Bus {
  if (value === null || value === "air" || value === "preview") return value ?? "air";
  throw new ParameterError(`bus=${value} is unknown; write air or preview.`);
}

function readCharacter(value: string | null): string | undefined {
  if (value === null) return undefined;
  if (value.trim() !== "" && value.length <= LONGEST_LABEL) return value.trim();
  throw new ParameterError(
    `character=${value} names no character: give its name or its label, at most ${LONGEST_LABEL} letters, as in character=one.`,
  );
}

function readName(value: string | null): string {
  const name = (value ?? "").trim();
  if (value === null || (name.length > 0 && name.length <= 24)) return name;
  throw new ParameterError(`name=${value} is no name of a stage: 1 to 24 letters, as in name=left.`);
}

/** A colour's name, or `#rrggbb`; an address may write it with its "#" as it is, or leave that out. */
function readBackground(parameters: URLSearchParams): Triple | undefined {
  const value = parameters.get("background");
  if (value === null) return undefined;
  const named: Readonly<Record<string, string>> = BACKGROUNDS;
  const colour = named[value.toLowerCase()] ?? value;
  if (!/^#?[0-9a-f]{6}$/i.test(colour)) {
    const names = Object.keys(BACKGROUNDS).join(", ");
    throw new ParameterError(`background=${value} is no colour; write ${names}, or #rrggbb, for example #00b140.`);
  }
  if (readSwitch(parameters, "transparent"))
    throw new ParameterError(`background=${value} and transparent exclude each other; leave one of them out.`);
  return decodeSrgb(colour.startsWith("#") ? colour : `#${colour}`);
}

function readLight(value: string | null): string | undefined {
  if (value === null) return undefined;
  if (!Object.keys(LIGHTS).includes(value))
    throw new ParameterError(`light=${value} is unknown; write ${Object.keys(LIGHTS).join(", ")}.`);
  return value;
}

function readShot(value: string | null): ShotSize | undefined {
  const size = SHOT_SIZES.find((name) => name === value);
  if (value === null || size !== undefined) return size;
  throw new ParameterError(`shot=${value} is unknown; write one of ${SHOT_SIZES.join(", ")}, or leave it out: heads.`);
}

function readQuality(value: string | null): Level | "auto" {
  if (value === null) return "auto";
  if (!QUALITIES.includes(value))
    throw new ParameterError(`quality=${value} is unknown; write one of ${QUALITIES.join(", ")}.`);
  return value as Level | "auto";
}

function readTile(parameters: URLSearchParams): WallTile | undefined {
  const place = parameters.get("tile");
  const of = parameters.get("of");
  if (place === null && of === null && parameters.get("bezel") === null) return undefined;
  const [column, row] = readPair(place, ",", "tile", "tile=0,1 (column, row, counted from 0 at the upper left)");
  const [columns, rows] = readPair(of, "x", "of", "of=3x3 (columns x rows)");
  if (columns < 1 || rows < 1 || columns > 64 || rows > 64)
    throw new ParameterError(`of=${of} is no wall; write 1x1 to 64x64.`);
  if (column >= columns || row >= rows)
    throw new ParameterError(`tile=${place} lies outside a wall of ${columns}x${rows}; columns and rows count from 0.`);
  return { column, row, columns, rows, bezel: readBezel(parameters.get("bezel")) };
}

function readPair(text: string | null, mark: string, name: string, example: string): [number, number] {
  const match = text === null ? null : new RegExp(`^(\\d{1,3})${mark}(\\d{1,3})$`).exec(text);
  if (match === null) throw new ParameterError(`${name}=${text ?? ""} is not understood; write ${example}.`);
  return [Number(match[1]), Number(match[2])];
}

/** Per cent of a picture's width, or two values for width and height. */
function readBezel(text: string | null): [number, number] {
  if (text === null) return [0, 0];
  const parts = text.split(",").map((part) => (part.trim() === "" ? Number.NaN : Number(part)));
  const [across, down = across] = parts;
  if (across === undefined || down === undefined || parts.length > 2 || !(inBezel(across) && inBezel(down)))
    throw new ParameterError(
      `bezel=${text} is not understood; write per cent of a picture's size, 0 to 50: bezel=3 or bezel=3,4.`,
    );
  return [across / 100, down / 100];
}

const inBezel = (value: number): boolean => value >= 0 && value <= 50;
