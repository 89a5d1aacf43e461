import { h } from './dom';

type Theme = 'light' | 'dark';

const kKey = 'edvo-theme';

function stored(): Theme | null {
  try {
    const value = localStorage.getItem(kKey);
    return value === 'light' || value === 'dark' ? value : null;
  } catch {
    return null; // a file that was opened from disk may have no storage
  }
}

function store(theme: Theme): void {
  try {
    localStorage.setItem(kKey, theme);
  } catch {
    // as above: the choice then lasts as long as the page
  }
}

/** A switch between light and dark that starts from the system's choice. */
export function themeSwitch(changed: () => void): HTMLElement {
  const dark = matchMedia('(prefers-color-scheme: dark)');
  let chosen = stored();
  const button = h('button', {
    class: 'theme',
    click: () => {
      chosen = shown() === 'dark' ? 'light' : 'dark';
      store(chosen);
      apply();
    },
  });
  const shown = (): Theme => chosen ?? (dark.matches ? 'dark' : 'light');
  const apply = () => {
    document.documentElement.dataset['theme'] = shown();
    button.textContent = shown() === 'dark' ? '\u2600 light' : '\u263E dark';
    button.setAttribute('aria-label', `Switch to the ${shown() === 'dark' ? 'light' : 'dark'} theme`);
    changed();
  };
  dark.addEventListener('change', apply);
  apply();
  return button;
}
