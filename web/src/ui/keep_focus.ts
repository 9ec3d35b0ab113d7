// SPDX-License-Identifier: Apache-2.0
// The keyboard's focus stays near where it was when what had it is removed or disabled: a dismissed notice, a step that is done.
// Else it would be nowhere, and screen readers would begin at the top of the page.

const reachable = 'a[href], button, input, select, textarea, summary, [tabindex]:not([tabindex="-1"])';

const isUsable = (element: HTMLElement) => element.isConnected && !element.matches(':disabled') && element.offsetParent !== null;

/** Where the focus goes from an element that is gone: what its nearest surroundings name by data-focus, else the first there. */
function placeNear(around: readonly Element[]): HTMLElement | null {
    for (const outer of around) {
        if (!outer.isConnected) continue;
        const named = outer.querySelector<HTMLElement>('[data-focus]');
        const found = named && isUsable(named) ? named : [...outer.querySelectorAll<HTMLElement>(reachable)].find(isUsable);
        if (found) return found;
    }
    return null;
}

export function keepFocus(): () => void {
    let last: HTMLElement | null = null, around: Element[] = [];
    const focused = (event: FocusEvent) => {
        last = event.target as HTMLElement;
        around = [];
        for (let outer = last.parentElement; outer && outer !== document.body; outer = outer.parentElement) around.push(outer);
    };
    const check = () => {
        if (document.activeElement !== document.body || !last || isUsable(last)) return;
        const next = placeNear(around);
        last = null;
        next?.focus({preventScroll: true});
    };
    // After the page has been drawn anew.
    const acted = () => requestAnimationFrame(() => setTimeout(check));
    document.addEventListener('focusin', focused);
    document.addEventListener('click', acted);
    document.addEventListener('keyup', acted);
    return () => {
        document.removeEventListener('focusin', focused);
        document.removeEventListener('click', acted);
        document.removeEventListener('keyup', acted);
    };
}

/** Goes to the next part of the page: the scene's text, the picture, the open panel. */
export function goToPart(by: 1 | -1) {
    const editor = document.querySelector('.editor')?.shadowRoot?.querySelector<HTMLElement>('.cm-content');
    const parts = [editor ?? null, document.querySelector<HTMLElement>('.frame'), document.querySelector<HTMLElement>('[role=tab][aria-selected=true]')];
    const usable = parts.filter((one) => one !== null && one.offsetParent !== null) as HTMLElement[];
    const areas = ['.text-pane', '.stage', '.side'].map((area) => document.querySelector(area)?.contains(document.activeElement) ?? false);
    const now = parts.findIndex((one, i) => areas[i] && one !== null && usable.includes(one));
    const at = now < 0 ? (by > 0 ? -1 : 0) : usable.indexOf(parts[now]!);
    usable[(at + by + usable.length) % usable.length]?.focus();
}
