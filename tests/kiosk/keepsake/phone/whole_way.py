#!/usr/bin/env python3
"""A visitor's whole way with the real programs, and what is left of it: onggi-console answers, a scripted visitor throws a
pot and keeps it, a kiosk goes on beside it (its gallery reads the folder, its store counts), the page is opened and the
keepsake deleted, and another one's page expires. Takes about a minute, and needs Xvfb.

usage: python3 -B tests/kiosk/keepsake/phone/whole_way.py [--programs build/release/bin] [--display :420]
"""
import argparse
import os
import pathlib
import re
import shutil
import socket
import sqlite3
import subprocess
import sys
import tempfile
import time
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[4]
MINUTE = 60.0


def get(port, target, method="GET"):
    with socket.create_connection(("127.0.0.1", port), 10) as phone:
        phone.sendall(f"{method} {target} HTTP/1.1\r\nHost: kiosk\r\nAccept-Language: ko\r\n\r\n".encode())
        heard = b""
        while more := phone.recv(1 << 20):
            heard += more
    head, _, body = heard.partition(b"\r\n\r\n")
    return int(head.split()[1]), body


def within(seconds, what, done):
    begun = time.monotonic()
    while not done():
        if time.monotonic() - begun > seconds:
            sys.exit(f"FAILED: not within {seconds:.0f} s: {what}")
        time.sleep(0.1)
    took = time.monotonic() - begun
    print(f"{what}: after {took:.1f} s")
    return took


def sure(good, what):
    if not good:
        sys.exit(f"FAILED: {what}")
    print(what)


def holders(name):
    """Whatever names it: files and folders below the keepsakes and the system's own folder for what is passing, and what
    running programs have open or mapped, removed or not."""
    found = [str(p) for root in (KEPT, pathlib.Path(tempfile.gettempdir()), pathlib.Path("/dev/shm"))
             for p in root.rglob("*" + name + "*")]
    for process in PROCESSES:
        for link in pathlib.Path(f"/proc/{process.pid}/fd").iterdir():
            try:
                found += [f"{process.args[0]} holds {to}" for to in [os.readlink(link)] if name in to]
            except FileNotFoundError:
                pass
        found += [f"{process.args[0]} maps {line.split()[-1]}" for line in
                  pathlib.Path(f"/proc/{process.pid}/maps").read_text().splitlines() if name in line]
    return found


def texts_with(word):
    """Files below the keepsakes that hold `word`."""
    return [str(p) for p in KEPT.rglob("*") if p.is_file() and word.encode() in p.read_bytes()]


parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--programs", default=ROOT / "build/release/bin", type=pathlib.Path)
parser.add_argument("--display", default=":420")
arguments = parser.parse_args()
PROGRAMS, WORK = arguments.programs.resolve(), pathlib.Path(tempfile.mkdtemp(prefix="onggi-whole-", dir=ROOT / "build"))
KEPT, PROCESSES = WORK / "keepsakes", []
KEPT.mkdir()


def begin(*words, **kept):
    process = subprocess.Popen([str(w) for w in words], **kept)
    PROCESSES.append(process)
    return process


