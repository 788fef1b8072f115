#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares two folders of outputs: compare_outputs.py OLD_FOLDER NEW_FOLDER [NEW_KEYS]

Keys, codes, exit codes, numbers, file names and pictures must be equal. Words for people may differ; each changed
text is listed once, as old -> new, with the files that contain it. The rules by kind of file:

  .json           keys and their order, numbers as written, true, false, null, codes and units are equal; strings of
                  words are texts, and strings of several lines are scenarios
  .yaml           keys and values are equal; comments are texts, as are values that are words
  .csv            headers, numbers and codes are equal; cells that are words are texts; lines that begin with # are
                  scenarios
  .svg            equal but for what the text elements contain, which are texts
  .png            the pixels are equal
  .pdf            rendered pages are equal, or else the text in them is a text
  .html           tags are equal; what is between them is a text; pictures and JSON in it by their own rules
  .lines.txt      the lines are texts, in any order
  _command.txt    the first line, a command, is equal; the scenario below it by the rule for .yaml
  .exit           an exit code: equal
  completions     (.bash, .fish, _drillwave) the options and the quoted words are equal; the rest is a text
  other files     texts: the words may differ; the numbers and the names that a list explains are equal

In a text the numbers must be the same, in the same order. A decimal comma or the minus sign U+2212 belongs to its
number. A PNG or PDF whose SVG of the same name differs only in words is listed as text in a picture.

Not compared: versions, run times and the folders' own paths; in files with "accuracy" or "stability" in their names
also the columns of times; of "accuracy" what a picture, and the rest of a line behind a time, contain; lines on
standard error that say how far the work is. NEW_KEYS, as in peak_tension,gap, may be in JSON of the new folder only.

