// SPDX-License-Identifier: MIT
// How does a reader of the comparison's report, of its live page, or of the lessons, get back to the site? By the site's links, on top.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

import { navOf } from './pages.mjs';

/** The report may load no file, and has no search: so it gets the links with their style, and nothing else. */
export function withNav(root, report) {
  const style = readFileSync(join(root, 'games/site/report_nav.css'), 'utf8');
  const page = report.replace(/<body[^>]*>/, body => `${body}\n${navOf(root, '..', false)}`)
    .replace('</head>', () => `<style>\n${style}</style>\n</head>`);
  if (!page.includes('class="site-nav"') || !page.includes('.site-nav {')) throw new Error('the report has no <body> or no </head>');
  return page;
}
