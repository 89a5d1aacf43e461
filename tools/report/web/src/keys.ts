/** What the keys move. */
export interface Scrubbed {
  frame: () => number | undefined; // undefined while there is nothing to move
  scrub: (frame: number) => void;
  toggle: () => void;
}

/** Arrow keys scrub wherever they have no other meaning; the space bar plays or pauses. */
export function scrubByKeys(moved: Scrubbed): void {
  document.addEventListener('keydown', (event) => {
    const frame = moved.frame();
    const target = event.target as HTMLElement;
    if (frame === undefined || event.altKey || event.ctrlKey || event.metaKey) return;
    if (target.closest('input:not([type=checkbox]), select, [tabindex="0"]')) return;
    const step = event.shiftKey ? 10 : 1;
    if (event.key === 'ArrowLeft') moved.scrub(frame - step);
    else if (event.key === 'ArrowRight') moved.scrub(frame + step);
    else if (event.key === ' ' && !target.closest('button, summary, input')) moved.toggle();
    else return;
    event.preventDefault();
  });
}
