// SPDX-License-Identifier: Apache-2.0
// Completion for .glint: blocks, keys and values, from the reader's own tables.
import {type Completion, type CompletionContext, type CompletionResult, autocompletion} from '@codemirror/autocomplete';
import type {FieldInfo, SceneInfo} from 'glint-wasm';

/** Enough text before the cursor to find the blocks around it. */
const farthest = 50_000;
/** The words of the key that says a block's kind. */
const kinds: Record<string, Record<string, string[]>> = {
    light: {type: ['ambient', 'point', 'directional', 'spot', 'parallelogram', 'disc', 'sphere']},
    fog: {type: ['linear', 'exp', 'exp2']},
    background_gradient: {type: ['sphere', 'plane']},
    occlusion: {method: ['hashed', 'fixed']},
};

/** The fields of a block; those that are not listed are materials and shapes. */
function fieldsOf(facts: SceneInfo, block: string): FieldInfo[] {
    switch (block) {
        case 'light': return facts.light_fields;
        case 'camera': return facts.camera_fields;
        case 'fog': return facts.fog_fields;
        case 'background_gradient': return facts.gradient_fields;
        case 'occlusion': return facts.occlusion_fields;
        case 'texture': return facts.texture_fields;
        default: return facts.material_fields;
    }
}

/** The words of the blocks that are open at the end of a text, the outermost first; null in a comment or a string. */
function openBlocks(text: string, blocks: Record<string, string[]>): string[] | null {
    const open: string[] = [];
    let words: string[] = [];
    for (const {0: token, index} of text.matchAll(/#.*|\/\/.*|"(?:\\.|[^"\\\n])*"?|[{}]|[^\s{}"#]+/g)) {
        const isLast = index + token.length === text.length;
        if (/^(#|\/\/)/.test(token)) {
            if (isLast) return null;
        } else if (token.startsWith('"')) {
            if (isLast && !/^".*"$/.test(token)) return null;
            words.push(token);
        } else if (token === '{') {
            // A block may have a name before its brace.
            open.push(words.slice(-2).reverse().find((word) => word in blocks) ?? '');
            words = [];
        } else if (token === '}') {
            open.pop();
            words = [];
        } else {
            words.push(token);
        }
    }
    return open;
}

/** What is known about a key, for the list. */
function describe(facts: SceneInfo, block: string, key: string): Partial<Completion> {
    const setting = facts.settings.find(({name}) => name === key);
    if (setting && (block === 'render' || block === 'conventions')) return {detail: setting.values, info: setting.description};
    const field = fieldsOf(facts, block).find(({keys}) => keys.includes(key));
    return field ? {detail: field.type, info: field.description} : {};
}

/** The words that a key's value can be. */
function valuesOf(facts: SceneInfo, block: string, key: string, text: string): string[] {
    const words = kinds[block]?.[key];
    if (words) return words;
    const named = (what: string) => [...text.matchAll(new RegExp(`^\\s*${what}\\s+("[^"\\n]*"|[\\w-]+)`, 'gm'))].map(([, name]) => name!);
    if (key === 'material') return named('material');
    const field = fieldsOf(facts, block).find(({keys}) => keys.includes(key));
    if (field?.type === 'texture') return named('texture');
    if (field?.words) return field.words;
    if (field?.type === 'boolean') return ['true', 'false'];
    const values = facts.settings.find(({name}) => name === key)?.values;
    return values?.includes(' | ') && (block === 'render' || block === 'conventions') ? values.split(' | ') : [];
}

function complete(context: CompletionContext, facts: SceneInfo | null): CompletionResult | null {
    const word = context.matchBefore(/[A-Za-z_][\w-]*/);
    if (!facts || !(word || context.explicit)) return null;
    const from = word?.from ?? context.pos, {doc} = context.state;
    const before = doc.sliceString(Math.max(0, from - farthest), from);
    const open = openBlocks(before, facts.blocks);
    if (!open) return null;
    const block = open.at(-1) ?? '';
    const key = /([\w-]+)\s*=\s*$/.exec(before)?.[1];
    const whole = (label: string, type: string): Completion => ({label, type});
    const blockOf = (label: string): Completion => ({label, type: 'class', apply: label === 'material' || label === 'texture' ? `${label} ` : `${label} { `});
    let options: Completion[];
    if (key !== undefined) {
        options = valuesOf(facts, block, key, doc.toString()).map((label) => whole(label, 'constant'));
    } else if (open.length === 0) {
        options = [...Object.keys(facts.blocks).map(blockOf), ...['background', 'profile'].map((label) => ({label, type: 'property', apply: `${label} = `}))];
    } else {
        const keys = (facts.blocks[block] ?? []).map((label) => ({label, type: 'property', apply: `${label} = `, ...describe(facts, block, label)}));
        options = block === 'group' ? [...keys, ...Object.keys(facts.blocks).map(blockOf)] : keys;
    }
    return options.length === 0 ? null : {from, options, validFor: /^[\w-]*$/};
}

/** facts: those of the last scene without errors, if any. */
export const completion = (facts: () => SceneInfo | null) =>
    autocompletion({override: [(context) => complete(context, facts())], icons: false});
