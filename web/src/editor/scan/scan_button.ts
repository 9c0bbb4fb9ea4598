/** The buttons that open a scan, or photographs, from the desk. */

import { css, html, LitElement } from "lit";
import { customElement, property } from "lit/decorators.js";
import { base } from "../../ui/theme";
import { ACCEPTED_PHOTOGRAPHS, ACCEPTED_SCANS } from "./data/dropped_files";

const TITLES = {
  scan: "A scan or any mesh of a head: PLY, STL, OBJ with its materials and pictures, GLB, VRM, XYZ",
  photographs: "One to eight photographs of one person: JPEG, PNG",
};

/** Tells `scan` with the files that were chosen. */
@customElement("omote-scan-button")
export class ScanButton extends LitElement {
  @property() of: "scan" | "photographs" = "scan";

  static override styles = [
    base,
    css`
      label {
        position: relative;
        display: grid;
        place-content: center;
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
        label {
          min-height: 40px;
        }
      }
    `,
  ];

  override render() {
    const [what, accepted] = this.of === "scan" ? ["a scan", ACCEPTED_SCANS] : ["photographs", ACCEPTED_PHOTOGRAPHS];
    return html`<label title=${TITLES[this.of]}>From ${what}<input
      type="file" multiple aria-label="A face from ${what}" accept=${accepted} @change=${this.#choose} /></label>`;
  }

  readonly #choose = (event: Event): void => {
    const field = event.target as HTMLInputElement;
    const files = [...(field.files ?? [])];
    field.value = ""; // the same file again is a change too
    if (files.length > 0) this.dispatchEvent(new CustomEvent("scan", { detail: files, bubbles: true, composed: true }));
  };
}
