/** Which frame is shown; tells its listeners when that changes. */
export class Player {
  frame = 0;
  playing = false;
  private readonly listeners = new Set<() => void>();
  private startTime = 0; // ms, of the clock, when the first frame of this play was shown
  private startFrame = 0;

  constructor(readonly timestamps: number[]) {}

  get last(): number {
    return Math.max(0, this.timestamps.length - 1);
  }

  listen(listener: () => void): void {
    this.listeners.add(listener);
    listener();
  }

  seek(frame: number): void {
    const inside = Math.min(this.last, Math.max(0, Math.round(frame)));
    if (inside !== this.frame) {
      this.frame = inside;
      this.changed();
    }
  }

  /** By hand: ends playing. */
  scrub(frame: number): void {
    this.pause();
    this.seek(frame);
  }

  pause(): void {
    if (this.playing) {
      this.playing = false;
      this.changed();
    }
  }

  toggle(): void {
    if (this.playing) {
      this.pause();
      return;
    }
    if (this.frame === this.last) this.frame = 0;
    this.playing = true;
    this.startTime = performance.now();
    this.startFrame = this.frame;
    this.changed();
    requestAnimationFrame((now) => this.advance(now));
  }

  /** Nothing is told any more. */
  stop(): void {
    this.playing = false;
    this.listeners.clear();
  }

  private advance(now: number): void {
    if (!this.playing) return;
    const time = this.timestamps[this.startFrame]! + (now - this.startTime) / 1000;
    let frame = this.frame;
    while (frame < this.last && this.timestamps[frame + 1]! <= time) ++frame;
    this.seek(frame);
    if (frame === this.last) this.pause();
    requestAnimationFrame((next) => this.advance(next));
  }

  private changed(): void {
    for (const listener of this.listeners) listener();
  }
}
