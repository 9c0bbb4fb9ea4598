/** The fields of a binding as people write and read them. */

import type { BindingDocument } from "../../link/messages";
import { isLevel } from "./binding_target";

/** A binding that says nothing yet, of a fader. */
export const FIRST_BINDING: BindingDocument = {
  device: "",
  control: "",
  to: "",
  axis: "",
  arguments: [],
  low: null,
  high: null,
  curve: 1,
  pick_up: true,
  button: "",
  relative: "",
  step: 1 / 128,
  bank: "",
  dead_zone: 0,
};

/** Arguments as they are written: numbers where they are numbers. */
export const readArguments = (text: string): (string | number)[] =>
  text
    .split(",")
    .map((part) => part.trim())
    .filter((part) => part !== "")
    .map((part) => (Number.isFinite(Number(part)) ? Number(part) : part));

export function rangeText({ low, high }: BindingDocument): string {
  if (low === null && high === null) return "whole";
  return `${low === null ? "…" : rounded(low)} to ${high === null ? "…" : rounded(high)}`;
}

const rounded = (value: number): string => String(Math.round(value * 1000) / 1000);

export function modeText(binding: BindingDocument): string {
  if (binding.button !== "") return binding.button;
  if (binding.relative !== "") return `encoder, ${binding.relative.replaceAll("_", " ")}`;
  return isLevel(binding) ? "fader" : "key";
}
