// SPDX-License-Identifier: Apache-2.0
// node serve.mjs FOLDER [PORT]: a static file server for this machine only; prints its address.
import {createReadStream, statSync} from 'node:fs';
import {createServer} from 'node:http';
import {extname, join, normalize, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

const types = {
    '.html': 'text/html; charset=utf-8',
    '.js': 'text/javascript; charset=utf-8',
    '.mjs': 'text/javascript; charset=utf-8',
    '.css': 'text/css; charset=utf-8',
    '.wasm': 'application/wasm',
    '.png': 'image/png',
    '.svg': 'image/svg+xml',
};

export function serve(folder, port) {
    const root = resolve(folder);
    const server = createServer((request, response) => {
        let path = join(root, normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname)));
        const stat = (at) => statSync(at, {throwIfNoEntry: false});
        if (stat(path)?.isDirectory()) path = join(path, 'index.html');
        if (!path.startsWith(root) || !stat(path)?.isFile()) {
            response.writeHead(404).end('not found');
            return;
        }
        response.writeHead(200, {'Content-Type': types[extname(path)] ?? 'application/octet-stream'});
        createReadStream(path).pipe(response);
    });
    return new Promise((done, failed) => {
        server.once('error', failed);
        server.listen(port, '127.0.0.1', () => done(server));
    });
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
    const server = await serve(process.argv[2] ?? 'dist', Number(process.argv[3] ?? 8080));
    console.log(`http://127.0.0.1:${server.address().port}/`);
}
