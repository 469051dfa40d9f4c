"""How long a change takes to be checked as it is typed on the staff's page, asked as a browser asks: 500 changes of one
exhibit, 500 of a label, 500 of a scene, and 500 of five words of a language.

usage: staff_checks.py --console build/release/bin/onggi-console [--seed 46]
"""
import argparse
import json
import pathlib
import random
import re
import shutil
import subprocess
import tempfile
import time
import urllib.request

ROOT = pathlib.Path(__file__).resolve().parents[2]
COUNT = 500


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--console", required=True)
    parser.add_argument("--seed", type=int, default=46)
    arguments = parser.parse_args()
    chance = random.Random(arguments.seed)
    with tempfile.TemporaryDirectory() as folder:
        for name in ("config", "content"):
            shutil.copytree(ROOT / name, pathlib.Path(folder) / name)
        console = subprocess.Popen([arguments.console, "--site", folder, "--state", folder + "/state", "--listen", "127.0.0.1:0"],
                                   stdout=subprocess.PIPE, text=True)
        try:
            said = console.stdout.readline() + console.stdout.readline()
            way_in = re.search(r"http://\S+", said)[0]
            at = way_in[:way_in.index("/?")]
            browser = urllib.request.build_opener(urllib.request.HTTPCookieProcessor())
            browser.open(way_in).read()

            def took(name, change):
                body = json.dumps({"changes": change}).encode()
                ask = urllib.request.Request(f"{at}/api/edit/{name}/check", body, {"Content-Type": "application/json", "Origin": at})
                began = time.perf_counter()
                browser.open(ask).read()
                return 1000 * (time.perf_counter() - began)

            words = "a round white jar of porcelain ".split()
            kinds = {
                "the exhibit": lambda: took("exhibit", [["idle.warn_after", chance.randint(0, 4000)],
                                                        ["credit", " ".join(chance.choices(words, k=8))]]),
                "a label": lambda: took("vessel/moon_jar", [["label.ko.text", " ".join(chance.choices(words, k=chance.randint(1, 200)))]]),
                "a scene": lambda: took("scene/master", [["clay.rows", chance.randint(1, 900)], ["slump", {}], ["wobble", None]]),
                "words": lambda: took("language/ko", [[f"text.attract.{key}", " ".join(chance.choices(words, k=8))]
                                                      for key in ("title", "lead", "begin", "centre", "collapse")]),
            }
            print("checks of       p50 ms  p95 ms  most ms")
            for name, one in kinds.items():
                times = sorted(one() for _ in range(COUNT))
                print(f"{name:14} {times[COUNT // 2]:7.1f} {times[COUNT * 95 // 100]:7.1f} {times[-1]:8.1f}")
        finally:
            console.terminate()
            console.wait()


if __name__ == "__main__":
    main()
