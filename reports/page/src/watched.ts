/** A value, and those who want to hear when it changes. */
export class Watched<T> {
  private readonly listeners: ((value: T) => void)[] = [];
  constructor(private current: T) {}

  get value(): T {
    return this.current;
  }

  set value(next: T) {
    this.current = next;
    for (const listener of this.listeners) listener(next);
  }

  watch(listener: (value: T) => void): void {
    this.listeners.push(listener);
  }
}
