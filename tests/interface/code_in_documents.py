"""Code and output in the documents for programmers are those of programs that the tests run.

    python3 tests/interface/code_in_documents.py .

Every block of C++ is followed by "(from [file](path))", in which it stands word for word; every
block of output by "(printed by [program](path))", whose header promises it.
"""

import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(sys.argv.pop(1))
DOCUMENTS = [ROOT / "docs/own_law.md", *sorted(ROOT.glob("docs/concepts/*.md"))]
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```\n", re.S | re.M)
SOURCE = re.compile(r"\A\n?\((from|printed by) \[[^\]]*\]\(([^)]+)\)", re.S)


class CodeInDocumentsTest(unittest.TestCase):
    def blocks(self, language):
        for document in DOCUMENTS:
            text = document.read_text()
            for block in BLOCK.finditer(text):
                if block[1] == language:
                    source = SOURCE.match(text[block.end():])
                    yield document, block[2], source

    def test_every_document_has_code(self):
        self.assertEqual(len(DOCUMENTS), 8)
        self.assertEqual({d for d, _, _ in self.blocks("cpp")}, set(DOCUMENTS))

    def test_code_stands_in_the_file_that_is_named(self):
        for document, code, source in self.blocks("cpp"):
            with self.subTest(document.name, code=code):
                self.assertTrue(source, "it does not say where it is from")
                self.assertIn(code, (document.parent / source[2]).read_text())

    def test_output_stands_in_the_header_of_its_program(self):
        outputs = [(d, o, s) for d, o, s in self.blocks("text") if s and s[1] == "printed by"]
        self.assertTrue(outputs)
        for document, output, source in outputs:
            header = (document.parent / source[2]).read_text().split("#include")[0]
            for line in output.splitlines():
                self.assertIn(f"//   {line}\n", header)


if __name__ == "__main__":
    unittest.main()
