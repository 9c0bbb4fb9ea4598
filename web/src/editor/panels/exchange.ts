import { html } from "lit";
import { customElement } from "lit/decorators.js";
import { base } from "../../console/theme";
import { controls, panel } from "../controls_style";
import { BenchElement } from "../element";
import type { Topic } from "../workbench";

/** How the open item gets out of the show file: the commands, ready to copy. */
@customElement("omote-exchange")
export class Exchange extends BenchElement {
  static override styles = [base, controls, panel];

  protected override topics(): readonly Topic[] {
    return ["draft", "items"];
  }

  override render() {
    const { item } = this.bench;
    if (item === null) return html`<p>Open something to take it out of the show.</p>`;
    return html`<p>On the show's computer, in a terminal:</p>`;
  }
}
