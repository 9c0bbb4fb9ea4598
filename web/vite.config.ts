import { resolve } from "node:path";
import { defineConfig } from "vite";

/** Pages and their files; "/assets/" belongs to the cast, so the bundle's own files live under "/static/". */
const PAGES = ["index", "stage", "console", "devices", "editor"];
const page = (name: string): string => resolve(import.meta.dirname, `${name}.html`);

export default defineConfig({
  base: "/",
  build: {
    target: "chrome120", // OBS embeds an old Chromium
    outDir: resolve(import.meta.dirname, "../src/omote/server/web"),
    emptyOutDir: true,
    assetsDir: "static",
    chunkSizeWarningLimit: 900,
    rolldownOptions: { input: Object.fromEntries(PAGES.map((name) => [name, page(name)])) },
  },
});
