// SPDX-License-Identifier: MIT
// The panel over a game: sound, keys, records, and what the kit sees.

import { keyName, keyNumber } from './keys.js';

function button(text, act) {
  const made = document.createElement('button');
  made.type = 'button';
  made.textContent = text;
  made.addEventListener('click', act);
  return made;
}

/** Lets a file of the browser's downloads come to be. */
export function save(name, blob) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/** The keys of a game's actions, as a player may change them. */
class KeyTable {
  constructor(table, actions, usual, changed) {
    this.table = table;
    this.actions = actions;
    this.changed = changed;
    this.usual = usual;
    this.waiting = null;
    table.closest('dialog').addEventListener('keydown', event => this.take(event));
  }

  show() {
    this.table.replaceChildren(...this.actions.map((action, i) => {
      const row = document.createElement('tr');
      const cells = [action.name, this.waiting === i ? 'press a key' : action.keys.map(keyName).join(', ')].map(text => {
        const cell = document.createElement('td');
        cell.textContent = text;
        return cell;
      });
      const change = button('Change', () => { this.waiting = i; this.show(); });
      change.setAttribute('aria-label', `Change the key for ${action.name}`);
      const last = document.createElement('td');
      last.append(change);
      row.append(...cells, last);
      return row;
    }));
    if (this.waiting !== null) this.table.rows[this.waiting].querySelector('button').focus();
  }

  take(event) {
    if (this.waiting === null) return;
    const key = keyNumber(event.code);
    event.preventDefault();
    event.stopPropagation();
    const action = this.waiting;
    this.waiting = null;
    if (key !== undefined && event.code !== 'Escape') {
      for (const other of this.actions) other.keys = other.keys.filter(used => used !== key);
      this.actions[action].keys = [key];
      this.changed();
    }
    this.show();
    this.table.rows[action].querySelector('button').focus();
  }

  reset() {
    this.actions.forEach((action, i) => { action.keys = [...this.usual[i]]; });
    this.waiting = null;
    this.changed();
    this.show();
  }
}

/**
 * @param dialog the panel's element, with its parts by class
 * @param actions those whose keys may be changed; usual: their keys at first
 * @param does what the panel can do: sound(), times(), debug(), picture(), saveRecord(), openRecord(text, name), keysChanged(), closed()
 */
export function makePanel(dialog, actions, usual, does) {
  const part = name => dialog.querySelector(`.${name}`);
  const keys = new KeyTable(part('keys'), actions, usual, does.keysChanged);
  const show = () => {
    part('sound').textContent = `Sound: ${does.soundOn() ? 'on' : 'off'}`;
    part('debug').textContent = `What the kit sees: ${does.debugOn() ? 'on' : 'off'}`;
    part('times').textContent = `Times: ${does.timesOn() ? 'on' : 'off'}`;
    keys.show();
  };
  for (const name of ['sound', 'debug', 'times']) part(name).addEventListener('click', () => { does[name](); show(); });
  part('reset').addEventListener('click', () => keys.reset());
  part('picture').addEventListener('click', does.picture);
  part('save').addEventListener('click', does.saveRecord);
  part('close').addEventListener('click', () => dialog.close());
  part('file').addEventListener('change', async event => {
    const [file] = event.target.files;
    event.target.value = '';
    if (!file) return;
    dialog.close();
    does.openRecord(await file.text(), file.name);
  });
  let isOpen = false;  // until the close event, which comes a little after the dialog is gone, and moves the focus
  dialog.addEventListener('close', () => { isOpen = false; does.closed(); });
  return { open() { show(); dialog.showModal(); isOpen = true; }, isOpen: () => isOpen };
}
