"""The staff's page by HTTPS, whole: what `onggi setup --console` writes, a real nginx with the package's own settings, and the
real onggi-console at its socket, asked over TLS.

usage: staff_web_test.py --onggi build/.../onggi --console build/.../onggi-console
Skipped (77) where there is no nginx or no openssl.
"""
import argparse
import http.client
import json
import os
import pathlib
import re
import shutil
import socket
import ssl
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import warnings

ROOT = pathlib.Path(__file__).resolve().parents[4]
PACKAGE = ROOT / "kiosk/program/package"
STAFF, DESK, EVE = "127.0.0.2", "127.0.0.3", "127.0.0.4"  # the page's address, and two computers of the staff's network
NGINX, OPENSSL = shutil.which("nginx", path="/usr/sbin:/usr/bin"), shutil.which("openssl")
# Numbers for the users and groups of the units, where root can become them; else all is this user's.
NUMBERS = {"onggi": 64101, "onggi-phone": 64102, "onggi-console": 64103, "onggi-keepsakes": 64105, "onggi-site": 64106, "onggi-staff-web": 64107,
           "video": 64108, "render": 64109, "onggi-screen": 64110}
OTHER_USER = 64104
NAME, PASSPHRASE = "maria.k", "four words of hers"


def free_port():
    with socket.socket() as one:
        one.bind((STAFF, 0))
        return one.getsockname()[1]


def number(name, own):
    return NUMBERS[name] if os.getuid() == 0 else own


def as_unit(unit):
    """The words that make a command a process of the unit's user and groups."""
    text = (PACKAGE / "system" / unit).read_text()
    if os.getuid() != 0:
        return []
    user = NUMBERS[re.search(r"^User=(.*)", text, flags=re.M)[1]]
    groups = [NUMBERS[name] for name in re.search(r"^SupplementaryGroups=(.*)", text, flags=re.M)[1].split()]
    return ["setpriv", f"--reuid={user}", f"--regid={user}", "--groups=" + ",".join(map(str, groups)), "--no-new-privs"]


def image(root):
    """A Debian with the package, as far as setup looks."""
    for name, text in (("etc/passwd", f"onggi:x:{number('onggi', os.getuid())}:{number('onggi', os.getgid())}::/:/bin/false\n"),
                       ("etc/group", "".join(f"{name}:x:{number(name, os.getgid())}:\n" for name in NUMBERS)),
                       ("etc/hostname", "kiosk\n"), ("usr/sbin/nginx", ""), ("usr/bin/openssl", "")):
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text)
    share = root / "usr/share/onggi"
    shutil.copytree(ROOT / "config", share / "config")
    for name in ("lessons", "ways", "vessels/moon_jar"):
        shutil.copytree(ROOT / "content" / name, share / "content" / name)
    for name in ("glazes.toml", "missions.toml"):
        shutil.copy(ROOT / "content" / name, share / "content" / name)
    shutil.copytree(PACKAGE / "system", share / "system")
    units = root / "usr/lib/systemd/system"
    units.mkdir(parents=True)
    (root / "lib").symlink_to("usr/lib")
    for unit in (PACKAGE / "system").glob("*.service"):
        shutil.copy(unit, units)


class ScreenSocket:
    """As systemd serves onggi-screen.socket: a process for each connection, which is its standard input and output."""

    def __init__(self, folder):
        self.folder = folder
        folder.mkdir()
        self.at = folder / "page.sock"
        self.listening = socket.socket(socket.AF_UNIX)
        self.listening.bind(str(self.at))
        self.listening.listen()
        os.chown(self.at, os.getuid(), number("onggi-console", os.getgid()))
        self.at.chmod(0o660)
        self.processes = []
        threading.Thread(target=self.serve, daemon=True).start()

    def serve(self):
        while True:
            try:
                asked, _ = self.listening.accept()
            except OSError:
                return
            with asked:
                self.processes.append(subprocess.Popen([*as_unit("onggi-screen@.service"), ARGUMENTS.onggi, "screen", "--asked"],
                                                       stdin=asked, stdout=asked, stderr=subprocess.DEVNULL, cwd="/"))

    def end(self):
        self.listening.shutdown(socket.SHUT_RDWR)
        self.listening.close()
        for process in self.processes:
            process.kill()
            process.wait()


