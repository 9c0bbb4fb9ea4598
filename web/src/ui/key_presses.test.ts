import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { listenToKeys, openLayer } from "./key_presses";

/** As much of an element as keys ask for. */
class FakeElement extends EventTarget {
  readonly isContentEditable = false;
  blurred = false;

  blur(): void {
    this.blurred = true;
  }
}

class FakeInput extends FakeElement {
  constructor(
    readonly type: string,
    public value: string,
  ) {
    super();
  }
}

class FakeKey extends Event {
  readonly isComposing = false;

  constructor(
    readonly key: string,
    private readonly field: EventTarget,
  ) {
    super("keydown", { cancelable: true });
  }

  override composedPath(): EventTarget[] {
    return [this.field];
  }
}

let page: EventTarget;
let stop: () => void;

beforeEach(() => {
  page = new EventTarget();
  vi.stubGlobal("window", page);
  vi.stubGlobal("HTMLElement", FakeElement);
  vi.stubGlobal("HTMLInputElement", FakeInput);
  vi.stubGlobal("HTMLSelectElement", class extends FakeElement {});
  vi.stubGlobal("HTMLTextAreaElement", class extends FakeElement {});
  vi.stubGlobal("KeyboardEvent", FakeKey);
  stop = listenToKeys({ page: () => undefined });
});

afterEach(() => {
  stop();
  vi.unstubAllGlobals();
});

describe("Escape in a field", () => {
  it("empties a search, tells who filters by it, and leaves it", () => {
    const field = new FakeInput("search", "smi");
    let filter = field.value;
    field.addEventListener("input", () => {
      filter = field.value;
    });
    page.dispatchEvent(new FakeKey("Escape", field));
    expect([field.value, filter, field.blurred]).toEqual(["", "", true]);
  });

  it("brings back what another field held before it was typed in, and tells who follows it", () => {
    const field = new FakeInput("text", "Ana");
    const told: string[] = [];
    field.addEventListener("input", () => told.push(field.value));
    page.dispatchEvent(new FakeKey("x", field));
    field.value = "Anax";
    page.dispatchEvent(new FakeKey("Escape", field));
    expect([field.value, told, field.blurred]).toEqual(["Ana", ["Ana"], true]);
  });

  it("tells of nothing where nothing was typed", () => {
    const field = new FakeInput("search", "");
    field.addEventListener("input", () => expect.unreachable());
    page.dispatchEvent(new FakeKey("Escape", field));
    expect(field.blurred).toBe(true);
  });
});

describe("a key that a dialog hears", () => {
  const field = new EventTarget();
  const heard: string[] = [];
  const press = (target: EventTarget, key: string): void => void page.dispatchEvent(new FakeKey(key, target));

  it("comes to it wherever the focus is, but never out of a field, and to nobody else", () => {
    const element = new FakeElement() as unknown as HTMLElement;
    const hears = ({ key }: KeyboardEvent): boolean => key === "z" && heard.push(key) > 0;
    const end = openLayer({ element, kind: "dialog", close: () => undefined, hears });
    press(field, "z");
    press(element, "z");
    press(new FakeInput("text", ""), "z");
    press(element, "x");
    expect(heard).toEqual(["z", "z"]);
    end();
    press(field, "z");
    expect(heard).toHaveLength(2);
  });
});
