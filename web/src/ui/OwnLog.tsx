// SPDX-License-Identifier: Apache-2.0
// The log of the user's own ray tracer, in the panel Compare: what is wrong first and why, as `glint diagnose` says it.
import type {Diagnosis, DiagnosisFinding} from 'glint-wasm';

import {openHelp} from '../store/help';
import {closeLog, diagnosis, isLogOfPicture, loggedPixels} from '../store/own_log';
import {isProjected} from '../store/projector';
import {setSetting} from '../store/settings';
import {info, ownLog, pinned, state, tab} from '../store/state';
import {FileButton} from './fields';
import {LogTree, showRow} from './LogTree';
import {SpaceInPanel} from './Space';
import {findingTitle, placeText, referenceOf, summary, valuesOf} from './log_words';

const topics: Record<string, string> = {lighting: 'The lighting equation', conventions: 'Conventions'};

/** A place of the documents, which the help has. */
function Reference({where}: {where: string}) {
    if (where === '') return null;
    const {words, topic, heading} = referenceOf(where);
    return (
        <>
            ; see {words}{words && topic && ', '}
            {topic && <button class="link" onClick={() => openHelp(topic, heading)}>{topics[topic] ?? topic}{heading && `: ${heading.replaceAll('-', ' ')}`}</button>}
        </>
    );
}

function Causes({finding: {sure, causes, relation, pixels}, all}: {finding: DiagnosisFinding; all: number}) {
    if (causes.length === 0) {
        return (
            <>
                {relation && <p>Everywhere {relation}.</p>}
                <p>Cause unknown: no known mistake gives these numbers.{pixels * 500 < all && ' So few may be rounding, which grows behind mirrors and glass.'}</p>
            </>
        );
    }
    const [only] = causes;
    if (sure) return <p><b>Cause:</b> {only!.explanation} <span class="mono faint">{only!.id}</span></p>;
    return (
        <>
            <p>{causes.length === 1 ? 'Possible cause, which gives these numbers:' : 'Possible causes, each of which gives these numbers:'}</p>
            <ul class="hints">{causes.map(({id, explanation}) => <li key={id}>{explanation} <span class="mono faint">{id}</span></li>)}</ul>
        </>
    );
}

function Finding({finding, all}: {finding: DiagnosisFinding; all: number}) {
    const {example, quantity, formula, where} = finding, {yours, expected} = valuesOf(example);
    return (
        <li class="log-finding" data-quantity={quantity}>
            <h3>{findingTitle(finding, all)}</h3>
            <dl>
                <dt>yours</dt><dd class="mono">{yours}</dd>
                <dt>it should be</dt><dd class="mono">{expected}</dd>
            </dl>
            <Causes finding={finding} all={all} />
            <p class="note"><span class="mono">{quantity}</span> = {formula}<Reference where={where} /></p>
            <p class="note">
                {loggedPixels.value.has(example.pixel.join())
                    ? <><button class="link" onClick={() => showRow(example)}>Show this value</button>: {placeText(example)}</>
                    : placeText(example)}
            </p>
        </li>
    );
}

function Found({found}: {found: Diagnosis}) {
    const warnings = found.diagnostics.filter(({severity}) => severity === 'warning');
    return (
        <>
            {warnings.length > 0 && (
                <div>
                    {warnings.slice(0, 5).map(({line, message}, i) => <p key={i} class="message warning">{line > 0 && <span class="where">line {line}</span>}{message}</p>)}
                    {warnings.length > 5 && <p class="message warning">And {warnings.length - 5} more warnings.</p>}
                </div>
            )}
            {found.conventions.length > 0 && <ul class="log-facts" aria-label="What the log’s numbers mean">{found.conventions.map((one) => <li key={one}>{one}</li>)}</ul>}
            {found.findings.length > 0 && <ol class="log-findings" aria-label="What differs">{found.findings.map((one, i) => <Finding key={i} finding={one} all={found.pixels} />)}</ol>}
            <LogTree />
            {pinned.value && tab.value === 'compare' && !isProjected.value && isLogOfPicture() && <SpaceInPanel />}
        </>
    );
}

/** The log is of another size than the picture on the page. */
function OtherSize() {
    const size = ownLog.value?.size;
    if (!size || !info.value || size.join() === [info.value.width, info.value.height].join()) return null;
    const [width, height] = size;
    return (
        <>
            <p class="note">Your log is of {width} × {height} pixels, and the scene’s picture has {info.value.width} × {info.value.height}.</p>
            <div><button class="button" onClick={() => setSetting('size', `${width}x${height}`)}>Render at {width} × {height}</button></div>
        </>
    );
}

export function OwnLog() {
    const own = ownLog.value, found = diagnosis.value;
    if (!own) {
        return (
            <section>
                <h2>Your own ray tracer, value by value</h2>
                <p class="note">
                    Let your ray tracer write what it computes for a few pixels, and drop this log (.log, .txt, .jsonl) onto the page: glint names the first quantity that is wrong, and why.{' '}
                    <button class="link" onClick={() => openHelp('trace_log')}>How to write a log</button>
                </p>
                <div><FileButton label="Open a log" /></div>
            </section>
        );
    }
    return (
        <section class="own-log" aria-label="Your log" data-answered={found !== null}>
            <h2>{own.name}</h2>
            <div role="status">
                {found !== null ? typeof found !== 'string' && <p>{summary(found).join(' ')}</p>
                    : <p>{state.value === 'error' ? 'The scene has errors: the log is compared again when they are mended.' : 'Comparing…'}</p>}
            </div>
            {typeof found === 'string' && <p class="message error" role="alert">{found}</p>}
            <OtherSize />
            {found !== null && typeof found !== 'string' && <Found found={found} />}
            <div><button class="button" onClick={closeLog}>Close your log</button></div>
        </section>
    );
}