class StaffWeb(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        os.umask(0o022)
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="onggi-web-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.folder.chmod(0o755)
        cls.machine = cls.folder / "machine"
        image(cls.machine)
        cls.port = free_port()
        cls.at = f"{STAFF}:{cls.port}"
        done = subprocess.run([ARGUMENTS.onggi, "setup", "--root", str(cls.machine), "--console", cls.at],
                              capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr
        cls.said = done.stdout
        etc, run = cls.machine / "etc/onggi/staff-web", cls.folder / "run"
        web = cls.folder / "web"
        cls.state = cls.folder / "state"
        for made, name, mode in ((run, "onggi-console", 0o750), (cls.state, "onggi-console", 0o700),
                                 (web, "onggi-staff-web", 0o700)):
            made.mkdir(mode=mode)
            os.chown(made, number(name, os.getuid()), number(name, os.getgid()))
        cls.certificate, cls.socket = etc / "self-signed.pem", run / "page.sock"
        # As the units start them, with this test's folders in place of the machine's.
        places = (("/etc/onggi/staff-web", str(etc)), ("/run/onggi-console", str(run)), ("/run/onggi-staff-web", str(web)),
                  ("/run/onggi-screen", str(cls.folder / "screen")))
        cls.screens = ScreenSocket(cls.folder / "screen")
        cls.addClassCleanup(cls.screens.end)

        def here(text):
            for place, own in places:
                text = text.replace(place, own)
            return text
        cls.environment = dict(line.split("=", 1) for line in (etc / "console.env").read_text().splitlines()[1:])
        unit = (PACKAGE / "system/onggi-console.service").read_text()
        words = re.search(r"^ExecStart=\S+ (.*)", unit, flags=re.M)[1]
        words = words.replace("${LISTEN}", here(cls.environment["LISTEN"])).replace("$ADDRESSES", cls.environment["ADDRESSES"])
        cls.words = [ARGUMENTS.console, *here(words).replace("/srv/onggi", str(cls.machine / "srv/onggi")).split(),
                     "--state", str(cls.state)]
        cls.console = None
        cls.start_console()
        (etc / "address.conf").write_text(here((etc / "address.conf").read_text()))
        settings = cls.folder / "nginx.conf"
        settings.write_text(here((PACKAGE / "staff-web/nginx.conf").read_text()))
        words = re.search(r"^ExecStart=/usr/sbin/nginx (.*)", (PACKAGE / "system/onggi-staff-web.service").read_text(), flags=re.M)[1]
        words = words.replace("/usr/share/onggi/staff-web/nginx.conf", str(settings)).split()
        cls.nginx = subprocess.Popen([*as_unit("onggi-staff-web.service"), NGINX, *words], stderr=subprocess.PIPE, text=True)
        cls.addClassCleanup(cls.end_both)
        end = time.monotonic() + 20
        while True:
            try:
                socket.create_connection((STAFF, cls.port), 1).close()
                break
            except OSError:
                assert cls.nginx.poll() is None and time.monotonic() < end, cls.nginx.stderr.read()
                time.sleep(0.05)
        code = cls.give_code()
        status, fields, _ = cls.ask("GET", "/?code=" + code)
        assert status == 303, status
        cls.set_cookie = fields["Set-Cookie"]
        cls.cookie = cls.set_cookie.split(";")[0]
        status, _, said = cls.change("/api/people", {"name": NAME, "role": "desk", "passphrase": PASSPHRASE})
        assert status == 200, said

    @classmethod
    def end_both(cls):
        for process in (cls.nginx, cls.console):
            process.terminate()
            process.wait()
        cls.nginx.stderr.close()
        cls.console.stdout.close()

    @classmethod
    def start_console(cls):
        cls.console = subprocess.Popen([*as_unit("onggi-console.service"), *cls.words], stdout=subprocess.PIPE, text=True)
        cls.printed = cls.console.stdout.readline() + cls.console.stdout.readline()

    @classmethod
    def give_code(cls):
        said = subprocess.run([*cls.words, "--code"], capture_output=True, text=True, check=True).stdout
        return re.search(rf"https://{re.escape(cls.at)}/\?code=(\S+)", said)[1]

    @classmethod
    def tls(cls, **kept):
        context = ssl.create_default_context(cafile=str(cls.certificate))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # older versions are named only to see them refused
            for name, value in kept.items():
                setattr(context, name, value)
        return context

    @classmethod
    def ask(cls, method, target, body=None, host=None, source=DESK, **fields):
        link = http.client.HTTPSConnection(STAFF, cls.port, timeout=20, context=cls.tls(), source_address=(source, 0))
        try:
            link.request(method, target, body=body, headers={"Host": host or cls.at, **{
                name.replace("_", "-"): value for name, value in fields.items()}})
            answer = link.getresponse()
            return answer.status, dict(answer.getheaders()), answer.read().decode()
        finally:
            link.close()

    @classmethod
    def change(cls, target, body, **fields):
        kept = {"Origin": f"https://{cls.at}", "Cookie": cls.cookie, "Content-Type": "application/json", **fields}
        return cls.ask("POST", target, json.dumps(body), **kept)

    def test_the_page_and_signing_in_work_and_setup_says_where(self):
        self.assertEqual(self.ask("GET", "/")[0], 401)
        self.assertEqual(self.ask("GET", "/api/state", Cookie=self.cookie)[0], 200)
        self.assertIn("<title>", self.ask("GET", "/", Cookie=self.cookie)[2])
        status, fields, _ = self.change("/api/enter", {"name": NAME, "passphrase": PASSPHRASE}, Cookie="", source="127.0.0.5")
        self.assertEqual(status, 200)
        self.assertIn("Secure", fields["Set-Cookie"])
        for page in (f"https://{self.at}", f"https://kiosk.local:{self.port}", f"https://kiosk:{self.port}"):
            self.assertIn(page, self.said)
        told = subprocess.run([OPENSSL, "x509", "-noout", "-fingerprint", "-sha256", "-in", str(self.certificate)],
                              capture_output=True, text=True, check=True).stdout
        self.assertIn(told.strip(), self.said)

    def test_the_certificate_is_for_each_name_and_its_key_for_root_and_the_web_server(self):
        for name in (STAFF, "kiosk", "kiosk.local"):
            with socket.create_connection((STAFF, self.port), 5) as raw, self.tls().wrap_socket(raw, server_hostname=name):
                pass
        with self.assertRaises(ssl.SSLCertVerificationError), socket.create_connection((STAFF, self.port), 5) as raw:
            self.tls().wrap_socket(raw, server_hostname="other.example")
        self.assertEqual((self.certificate.parent / "self-signed-key.pem").stat().st_mode & 0o7777, 0o640)

    def test_the_cookie_is_for_https_and_this_host_alone(self):
        for part in ("__Host-", "; Secure", "; HttpOnly", "; SameSite=Strict", "; Path=/;"):
            self.assertIn(part, self.set_cookie)
        self.assertNotIn("Domain", self.set_cookie)

    def test_a_self_signed_certificate_binds_no_browser_for_later(self):
        self.assertNotIn("Strict-Transport-Security", self.ask("GET", "/")[1])

    def test_plain_http_gives_nothing(self):
        with socket.create_connection((STAFF, self.port), 5) as raw:
            raw.sendall(f"GET / HTTP/1.1\r\nHost: {self.at}\r\n\r\n".encode())
            try:
                self.assertEqual(raw.recv(4096), b"")
            except ConnectionResetError:
                pass

    def test_no_older_tls_is_spoken(self):
        self.assertIn("ssl_protocols TLSv1.2 TLSv1.3;", (PACKAGE / "staff-web/nginx.conf").read_text())
        context = self.tls(minimum_version=ssl.TLSVersion.TLSv1, maximum_version=ssl.TLSVersion.TLSv1_1)
        context.set_ciphers("ALL:@SECLEVEL=0")
        with self.assertRaises((ssl.SSLError, ConnectionError)), socket.create_connection((STAFF, self.port), 5) as raw:
            context.wrap_socket(raw, server_hostname=STAFF)

    def test_no_other_address_of_the_machine_listens(self):
        for other in ("127.0.0.1", DESK):
            with self.assertRaises(ConnectionRefusedError):
                socket.create_connection((other, self.port), 5)

    def test_another_host_and_another_pages_form_are_refused(self):
        for host in ("evil.example", STAFF, f"kiosk.local.evil.example:{self.port}", f"127.0.0.1:{self.port}"):
            self.assertEqual(self.ask("GET", "/", host=host)[0], 421, host)
        self.assertEqual(self.ask("GET", "/", host=f"kiosk.local:{self.port}")[0], 401)
        for origin in (f"http://{self.at}", "https://evil.example", f"https://kiosk.local:{self.port}"):
            self.assertEqual(self.change("/api/people", {}, Origin=origin)[0], 403, origin)

    def test_who_tries_passphrases_waits_at_their_own_address_whatever_they_say(self):
        wrong = {"name": "wrong.one", "passphrase": "x"}
        self.assertEqual(self.change("/api/enter", wrong, Cookie="", source=EVE)[0], 401)
        # The pause of a second may be over on a machine that is busy. Then it doubles.
        self.assertIn(429, [self.change("/api/enter", wrong, Cookie="", source=EVE, X_Real_IP=f"9.9.9.{n}")[0] for n in range(4)])
        self.assertEqual(self.change("/api/enter", wrong, Cookie="", source=DESK, X_Real_IP=EVE)[0], 401)
        # The list of changes has the address, too.
        changes = [json.loads(line) for line in (self.state / "changes").read_text().splitlines()]
        self.assertIn(("added person", DESK), [(c["did"], c["from"]) for c in changes])

    def test_without_a_proxy_nobodys_word_for_an_address_counts(self):
        alone = subprocess.Popen([ARGUMENTS.console, "--site", str(self.machine / "srv/onggi"), "--listen", "127.0.0.1:0",
                                  "--state", str(self.folder / "alone")], stdout=subprocess.PIPE, text=True)
        try:
            said = alone.stdout.readline() + alone.stdout.readline()
            at = re.search(r"http://(\S+)/\?code=", said)[1]

            def wrong(address):
                link = http.client.HTTPConnection(at, timeout=20)
                link.request("POST", "/api/enter", json.dumps({"name": "wrong.one", "passphrase": "x"}), {
                    "Origin": f"http://{at}", "Content-Type": "application/json", "X-Real-IP": address})
                status = link.getresponse().status
                link.close()
                return status
            self.assertIn(429, [wrong(f"10.0.0.{n}") for n in range(5)])
        finally:
            alone.terminate()
            alone.wait()
            alone.stdout.close()

    def told(self, field, target="/api/people"):
        """The answer to a head that promises a body, before anything of the body is sent."""
        with socket.create_connection((STAFF, self.port), 20) as raw, \
                self.tls().wrap_socket(raw, server_hostname=STAFF) as link:
            link.sendall(f"POST {target} HTTP/1.1\r\nHost: {self.at}\r\nConnection: close\r\n{field}\r\n\r\n".encode())
            answer = b""
            # The whole answer; the connection stays open a little for what the other side still sends.
            while b"\n" not in answer.partition(b"\r\n\r\n")[2] and b"}" not in answer and (more := link.recv(4096)):
                answer += more
        return answer.decode()

    def test_four_gigabytes_are_refused_at_once_in_words(self):
        begin = time.monotonic()
        answer = self.told(f"Content-Length: {4 << 30}")
        self.assertLess(time.monotonic() - begin, 2)
        self.assertTrue(answer.startswith("HTTP/1.1 413"), answer)
        self.assertIn("too large", json.loads(answer.partition("\r\n\r\n")[2])["what"])
        self.assertTrue(self.told("Transfer-Encoding: chunked").startswith("HTTP/1.1 411"))

    def test_a_scan_of_600_megabytes_reaches_the_page_at_its_own_address_alone(self):
        length = f"Content-Length: {600 << 20}"
        # Whatever the page says to it: these are not the web server's words.
        self.assertNotIn("This scan is too large", self.told(length, "/api/upload?name=scan.glb"))
        self.assertNotIn("at most 128 KB", self.told(length, "/api/upload"))
        self.assertIn("at most 600 MB", self.told(f"Content-Length: {(600 << 20) + 1}", "/api/upload"))
        self.assertIn("Content-Length", self.told("Transfer-Encoding: chunked", "/api/upload"))
        for other in ("/api/upload/", "/api/uploads", "/", "/api/people?x=/api/upload"):
            self.assertIn("at most 128 KB", self.told(length, other), other)

    def test_the_web_server_takes_what_the_page_takes_and_refuses_what_it_refuses(self):
        for size, good in ((128 << 10, True), ((128 << 10) + 1, False)):
            body = json.dumps({"name": "x", "role": "desk", "passphrase": ""}).ljust(size)
            status, _, said = self.ask("POST", "/api/people", body, Origin=f"https://{self.at}", Cookie=self.cookie,
                                       Content_Type="application/json")
            self.assertEqual(status, 409 if good else 413, said)
            self.assertIn("too short" if good else "too large", json.loads(said)["what"])

    def test_slow_clients_keep_nobody_waiting_and_take_no_more_than_their_share(self):
        slow = []
        try:
            for n in range(60):
                raw = socket.create_connection((STAFF, self.port), 5, source_address=(EVE, 0))
                slow.append(self.tls().wrap_socket(raw, server_hostname=STAFF))
                head = f"POST /api/enter HTTP/1.1\r\nHost: {self.at}\r\nContent-Length: 500\r\n"
                slow[-1].sendall((head + ("\r\n{" if n % 2 else "")).encode())
            time.sleep(0.3)
            begin = time.monotonic()
            self.assertEqual(self.ask("GET", "/api/door")[0], 200)
            self.assertLess(time.monotonic() - begin, 1.0)
        finally:
            for link in slow:
                link.close()

    def test_the_socket_is_for_the_proxys_group_alone(self):
        self.assertEqual(self.socket.stat().st_mode & 0o7777, 0o660)
        self.assertEqual(self.socket.parent.stat().st_mode & 0o7777, 0o750)
        if os.getuid() != 0:
            self.skipTest("only root can become another user")
        reach = f"import socket; socket.socket(socket.AF_UNIX).connect({str(self.socket)!r})"
        other = subprocess.run(["setpriv", f"--reuid={OTHER_USER}", f"--regid={OTHER_USER}", "--clear-groups", "python3", "-c",
                                reach], capture_output=True, text=True, check=False)
        self.assertIn("PermissionError", other.stderr)

    def test_the_consoles_state_is_its_own_though_root_gives_codes(self):
        self.give_code()
        for file in [self.state, *self.state.iterdir()]:
            self.assertEqual(file.stat().st_uid, number("onggi-console", os.getuid()), file)
        self.assertEqual(self.state.stat().st_mode & 0o7777, 0o700)

    def test_root_and_the_page_change_the_exhibit_by_turns(self):
        exhibit = self.machine / "srv/onggi/config/exhibit.toml"
        page = as_unit("onggi-console.service")
        for words, value in (([], 91), (page, 92), ([], 93), (page, 94)):
            done = subprocess.run([*words, ARGUMENTS.onggi, "set", str(exhibit), "idle.warn_after", str(value)],
                                  capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, f"{value}: {done.stdout}{done.stderr}")
            self.assertIn(f"warn_after = {value}", exhibit.read_text())
        if page:  # the phone's user, and the kiosk's
            for unit in ("onggi-phone.service", "onggi.service"):
                refused = subprocess.run([*as_unit(unit), ARGUMENTS.onggi, "set", str(exhibit), "idle.warn_after", "95"],
                                         capture_output=True, text=True, check=False)
                self.assertNotEqual(refused.returncode, 0, unit)
            self.assertIn("warn_after = 94", exhibit.read_text())

    def draw(self, screen):
        status, _, said = self.change("/api/screen", {"screen": screen, "file": "exhibit", "changes": [["idle.warn_after", 77]]})
        self.assertEqual(status, 202, said)
        return json.loads(said)["number"]

    def test_a_screen_is_drawn_by_another_user_and_ends_when_nobody_wants_it(self):
        number_ = self.draw("language")
        end = time.monotonic() + 300
        while (drawn := json.loads(self.ask("GET", f"/api/screen?number={number_}", Cookie=self.cookie)[2]))["drawing"]:
            self.assertLess(time.monotonic(), end)
            time.sleep(0.2)
        self.assertEqual(drawn["what"], "")
        self.assertEqual([one["width"] for one in drawn["pictures"]], [1280, 1080])
        self.draw("keepsake")
        end = time.monotonic() + 20
        while len(self.screens.processes) < 2:
            self.assertLess(time.monotonic(), end)
            time.sleep(0.05)
        process = self.screens.processes[-1]
        if os.getuid() == 0:  # a moment after its start
            while f"\nUid:\t{NUMBERS['onggi-screen']}\t" not in pathlib.Path(f"/proc/{process.pid}/status").read_text():
                self.assertLess(time.monotonic(), end, "another user draws")
                time.sleep(0.01)
        status, _, _ = self.change("/api/screen/stop", {})
        self.assertEqual(status, 200)
        process.wait(timeout=6)  # a keepsake takes twice as long at least

    def test_a_page_that_does_not_run_is_told_and_comes_back(self):
        self.console.terminate()
        self.console.wait()
        self.console.stdout.close()
        self.assertFalse(self.socket.exists())
        status, _, said = self.ask("GET", "/")
        self.assertEqual(status, 502)
        self.assertIn("systemctl restart onggi-console", json.loads(said)["remedy"])
        self.start_console()
        self.assertEqual(self.ask("GET", "/")[0], 401)
        # Sessions end with the program.
        type(self).cookie = self.ask("GET", "/?code=" + self.give_code())[1]["Set-Cookie"].split(";")[0]


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--onggi", required=True)
    parser.add_argument("--console", required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    for name, found in (("nginx", NGINX), ("openssl", OPENSSL)):
        if not found:
            print(f"skipped: there is no {name} here (tests/packages.txt)")
            sys.exit(77)
    unittest.main(argv=[sys.argv[0], *rest])
