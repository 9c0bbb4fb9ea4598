/**
 * Steps on a whole recipe (layers, a face's mix) that a hand makes faster than the server answers: each one is a change
 * of what the step before it leaves, they are sent one after the other, and the page shows the last one at once.
 */

/** What a step asks, made of the recipe that the server has by then; resolves when it is answered or refused. */
type Send<Recipe> = (recipe: Recipe, answered: () => void) => Promise<unknown>;

interface Step<Recipe> {
  readonly change: (recipe: Recipe) => Recipe;
  readonly send: Send<Recipe>;
}

export class RecipeSteps<Recipe> {
  #waiting: readonly Step<Recipe>[] = [];
  #sending = false;
  #whenEmpty: (() => void)[] = [];

  /** `recipe`: the one that the server last told; null where nothing is open. */
  constructor(private readonly recipe: () => Recipe | null) {}

  get size(): number {
    return this.#waiting.length;
  }

  /** The recipe as the hand has it: the server's, and the steps that it has not answered. */
  shown<Kind extends Recipe>(recipe: Kind): Kind {
    return this.#waiting.reduce<Recipe>((current, { change }) => change(current), recipe) as Kind;
  }

  /** One more step; sent at once where none waits. */
  add(change: (recipe: Recipe) => Recipe, send: Send<Recipe>): void {
    this.#waiting = [...this.#waiting, { change, send }];
    void this.#sendAll();
  }

  /** Another item is open, or none: steps of the one before go. */
  forget(): void {
    this.#waiting = [];
  }

  /** Resolves when every step has been answered; what is asked after them must not come before. */
  empty(): Promise<void> {
    if (this.size === 0) return Promise.resolve();
    return new Promise((done) => this.#whenEmpty.push(done));
  }

  async #sendAll(): Promise<void> {
    if (this.#sending) return;
    this.#sending = true;
    for (let step = this.#waiting[0]; step !== undefined; step = this.#waiting[0]) {
      const [sent, recipe] = [step, this.recipe()];
      const answered = (): void => {
        this.#waiting = this.#waiting.filter((waiting) => waiting !== sent);
      };
      if (recipe !== null) await sent.send(sent.change(recipe), answered);
      answered(); // also where it was refused
    }
    this.#sending = false;
    for (const done of this.#whenEmpty.splice(0)) done();
  }
}
