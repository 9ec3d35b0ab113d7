// SPDX-License-Identifier: Apache-2.0
// Markdown with formulas, for the lessons of the page and for the site.
import katex from 'katex';
import {Marked} from 'marked';

const mathml = (tex, displayMode) => katex.renderToString(tex, {output: 'mathml', displayMode, throwOnError: true})
    .replace(/^<span class="katex">|<\/span>$/g, '').replace(/<annotation.*?<\/annotation>/gs, '');

/** $...$ and $$...$$ as MathML. */
const formulas = {
    name: 'formula', level: 'inline',
    start: (text) => text.indexOf('$'),
    tokenizer(text) {
        const match = /^\$\$([^$]+)\$\$|^\$([^$\n]+)\$/.exec(text);
        if (match) return {type: 'formula', raw: match[0], tex: match[1] ?? match[2], display: match[1] !== undefined};
    },
    renderer: ({tex, display}) => mathml(tex, display),
};

export const plainMarkdown = () => new Marked();
export const lessonMarkdown = () => new Marked({extensions: [formulas]});
