"""Copy from node_modules into the theme what a page needs of KaTeX, and no file it does not fetch.

Every browser that runs KaTeX reads woff2, so the other two font formats are left behind and their
references are cut from the style sheet: the built site then links to no file that is not there.
"""

import re
import shutil
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SOURCE = ROOT / "node_modules" / "katex"
TARGET = ROOT / "armillary" / "site" / "theme" / "assets" / "katex"


def woff2_only(css: str) -> str:
    """The style sheet with the woff and truetype alternatives of each font removed."""
    return re.sub(r",url\([^)]+\) format\(\"(woff|truetype)\"\)", "", css)


def main() -> None:
    """Replace the theme's copy by the installed package's files."""
    css = woff2_only((SOURCE / "dist" / "katex.min.css").read_text("utf-8"))
    fonts = sorted(set(re.findall(r"url\(([^)]+)\)", css)))
    if not fonts or any(not re.fullmatch(r"fonts/[\w-]+\.woff2", font) for font in fonts):
        sys.exit("copy_katex: the style sheet names its fonts in a way this script does not know.")

    staging = TARGET.with_name("katex.new")
    shutil.rmtree(staging, ignore_errors=True)
    (staging / "fonts").mkdir(parents=True)
    (staging / "katex.min.css").write_text(css, "utf-8", newline="\n")
    for name in ("katex.min.js", *fonts):
        shutil.copyfile(SOURCE / "dist" / name, staging / name)
    shutil.copyfile(SOURCE / "LICENSE", staging / "LICENSE")
    shutil.rmtree(TARGET, ignore_errors=True)
    staging.rename(TARGET)


if __name__ == "__main__":
    main()
