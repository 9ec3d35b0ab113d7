// SPDX-License-Identifier: Apache-2.0
// Whether the machine is in use by others while something is measured: then the time says nothing.
import {readdirSync, readFileSync} from 'node:fs';

/** Ticks of all processors that were not idle, and of all. */
function ticksOfMachine() {
    const [user, nice, system, idle, wait, ...rest] = readFileSync('/proc/stat', 'utf8').split('\n')[0].split(/\s+/).slice(1, 9).map(Number);
    const busy = user + nice + system + rest.reduce((sum, one) => sum + one, 0);  // interrupts, and what other virtual machines take
    return {busy, all: busy + idle + wait};
}

/** Ticks of this process and its descendants. */
function ownTicks() {
    const processes = new Map();
    for (const pid of readdirSync('/proc').filter((name) => /^\d+$/.test(name))) {
        try {
            const fields = readFileSync(`/proc/${pid}/stat`, 'utf8').replace(/^.*\) /, '').split(' ').map(Number);
            processes.set(Number(pid), {parent: fields[1], ticks: fields[11] + fields[12]});
        } catch {
            // It has ended.
        }
    }
    const isOwn = (pid) => pid === process.pid || (processes.has(pid) && isOwn(processes.get(pid).parent));
    return [...processes].filter(([pid]) => isOwn(pid)).reduce((sum, [, {ticks}]) => sum + ticks, 0);
}

/** The share of the machine's time that others use while a function runs, and its result. */
export async function withShareOfOthers(act) {
    const machine = ticksOfMachine(), own = ownTicks();
    const result = await act();
    const now = ticksOfMachine();
    return {result, others: Math.max(0, now.busy - machine.busy - (ownTicks() - own)) / (now.all - machine.all)};
}

/**
 * Measures until a figure is good, at most five times. The figure is judged only if the machine was this test's own at least once;
 * on a busy machine it is only printed.
 */
export async function judged(what, isGood, measure) {
    const tried = [];
    do {
        tried.push(await withShareOfOthers(measure));
    } while (!isGood(tried.at(-1).result) && tried.length < 5);
    const words = tried.map(({result, others}) => `${result.toFixed(2)} (others ${Math.round(100 * others)}%)`).join(', ');
    console.log(`# ${what}: ${words}`);
    const fair = tried.filter(({others}) => others < 0.05);
    return {isGood: fair.length === 0 || tried.some(({result}) => isGood(result)), words};
}
