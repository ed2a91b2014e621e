#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A server on the loopback address that behaves well or badly, by the id that is asked for. It stands
for the PDB and for AlphaFold DB in tests. Prints the ports for http and for https with a certificate
that nobody signed (0 without openssl), and ends when its standard input is closed."""
import gzip
import json
import os
import ssl
import subprocess
import sys
import tempfile
import threading
import time
import zlib
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

ATOM = "ATOM 1 C CA ALA A 1 1 ? {}.000 0.000 0.000 1.00 9.00 1 A\n"
MODEL = ("data_TEST\n#\nloop_\n" + "".join(f"_atom_site.{name}\n" for name in (
    "group_PDB id type_symbol label_atom_id label_comp_id label_asym_id label_entity_id label_seq_id "
    "pdbx_PDB_ins_code Cartn_x Cartn_y Cartn_z occupancy B_iso_or_equiv auth_seq_id auth_asym_id").split())
         + ATOM.format(0) + ATOM.format(3).replace(" 1 C", " 2 C", 1) + "#\n").encode()
PACKED = gzip.compress(MODEL, mtime=0)
counts, lock = {}, threading.Lock()
tls_port = 0


class Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"

    def log_message(self, *_):
        pass

    def answer(self, status, body=b"", length=None, **headers):
        self.send_response(status)
        if length != "none":
            self.send_header("Content-Length", str(len(body) if length is None else length))
        for name, value in headers.items():
            self.send_header(name, value)
        self.send_header("Connection", "close")
        self.end_headers()
        self.close_connection = True
        try:
            self.wfile.write(body)
        except OSError:
            pass

    def do_GET(self):
        path, base = self.path, f"http://127.0.0.1:{self.server.server_port}"
        proxied = path.startswith("http://")
        if proxied:
            path = "/" + path.split("/", 3)[3]
        with lock:
            counts[path] = counts.get(path, 0) + 1
        name = path.rsplit("/", 1)[1].split(".")[0]
        if path.startswith("/api/"):
            return self.about_model(name, base)
        if path.startswith("/files/"):
            return self.answer(200, MODEL)
        if not path.endswith(".cif.gz"):
            return self.answer(404)
        if name == "1GOD":
            return self.answer(200, PACKED)
        if name == "1PRX":
            return self.answer(200 if proxied else 404, PACKED)
        if name == "1CNT":  # good once
            return self.answer(200, PACKED) if counts[path] == 1 else self.answer(500)
        if name == "1SLO":  # half of the file, and then nothing
            self.answer(200, PACKED[:20], len(PACKED))
            self.wfile.flush()
            return time.sleep(30)
        if name == "1BRK":
            return self.answer(200, PACKED[:40], len(PACKED))
        if name == "1LEN":  # fewer bytes announced than sent
            return self.answer(200, PACKED, len(PACKED) - 9)
        if name == "1CUT":  # nothing announced, and cut off
            return self.answer(200, PACKED[:-9], "none")
        if name == "1BIG":
            return self.answer(200, PACKED, 1 << 40)
        if name == "1BMB":
            packer = zlib.compressobj(1, wbits=31)
            return self.answer(200, packer.compress(b"data_\n" + bytes(17 << 20)) + packer.flush())
        if name == "1PAG":
            return self.answer(200, b"<html>Please log in</html>")
        if name == "1PGZ":
            return self.answer(200, gzip.compress(b"<html>Please log in</html>\n"))
        if name == "1RED":
            return self.answer(302, Location="/download/1GOD.cif.gz")
        if name == "1LOP":
            return self.answer(302, Location="/download/1LOP.cif.gz")
        if name == "1HTP":
            return self.answer(302, Location="http://192.0.2.1/download/1GOD.cif.gz")
        if name == "1FIL":
            return self.answer(302, Location="file:///etc/passwd")
        if name == "1TLS":
            return self.answer(302, Location=f"https://127.0.0.1:{tls_port}/download/1GOD.cif.gz")
        if name == "1ERR":
            return self.answer(500)
        if name == "1MNY":
            return self.answer(429)
        return self.answer(404)

    def about_model(self, accession, base):
        def model(address):
            return json.dumps([{"entryId": "AF-X", "cifUrl": address}]).encode()
        answers = {
            "P69905": json.dumps([{"cifUrl": f"{base}/files/AF-P69905-2-F1-model_v6.cif"}, 7,
                                  {"cifUrl": f"{base}/files/AF-P69905-F1-model_v6.cif"}]).encode(),
            "P00001": b'[{"cifUrl": "http',
            "P00002": model("http://192.0.2.1/files/AF-P00002-F1-model_v6.cif"),
            "P00003": b"[]",
            "P00004": model(base + "/files/../../AF-P00004-F1-model_v6.cif"),
            "P00005": model(base + "/files/AF-P69905-F1-model_v6.cif"),
            "P00006": b'{"error": "none"}',
            "P00007": b"[" * 100000,
        }
        return self.answer(200, answers[accession]) if accession in answers else self.answer(404)


def start_tls(folder):
    made = subprocess.run(
        ["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes",
         "-keyout", f"{folder}/key", "-out", f"{folder}/certificate", "-days", "2", "-subj", "/CN=127.0.0.1",
         "-addext", "subjectAltName=IP:127.0.0.1"], capture_output=True, check=False)
    if made.returncode != 0:
        return 0
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.load_cert_chain(f"{folder}/certificate", f"{folder}/key")
    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    server.socket = context.wrap_socket(server.socket, server_side=True, do_handshake_on_connect=False)
    server.handle_error = lambda *_: None  # nobody accepts the certificate
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return server.server_port


def main():
    global tls_port
    with tempfile.TemporaryDirectory() as folder:
        try:
            tls_port = start_tls(folder)
        except FileNotFoundError:
            pass
    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    server.handle_error = lambda *_: None
    threading.Thread(target=server.serve_forever, daemon=True).start()
    print(server.server_port, tls_port, flush=True)
    sys.stdin.read()
    os._exit(0)


if __name__ == "__main__":
    main()
