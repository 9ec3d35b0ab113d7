// SPDX-License-Identifier: Apache-2.0
// One worker per core, and a queue of jobs.
import type {OpenRequest} from 'glint-wasm';

import type {Answers, FromWorker, Job, Task, ToWorker} from './protocol';

/** The job was cancelled, or its worker was terminated. */
export class Stopped extends Error {}

interface OpenScene {
    key: number;
    bytes: number;
}

interface Waiting {
    job: Job;
    /** What the scene takes in a worker, about. */
    bytes: number;
    opening: (done: number) => void;
    done: (answer: Answers[keyof Answers]) => void;
    failed: (why: Error) => void;
    /** It was running when it was cancelled. */
    isCancelled?: boolean;
}

interface Member {
    worker: Worker;
    module: WebAssembly.Module;
    running: Waiting | null;
    timer: number;
    /** By view: its scene in this worker. */
    open: Map<string, OpenScene>;
}

/** A job is aborted after this time without an answer or news of its progress, in milliseconds. */
const patience: Record<Task['what'], number> = {open: 10_000, explain: 10_000, convert: 10_000, compare: 120_000, 'compare-picture': 600_000, diagnose: 600_000, layers: 10_000, tile: Infinity, floats: Infinity};
/** A tile that is no longer needed may finish within this time; then its worker is terminated. */
const grace = 250;

/** The bytes that the scenes of all workers may take: a large one is opened in fewer of them, but always in one. */
const budget = 1.5e9;
/** What a scene takes for each byte of its texts: 3 to 7, measured of large meshes in .pov, .dat and .ply. */
const bytesPerByte = 7;

function bytesOf({texts, includes = []}: OpenRequest): number {
    return [...texts, ...includes].reduce((sum, {text, base64}) => sum + text.length + (base64?.length ?? 0) * 3 / 4, 0) * bytesPerByte;
}

const newWorker = () => new Worker(new URL('./worker.ts', import.meta.url), {type: 'module'});

export class Pool {
    readonly size: number;
    #members: Member[];
    #urgent: Waiting[] = [];
    #queue: Waiting[] = [];
    /** Those that the core cannot do, until there is the whole engine. */
    #held: Waiting[] = [];
    #module: WebAssembly.Module;
    #whole: Promise<WebAssembly.Module> | null = null;
    #nextId = 0;

    /** The workers have the engine's core until a job needs the whole. */
    constructor(core: WebAssembly.Module, private readonly loadWhole: () => Promise<WebAssembly.Module>, size: number,
                private readonly create: () => Worker = newWorker) {
        this.#module = core;
        this.size = size;
        this.#members = Array.from({length: size}, () => this.#start());
    }

