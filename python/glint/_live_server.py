# SPDX-License-Identifier: Apache-2.0
"""The HTTP server of a live view: on this computer alone, for one page that knows its address."""

from __future__ import annotations

import hmac
import http.server
import json
import pathlib
import secrets
import threading
from typing import Any, Callable, Dict, NamedTuple, Optional, Tuple

_MOST_BYTES = 4096
_MOST_CONNECTIONS = 32
_PAGE = pathlib.Path(__file__).with_name("_live.html")


class Answer(NamedTuple):
    """What a request gets."""

    status: int
    kind: str = "text/plain; charset=utf-8"
    content: bytes = b""
    headers: Tuple[Tuple[str, str], ...] = ()


def said(status: int, text: object) -> Answer:
    """A text that the page shows."""
    return Answer(status, content=str(text).encode("utf-8", "replace"))


Action = Callable[[Dict[str, Any]], Answer]


class _Stopped(Exception):
    pass


class _Handler(http.server.BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    timeout = 20  # seconds without a byte of the other side
    disable_nagle_algorithm = True
    server: LiveServer

    def version_string(self) -> str:
        return "glint"

    def log_message(self, *arguments: Any) -> None:
        pass

    def send_error(self, code: int, message: Optional[str] = None, explain: Optional[str] = None) -> None:
        """Also what the base class refuses: malformed and too long requests, other methods."""
        code = 405 if code == 501 else code
        self.close_connection = True
        self._send(said(code, message or "refused"))

    def _send(self, answer: Answer) -> None:
        self.send_response(answer.status)
        for name, value in answer.headers:
            self.send_header(name, value)
        self.send_header("Content-Type", answer.kind)
        self.send_header("Content-Length", str(len(answer.content)))
        self.send_header("Cache-Control", "no-store")
        self.send_header("Referrer-Policy", "no-referrer")
        self.send_header("X-Content-Type-Options", "nosniff")
        if self.close_connection:
            self.send_header("Connection", "close")
        self.end_headers()
        if self.command != "HEAD":
            self.wfile.write(answer.content)

    def _path(self) -> Optional[str]:
        """The part after the token; None if the request was refused."""
        host = f"127.0.0.1:{self.server.port}"
        # Another name that leads here is a page's that wants to read this one.
        if self.headers.get_all("Host") != [host] or self.headers.get("Origin", f"http://{host}") != f"http://{host}":
            self.send_error(403, "This address is not the live view's.")
            return None
        start = f"/{self.server.token}/"
        path = self.path.encode("latin-1", "replace")
        if not hmac.compare_digest(path[: len(start)], start.encode()):
            self.send_error(404, "There is no such page.")
            return None
        if self.server.is_stopped:
            self.send_error(410, "The live view is closed.")
            return None
        return self.path[len(start):]

    def do_GET(self) -> None:
        path = self._path()
        if path is None:
            return
        if path:
            self.send_error(405 if path in self.server.actions else 404, "There is no such page.")
            return
        nonce = secrets.token_urlsafe(16)
        policy = (
            f"default-src 'none'; script-src 'nonce-{nonce}'; style-src 'nonce-{nonce}'; style-src-attr 'unsafe-inline'; "
            "img-src data:; connect-src 'self'; base-uri 'none'; form-action 'none'"
        )
        page = _PAGE.read_bytes().replace(b"NONCE", nonce.encode())
        self._send(Answer(200, "text/html; charset=utf-8", page, (("Content-Security-Policy", policy),)))

    def do_POST(self) -> None:
        path = self._path()
        if path is None:
            return
        action = self.server.actions.get(path)
        length = self.headers.get("Content-Length", "")
        if action is None:
            self.send_error(404 if path else 405, "There is no such page.")
        elif "Transfer-Encoding" in self.headers or not (length.isascii() and length.isdigit()):
            self.send_error(411, "Content-Length: expected a number of bytes.")
        elif len(length) > 9 or int(length) > _MOST_BYTES:
            self.send_error(413, f"Content-Length: expected at most {_MOST_BYTES} bytes.")
        else:
            self._act(action, self.rfile.read(int(length)))

    def _act(self, action: Action, body: bytes) -> None:
        try:
            request = json.loads(body)
        except (ValueError, RecursionError):
            request = None
        if not isinstance(request, dict):
            self.send_error(400, "Expected a JSON object.")
            return
        try:
            answer = action(request)
        except (ValueError, TypeError, KeyError) as error:
            answer = said(400, error)
        except Exception as error:  # the page shows it: nobody else would
            answer = said(500, f"{type(error).__name__}: {error}")
        self._send(answer)


class LiveServer(http.server.ThreadingHTTPServer):
    """Serves one page at http://127.0.0.1:PORT/TOKEN/ until stop(), and calls `actions` with the JSON objects that are posted.

    OSError if the system gives no port. A request with another Host, another Origin or another token is refused, and so are
    other methods, bodies of more than 4096 bytes and more than 32 connections.
    """

    daemon_threads = True
    allow_reuse_address = False
    request_queue_size = _MOST_CONNECTIONS

    def __init__(self, actions: Dict[str, Action]) -> None:
        super().__init__(("127.0.0.1", 0), _Handler)
        self.actions = actions
        self.token = secrets.token_urlsafe(24)
        self.port = int(self.server_address[1])
        self.url = f"http://127.0.0.1:{self.port}/{self.token}/"
        self.is_stopped = False
        self._free = threading.BoundedSemaphore(_MOST_CONNECTIONS)
        self.thread = threading.Thread(target=self._serve, name="glint live view", daemon=True)
        self.thread.start()

    def server_bind(self) -> None:
        # Not HTTPServer's, which asks for the computer's name, perhaps for seconds.
        super(http.server.HTTPServer, self).server_bind()

    def _serve(self) -> None:
        try:
            self.serve_forever(0.1)
        except _Stopped:
            pass
        finally:
            self.server_close()

    def service_actions(self) -> None:
        if self.is_stopped:
            raise _Stopped

    def stop(self) -> None:
        """From any thread, also while garbage is collected: the port is free within 0.1 s."""
        self.is_stopped = True

    def process_request(self, request: Any, client_address: Any) -> None:
        if not self._free.acquire(blocking=False):
            self.shutdown_request(request)
            return
        try:
            super().process_request(request, client_address)
        except RuntimeError:  # no thread could be started
            self._free.release()
            self.shutdown_request(request)

    def process_request_thread(self, request: Any, client_address: Any) -> None:
        try:
            super().process_request_thread(request, client_address)
        finally:
            self._free.release()

    def handle_error(self, request: Any, client_address: Any) -> None:
        pass  # a page that went away
