/** What a control of a device can play, as an address of OSC, and how people read it. */

import type { BindingDocument } from "../../link/messages";
import type { Axis, LookKind } from "../store/axis";
import type { ConsoleStore } from "../store/console_store";
import type { Seconds } from "../store/timing";

/** An address with the part of it that is moved (`axis`), or with what a call is given (`arguments`). */
export type Target = Pick<BindingDocument, "to" | "axis" | "arguments">;

/** What reading a target needs: labels of the cast and of characters. */
export interface Labels {
  label(axis: Axis, name: string): string;
  character(name: string): string;
}

/** The labels that a console has. */
export const labelsOf = (store: ConsoleStore): Labels => ({
  label: (axis, name) => store.label(axis, name),
  character: (name) => (name === "*" ? "all" : (store.state?.characters[name]?.label ?? name)),
});

const ROOT = "/omote";

/** Characters as an address names them: one, all, or those in braces. */
export const whoOf = (names: readonly string[]): string =>
  names.length === 1 ? (names[0] as string) : `{${names.join(",")}}`;

const moved = (who: string, path: string, axis = ""): Target => ({ to: `${ROOT}/${who}/${path}`, axis, arguments: [] });

export const channelTarget = (who: string, name: string): Target => moved(who, `channel/${name}`);
/** A macro; its middle is 0. */
export const macroTarget = (who: string, name: string): Target => moved(who, `macro/${name}`);
export const barTarget = (who: string, axis: LookKind): Target => moved(who, `fade/${axis}`);
export const layerTarget = (who: string, layer: string, part: string | null): Target =>
  moved(who, part === null ? `layer/${layer}` : `layer/${layer}/${part}`);
export const directionTarget = (who: string, what: "head" | "gaze", part: string): Target => moved(who, what, part);
export const padTarget = (who: string, name: string, axis: string): Target => moved(who, `pad/${name}`, axis);
export const panicTarget = (who: string): Target => moved(who, "panic");
export const releaseTarget = (who: string, axis: LookKind): Target => moved(who, `release/${axis}`);
export const lightTarget = (name: string, seconds: number): Target => ({
  to: `${ROOT}/light`,
  axis: "",
  arguments: [name, seconds],
});

export const memoryTarget = (name: string, seconds: number): Target => ({
  to: `${ROOT}/memory`,
  axis: "",
  arguments: [name, seconds],
});

/** A clip that is played, and the end of all that are. */
export const clipTarget = (who: string, name: string): Target => ({ ...moved(who, "clip"), arguments: [name] });
export const stopClipsTarget = (who: string): Target => moved(who, "stop_clip");

/** How black all stages are: a fader's, or a key's that makes a blackout. */
export const BLACK_TARGET: Target = { to: `${ROOT}/black`, axis: "", arguments: [] };

/** GO of the cues, and what takes it back. */
export const GO_TARGET: Target = { to: `${ROOT}/go`, axis: "", arguments: [] };
export const BACK_TARGET: Target = { to: `${ROOT}/back`, axis: "", arguments: [] };

/** A call of a face or an expression; without seconds it is by hand. */
export const callTarget = (who: string, axis: Axis, name: string, seconds: Seconds): Target => ({
  to: `${ROOT}/${who}/${axis}`,
  axis: "",
  arguments: [name, seconds ?? "hand"],
});

/** Equal for targets that play the same; the seconds of a call do not count. */
export const targetKey = ({ to, axis, arguments: [name] }: Target): string => JSON.stringify([to, axis, name ?? ""]);

/** Whether a fader moves it; a key alone plays the rest. */
export const isLevel = ({ to }: Pick<Target, "to">): boolean =>
  /\/(channel\/[^/]+|macro\/[^/]+|layer\/[^/]+(\/[^/]+)?|layer_on\/[^/]+|head|gaze|pad\/[^/]+|fade\/\w+|place|black)$/.test(
    to,
  );

/** The character of an address, "" for what is the whole show's. */
export function characterOf(to: string): string {
  const [, , who, ...rest] = to.split("/");
  return rest.length > 0 ? (who ?? "") : "";
}

/** What a target does, without whom it plays. */
export function targetLabel(target: Target, labels: Pick<Labels, "label">): string {
  if (target.to.startsWith("bank:")) return `turn to bank ${target.to.slice("bank:".length)}`;
  const [, , ...path] = target.to.split("/");
  const [what = "", name = "", part = ""] = characterOf(target.to) === "" ? path : path.slice(1);
  const [called, seconds] = target.arguments;
  const time = seconds === undefined ? "" : typeof seconds === "number" ? `, ${seconds} s` : ", by hand";
  if (what === "channel") return labels.label("expression", name);
  if (what === "layer") return `influence of ${name}${part === "" ? "" : ` on ${part}`}`;
  if (what === "macro") return `macro ${name}`;
  if (what === "pad") return `pad ${name} ${target.axis}`.trim();
  if (what === "layer_on") return `${name} on or off`;
  if (what === "fade") return `${name} T-bar`;
  if (what === "release") return `let go of the ${name} T-bar`;
  if (what === "face" || what === "expression") return `${what} ${labels.label(what, String(called))}${time}`;
  const words = what.replaceAll("_", " ");
  if (typeof called === "number") return `${words}, ${called} s`;
  if (called !== undefined) return `${words} ${called}${time}`;
  return target.axis === "" ? words : `${words} ${target.axis}`;
}

/** The same with whom it plays. */
export function targetText(target: Target, labels: Labels): string {
  const who = characterOf(target.to);
  return who === "" ? targetLabel(target, labels) : `${targetLabel(target, labels)} of ${labels.character(who)}`;
}

/** A control's name where there is little room: `cc7`, `n60`, `b3`. */
export function shortControl(control: string): string {
  return control
    .replace(/^1\//, "")
    .replace(/\b(note|button|axis|trigger|program)(?=\d)/, (word) => word[0] as string)
    .replace("pressure", "prs");
}

/**
 * The controls of bindings where there is little room: `a0 a1`; where two devices of one name are bound, with the
 * number of each: `2: a0 a1`. `devices`: all that are bound.
 */
export function shortControls(
  bindings: readonly Pick<BindingDocument, "device" | "control">[],
  devices: readonly string[],
): string {
  const controls = new Map<string, Set<string>>();
  for (const { device, control } of bindings)
    controls.set(device, (controls.get(device) ?? new Set()).add(shortControl(control)));
  return [...controls].map(([device, names]) => `${numberAmong(device, devices)}${[...names].join(" ")}`).join(" ");
}

/** Which of several devices of one name it is; "" where there is one alone. */
function numberAmong(device: string, devices: readonly string[]): string {
  const plain = (name: string): string => name.replace(/ \d+$/, "");
  const twins = new Set(devices.filter((other) => plain(other) === plain(device)));
  return twins.size < 2 ? "" : `${/ (\d+)$/.exec(device)?.[1] ?? 1}: `;
}

/** Bindings by what they play, as `targetKey` tells it apart. */
export function bindingsByTarget(
  bindings: readonly BindingDocument[],
  key: (binding: BindingDocument) => string = targetKey,
): ReadonlyMap<string, readonly BindingDocument[]> {
  const groups = new Map<string, BindingDocument[]>();
  for (const binding of bindings) groups.set(key(binding), [...(groups.get(key(binding)) ?? []), binding]);
  return groups;
}
