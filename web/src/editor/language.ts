// SPDX-License-Identifier: Apache-2.0
// Syntax highlighting for all scene formats: comments, strings, numbers, block names and keys. One tokenizer for all.
import {type StreamParser, HighlightStyle, StreamLanguage, syntaxHighlighting} from '@codemirror/language';
import {tags} from '@lezer/highlight';

interface Marks {
    /** Starts a comment up to the end of the line. */
    comment: RegExp;
    /** Inside a block comment. */
    long: boolean;
}

const marksOf: Record<string, Marks> = {
    glint: {comment: /^(#|\/\/)/, long: false},
    cgfs: {comment: /^(#|\/\/)/, long: false},
    nff: {comment: /^#/, long: false},
    dat: {comment: /^#/, long: false},
    json: {comment: /^\/\//, long: true},
    js: {comment: /^\/\//, long: true},
    pov: {comment: /^\/\//, long: true},
};

function parser(marks: Marks): StreamParser<{inComment: boolean}> {
    return {
        startState: () => ({inComment: false}),
        token(stream, state) {
            if (state.inComment) {
                state.inComment = !stream.match(/^[\s\S]*?\*\//);
                if (state.inComment) stream.skipToEnd();
                return 'comment';
            }
            if (stream.eatSpace()) return null;
            if (marks.long && stream.match('/*')) {
                state.inComment = true;
                return 'comment';
            }
            if (stream.match(marks.comment)) {
                stream.skipToEnd();
                return 'comment';
            }
            // A key before a colon, then other strings.
            if (stream.match(/^("(\\.|[^"\\])*"|'(\\.|[^'\\])*')(?=\s*:)/)) return 'propertyName';
            if (stream.match(/^("(\\.|[^"\\])*"?|'(\\.|[^'\\])*'?)/)) return 'string';
            if (stream.match(/^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?/)) return 'number';
            if (stream.match(/^(true|false|null|none)\b/)) return 'bool';
            if (stream.match(/^[\w-]+(?=\s*[=:])/)) return 'propertyName';
            if (stream.match(/^[A-Za-z_][\w-]*(?=\s*("[^"]*"\s*)?(\w+\s*)?[{<])/)) return 'keyword';
            if (stream.match(/^(include|export|const|let|var|default|b|v|l|f|s|p|pp|c|from|at|up|angle|hither|resolution|rgb|rgbf)\b/))
                return 'keyword';
            if (stream.match(/^[A-Za-z_][\w-]*/)) return 'variableName';
            stream.next();
            return null;
        },
    };
}

const style = HighlightStyle.define([
    {tag: tags.comment, class: 'tok-comment'},
    {tag: tags.string, class: 'tok-string'},
    {tag: tags.number, class: 'tok-number'},
    {tag: tags.bool, class: 'tok-number'},
    {tag: tags.keyword, class: 'tok-keyword'},
    {tag: tags.propertyName, class: 'tok-key'},
]);

/** The highlighting for a file name. */
export function languageOf(name: string) {
    const marks = marksOf[name.split('.').at(-1)!.toLowerCase()] ?? marksOf['glint']!;
    return [StreamLanguage.define(parser(marks)), syntaxHighlighting(style)];
}
