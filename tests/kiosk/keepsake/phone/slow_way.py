"""A slow and lossy way between a browser and the server, in the test's own process: answers go on in small bursts, and those
to the targets that `breaks` names break off after a random number of bytes.

    with SlowWay(port, breaks=("pot.glb",), after=300_000, seed=1) as way:
        page.go(f"http://127.0.0.1:{way.port}/k/...")
"""
import random
import socket
import socketserver
import threading
import time


class SlowWay:
    def __init__(self, port, breaks=(), after=300_000, burst=32768, pause=0.002, seed=1):
        self.asked, chance = [], random.Random(seed)  # the request lines and Range headers, in order

        class Carry(socketserver.BaseRequestHandler):
            def handle(carried):
                head = carried.request.recv(16384)
                if not head:
                    return
                line = head.split(b"\r\n")[0].decode()
                span = [each.decode() for each in head.split(b"\r\n") if each.lower().startswith(b"range:")]
                self.asked.append((line, span[0] if span else ""))
                left = chance.randrange(1000, after) if any(b in line for b in breaks) else None
                with socket.create_connection(("127.0.0.1", port)) as server:
                    server.sendall(head)
                    while part := server.recv(burst if left is None else min(burst, left) or 1):
                        carried.request.sendall(part)
                        time.sleep(pause)
                        if left is not None:
                            left -= len(part)
                            if left <= 0:
                                return

        class Ways(socketserver.ThreadingTCPServer):
            daemon_threads, request_queue_size, allow_reuse_address = True, 128, True

            def handle_error(*_):
                pass  # a browser that has enough goes away

        self.server = Ways(("127.0.0.1", 0), Carry)
        self.port = self.server.server_address[1]
        self.thread = threading.Thread(target=self.server.serve_forever, daemon=True)

    def __enter__(self):
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.server.shutdown()
        self.server.server_close()
        self.thread.join()
