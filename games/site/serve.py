# SPDX-License-Identifier: MIT
# Serves a folder to this machine alone: serve.py FOLDER PORT. Where the port is taken, one of the next ten.
import sys
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer


class Handler(SimpleHTTPRequestHandler):
    def end_headers(self):
        self.send_header("Cache-Control", "no-cache")  # what was built anew is loaded anew
        super().end_headers()

    def log_message(self, *_):
        pass


def server_from(folder, port):
    for candidate in range(port, port + 10):
        try:
            return ThreadingHTTPServer(("127.0.0.1", candidate), partial(Handler, directory=folder))
        except OSError as error:
            last = error
    sys.exit(f"games/run web: no port from {port} to {port + 9} is free: {last}")


def main():
    server = server_from(sys.argv[1], int(sys.argv[2]))
    print(f"http://127.0.0.1:{server.server_port}/ (Ctrl-C ends it)", flush=True)
    try:
        server.serve_forever()
    except KeyboardInterrupt:
        pass


main()
