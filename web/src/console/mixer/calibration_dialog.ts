/** A performer before a tracker is measured: face at rest, then the largest of each move, seen as bars. */

import { html, nothing, type PropertyValues } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { SourceState } from "../../link/messages";
import { base } from "../../ui/theme";
import { whileShown } from "../../ui/topic_element";
import { ConsoleDialog, sheet } from "../controls/console_dialog";
import { LayerCommands } from "./layer_commands";
import "./source_tuning";
import type { Topic } from "../store/page_store";
import { sourceLabel } from "../store/source_label";
import { adviceOnRest, type CalibrationStep, channelsOf, stepsFor } from "./calibration_steps";
import { calibrationStyle } from "./calibration_style";
import "./value_bars";

/** The source `name`, step by step. Tells `close`. */
@customElement("omote-calibration-dialog")
export class CalibrationDialog extends ConsoleDialog {
  protected override readonly first = ".main";
  @property() name = "";
  @state() private at = 0;
  /** The channels that it sends, once they have come. */
  @state() private names: readonly string[] = [];

  static override styles = [base, sheet, calibrationStyle];

  protected override readonly topics: readonly Topic[] = ["sources", "link", "manifest"];

  constructor() {
    super();
    whileShown(this, () => {
      const looks = setInterval(() => this.#look(), 200);
      return () => {
        clearInterval(looks);
        this.#stop();
        this.context.sources.watch("");
      };
    });
  }

  protected override updated(changed: PropertyValues): void {
    if (changed.has("name")) this.context.sources.watch(this.name);
  }

  get #source(): SourceState | null {
    return this.store.sources.find(({ name }) => name === this.name) ?? null;
  }

  get #steps(): readonly CalibrationStep[] {
    return stepsFor(this.names);
  }

  /** Channels come with the first values; a link that was lost is asked again. */
  #look(): void {
    const { watched } = this.context.sources;
    if (watched === null) this.context.sources.watch(this.name);
    else if (watched.names.join() !== this.names.join()) this.names = watched.names;
  }

  override render() {
    const source = this.#source;
    return html`<section class="panel" role="dialog" aria-modal="true" aria-label="Calibration of ${sourceLabel(this.name)}">
      <div class="row"><h2>Calibration of ${sourceLabel(source?.performer ?? this.name)}</h2>
        <button class="close" @click=${this.close}>Close</button></div>
      ${source === null ? html`<p>${sourceLabel(this.name)} does not send any more.</p>` : this.#measure(source)}
    </section>`;
  }

  #measure(source: SourceState) {
    const steps = this.#steps;
    const step = steps[this.at] ?? steps[0];
    if (step === undefined) return html`<p>Waiting for ${sourceLabel(this.name)} to see a face.</p>`;
    const measured = step.of.length === 0 ? [] : channelsOf(step, this.names);
    return html`<ol aria-label="Faces to make">${steps.map((listedStep, at) => this.#tab(source, listedStep, at))}</ol>
      <div class="row now"><p class="asks" role="status">${step.asks}</p>
        <button class="main" @click=${() => this.#press(source, step)}>${words(source, step)}</button>
        <button @click=${() => this.#go(this.at + 1)} ?disabled=${this.at + 1 >= steps.length}>Next</button></div>
      <p class="unrest" role="status">${adviceOnRest(source.neutral)}</p>
      <div class="bars"><omote-value-bars .context=${this.context} .names=${sorted(this.names, measured)} .wanted=${measured}></omote-value-bars></div>
      <p class="key">Upper bar: as it comes. Lower, red: as it is read.</p>
      <div class="tuning"><omote-source-tuning .context=${this.context} .source=${source}></omote-source-tuning>
        <omote-source-tuning .context=${this.context} .source=${source} numbers></omote-source-tuning></div>
      <div class="row"><button data-mirror aria-pressed=${source.mirror} title="Left and right are swapped"
          @click=${() => new LayerCommands(this.store).tune(source, { mirror: !source.mirror })}>Mirror</button>
        <button ?disabled=${!source.calibrated} title="It is read as it sends; Undo brings it back"
          @click=${() => this.context.sources.calibrate(source, "reset")}>Forget all</button></div>`;
  }

  #tab(source: SourceState, step: CalibrationStep, at: number) {
    const isMeasured =
      step.of.length === 0 ? hasRest(source) : channelsOf(step, this.names).some((name) => name in source.highest);
    return html`<li><button class=${isMeasured ? "known" : ""} aria-current=${at === this.at ? "step" : nothing} aria-pressed=${at === this.at}
      @click=${() => this.#go(at)}>${step.label}</button></li>`;
  }

  /** Rest is taken at once; a move is listened to from one press to the next, which goes on to the next face. */
  #press(source: SourceState, step: CalibrationStep): void {
    const { sources } = this.context;
    if (step.of.length === 0) {
      if (sources.calibrate(source, "neutral")) this.#go(this.at + 1);
    } else if (source.ranging) {
      if (sources.calibrate(source, "done")) this.at = Math.min(this.at + 1, this.#steps.length - 1);
    } else sources.calibrate(source, "range", channelsOf(step, this.names));
  }

  #go(at: number): void {
    this.#stop();
    this.at = Math.min(at, this.#steps.length - 1);
  }

  /** What is listened to is not left open. */
  #stop(): void {
    const source = this.#source;
    if (source?.ranging) this.context.sources.calibrate(source, "done");
  }
}

const hasRest = ({ neutral }: SourceState): boolean => Object.keys(neutral).length > 0;

const words = (source: SourceState, step: CalibrationStep): string => {
  if (step.of.length === 0) return "At rest now";
  return source.ranging ? "Done" : "Start";
};

/** Those that are measured first. */
const sorted = (names: readonly string[], first: readonly string[]): readonly string[] => [
  ...first,
  ...names.filter((name) => !first.includes(name)),
];
