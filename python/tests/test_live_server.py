# SPDX-License-Identifier: Apache-2.0
"""What the server of a live view refuses: never with a traceback, and it answers the page afterwards."""

import socket
import time
import webbrowser

import pytest

import glint


@pytest.fixture
def view(monkeypatch, capfd):
    monkeypatch.setenv("DISPLAY", ":0")
    monkeypatch.setattr(webbrowser, "open", lambda address: True)
    view = glint.Scene(glint.Sphere(), glint.Light("ambient"), size=(8, 6)).live()
    yield view
    path = view.url.split("/", 3)[3]
    assert send(view, f"GET /{path} HTTP/1.1\r\nHost: {host(view)}\r\nConnection: close\r\n\r\n").startswith(b"HTTP/1.1 200 ")
    view.close()
    assert capfd.readouterr() == ("", "")


def host(view):
    return view.url.split("/")[2]


def send(view, text, end=True):
    """The whole answer to bytes; `end`: nothing more is sent."""
    name, port = host(view).split(":")
    with socket.create_connection((name, int(port)), timeout=30) as connection:
        answer = b""
        try:
            connection.sendall(text.encode("latin-1") if isinstance(text, str) else text)
            if end:
                connection.shutdown(socket.SHUT_WR)
            while True:
                part = connection.recv(65536)
                if not part:
                    break
                answer += part
        except ConnectionError:
            pass
        return answer


def status(answer):
    return int(answer.split(b" ", 2)[1])


def ask(view, method="POST", path=None, own_host=None, body="{}", headers=()):
    path = "/" + view.url.split("/", 3)[3] + "picture" if path is None else path
    lines = [f"{method} {path} HTTP/1.1", f"Host: {own_host or host(view)}", f"Content-Length: {len(body)}", *headers]
    return send(view, "\r\n".join(lines) + "\r\n\r\n" + body)


def test_the_page(view):
    answer = ask(view, "GET", "/" + view.url.split("/", 3)[3], body="").decode()
    head, body = answer.split("\r\n\r\n", 1)
    assert status(answer.encode()) == 200 and "Access-Control" not in head and "Python" not in head
    policy = next(line for line in head.split("\r\n") if line.startswith("Content-Security-Policy"))
    nonce = policy.split("'nonce-")[1].split("'")[0]
    assert "default-src 'none'; script-src 'nonce-" in policy and "NONCE" not in body
    assert body.count(f'nonce="{nonce}"') == 2 and "http" not in body


@pytest.mark.parametrize("name", ["localhost", "evil.example", "127.0.0.1", "127.0.0.1:1"])
def test_other_hosts(view, name):
    assert status(ask(view, own_host=name)) == 403


def test_other_origins_and_several_hosts(view):
    assert status(ask(view, headers=["Origin: http://evil.example"])) == 403
    assert status(ask(view, headers=["Origin: null"])) == 403
    assert status(ask(view, headers=[f"Host: {host(view)}"])) == 403
    assert status(ask(view, headers=[f"Origin: http://{host(view)}"])) == 200


def test_other_tokens(view):
    token = view.url.split("/")[3]
    for path in ("/", "/picture", f"/{token[:-1]}/picture", f"/{token}x/picture", f"/{token.swapcase()}/picture", "/\xff\xfe/", "//", "*"):
        assert status(ask(view, path=path)) == 404, path
        assert status(ask(view, "GET", path=path, body="")) == 404, path


def test_other_paths_and_methods(view):
    token = view.url.split("/")[3]
    for path in ("_live.html", "../_live.py", "..%2f", "picture/", "picture?x", "__init__"):
        assert status(ask(view, path=f"/{token}/{path}")) == 404, path
        assert status(ask(view, "GET", path=f"/{token}/{path}", body="")) == 404, path
    assert status(ask(view, "GET", body="")) == 405 and status(ask(view, path=f"/{token}/")) == 405
    for method in ("PUT", "DELETE", "OPTIONS", "HEAD", "TRACE", "CONNECT", "do_POST", "XXX"):
        assert status(ask(view, method)) == 405, method


def test_malformed_bodies(view):
    for body in ("", "[]", "1", "null", "{", "[" * 4000, '{"x": ' * 600, "\xff", '{"page": NaN}', '{"page": 1e999}', '{"values": {"a": {}}}'):
        assert status(ask(view, body=body)) == 400, body


def test_huge_bodies(view):
    path = "/" + view.url.split("/", 3)[3] + "picture"
    start = f"POST {path} HTTP/1.1\r\nHost: {host(view)}\r\n"
    assert status(ask(view, body=" " * 5000)) == 413
    for length, wanted in (("99999999999999999999", 413), ("4097", 413), ("-1", 411), ("1e3", 411), ("", 411), ("\xb2", 411)):
        assert status(send(view, f"{start}Content-Length: {length}\r\n\r\n")) == wanted, length
    assert status(send(view, start + "\r\n")) == 411
    assert status(send(view, start + "Transfer-Encoding: chunked\r\nContent-Length: 2\r\n\r\n{}")) == 411
    assert send(view, start + "Content-Length: 100\r\n\r\n{")[9:12] in (b"400", b"")  # less than was promised


def test_huge_and_malformed_heads(view):
    assert status(send(view, "GET /" + "a" * 70000 + " HTTP/1.1\r\n\r\n")) == 414
    assert status(send(view, "GET / HTTP/1.1\r\nX: " + "a" * 70000 + "\r\n\r\n")) == 431
    assert status(send(view, "GET / HTTP/1.1\r\n" + "X: a\r\n" * 200 + "\r\n")) == 431
    assert status(send(view, "GET / HTTP/1.1\r\n\r\n")) == 403
    for head in ("GET\r\n\r\n", "GET / HTTP/9.9\r\n\r\n", "GET / x y z\r\n\r\n", "\x00\x01\x02\r\n\r\n", "\x16\x03\x01\x02\x00", "", "\r\n"):
        answer = send(view, head)
        assert b"Traceback" not in answer and b" 200 " not in answer, head


def test_connections_that_say_nothing_do_not_stop_the_others(view):
    name, port = host(view).split(":")
    silent = [socket.create_connection((name, int(port))) for _ in range(20)]
    start = time.monotonic()
    assert status(ask(view)) == 200 and time.monotonic() - start < 10
    more = [socket.create_connection((name, int(port))) for _ in range(40)]
    time.sleep(0.5)
    for connection in silent + more:
        connection.close()
    time.sleep(0.5)
