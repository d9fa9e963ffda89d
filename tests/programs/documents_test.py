"""What the documents say of the code is so.

    python3 tests/programs/documents_test.py .
"""

import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(sys.argv.pop(1))


def read(name):
    return (ROOT / name).read_text()


class DocumentsTest(unittest.TestCase):
    def test_the_readme_s_program_is_the_example(self):
        block = re.search(r"```cpp\n(.*?)```", read("README.md"), re.S).group(1)
        example = read("examples/first_crack.cpp")
        self.assertIn(block, example)

    def test_the_version_is_the_same_everywhere(self):
        version = re.search(r"project\(hfdem VERSION (\S+)", read("CMakeLists.txt")).group(1)
        self.assertIn(f'version = "{version}"', read("include/hfdem/base/version.hpp"))
        self.assertIn(f"version: {version}\n", read("CITATION.cff"))
        self.assertIn(f"## {version}", read("CHANGELOG.md"))

    def test_links_to_files_lead_somewhere(self):
        for document in ["README.md", "CONTRIBUTING.md", "examples/host_code/README.md",
                         *map(str, ROOT.glob("docs/**/*.md"))]:
            folder = (ROOT / document).parent
            prose = re.sub(r"```.*?```", "", read(document), flags=re.S)
            for target in re.findall(r"\]\(([^)#:]+)\)", prose):
                self.assertTrue((folder / target).exists(), f"{document}: {target}")


if __name__ == "__main__":
    unittest.main()