def visit(language):
    """A scripted visitor's keepsake; its folder and the token of its page."""
    before = set(KEPT.iterdir())
    subprocess.run([PROGRAMS / "onggi", "visit", "--script", "follow", "--vessel", "moon_jar", "--language", language, "--window", "640x480",
                    "--config", CONFIG, "--out", KEPT], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    # The command's own report of the scripted visitor, which no museum has.
    (KEPT / "visit.json").unlink()
    shutil.rmtree(KEPT / "screens")
    made = [p for p in KEPT.iterdir() if p not in before and re.match(r"\d{4}-\d\d-\d\d_\d{6}_", p.name)]
    token = [p.name for p in (KEPT / "phone").iterdir() if p.is_file() and made[0].name in p.read_text(errors="ignore")]
    return made[0], token[0]


try:
    # The exhibit that comes, with phones and all of its languages.
    shutil.copytree(ROOT / "config", WORK / "config")
    (WORK / "content").symlink_to(ROOT / "content")
    CONFIG = WORK / "config/exhibit.toml"
    console = begin(PROGRAMS / "onggi-console", "--phone-only", "--keepsakes", KEPT, "--listen", "127.0.0.1:0",
                    stdout=subprocess.PIPE, text=True)
    port = int(re.search(r"port (\d+)", console.stdout.readline())[1])
    text = re.sub(r"^folder = .*keepsakes.*$", f'folder = "{KEPT}"', CONFIG.read_text(), flags=re.M)
    if "[phone]" in text:
        text = re.sub(r"^address = .*$", f'address = "http://127.0.0.1:{port}"', text, flags=re.M)
    else:
        text += f'\n[phone]\naddress = "http://127.0.0.1:{port}"\n'
    CONFIG.write_text(text)
    sure(tomllib.loads(text)["phone"]["address"].endswith(str(port)), "the exhibit names the page's address")

    begin("Xvfb", arguments.display, "-screen", "0", "1280x720x24", stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    within(10, "a display is there", pathlib.Path(f"/tmp/.X11-unix/X{arguments.display[1:]}").exists)
    folder, token = visit("ko")
    kiosk = begin(PROGRAMS / "onggi", "run", "--config", CONFIG, "--window", "1280x720", stdout=subprocess.DEVNULL,
                  stderr=open(WORK / "log", "w", encoding="utf-8"), env={**os.environ, "DISPLAY": arguments.display})
    store = KEPT / "onggi.sqlite"
    within(MINUTE, "the kiosk is open and has its store", lambda: (KEPT / "onggi.sqlite-wal").exists())
    sure((folder / "postcard.jpg").stat().st_size > 50_000, "a visitor's keepsake is there")

    status, page = get(port, "/k/" + token)
    sure(status == 200 and b'<html lang="ko"' in page, "the page opens, in the visit's language")
    for file in ("postcard.jpg", "turning.gif", "pot.glb"):
        status, body = get(port, f"/k/{token}/{file}")
        sure(status == 200 and body == (folder / file).read_bytes(), f"{file} is whole")
    subprocess.run([PROGRAMS / "onggi-console", "--stl", folder, "--to", WORK / "desk.stl"], check=True, capture_output=True)
    for over in ("pot.glb", "postcard.jpg"):
        was = (folder / over).read_bytes()
        tried = subprocess.run([PROGRAMS / "onggi-console", "--stl", folder, "--to", folder / over], capture_output=True, text=True)
        sure(tried.returncode == 2 and (folder / over).read_bytes() == was, f"no STL is written over {over}: {tried.stderr}")
    status, body = get(port, f"/k/{token}/pot.stl")
    sure(status == 200 and body == (WORK / "desk.stl").read_bytes(), "the pot for a printer is what the desk would print")

    def counted():
        with tempfile.TemporaryDirectory() as copies:
            for file in KEPT.glob("onggi.sqlite*"):
                shutil.copy(file, copies)
            return sqlite3.connect(pathlib.Path(copies) / "onggi.sqlite").execute("SELECT count(*) FROM fetches").fetchone()[0]

    within(1.5 * MINUTE, "the kiosk has counted that a phone fetched it", lambda: counted() == 1)

    time.sleep(3)  # the gallery has it by now
    status, body = get(port, f"/k/{token}/delete", "POST")
    sure(status == 200 and "지웠습니다" in body.decode(), "it is deleted")
    within(MINUTE, "no file, folder, open file or map of it is left", lambda: not holders(folder.name))
    named = texts_with(folder.name) + texts_with(token)
    sure(not named, "and no file below the keepsakes names it or its token " + ", ".join(named))
    sure(get(port, "/k/" + token)[0] == 404, "its page says what every wrong one says")
    sure(kiosk.poll() is None and console.poll() is None, "kiosk and console go on")

    other = visit("en")[0]
    short = subprocess.run([PROGRAMS / "onggi-console", "--pass", other, "--hours", "0.001"], check=True, capture_output=True,
                           text=True).stdout.strip()
    sure(get(port, short)[0] == 200, "another page opens")
    within(10, "and expires after its 3.6 s", lambda: get(port, short)[0] == 404)
    within(1.5 * MINUTE, "its pass is removed at the next look", lambda: not (KEPT / "phone" / short[3:]).exists())
    sure(other.is_dir(), "the keepsake stays for the museum's days")
    print("Good")
finally:
    for process in reversed(PROCESSES):
        process.terminate()
    for process in PROCESSES:
        try:
            process.wait(20)
        except subprocess.TimeoutExpired:
            process.kill()
    shutil.rmtree(WORK, ignore_errors=True)
