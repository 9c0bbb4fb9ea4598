import { describe, expect, it } from "vitest";
import { capture } from "./capture";

/** A view whose context is lost while its picture is made, before or after the page hears of it. */
function viewOf({ lost = false, heard = false }) {
  const closed: string[] = [];
  const view = { canvas: {}, alive: true, context: { isContextLost: () => false } };
  const make = async () => {
    view.alive = !heard;
    view.context.isContextLost = () => lost;
    return { close: () => closed.push("closed") };
  };
  const [given, made] = [view as unknown as Parameters<typeof capture>[0], make as unknown as typeof createImageBitmap];
  return { closed, picture: () => capture(given, made) };
}

describe("a captured picture", () => {
  it("is the picture that was made", async () => {
    const { picture, closed } = viewOf({});
    expect(await picture()).toHaveProperty("close");
    expect(closed).toEqual([]);
  });

  it.each([{ lost: true }, { heard: true }, { lost: true, heard: true }])(
    "is none where the context went while it was made: %o",
    async (how) => {
      const { picture, closed } = viewOf(how);
      await expect(picture()).rejects.toThrow("lost for a moment");
      expect(closed).toEqual(["closed"]);
    },
  );
});
