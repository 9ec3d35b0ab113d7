# SPDX-License-Identifier: Apache-2.0
"""The requests of a live view's page."""

import json
import urllib.error
import urllib.request

import numpy as np


def ask(view, action, **request):
    """(status, headers, content) of a request."""
    posted = urllib.request.Request(view.url + action, json.dumps(request).encode(), method="POST")
    try:
        with urllib.request.urlopen(posted, timeout=60) as response:
            return response.status, response.headers, response.read()
    except urllib.error.HTTPError as error:
        return error.code, error.headers, error.read()


def picture(view, **request):
    status, headers, content = ask(view, "picture", **request)
    assert status == 200, content
    width, height = map(int, headers["Glint-Size"].split("x"))
    return np.frombuffer(content, np.uint8).reshape(height, width, 3)
