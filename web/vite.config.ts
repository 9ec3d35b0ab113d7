// SPDX-License-Identifier: Apache-2.0
import {createHash} from 'node:crypto';
import {defineConfig, type Plugin} from 'vite';

/** Writes sw.js: a service worker that keeps the files of this build, so that the page opens without a network. */
function offline(): Plugin {
    return {
        name: 'offline',
        apply: 'build',
        generateBundle(_, bundle) {
            // The gallery's thumbnails are kept when they are first seen.
            const all = ['./', ...Object.keys(bundle), 'icon.svg'].filter((name) => !name.endsWith('.map'));
            const files = all.filter((name) => !name.endsWith('.png'));
            const digest = createHash('sha256').update(all.join()).digest('hex').slice(0, 12);
            const source = `const cacheName = 'glint-${digest}';
const files = ${JSON.stringify(files)};
addEventListener('install', (event) => event.waitUntil(
    caches.open(cacheName).then((cache) => cache.addAll(files)).then(() => skipWaiting())));
addEventListener('activate', (event) => event.waitUntil(caches.keys().then((names) =>
    Promise.all(names.filter((name) => name.startsWith('glint-') && name !== cacheName).map((name) => caches.delete(name))))));
addEventListener('fetch', (event) => {
    if (event.request.method === 'GET')
        event.respondWith(caches.match(event.request, {ignoreSearch: true}).then(async (kept) => {
            if (kept) return kept;
            const found = await fetch(event.request);
            if (found.ok && event.request.url.endsWith('.png')) {
                const copy = found.clone();
                caches.open(cacheName).then((cache) => cache.put(event.request, copy)).catch(() => {});  // there may be no room
            }
            return found;
        }));
});
`;
            this.emitFile({type: 'asset', fileName: 'sw.js', source});
        },
    };
}

/** Fetches the engine's core while the page's code is loaded, not after it. */
function preloadEngine(): Plugin {
    return {
        name: 'preload-engine',
        apply: 'build',
        transformIndexHtml: {
            order: 'post',
            handler: (_, {bundle}) => Object.keys(bundle ?? {}).filter((name) => /glint-core.*\.wasm$/.test(name)).map((name) => ({
                tag: 'link', attrs: {rel: 'preload', as: 'fetch', crossorigin: '', href: `./${name}`}, injectTo: 'head',
            })),
        },
    };
}

export default defineConfig({
    base: './',
    build: {target: 'es2022', minify: 'terser', terserOptions: {compress: {passes: 3}, format: {comments: false}}, assetsInlineLimit: 0, modulePreload: {polyfill: false}, chunkSizeWarningLimit: 700},
    worker: {format: 'es'},
    plugins: [offline(), preloadEngine()],
});
