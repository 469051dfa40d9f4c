"""OpenGL ES 3.1, as small boards have it, draws what OpenGL 3.3 draws.

usage: embedded_test.py --program onggi_test_kiosk_picture_render [--every]     (--every: all pictures, not the telling ones)
"""

import argparse
import os
import subprocess
import sys
import tempfile

TELLING = "Gallery.AVase*:Gallery.EveryGlaze*:Gallery.ABowl*:Torn.TearsInAllSkins*:AHand.EveryToolAtTheWall:Decorated.ACoil*:Decorated.SlipThat*"
EVERY = "Gallery.*:KilnLook.*:Torn.*:AHand.*:AVessel.*:AFrame.*:APaintedPortrait.*:APortrait.*:Decorated.*"


def draw(program, pictures, **environment):
    """What the program said and its exit status; --gtest_fail_if_no_test_selected is not in every GoogleTest."""
    run = subprocess.run([program, "--gtest_filter=" + pictures], env={**os.environ, **environment},
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return run.stdout, run.returncode


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--every", action="store_true")
    arguments = parser.parse_args()
    pictures = EVERY if arguments.every else TELLING
    with tempfile.TemporaryDirectory() as folder:
        said, code = draw(arguments.program, pictures, ONGGI_GALLERY=folder)
        if code or not os.listdir(folder):
            print(said)
            print("OpenGL 3.3 drew nothing, so that there is nothing to compare with.")
            return 1 if code else 77
        # Mesa then offers OpenGL 3.1, which is too little, and OpenGL ES 3.1.
        said, code = draw(arguments.program, pictures, ONGGI_ALIKE=folder, MESA_GL_VERSION_OVERRIDE="3.1",
                          MESA_GLES_VERSION_OVERRIDE="3.1", ONGGI_EMBEDDED="1")
        alike = [line for line in said.splitlines() if ": apart by" in line]
        print("\n".join(alike) if not code else said)
        if len(alike) < len(os.listdir(folder)):
            print(f"{len(os.listdir(folder))} pictures were drawn by OpenGL 3.3 and {len(alike)} by OpenGL ES.")
            return 1
    return code


if __name__ == "__main__":
    sys.exit(main())
