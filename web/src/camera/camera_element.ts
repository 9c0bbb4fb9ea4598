/** An element of the camera page, drawn anew when its session changes. */

import { LitElement } from "lit";
import { property } from "lit/decorators.js";
import type { CameraSession } from "./session/camera_session";

export abstract class CameraElement extends LitElement {
  @property({ attribute: false }) session!: CameraSession;
  /** Counts changes of the session: what makes Lit draw. */
  @property({ attribute: false }) count = 0;
}
