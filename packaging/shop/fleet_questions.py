#!/usr/bin/env python3
"""The SQL of the manual's page (shop.md), a question a line: fleet_questions.py [PAGE]"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))


def questions(page):
    """Indented blocks that begin with SELECT or WITH."""
    block = []
    with open(page, encoding="utf-8") as file:
        for line in [*file.read().split("\n"), ""]:
            if line.startswith("    "):
                block.append(line.strip())
                continue
            if block and block[0].split()[0] in ("SELECT", "WITH"):
                yield " ".join(block)
            block = []


if __name__ == "__main__":
    for question in questions(sys.argv[1] if sys.argv[1:] else os.path.join(HERE, "../../resources/manual/shop.md")):
        print(question)
