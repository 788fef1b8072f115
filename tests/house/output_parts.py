# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers, words, keys and pixels in outputs of the program, for compare_outputs.py."""
import difflib
import re
import subprocess
import zlib

SIGNED = r'(?<![\w.])[-+]?\d+(?:[.,]\d+)*(?:[eE][-+]?\d+)?'
NUMBER = re.compile(SIGNED + r'|\d+(?:[.,]\d+)*(?:[eE][-+]?\d+)?|[⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+')


class Pairs(list):
    """A JSON object, in its order."""


class Written(str):
    """A JSON number, as it is written."""


def brief(value):
    text = str(value)
    return repr(text if len(text) < 160 else text[:80] + ' … ' + text[-70:])


def is_wording(text):
    """Words for people, not a code, a quantity or a structure."""
    return ' ' in text.strip() and re.search(r'[^\W\d_]{4,}', text) and not re.search('[{}]', text)


def numbers_in(text):
    return NUMBER.findall(text.replace('−', '-'))


def changes(old, new):
    """The unequal stretches of two lists."""
    for tag, a, b, c, d in difflib.SequenceMatcher(None, old, new, False).get_opcodes():
        if tag != 'equal':
            yield old[a:b], new[c:d]


def split_comments(text):
    """Keys with their values, and the comments, of a scenario."""
    code, comments = [], []
    for line in text.split('\n'):
        before, mark, comment = re.match(r'(.*?)((?:^|\s)#|$)(.*)', line).groups()
        if before.strip():
            key, _, value = before.rstrip().partition(': ') if ': ' in before else ('', '', before.rstrip())
            code.append((key, value))
        if mark:
            comments.append(comment.strip())
    return code, '\n'.join(comments)


def pixels(png):
    """Size, palette and colours, without the properties that a PNG file may have."""
    parts, at = {}, 8
    while at < len(png):
        size, kind = int.from_bytes(png[at:at + 4], 'big'), png[at + 4:at + 8]
        parts[kind] = parts.get(kind, b'') + png[at + 8:at + 8 + size]
        at += size + 12
    return [parts.get(b'IHDR'), parts.get(b'PLTE'), parts.get(b'tRNS'), zlib.decompress(parts.get(b'IDAT', b''))]


def output_of(command, given):
    return subprocess.run(command, input=given, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=True).stdout
