/** What time it is in the scene, and whether it passes. */
import { Watched } from "../watched";

/** A whole run takes as long as its frames at this rate, but neither flashes by nor lasts. */
const FRAMES_PER_SECOND = 25;
const SHORTEST = 3;
const LONGEST = 20;
/** A page that was out of sight does not leap. */
const LEAP = 1;

export class Clock {
  readonly time: Watched<number>;
  readonly playing = new Watched(false);
  speed = 1;
  repeat = false;
  private before = 0;

  constructor(
    private readonly first: number,
    private readonly last: number,
    private readonly frames: number,
  ) {
    this.time = new Watched(first);
  }

  /** Of the scene's time, in a second of the reader's. */
  get rate(): number {
    const seconds = Math.min(LONGEST, Math.max(SHORTEST, this.frames / FRAMES_PER_SECOND));
    return (this.speed * (this.last - this.first)) / seconds;
  }

  seek(time: number): void {
    this.time.value = Math.min(this.last, Math.max(this.first, time));
  }

  /** From the end it begins anew. */
  play(): void {
    if (this.playing.value || this.last <= this.first) return;
    if (this.time.value >= this.last) this.seek(this.first);
    this.playing.value = true;
    this.before = performance.now();
    requestAnimationFrame((now) => this.tick(now));
  }

  pause(): void {
    if (this.playing.value) this.playing.value = false;
  }

  toggle(): void {
    if (this.playing.value) this.pause();
    else this.play();
  }

  private tick(now: number): void {
    if (!this.playing.value) return;
    const next = this.time.value + this.rate * Math.min(LEAP, Math.max(0, (now - this.before) / 1000));
    this.before = now;
    const isOver = next >= this.last;
    this.seek(isOver && this.repeat ? this.first : next);
    if (isOver && !this.repeat) this.pause();
    else requestAnimationFrame((later) => this.tick(later));
  }
}
