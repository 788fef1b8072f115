#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws texts of the program for a reader who has seen nothing else: sample_texts.py ROOT [SEED]

Prints 20 screens to look at, 20 help texts, 20 comments of public headers and 20 statements or alerts. The draw
depends only on SEED, by default the hash of the last commit, and on the texts. Screens are commands of the program
tests/ui/screenshots. `--check` draws from made-up seeds and checks that every list is full and without repeats.
"""
import pathlib
import random
import re
import subprocess
import sys
import xml.etree.ElementTree

COUNT = 20
SIZES = ('800x500', '1000x650', '1280x800', '1440x900')
STATEMENTS = re.compile(r'core/report/(alert|feed|sequence|strength|design|identify)_words\.cpp$')


def messages(root):
    """Yields context and text of every message of the German catalogue, which has all of them."""
    catalogue = xml.etree.ElementTree.parse(root / 'resources/languages/drillwave_de.ts')
    for context in catalogue.iter('context'):
        for message in context.iter('message'):
            yield context.findtext('name'), message.findtext('source')


def screens(root):
    headers = ''.join(header.read_text() for header in (root / 'ui/pages').rglob('*_page.h'))
    studies = ''.join(source.read_text() for source in (root / 'core/report').glob('*_answer.cpp'))
    titles = set(re.findall(r'title\(\) const override \{ return tr\("([^"]+)"\)', headers))
    titles |= set(re.findall(r'^ {8}\.title = translatable\("([^"]+)"\)', studies, re.MULTILINE)) | {'COR–stiffness'}
    return [f'screenshots --size {size} --language {language} FOLDER "{title}"'
            for title in sorted(titles) for size in SIZES for language in ('en', 'de', 'sv')]


def help_texts(root):
    return sorted({text for context, text in messages(root) if context == 'help' and ' ' in text})


def comments(root):
    """Returns comments that begin with /// in headers, each with the line that follows it."""
    found = []
    for room in ('core', 'ui', 'app'):
        for header in sorted((root / room).rglob('*.h')):
            text = header.read_text()
            for match in re.finditer(r'((?:^ *///(?!<).*\n)+)(.*)', text, re.MULTILINE):
                words = ' '.join(re.sub(r'^ */// ?', '', line) for line in match[1].splitlines())
                found.append(f'{header.relative_to(root)}: {words}\n      {match[2].strip()}')
    return found


def statements(root):
    found = set()
    for source in (root / 'core/report').glob('*.cpp'):
        if STATEMENTS.search(str(source)):
            for literals in re.findall(r'translatable\(\s*((?:"(?:[^"\\]|\\.)*"\s*)+)\)', source.read_text()):
                text = ''.join(re.findall(r'"((?:[^"\\]|\\.)*)"', literals))
                if text.endswith('.'):
                    found.add(text)
    return sorted(found)


def draw(root, seed):
    random_numbers = random.Random(seed)
    lists = {'Screens': screens(root), 'Help': help_texts(root), 'Comments': comments(root), 'Statements': statements(root)}
    return {title: random_numbers.sample(texts, COUNT) for title, texts in lists.items()}


def check(root):
    for seed in ('first', 'second'):
        for title, texts in draw(root, seed).items():
            assert len(set(texts)) == COUNT, title
    assert draw(root, 'first') == draw(root, 'first') != draw(root, 'second')


def main():
    arguments = [each for each in sys.argv[1:] if each != '--check']
    root = pathlib.Path(arguments[0])
    if '--check' in sys.argv:
        return check(root)
    last = ['git', '-C', str(root), 'rev-parse', 'HEAD']
    seed = arguments[1] if len(arguments) > 1 else subprocess.run(last, check=True, capture_output=True, text=True).stdout.strip()
    for title, texts in draw(root, seed).items():
        print(f'## {title}, drawn with {seed}')
        for number, text in enumerate(texts, 1):
            print(f'{number:4}  {text}')
        print()


if __name__ == '__main__':
    main()
