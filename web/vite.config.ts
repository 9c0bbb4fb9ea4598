import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { defineConfig, type Plugin } from "vite";
import { mediapipeAssets } from "./tools/mediapipe_assets.ts";

/** Pages and their files; "/assets/" belongs to the cast, so the bundle's own files live under "/static/". */
const PAGES = [
  "index",
  "stage",
  "console",
  "cues",
  "solo",
  "clips",
  "notes",
  "runs",
  "devices",
  "camera",
  "microphone",
  "editor",
  "replay",
];
const page = (name: string): string => resolve(import.meta.dirname, `${name}.html`);

/** What the heads of console, cues, solo, clips, devices and editor share. */
const toolHead: Plugin = {
  name: "tool head",
  transformIndexHtml: {
    order: "pre",
    handler: (html) => html.replace("<!-- tool_head.html -->", readFileSync(page("tool_head"), "utf8").trim()),
  },
};

export default defineConfig({
  base: "/",
  plugins: [toolHead, ...mediapipeAssets("pages")],
  worker: {
    plugins: () => mediapipeAssets("worker"),
    // The server gives this folder, and no other, the right to compile WebAssembly.
    rolldownOptions: { output: { entryFileNames: "static/wasm_workers/[name]-[hash].js" } },
  },
  build: {
    target: "chrome120", // OBS embeds an old Chromium
    outDir: resolve(import.meta.dirname, "../src/omote/server/web"),
    emptyOutDir: true,
    assetsDir: "static",
    chunkSizeWarningLimit: 900,
    rolldownOptions: { input: Object.fromEntries(PAGES.map((name) => [name, page(name)])) },
  },
});
