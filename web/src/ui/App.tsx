// SPDX-License-Identifier: Apache-2.0
import {useEffect} from 'preact/hooks';

import {savePicture} from '../files';
import {droppedFiles} from '../given_files';
import {openFiles} from '../store/opening';
import {isLarge} from '../store/space';
import {challenge, lesson} from '../store/learning';
import {isProjected, project} from '../store/projector';
import {type Tab, services, pinned, tab} from '../store/state';
import {stepBy} from '../store/stepping';
import {layout} from '../store/layout';
import {goToPart, keepFocus} from './keep_focus';
import {Compare} from './Compare';
import {Controls} from './Controls';
import {Header} from './Header';
import {Inspector} from './Inspector';
import {Learn} from './Learn';
import {Stage} from './Stage';
import {Welcome} from './Welcome';
import {TextPane} from './TextPane';

const tabs = [
    ['learn', 'Learn'],
    ['text', 'Text'],
    ['controls', 'Controls'],
    ['inspect', 'Inspect'],
    ['compare', 'Compare'],
] as const;

/** Whether a panel is shown: the chosen one; on a projector the task and the explanation. */
const isShown = (name: Tab) => (isProjected.value ? name === 'learn' || name === 'inspect' : tab.value === name);

/** True if keys are text input. */
function isTyping(event: KeyboardEvent): boolean {
    const target = event.composedPath()[0];
    return target instanceof HTMLElement &&
        (target.isContentEditable || ['INPUT', 'SELECT', 'TEXTAREA'].includes(target.tagName) && (target as HTMLInputElement).type !== 'range'
            && (target as HTMLInputElement).type !== 'checkbox');
}

function useKeys() {
    useEffect(() => {
        const pressed = (event: KeyboardEvent) => {
            if (event.key === 'F6') {
                event.preventDefault();
                goToPart(event.shiftKey ? -1 : 1);
                return;
            }
            if (isTyping(event) || event.defaultPrevented) return;
            const command = event.ctrlKey || event.metaKey;
            if (command && event.key.toLowerCase() === 'z') {
                event.preventDefault();
                if (event.shiftKey) {
                    services.editor?.redo();
                } else {
                    services.editor?.undo();
                }
            } else if (event.key === 's' && !command && !event.altKey) {
                void savePicture('png');
            } else if (event.key === 'l' && !command && !event.altKey) {
                project(!isProjected.value);
            } else if ((event.key === 'n' || event.key === 'p') && !command && !event.altKey && pinned.value && isShown('inspect')) {
                stepBy(event.key === 'n' ? 1 : -1);
            } else if (event.key === 'Escape' && !document.querySelector('dialog[open]')) {
                if (isLarge.value) {
                    isLarge.value = false;
                } else {
                    pinned.value = null;
                }
            }
        };
        addEventListener('keydown', pressed);
        return () => removeEventListener('keydown', pressed);
    }, []);
}

function useDrop() {
    useEffect(() => {
        const over = (event: DragEvent) => event.preventDefault();
        const drop = (event: DragEvent) => {
            event.preventDefault();
            if (event.dataTransfer && event.dataTransfer.files.length > 0) void droppedFiles(event.dataTransfer).then(openFiles);
        };
        addEventListener('dragover', over);
        addEventListener('drop', drop);
        return () => {
            removeEventListener('dragover', over);
            removeEventListener('drop', drop);
        };
    }, []);
}

function Tabs() {
    const move = (event: KeyboardEvent) => {
        const step = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
        if (step === 0) return;
        event.preventDefault();
        const buttons = [...(event.currentTarget as HTMLElement).querySelectorAll<HTMLElement>('[role=tab]')]
            .filter((button) => button.offsetParent !== null);
        const at = buttons.indexOf(event.target as HTMLElement);
        const next = buttons[(at + step + buttons.length) % buttons.length];
        next?.focus();
        next?.click();
    };
    return (
        <div class="tabs" role="tablist" aria-label="Panels" onKeyDown={move}>
            {tabs.map(([name, label]) => (
                <button
                    key={name} role="tab" id={`tab-${name}`} class={`tab tab-${name}`} aria-controls={`panel-${name}`}
                    aria-selected={tab.value === name} tabIndex={tab.value === name ? 0 : -1}
                    onClick={() => {
                        tab.value = name;
                    }}
                >
                    {label}
                </button>
            ))}
        </div>
    );
}

export function App() {
    useKeys();
    useDrop();
    useEffect(keepFocus, []);
    const isTask = isProjected.value && (lesson.value !== null || challenge.value !== null);
    const panel = (name: Tab) => ({
        id: `panel-${name}`, role: 'tabpanel' as const, 'aria-labelledby': `tab-${name}`, class: 'panel',
        hidden: name === 'learn' && isProjected.value ? !isTask : !isShown(name),
    });
    return (
        <div class={`shell${isProjected.value ? ' projector' : ''}${isTask ? ' with-task' : ''}`} data-tab={tab.value}>
            <Header />
            <Welcome />
            <main class="columns" style={{'--left': `${layout.value.left}%`, '--right': `${layout.value.right}%`}}>
                <TextPane />
                <Stage />
                <section class="side" aria-label="Panels">
                    <Tabs />
                    <div {...panel('learn')}>{isShown('learn') && <Learn />}</div>
                    <div {...panel('controls')}><Controls /></div>
                    <div {...panel('inspect')}>{isShown('inspect') && <Inspector />}</div>
                    <div {...panel('compare')}><Compare /></div>
                </section>
            </main>
        </div>
    );
}
