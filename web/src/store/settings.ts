// SPDX-License-Identifier: Apache-2.0
// Settings: stored in the text if its format can express them, else in the overrides.
import {currentDocumentState, format, services, overrides, settingOf, text} from './state';

let lastOverride = {name: '', time: 0};

function setOverrides(now: Record<string, string>, again = false) {
    services.editor?.setDocumentState({...currentDocumentState(), overrides: now}, undefined, again);
}

function without(record: Record<string, string>, key: string) {
    const {[key]: _, ...rest} = record;
    return rest;
}

export function setSetting(name: string, value: string) {
    const setting = settingOf(name);
    const edits = format.value?.setting(text.value, name, value, setting?.is_convention ?? false);
    if (edits) {
        if (name in overrides.value) setOverrides(without(overrides.value, name));
        services.editor?.apply(edits);
        return;
    }
    // Dragging a slider is one change for undo.
    const again = lastOverride.name === name && (services.editor?.continues || performance.now() - lastOverride.time < 500);
    lastOverride = {name, time: performance.now()};
    setOverrides({...overrides.value, [name]: value}, again);
}

export function dropOverride(name: string) {
    setOverrides(without(overrides.value, name));
}
