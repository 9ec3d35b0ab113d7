// SPDX-License-Identifier: Apache-2.0
// Creates src/lessons/: the lessons of ../docs/lessons as HTML, with formulas as MathML, the challenges of challenges/, and the help:
// documents of ../docs.
// docs/lessons/README.md describes the syntax of a lesson.
import {mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

import {lessonMarkdown} from './markdown.mjs';

const web = fileURLToPath(new URL('..', import.meta.url));
const lessons = join(web, '..', 'docs', 'lessons');
const challenges = join(web, 'challenges');
const out = join(web, 'src', 'lessons');

const marked = lessonMarkdown();

/** The blocks of a lesson: its fenced blocks are taken out by the language of each. */
function split(markdown, where) {
    const tokens = marked.lexer(markdown);
    const title = tokens.find((token) => token.type === 'heading' && token.depth === 1)?.text;
    if (!title) throw new Error(`${where}: a lesson begins with its title`);
    const parts = [{title, tokens: [], scene: null, log: null, checks: [], solution: null}];
    for (const token of tokens) {
        const part = parts.at(-1);
        if (token.type === 'heading' && token.depth === 1) continue;
        if (token.type === 'heading' && token.depth === 2) {
            parts.push({title: token.text, tokens: [], scene: null, log: null, checks: [], solution: null});
        } else if (token.type === 'code' && token.lang) {
            const [what, name] = token.lang.split(/\s+/);
            if (what === 'scene' || what === 'log') part[what] = {name, text: `${token.text}\n`};
            else if (what === 'check') part.checks.push(...token.text.split('\n').filter((line) => line.trim()));
            else if (what === 'solution') part.solution = token.text;
            else throw new Error(`${where}: unknown block '${token.lang}'`);
        } else {
            part.tokens.push(token);
        }
    }
    return parts;
}

/** Without the end tags that HTML allows to omit: they are 1 kB of the compressed page. */
const shorter = (html) => html.replace(/\n?<\/(td|tr|th|thead|tbody|li|p)>\n?/g, '');

function lesson(file) {
    const [intro, ...steps] = split(readFileSync(join(lessons, file), 'utf8'), file);
    if (!intro.scene || steps.length < 3 || steps.length > 6) throw new Error(`${file}: a lesson has a scene and 3 to 6 steps`);
    const html = (part) => shorter(marked.parser(part.tokens)).trim();
    return {
        id: file.replace(/\.md$/, ''), title: intro.title, html: html(intro), scene: intro.scene, ...(intro.log && {log: intro.log}),
        steps: steps.map((step) => {
            if (step.checks.length === 0 || !step.solution) throw new Error(`${file}: step '${step.title}' needs a check and a solution`);
            return {title: step.title, html: html(step), scene: step.scene, checks: step.checks, solution: step.solution};
        }),
    };
}

/**
 * A file of challenges/: the task in its first line, perhaps lines of `# check CONDITION`, then the target, the start and perhaps the
 * log of a program that draws the target, divided by lines of ---. The challenge is met by the target's picture, and by one that is nearly the target if the conditions hold.
 */
function challenge(file) {
    const [task, ...rest] = readFileSync(join(challenges, file), 'utf8').split('\n');
    const checks = rest.filter((line) => line.startsWith('# check ')).map((line) => line.slice(8));
    const [target, start, log] = rest.filter((line) => !line.startsWith('# check ')).join('\n').split(/^---\n/m);
    return {id: file.replace(/\.\w+$/, ''), task: task.replace(/^#\s*/, ''), name: file, target, start, ...(log && {log: {name: 'mine.log', text: log}}), ...(checks.length > 0 ? {checks} : {})};
}

/** Documents that the page's help shows, and the heading from which on. Their links lead to other documents, which the page does not have. */
const documents = [
    ['guide', 'Guide and keys', 'playground.md', 'What it does'], ['glint', '.glint', 'formats/glint.md'], ['cgfs', '.cgfs', 'formats/cgfs.md'],
    ['epfl', 'RT2’s .json', 'formats/epfl.md'], ['csc473', 'CSC 473’s .pov', 'formats/csc473.md'], ['povray', 'POV-Ray', 'formats/povray.md'],
    ['tachyon', 'Tachyon', 'formats/tachyon.md'], ['nff', '.nff', 'formats/nff.md'], ['conventions', 'Conventions', 'conventions.md'],
    ['lighting', 'The lighting equation', 'lighting.md'], ['diagnose', 'Your own ray tracer', 'diagnose.md'], ['trace_log', 'Its log', 'formats/trace_log.md'],
];
function topic([id, title, file, from]) {
    const markdown = readFileSync(join(lessons, '..', file), 'utf8');
    const text = from ? markdown.slice(markdown.indexOf(`## ${from}`)) : markdown;
    const html = marked.parse(text).replace(/<a [^>]*>|<\/a>|<img[^>]*>/g, '').replace(/<(\/?)h1/g, '<$1h2');
    return {id, title, html: shorter(html)};
}

const list = readdirSync(lessons).filter((file) => /^\d.*\.md$/.test(file)).sort().map(lesson);
const pictures = readdirSync(challenges).sort().map(challenge);
rmSync(out, {recursive: true, force: true});
mkdirSync(out, {recursive: true});
const data = (name, type, value) => writeFileSync(join(out, `${name}.ts`),
    `// Made by tools/make-lessons.mjs.\nimport type {${type}} from '../learn/types';\n\nexport const ${name}: ${type}[] = ${JSON.stringify(value, null, 1)};\n`);
data('lessons', 'Lesson', list);
data('challenges', 'Challenge', pictures);
data('help', 'Topic', documents.map(topic));
console.log(`${list.length} lessons, ${pictures.length} challenges`);
