"""axe-core, which looks for what keeps people out of a page (WCAG 2.2, A and AA). Debian has no package of it, so one version is
fetched once from npm's registry, held against its digest, and kept in the user's cache. Tests alone use it.
"""
import hashlib
import io
import os
import pathlib
import tarfile
import urllib.error
import urllib.request

VERSION = "4.10.3"
DIGEST = ("5e6edba515e70d25f6604d9815f064d859c5d1ea7ab661bbc4f87c88779ef0c2"
          "1cae0abbeb636471ef39e9d62d2582e4b88a1866f19f4ecfcf6d986275e4dc12")  # SHA-512 of the archive
ADDRESS = f"https://registry.npmjs.org/axe-core/-/axe-core-{VERSION}.tgz"
TAGS = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"]


def source():
    """Its script; None where it is not kept and cannot be fetched."""
    cache = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") / "onggi"
    kept = cache / f"axe-core-{VERSION}.tgz"
    try:
        archive = kept.read_bytes()
    except OSError:
        try:
            with urllib.request.urlopen(ADDRESS, timeout=20) as answer:
                archive = answer.read()
        except (OSError, urllib.error.URLError):
            return None
        if hashlib.sha512(archive).hexdigest() == DIGEST:
            cache.mkdir(parents=True, exist_ok=True)
            kept.write_bytes(archive)
    if hashlib.sha512(archive).hexdigest() != DIGEST:
        raise ValueError(f"{ADDRESS} is not what it was: delete {kept}, and look at who answers")
    with tarfile.open(fileobj=io.BytesIO(archive)) as files:
        return files.extractfile("package/axe.min.js").read().decode()


def faults(page, script):
    """What it finds in `page`: [rule: element, what]. Put in by the browser's protocol, so the page's own policy stays."""
    if not page.value("typeof axe === 'object'"):
        page.say("Runtime.evaluate", expression=script + ";0")
    found = page.value("axe.run(document, {runOnly: %s, resultTypes: ['violations']}).then(({violations}) => violations.flatMap("
                       "({id, nodes}) => nodes.map(({target, any, all, none}) => `${id}: ${target.join(' ')}: "
                       "${[...any, ...all, ...none].map(({message}) => message).join('; ')}`)))" % TAGS)
    return found
