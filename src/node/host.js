// SPDX-License-Identifier: Apache-2.0
// What emscripten does not pass on to node: the environment's variables, what standard input and output are, and a terminal's width.
mergeInto(LibraryManager.library, {
    $ENV__postset: 'Object.assign(ENV, process.env);',
    __syscall_ioctl__deps: ['$SYSCALLS'],
    __syscall_ioctl: function(fd, request, varargs) {
        const windowSize = 0x5413, notTerminal = -25;
        if (request !== windowSize || !require('tty').isatty(fd)) return notTerminal;
        const terminal = fd === 2 ? process.stderr : process.stdout;
        const [columns, rows] = terminal.getWindowSize ? terminal.getWindowSize() : [80, 24];
        const to = HEAP32[varargs >> 2] >> 1;
        HEAPU16[to] = rows;
        HEAPU16[to + 1] = columns;
        return 0;
    },
    // What isatty() asks.
    fd_fdstat_get__deps: ['$SYSCALLS'],
    fd_fdstat_get: function(fd, to) {
        const characterDevice = 2, folder = 3, regularFile = 4;
        const isFolder = fd > 2 && FS.isDir(FS.stat(SYSCALLS.getStreamFromFD(fd).path).mode);
        HEAP8[to] = require('tty').isatty(fd) ? characterDevice : isFolder ? folder : regularFile;
        return 0;
    },
    __syscall_fstat64__deps: ['$SYSCALLS'],
    __syscall_fstat64: function(fd, to) {
        if (fd > 2) return SYSCALLS.doStat(FS.stat, SYSCALLS.getStreamFromFD(fd).path, to);
        return SYSCALLS.doStat(() => fs.fstatSync(fd), '', to);
    },
});