    #start(): Member {
        const worker = this.create();
        const module = this.#module;
        const member: Member = {worker, module, running: null, timer: 0, open: new Map()};
        worker.addEventListener('message', ({data}: MessageEvent<FromWorker>) => this.#finish(member, data));
        worker.addEventListener('error', () => this.#replace(member, 'the worker stopped'));
        worker.postMessage({kind: 'start', module} satisfies ToWorker);
        return member;
    }

    /** Loads the whole engine, if that has not been done; the workers get it when a job needs it. */
    fetchWhole(): Promise<WebAssembly.Module> {
        this.#whole ??= this.loadWhole().catch((error: unknown) => {
            this.#whole = null;  // the next job tries again
            throw error;
        });
        return this.#whole;
    }

    /** Repeats a job with the whole engine. */
    async #repeat(waiting: Waiting) {
        if (waiting.isCancelled) {
            waiting.failed(new Stopped());
            return;
        }
        this.#held.push(waiting);
        try {
            this.#module = await this.fetchWhole();
            this.#urgent.unshift(...this.#held);
        } catch (error) {
            const why = new Error(`the rest of the engine cannot be loaded: ${error instanceof Error ? error.message : String(error)}`);
            for (const one of this.#held) one.failed(why);
        }
        this.#held = [];
        this.#next();
    }

    /** Queues a job. Urgent jobs come first. opening: called with the part of the job's scene that is open, from 0 to 1. */
    run<T extends Task>(job: Job & {task: T}, urgent = false, opening: (done: number) => void = () => {}): Promise<Answers[T['what']]> {
        return new Promise((done, failed) => {
            (urgent ? this.#urgent : this.#queue).push({job, bytes: bytesOf(job.request), opening, done: done as Waiting['done'], failed});
            this.#next();
        });
    }

    /** Cancels a view's jobs up to `key`. Running jobs have a moment to finish. */
    cancel(view: string, key: number) {
        const concerned = (waiting: Waiting) => waiting.job.view === view && waiting.job.key <= key;
        const withdrawn = [...this.#held, ...this.#urgent, ...this.#queue].filter(concerned);
        this.#held = this.#held.filter((waiting) => !concerned(waiting));
        this.#urgent = this.#urgent.filter((waiting) => !concerned(waiting));
        this.#queue = this.#queue.filter((waiting) => !concerned(waiting));
        for (const waiting of withdrawn) waiting.failed(new Stopped());
        for (const member of this.#members) {
            if (!member.running || !concerned(member.running)) continue;
            member.running.isCancelled = true;
            this.#limit(member, grace);
        }
    }

    #limit(member: Member, milliseconds: number) {
        clearTimeout(member.timer);
        if (milliseconds === Infinity) return;
        member.timer = window.setTimeout(() => this.#replace(member, 'it took too long'), milliseconds);
    }

    #replace(member: Member, why: string) {
        member.worker.terminate();
        clearTimeout(member.timer);
        member.running?.failed(new Stopped(member.running.isCancelled ? '' : why));
        this.#members[this.#members.indexOf(member)] = this.#start();
        this.#next();
    }

    #finish(member: Member, message: FromWorker) {
        const {running} = member;
        if ('done' in message) {
            if (!running || running.isCancelled) return;
            this.#limit(member, patience[running.job.task.what]);
            running.opening(message.done);
            return;
        }
        member.running = null;
        clearTimeout(member.timer);
        if (running && 'answer' in message) {
            running.done(message.answer);
        } else if (running && 'leftOut' in message) {
            member.open.clear();
            void this.#repeat(running);
        } else if (running && 'error' in message) {
            if (message.broken) member.open.clear();
            running.failed(new Error(message.broken ? 'the scene needs more memory than there is' : message.error));
        }
        this.#next();
    }

    /** Whether the worker may open the job's scene, in place of what it has of this view. */
    #mayOpen(member: Member, {job, bytes}: Waiting): boolean {
        if (!this.#members.some(({open}) => open.get(job.view)?.key === job.key)) return true;
        const held = this.#members.flatMap(({open}) => [...open.values()]).reduce((sum, scene) => sum + scene.bytes, 0);
        return held - (member.open.get(job.view)?.bytes ?? 0) + bytes <= budget;
    }

    #next() {
        for (const member of this.#members) {
            if (member.running) continue;
            if (member.module !== this.#module) {
                member.module = this.#module;
                member.open.clear();
                member.worker.postMessage({kind: 'start', module: this.#module} satisfies ToWorker);
            }
            // Prefer jobs whose scene is already open in this worker.
            const has = ({job}: Waiting) => member.open.get(job.view)?.key === job.key;
            const choose = (queue: Waiting[]) => queue.find(has) ?? queue.find((waiting) => this.#mayOpen(member, waiting));
            const waiting = choose(this.#urgent) ?? choose(this.#queue);
            if (!waiting) continue;
            const queue = this.#urgent.includes(waiting) ? this.#urgent : this.#queue;
            queue.splice(queue.indexOf(waiting), 1);
            const {view, key, request, prepare, task} = waiting.job;
            const message: ToWorker = {
                kind: 'job', id: ++this.#nextId, view, key, prepare, task,
                request: has(waiting) ? null : request,
            };
            member.running = waiting;
            member.open.set(view, {key, bytes: waiting.bytes});
            this.#limit(member, patience[task.what]);
            member.worker.postMessage(message);
        }
    }
}
