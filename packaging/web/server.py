"""Serves a folder on this machine alone: server.py FOLDER PORT"""

import functools
import http.server
import sys


class Handler(http.server.SimpleHTTPRequestHandler):
    # Browsers compile a program while it loads only if its type is right.
    extensions_map = {
        **http.server.SimpleHTTPRequestHandler.extensions_map,
        ".wasm": "application/wasm",
        ".js": "text/javascript",
    }

    def log_message(self, *_):
        pass


def server(folder, port=0):
    """A server of the folder; port 0 takes a free one."""
    handler = functools.partial(Handler, directory=str(folder))
    return http.server.ThreadingHTTPServer(("127.0.0.1", port), handler)


if __name__ == "__main__":
    page = server(sys.argv[1], int(sys.argv[2]))
    print(f"http://127.0.0.1:{page.server_port}/ (Ctrl+C ends)", flush=True)
    try:
        page.serve_forever()
    except KeyboardInterrupt:
        pass
