/** The buttons that open a scan or photographs from the desk, or the camera. */

import { css, html, LitElement } from "lit";
import { customElement, property } from "lit/decorators.js";
import { base } from "../../ui/theme";
import { ACCEPTED_PHOTOGRAPHS, ACCEPTED_SCANS } from "./data/dropped_files";

const TITLES = {
  scan: "A scan or any mesh of a head: PLY, STL, OBJ with its materials and pictures, GLB, VRM, XYZ",
  photographs: "One to eight photographs of one person: JPEG, PNG",
  camera: "A turn of the head before this computer's camera",
};

const style = css`
  label,
  button {
    position: relative;
    display: grid;
    place-content: center;
    width: 100%;
    min-height: 30px;
    padding: 0 8px;
    border: 1px solid var(--line);
    border-radius: 4px;
    color: var(--dim);
    background: var(--raised);
    overflow: hidden;
    white-space: nowrap;
  }
  label:focus-within {
    outline: 2px solid var(--focus);
    outline-offset: 1px;
  }
  input {
    position: absolute;
    inset: 0;
    opacity: 0;
    cursor: pointer;
  }
  @media (pointer: coarse) {
    label,
    button {
      min-height: 40px;
    }
  }
`;

/** Tells `scan` with the files that were chosen; with none where the camera is to take them. */
@customElement("omote-scan-button")
export class ScanButton extends LitElement {
  @property() of: "scan" | "photographs" | "camera" = "scan";

  static override styles = [base, style];

  override render() {
    if (this.of === "camera")
      return html`<button title=${TITLES.camera} aria-label="A face from the camera" @click=${() => this.#tell([])}>From the camera</button>`;
    const [what, accepted] = this.of === "scan" ? ["a scan", ACCEPTED_SCANS] : ["photographs", ACCEPTED_PHOTOGRAPHS];
    return html`<label title=${TITLES[this.of]}>From ${what}<input
      type="file" multiple aria-label="A face from ${what}" accept=${accepted} @change=${this.#choose} /></label>`;
  }

  readonly #choose = (event: Event): void => {
    const field = event.target as HTMLInputElement;
    const files = [...(field.files ?? [])];
    field.value = ""; // the same file again is a change too
    if (files.length > 0) this.#tell(files);
  };

  #tell(files: readonly File[]): void {
    this.dispatchEvent(new CustomEvent("scan", { detail: files, bubbles: true, composed: true }));
  }
}
