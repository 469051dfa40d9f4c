"""The kiosk's own access point, with a cable in place of the radio: the files that the package brings, a real dnsmasq,
nft and onggi-console in a network namespace, and a phone in another.

usage: access_point_test.py --console build/.../onggi-console
Skipped (77), by name, where no namespace can be made or a program is missing.
"""
import argparse
import ctypes
import os
import pathlib
import re
import shutil
import socket
import struct
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[4]
FILES = ROOT / "kiosk/program/package/access-point"
KIOSK, PHONE = f"onggi-kiosk-{os.getpid()}", f"onggi-phone-{os.getpid()}"
ADDRESS = "192.168.4.1"
SUCCESS = b"<HTML><HEAD><TITLE>Success</TITLE></HEAD><BODY>Success</BODY></HTML>"
ASKED = {("captive.apple.com", "/hotspot-detect.html"): (200, SUCCESS),
         ("connectivitycheck.gstatic.com", "/generate_204"): (204, b""),
         ("www.msftconnecttest.com", "/connecttest.txt"): (200, b"Microsoft Connect Test"),
         ("www.msftncsi.com", "/ncsi.txt"): (200, b"Microsoft NCSI"),
         ("detectportal.firefox.com", "/success.txt?ipv4"): (200, b"success\n"),
         ("network-test.debian.org", "/nm"): (200, b"NetworkManager is online\n")}


def why_not():
    """Why it cannot be tried here; None where it can."""
    missing = [name for name in ("ip", "dnsmasq", "nft") if shutil.which(name, path=PATH) is None]
    if missing:
        return "there is no " + ", ".join(missing)
    table = "add table inet onggi_trial { chain c { type nat hook prerouting priority dstnat; }; }"
    tried = subprocess.run(["unshare", "-n", "nft", table], capture_output=True, env={**os.environ, "PATH": PATH}, check=False)
    return None if tried.returncode == 0 else "no network namespace with nft's rules can be made"


PATH = os.environ["PATH"] + ":/usr/sbin:/sbin"


def say(*words, **kept):
    return subprocess.run(words, check=True, capture_output=True, text=True, env={**os.environ, "PATH": PATH}, **kept)


class AccessPointTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="onggi-point-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        visit = cls.folder / "kept/2026-05-04_141503_moon_jar"
        visit.mkdir(parents=True)
        (visit / "postcard.jpg").write_bytes(b"a postcard")
        for name in (KIOSK, PHONE):
            say("ip", "netns", "add", name)
            cls.addClassCleanup(say, "ip", "netns", "del", name)
            say("ip", "-n", name, "link", "set", "lo", "up")
        say("ip", "-n", KIOSK, "link", "add", "wlan0", "type", "veth", "peer", "name", "wlan0", "netns", PHONE)
        network = (FILES / "onggi-phones.network").read_text()
        say("ip", "-n", KIOSK, "address", "add", re.search(r"^Address=(.*)", network, re.M)[1], "dev", "wlan0")
        for name in (KIOSK, PHONE):
            say("ip", "-n", name, "link", "set", "wlan0", "up")
        say("ip", "netns", "exec", KIOSK, "nft", "-f", str(FILES / "nftables.conf"))
        leases = cls.folder / "leases"
        cls.begin("dnsmasq", "--keep-in-foreground", f"--conf-file={FILES / 'dnsmasq.conf'}", "--user=root", "--pid-file",
                  f"--dhcp-leasefile={leases}")
        cls.begin(ARGUMENTS.console, "--phone-only", "--keepsakes", str(cls.folder / "kept"), "--listen", "0.0.0.0:8080")
        cls.begin(sys.executable, "-m", "http.server", "8443")  # something else of the kiosk's
        cls.token = say(ARGUMENTS.console, "--pass", str(visit)).stdout.strip()
        # From here on this process is the phone.
        cls.own = os.open("/proc/self/ns/net", os.O_RDONLY)
        cls.addClassCleanup(os.close, cls.own)
        enter(f"/run/netns/{PHONE}")
        cls.addClassCleanup(enter, f"/proc/self/fd/{cls.own}")
        end = time.monotonic() + 10
        while not (cls.answers(53) and cls.answers(8080)):
            if time.monotonic() > end:
                raise TimeoutError("the access point does not come up")
            time.sleep(0.1)

    @classmethod
    def begin(cls, *words):
        process = subprocess.Popen(["ip", "netns", "exec", KIOSK, *words], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                   env={**os.environ, "PATH": PATH})
        cls.addClassCleanup(lambda: (process.terminate(), process.wait(10)))

    @classmethod
    def answers(cls, port):
        if "192.168.4.9" not in say("ip", "-4", "-o", "address", "show", "dev", "wlan0").stdout:
            say("ip", "address", "add", "192.168.4.9/24", "dev", "wlan0")
        try:
            socket.create_connection((ADDRESS, port), 1).close()
            return True
        except OSError:
            return False

    def get(self, host, target, port=80):
        with socket.create_connection((self.address_of(host), port), 5) as phone:
            phone.sendall(f"GET {target} HTTP/1.1\r\nHost: {host}\r\n\r\n".encode())
            heard = b""
            while more := phone.recv(65536):
                heard += more
        head, _, body = heard.partition(b"\r\n\r\n")
        return int(head.split()[1]), body

    @staticmethod
    def address_of(name):
        """What the access point's DNS says."""
        labels = b"".join(bytes([len(part)]) + part.encode() for part in name.split("."))
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as phone:
            phone.settimeout(5)
            phone.sendto(struct.pack(">6H", 7, 0x0100, 1, 0, 0, 0) + labels + b"\0" + struct.pack(">2H", 1, 1), (ADDRESS, 53))
            answer = phone.recv(512)
        return socket.inet_ntoa(answer[-4:])

    def test_a_phone_is_given_an_address(self):
        mac = bytes.fromhex(pathlib.Path("/sys/class/net/wlan0/address").read_text().strip().replace(":", "")) \
            if pathlib.Path("/sys/class/net/wlan0/address").exists() else b"\x02\0\0\0\0\7"
        ask = struct.pack(">4BI2H16x", 1, 1, 6, 0, 305, 0, 0x8000) + mac + bytes(10 + 192) + b"\x63\x82\x53\x63\x35\x01\x01\xff"
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as phone:
            phone.setsockopt(socket.SOL_SOCKET, socket.SO_BROADCAST, 1)
            phone.setsockopt(socket.SOL_SOCKET, socket.SO_BINDTODEVICE, b"wlan0")
            phone.bind(("", 68))
            phone.settimeout(10)
            phone.sendto(ask, ("255.255.255.255", 67))
            offer = phone.recv(1500)
        given = socket.inet_ntoa(offer[16:20])
        self.assertRegex(given, r"^192\.168\.4\.")
        self.assertTrue(10 <= int(given.split(".")[3]) <= 250, given)
        self.assertIn(b"\x03\x04" + socket.inet_aton(ADDRESS), offer, "the way out")
        self.assertIn(b"\x06\x04" + socket.inet_aton(ADDRESS), offer, "who knows names")

    def test_every_name_is_the_kiosks_but_the_one_that_windows_compares(self):
        for name in ("captive.apple.com", "example.org", "a.b.c.d"):
            self.assertEqual(self.address_of(name), ADDRESS)
        self.assertEqual(self.address_of("dns.msftncsi.com"), "131.107.255.255")

    def test_each_question_whether_the_network_is_good_is_answered_to_the_byte(self):
        for (host, target), wanted in ASKED.items():
            self.assertEqual(self.get(host, target), wanted, host)

    def test_the_page_opens_at_the_webs_own_port_as_the_code_has_it(self):
        status, body = self.get("onggi.example", self.token)
        self.assertEqual(status, 200)
        self.assertIn(b"postcard.jpg", body)
        self.assertEqual(self.get("onggi.example", self.token + "/postcard.jpg"), (200, b"a postcard"))
        self.assertEqual(self.get("onggi.example", "/")[0], 404)

    def test_https_and_all_else_of_the_kiosk_is_refused_at_once(self):
        # Something does listen there.
        say("ip", "netns", "exec", KIOSK, sys.executable, "-c",
            "import socket, time; time.sleep(0.3); socket.create_connection(('127.0.0.1', 8443), 5)")
        for port in (443, 22, 8443):
            begun = time.monotonic()
            with self.assertRaises(ConnectionRefusedError):
                socket.create_connection((ADDRESS, port), 5)
            self.assertLess(time.monotonic() - begun, 2.0, "a phone does not wait")


def enter(path):
    """This process goes into the network namespace at `path`."""
    with open(path, "rb") as there:
        if ctypes.CDLL(None, use_errno=True).setns(there.fileno(), 0x40000000) != 0:
            raise OSError(ctypes.get_errno(), "setns")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--console", required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    if reason := why_not():
        print(f"The access point is not tried: {reason}.")
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *rest])
