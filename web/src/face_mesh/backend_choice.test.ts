import { expect, it } from "vitest";
import { chooseBackend, type Raced } from "./backend_choice";
import type { Backend } from "./solution";

const FACE = new Float32Array(3);
const picture = {} as ImageBitmap;

/** A mesh that takes so long at each place; it throws or finds nothing where told. */
class Runner implements Raced {
  now = 0;
  used: Backend[] = [];

  constructor(
    private readonly costs: Record<Backend, number>,
    private readonly broken: Backend | null = null,
    private readonly blind: Backend | null = null,
  ) {}

  use(backend: Backend): void {
    this.used.push(backend);
  }

  find(): Promise<Float32Array> {
    const backend = this.used.at(-1) ?? "CPU";
    if (backend === this.broken) return Promise.reject(new Error("no context"));
    this.now += this.costs[backend];
    return Promise.resolve(backend === this.blind ? new Float32Array() : FACE);
  }
}

const race = (runner: Runner, gpu = true) =>
  chooseBackend(
    runner,
    picture,
    () => runner.now,
    () => gpu,
  );

it("takes the faster place, and leaves the mesh there", async () => {
  const fast = new Runner({ CPU: 30, GPU: 8 });
  expect(await race(fast)).toEqual({ backend: "GPU", cost: 8 });
  expect(fast.used.at(-1)).toBe("GPU");
  const slow = new Runner({ CPU: 12, GPU: 200 });
  expect(await race(slow)).toEqual({ backend: "CPU", cost: 12 });
  expect(slow.used.at(-1)).toBe("CPU");
});

it("does not try a graphics processor that is none", async () => {
  const runner = new Runner({ CPU: 30, GPU: 1 });
  expect(await race(runner, false)).toEqual({ backend: "CPU", cost: 30 });
  expect(runner.used).toEqual(["CPU"]);
});

it("never takes a place that fails or finds nothing", async () => {
  expect((await race(new Runner({ CPU: 30, GPU: 1 }, "GPU"))).backend).toBe("CPU");
  expect((await race(new Runner({ CPU: 30, GPU: 1 }, null, "GPU"))).backend).toBe("CPU");
  await expect(race(new Runner({ CPU: 30, GPU: 1 }, "CPU"))).rejects.toThrow("no context");
});