Exit code: 0 no difference, 3 only texts differ, 1 something that must be equal differs, 2 the folders cannot be
compared.
"""
import base64
import csv
import difflib
import html
import io
import json
import os
import re
import shutil
import signal
import subprocess
import sys

sys.dont_write_bytecode = True  # next to the sources
from output_parts import (Pairs, Written, brief, changes, is_wording, numbers_in, output_of, pixels,
                          split_comments)

MOST_LISTED = 60
LISTED_NAME = re.compile(r'^ +(--?[a-z][\w-]*|[a-z]\w*(?:[._][a-z]\w*)+)(?=\s|$)', re.M)
COMPLETED = re.compile(r"(?<![\w-])--?[a-z][\w-]*|'[^' \n]+'")
DATA = re.compile(r'data:image/svg\+xml;base64,([A-Za-z0-9+/=]+)')
TIME = r'[\d.,]+(?:e-?\d+)?\s?(?:ns|[\u00b5\u03bc]s|us|ms|s|min)\b'
TIMED = {'median_s', 'min_s', 'runs', 'speed', 'seconds'}  # in files of accuracy and stability
TIMED_FILE = re.compile('accuracy|stability')
RUN_TIME = 'run_time'


class Comparison:
    def __init__(self, old, new, added=()):
        self.roots, self.added = (old, new), set(added)
        self.failures, self.texts, self.files = [], {}, 0

    def fail(self, where, what):
        self.failures.append(f'{where}: {what}')

    def equal(self, where, old, new):
        if old != new:
            self.fail(where, f'{brief(old)} -> {brief(new)}')

    def equal_lists(self, where, old, new):
        for before, after in changes(old, new):
            return self.fail(where, f'{brief(" ".join(before))} -> {brief(" ".join(after))}')

    def text(self, where, old, new):
        """Words may differ; numbers, and names that a list explains, may not."""
        old, new = self.plain(where, old), self.plain(where, new)
        if old == new:
            return
        self.equal_lists(where + ' numbers', numbers_in(old), numbers_in(new))
        self.equal_lists(where + ' names', LISTED_NAME.findall(old), LISTED_NAME.findall(new))
        for before, after in changes(old.split('\n'), new.split('\n')):
            change = '\n'.join(before).strip(), '\n'.join(after).strip()
            self.texts.setdefault(change, {})[where.split(' ')[0]] = True

    def plain(self, where, text):
        """Without what no two builds, or runs, have in common."""
        text = re.sub(r'((?:Drillwave|drillwave|"?version"?:?) "?)\d+\.\d+(?:\.\d+)*(?:\+[\w.]+)?',
                      r'\1VERSION', text)
        text = re.sub(r'(record_crc32: ")\w+', r'\1CHECKSUM', text)  # of a record with the version
        text = re.sub(rf'((?: in| på| ·) ){TIME}(?=\.?$| · )', r'\1TIME', text, flags=re.M)
        for root in self.roots:
            text = text.replace(os.path.abspath(root), 'FOLDER')
        if 'accuracy' in where:
            text = re.sub(' +', ' ', re.sub(rf'{TIME}.*$', 'TIME', text, flags=re.M))
        if 'stability' in where:
            text = re.sub(r'^( *\w*(?:sec|sek|time|zeit|tid)\w*) +\d.*$', r'\1 TIME', text, flags=re.M | re.I)
        if where.endswith('.err.txt'):
            text = re.sub(r'^\d+ % \S.*/s\b.*\n?', '', text, flags=re.M)  # how far the work is
        if where.endswith('.1'):
            text = re.sub(r'(?m)^\.TH (\S+ \d).*$', r'.TH \1', text)
        return text

    def json(self, where, old, new):
        try:
            self.value(where + ' ', *(json.loads(each, object_pairs_hook=Pairs, parse_int=Written,
                                                 parse_float=Written) for each in (old, new)))
        except ValueError:
            self.text(where, old, new)

    def value(self, where, old, new):
        if isinstance(old, Pairs) and isinstance(new, Pairs):
            leave = TIMED if TIMED_FILE.search(where.split(' ')[0]) else ()
            old, new = ([each for each in side if each[0] not in leave and not each[0].startswith(RUN_TIME)
                         and each[0] != 'version'] for side in (old, new))
            known = {key for key, _ in old}
            new = [each for each in new if each[0] in known or each[0] not in self.added]
            self.equal_lists(where + ' keys', [key for key, _ in old], [key for key, _ in new])
            for (key, before), (other, after) in zip(old, new):
                if key == other:
                    self.value(f'{where}/{key}', before, after)
        elif type(old) is list and type(new) is list:
            if len(old) != len(new):
                self.fail(where, f'{len(old)} -> {len(new)} elements')
            for number, (before, after) in enumerate(zip(old, new)):
                self.value(f'{where}/{number}', before, after)
        elif type(old) is str and type(new) is str and '\n' in old:
            self.yaml(where, old, new)
        elif type(old) is str and type(new) is str and is_wording(old) and is_wording(new):
            self.text(where, old, new)
        elif type(old) is not type(new) or old != new:
            self.equal(where, old, new)

    def yaml(self, where, old, new):
        (old, old_comments), (new, new_comments) = (split_comments(self.plain(where, each)) for each in (old, new))
        for before, after in changes(old, new):
            keys = [[key for key, _ in side] for side in (before, after)]
            if keys[0] == keys[1] and all(is_wording(value) for _, value in before + after):
                for (_, a), (_, b) in zip(before, after):
                    self.text(where, a, b)
            elif not keys[0] == keys[1] == [RUN_TIME]:
                self.fail(where, ' -> '.join(brief(', '.join(map(': '.join, side))) for side in (before, after)))
        self.text(where, old_comments, new_comments)

    def csv(self, where, old, new):
        rows, comments = [], []
        for each in (old, new):
            lines = each.splitlines(True)
            comments.append(''.join(re.sub('^# ?', '', line) for line in lines if line.startswith('#')))
            rows.append(list(csv.reader(line for line in lines if not line.startswith('#'))))
        self.yaml(where, *comments)
        if len(rows[0]) != len(rows[1]):
            self.fail(where, f'{len(rows[0])} -> {len(rows[1])} rows')
        names = rows[0][0] if rows[0] else []
        for number, (before, after) in enumerate(zip(*rows), 1):
            if len(before) != len(after):
                self.fail(f'{where} row {number}', f'{len(before)} -> {len(after)} cells')
            for name, a, b in zip(names, before, after):
                if a == b or (number > 1 and name in TIMED and TIMED_FILE.search(where)):
                    continue
                if number > 1 and is_wording(a) and is_wording(b):
                    self.text(where, a, b)
                else:
                    self.equal(f'{where} row {number} {name}', a, b)

    def svg(self, where, old, new):
        element = re.compile(r'(<(?:text|title)\b[^>]*>)(.*?)(?=</(?:text|title)>)', re.S)
        shapes = [element.sub(r'\1', each).split('\n') for each in (old, new)]
        words = [[html.unescape(re.sub('<[^>]*>', '', each)).strip() for _, each in element.findall(side)]
                 for side in (old, new)]
        if 'accuracy' in where:  # its points are at measured times
            return self.lines(where, *('\n'.join(each for each in side if not numbers_in(each)) for side in words))
        self.equal_lists(where + ' shapes', *shapes)
        for before, after in zip(*words):
            self.text(where, before, after)

    def html(self, where, old, new):
        old, new = (re.split(r'(<(?:[^>"]|"[^"]*")*>)', self.plain(where, each)) for each in (old, new))
        attribute = re.compile(r'\b(title|alt|content)="([^"]*)"')
        self.equal_lists(where + ' tags', *([attribute.sub(r'\1', DATA.sub('DATA', tag)) for tag in side[1::2]]
                                            for side in (old, new)))
        for number, (before, after) in enumerate(zip(old, new)):
            if before == after:
                continue
            if number % 2 == 0:
                (self.json if before.lstrip().startswith('{') else self.text)(where, before, after)
                continue
            for pictures in zip(DATA.findall(before), DATA.findall(after)):
                self.svg(where + ' picture', *(base64.b64decode(each).decode() for each in pictures))
            for (_, a), (_, b) in zip(attribute.findall(before), attribute.findall(after)):
                self.text(where, a, b)

    def completions(self, where, old, new):
        self.equal_lists(where, COMPLETED.findall(old), COMPLETED.findall(new))
        self.text(where, old, new)

    def lines(self, where, old, new):
        """Lines without an equal one are compared with the most similar one that has the same numbers."""
        old, new = (self.plain(where, each).split('\n') for each in (old, new))
        for line in list(old):
            if line in new:
                old.remove(line)
                new.remove(line)
        for line in old:
            likely = [each for each in new if numbers_in(each) == numbers_in(line)] or new[:1] or ['']
            best = max(likely, key=lambda each: difflib.SequenceMatcher(None, line, each).ratio())
            if best in new:
                new.remove(best)
            self.text(where, line, best)
        for line in new:
            self.text(where, '', line)

    def command(self, where, old, new):
        (first, _, old), (second, _, new) = old.partition('\n'), new.partition('\n')
        self.equal(where, first, second)
        self.yaml(where, old, new)

    def png(self, where, old, new):
        if 'accuracy' not in where and pixels(old) != pixels(new):
            self.picture(where, 'pixels differ')

    def pdf(self, where, old, new):
        if 'accuracy' in where:
            return
        words = [output_of(['pdftotext', '-layout', '-', '-'], each).decode() for each in (old, new)]
        has_twin = os.path.isfile(os.path.join(self.roots[0], os.path.splitext(where)[0] + '.svg'))
        if words[0] != words[1] and not has_twin:
            self.text(where, *words)
        elif words[0] != words[1] or (shutil.which('pdftoppm') and len(
                {output_of(['pdftoppm', '-r', '60', '-'], each) for each in (old, new)}) > 1):
            self.picture(where, 'rendered pages differ')

    def picture(self, where, what):
        """Words that differ are excused where the SVG of the same name differs only in them."""
        twins = [os.path.join(root, os.path.splitext(where)[0] + '.svg') for root in self.roots]
        if all(map(os.path.isfile, twins)):
            check = Comparison(*self.roots)
            check.svg(where, *(open(twin, encoding='utf-8').read() for twin in twins))
            if check.texts and not check.failures:
                self.texts.setdefault(('text in a picture: see the SVG of the same name', ''), {})[where] = True
                return
        self.fail(where, what)

    def file(self, where):
        old, new = (open(os.path.join(root, where), 'rb').read() for root in self.roots)
        if old == new:
            return
        rules = {'.json': self.json, '.yaml': self.yaml, '.csv': self.csv, '.svg': self.svg, '.html': self.html,
                 '.lines.txt': self.lines, '_command.txt': self.command, '.exit': self.equal, '.png': self.png,
                 '.pdf': self.pdf, '.bash': self.completions, '.fish': self.completions, '_drillwave': self.completions}
        rule = next((rule for ending, rule in rules.items() if where.endswith(ending)), self.text)
        if rule not in (self.png, self.pdf):
            old, new = (each.decode('utf-8', errors='replace') for each in (old, new))
        rule(where, old, new)

    def folders(self):
        names = [{os.path.relpath(os.path.join(folder, name), root) for folder, _, files in os.walk(root)
                  for name in files} for root in self.roots]
        for where in sorted(names[0] ^ names[1]):
            self.fail(where, 'only in the ' + ('old' if where in names[0] else 'new') + ' folder')
        for where in sorted(names[0] & names[1]):
            self.file(where)
        return len(names[0] & names[1])


def main(arguments):
    if len(arguments) not in (2, 3) or not all(map(os.path.isdir, arguments[:2])):
        print(__doc__.strip(), file=sys.stderr)
        return 2
    comparison = Comparison(*arguments[:2], ''.join(arguments[2:]).split(','))
    try:
        files = comparison.folders()
    except (OSError, subprocess.CalledProcessError) as error:
        print(f'cannot be compared: {error}', file=sys.stderr)
        return 2
    if not files:
        print('cannot be compared: the folders have no file in common', file=sys.stderr)
        return 2
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # a reader may leave early
    for (old, new), where in comparison.texts.items():
        print(f'text, {len(where)} files: {", ".join(list(where)[:3])}\n  {old}\n  -> {new}')
    for failure in comparison.failures[:MOST_LISTED]:
        print('DIFFERS ' + failure)
    print(f'{files} files, {len(comparison.texts)} changed texts, '
          f'{len(comparison.failures)} differences in what must be equal')
    return 1 if comparison.failures else 3 if comparison.texts else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
