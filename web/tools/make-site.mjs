// SPDX-License-Identifier: Apache-2.0
// node make-site.mjs OUT: writes the site to a folder: site/index.md and all that it links to, as HTML; the page from dist/. Files
// that are no Markdown and no pictures become pages with their text. tools/make-site adds the C++ reference.
import {cpSync, existsSync, mkdirSync, readFileSync, readdirSync, statSync, writeFileSync} from 'node:fs';
import {dirname, extname, join, posix} from 'node:path';
import {fileURLToPath} from 'node:url';
import {deflateRawSync} from 'node:zlib';

import {lessonMarkdown, plainMarkdown} from './markdown.mjs';

const web = fileURLToPath(new URL('..', import.meta.url));
const project = join(web, '..');
const out = process.argv[2];
const template = readFileSync(join(web, 'site/template.html'), 'utf8');
const escaped = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');

/** Parts of the site that are not made here. */
const made = ['playground', 'reference'];
const isPicture = (path) => ['.png', '.svg', '.jpg'].includes(extname(path));

/** Where a file of the project is in the site. */
function pathInSite(path) {
    if (made.some((folder) => path === folder || path.startsWith(`${folder}/`))) return path.includes('.') ? path : `${path.replace(/\/$/, '')}/index.html`;
    if (isPicture(path)) return path;
    if (path.endsWith('.md')) return path.replace(/\.md$/, '.html');
    return statSync(join(project, path)).isDirectory() ? `${path}/index.html` : `${path}.html`;
}

const written = new Set(), waiting = [];

/** The address, in the page of `from`, of a link in it; what it leads to becomes a part of the site. */
function address(link, from) {
    if (/^(https?:|mailto:|data:)/.test(link)) return link;
    const [path, fragment] = link.split('#');
    const anchor = fragment === undefined ? '' : `#${fragment}`;
    if (path === '') return anchor;
    const target = posix.normalize(posix.join(posix.dirname(from), decodeURIComponent(path))).replace(/\/$/, '');
    if (!made.includes(target) && !existsSync(join(project, target))) throw new Error(`${from}: the link ${link} leads nowhere`);
    if (!made.includes(target) && !written.has(target)) {
        written.add(target);
        waiting.push(target);
    }
    return posix.relative(posix.dirname(pathInSite(from)), pathInSite(target)) + anchor;
}

/** The anchor of a heading, as on GitHub. */
function slugs() {
    const seen = new Map();
    return (text) => {
        const slug = text.toLowerCase().replace(/[^\p{L}\p{N}_\- ]/gu, '').replaceAll(' ', '-');
        const before = seen.get(slug) ?? 0;
        seen.set(slug, before + 1);
        return before === 0 ? slug : `${slug}-${before}`;
    };
}

/** The fragment that opens a scene in the playground: that of src/share.ts. */
const fragment = (scene) => `#1=${deflateRawSync(JSON.stringify(scene)).toString('base64url')}`;

/** A block of a lesson (docs/lessons/README.md); other blocks are as they are. */
function lessonBlock(lang, text, path) {
    const [what, name] = lang.split(/\s+/);
    const code = `<pre><code>${escaped(text)}</code></pre>`;
    if (what === 'check' || what === 'solution') return `<details><summary>${what === 'check' ? 'Done when' : 'Solution'}</summary>${code}</details>`;
    if (what !== 'scene') return undefined;
    const link = pathInSite('playground');
    const to = posix.relative(posix.dirname(pathInSite(path)), link);
    return `${code}<p class="try"><a href="${to}${fragment({name, text: `${text}\n`})}">Open this scene in the playground</a></p>`;
}

function html(path, markdown) {
    const slug = slugs();
    const lesson = /^docs\/lessons\/(\d\w+)\.md$/.exec(path)?.[1];
    const marked = lesson ? lessonMarkdown() : plainMarkdown();
    const plain = (tokens) => tokens.map((token) => (token.tokens ? plain(token.tokens) : (token.text ?? ''))).join('');
    marked.use({renderer: {
        heading({tokens, depth}) {
            return `<h${depth} id="${slug(plain(tokens))}">${this.parser.parseInline(tokens)}</h${depth}>\n`;
        },
        link({href, tokens}) {
            const words = this.parser.parseInline(tokens);
            // Panels of the playground.
            if (lesson && /^#(inspect|compare|controls)$/.test(href)) return `<em>${words}</em>`;
            return `<a href="${escaped(address(href, path))}">${words}</a>`;
        },
        image({href, text}) {
            return `<img src="${escaped(address(href, path))}" alt="${escaped(text)}">`;
        },
        code({text, lang}) {
            return (lesson && lang && lessonBlock(lang, text, path)) || `<pre tabindex="0"><code>${escaped(text)}</code></pre>\n`;
        },
    }});
    // Tables whose columns need no names.
    const body = marked.parse(markdown).replace(/<thead>\s*<tr>(\s*<th[^>]*><\/th>)+\s*<\/tr>\s*<\/thead>/g, '').replace(/<th[^>]*><\/th>/g, '<td></td>');
    if (!lesson) return body;
    const to = posix.relative(posix.dirname(pathInSite(path)), 'playground/index.html');
    return body.replace('</h1>', `</h1>\n<p><a href="${to}#lesson=${lesson}">Do this lesson in the playground</a>, which checks each step.</p>`);
}

function write(path, title, body) {
    const to = pathInSite(path), root = '../'.repeat(to.split('/').length - 1);
    const values = {title: escaped(title), root, body};
    mkdirSync(dirname(join(out, to)), {recursive: true});
    writeFileSync(join(out, to), template.replace(/\{\{(\w+)\}\}/g, (_, name) => values[name]));
}

const titleOf = (markdown, path) => /^# (.*)$/m.exec(markdown)?.[1].replaceAll('`', '') ?? path;

function writeFile(path) {
    const file = join(project, path);
    if (isPicture(path)) {
        mkdirSync(dirname(join(out, path)), {recursive: true});
        cpSync(file, join(out, path));
    } else if (path.endsWith('.md')) {
        const markdown = readFileSync(file, 'utf8');
        write(path, `${titleOf(markdown, path)} · glint`, html(path, markdown));
    } else if (statSync(file).isDirectory()) {
        const entries = readdirSync(file, {withFileTypes: true}).filter((entry) => !/^[._]|^(node_modules|build|dist)$/.test(entry.name))
            .map((entry) => entry.name).sort();
        const list = entries.map((name) => `<li><a href="${escaped(address(name, `${path}/README.md`))}">${escaped(name)}</a></li>`);
        write(path, `${path} · glint`, `<h1>${escaped(path)}</h1>\n<ul>\n${list.join('\n')}\n</ul>`);
    } else {
        write(path, `${path} · glint`, `<h1>${escaped(path)}</h1>\n<pre tabindex="0"><code>${escaped(readFileSync(file, 'utf8'))}</code></pre>`);
    }
}

cpSync(join(web, 'dist'), join(out, 'playground'), {recursive: true});
cpSync(join(web, 'site/site.css'), join(out, 'site.css'));
const first = readFileSync(join(web, 'site/index.md'), 'utf8');
write('index.md', 'glint: a ray tracer that explains every pixel', html('index.md', first));
// What the template links to.
for (const path of ['docs/lessons/README.md', 'docs/gallery.md', 'docs/command.md', 'docs/library.md']) address(path, 'index.md');
while (waiting.length > 0) writeFile(waiting.pop());
console.log(`${written.size} files`);
