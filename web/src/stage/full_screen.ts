/** A stage fills its screen, and no more, by F and by a double click. */

/** Lets the page fill the screen where its browser allows that; what it refuses changes nothing. */
export function fillScreenOnDemand(): void {
  addEventListener("dblclick", toggle);
  addEventListener("keydown", (event) => {
    const chord = event.ctrlKey || event.altKey || event.metaKey;
    if (event.code === "KeyF" && !chord && !event.repeat) toggle();
  });
}

function toggle(): void {
  const done = document.fullscreenElement === null ? fill() : document.exitFullscreen();
  done?.catch(() => undefined);
}

/** A telephone of Apple has no such call. */
const fill = (): Promise<void> | undefined => document.documentElement.requestFullscreen?.();
