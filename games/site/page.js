// SPDX-License-Identifier: MIT
// What does a page of the site do: how does its search find a name, and when is its list of contents open?

const up = document.currentScript.dataset.up;
const form = document.querySelector('.search'), input = form.querySelector('input'), list = form.querySelector('ul');
const most = 12;

let loading;
/** The names are loaded when the search is first used. */
function names() {
  loading ??= new Promise((done, failed) => {
    const script = document.createElement('script');
    script.onload = () => done(globalThis.searchIndex);
    script.onerror = failed;
    script.src = `${up}search_index.js`;
    document.head.append(script);
  });
  return loading;
}

/** The smaller, the better; undefined: not found. A name without its class counts as a name, too. */
function rankOf(name, wanted) {
  const text = name.toLowerCase(), last = text.split('.').pop().replace('()', '');
  if (text === wanted || last === wanted) return 0;
  if (text.startsWith(wanted)) return 1;
  if (last.startsWith(wanted)) return 2;
  return wanted.split(/\s+/).every(word => text.includes(word)) ? 3 : undefined;
}

function find(all, wanted) {
  const found = [];
  for (const row of all) {
    const rank = rankOf(row[0], wanted);
    if (rank !== undefined) found.push({ row, rank });
  }
  return found.sort((a, b) => a.rank - b.rank || a.row[0].length - b.row[0].length).slice(0, most).map(one => one.row);
}

function lineOf([name, kind, place]) {
  const item = document.createElement('li'), link = document.createElement('a'), small = document.createElement('small');
  link.href = up + place;
  small.textContent = kind;
  link.append(name, ' ', small);
  item.append(link);
  return item;
}

async function show() {
  const all = await names(), wanted = input.value.trim().toLowerCase();
  const found = wanted ? find(all, wanted) : [];
  list.replaceChildren(...found.map(lineOf));
  if (wanted && !found.length) list.append('Nothing is named so.');
  list.hidden = !wanted;
}

/** The arrows go from the input to the lines and back. */
function move(event) {
  if (event.key === 'Escape') list.hidden = true;
  if (event.key !== 'ArrowDown' && event.key !== 'ArrowUp') return;
  const stops = [input, ...list.querySelectorAll('a')], at = stops.indexOf(document.activeElement);
  stops[(at + (event.key === 'ArrowDown' ? 1 : stops.length - 1)) % stops.length].focus();
  event.preventDefault();
}

input.addEventListener('focus', names);
input.addEventListener('input', show);
form.addEventListener('keydown', move);
form.addEventListener('focusout', event => { if (event.relatedTarget && !form.contains(event.relatedTarget)) list.hidden = true; });
document.addEventListener('pointerdown', event => { if (!form.contains(event.target)) list.hidden = true; });
list.addEventListener('click', () => { list.hidden = true; });
form.addEventListener('submit', async event => {
  event.preventDefault();
  await show();
  list.querySelector('a')?.click();
});

const contents = document.querySelector('.contents'), wide = matchMedia('(min-width: 1100px)');
const fold = () => { if (contents) contents.open = wide.matches; };
wide.addEventListener('change', fold);
fold();
