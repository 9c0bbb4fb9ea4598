/** What every part of the panel of mappings has: the stores that it shows, and the animation frame. */

import { AnimatedElement, type ConsoleContext } from "../controls/console_element";
import type { Topic } from "../store/page_store";
import type { MappingCommands } from "./mapping_commands";

export type MappingsContext = Pick<ConsoleContext, "store" | "devices" | "mappings" | "painter">;

export abstract class MappingsElement extends AnimatedElement<MappingsContext> {
  protected override readonly topics: readonly Topic[] = ["mapping_list", "manifest", "characters"];

  protected get mappings(): MappingCommands {
    return this.context.mappings;
  }

  /** Writes what moves. */
  paint(_now: number): void {}
}
