#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that compare_outputs.py finds each kind of difference: check_compare.py (no arguments)"""
import contextlib
import io
import os
import sys
import tempfile
import zlib

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import compare_outputs


def png(grey, title):
    """One pixel."""
    def part(kind, data):
        return len(data).to_bytes(4, 'big') + kind + data + zlib.crc32(kind + data).to_bytes(4, 'big')
    return (b'\x89PNG\r\n\x1a\n' + part(b'IHDR', bytes([0, 0, 0, 1, 0, 0, 0, 1, 8, 0, 0, 0, 0])) +
            part(b'tEXt', b'Title\0' + title) + part(b'IDAT', zlib.compress(bytes([0, grey]))) + part(b'IEND', b''))


FILES = {
    'run.json': '{"version": "1.2", "cor": 0.4300, "feed": "full_rate", "unit": "N s", "solved": true,\n'
                ' "run_time": 1e-3, "text": "The feed of 8 kN is enough."}\n',
    'run.txt': '  restitution e  0.43\n  gap            −1.5 mm\n  method exact, 13 pieces, solved in 91.3 us\n',
    'run_de.txt': 'Die Rückprallzahl ist 0,43.\n',
    'run.exit': '0\n',
    'run.err.txt': 'drillwave run: rod.length = -1m: must be above 0\n',
    'stability.err.txt': '38 % done  94 cases/s  24 s left\n',
    'stability.txt': '  seconds    0.3    chatter\n  cases      12\n',
    'help.txt': 'Options:\n  --json    print one object\n  bit_rock.gap  gap of bit and rock\n',
    'rows.csv': '# drillwave: 1\n# rod: {length: 3 m}   # an extension rod\ngap [mm],cor,feed\n1,0.5,full_rate\n',
    'best.yaml': 'title: Rod in rock\nrod:\n  length: 3.66 m  # a 12 ft extension rod\n',
    'report.html': '<h1 title="The head">A report</h1><td data-value="1.5">1.5 kN</td>',
    'plot.svg': '<svg><path d="M 0 1 L 2 3"/><text x="5" >gap of the bit, 10</text></svg>',
    'plot.png': png(7, b'a'),
    '05_command.txt': "drillwave gap - -o - <<'END'\nrod:\n  length: 3 m  # a rod\nEND\n",
    '05.lines.txt': 'label: gap of the bit\nlabel: 10 blows\nbutton: Scan\n',
    'x.accuracy.csv': 'method,error,median_s\nexact,1e-14,0.001\n',
    'x.accuracy.svg': '<svg><path d="M 0 1"/><text>median of times</text><text>10 us</text></svg>',
    'drillwave.fish': "complete -l json -d 'print one object' -a 'cor'\n",
}
SAME, TEXTS, DIFFERENT, IMPOSSIBLE = 0, 3, 1, 2

# File, what is changed into what, exit code, words of the output.
CASES = [
    ('run.json', '0.4300', '0.4301', DIFFERENT, 'run.json'),
    ('run.json', '0.4300', '0.43', DIFFERENT, '0.4300'),
    ('run.json', '"cor"', '"e"', DIFFERENT, 'keys'),
    ('run.json', '"cor": 0.4300, "feed": "full_rate"', '"feed": "full_rate", "cor": 0.4300', DIFFERENT, 'keys'),
    ('run.json', 'full_rate', 'rate_full', DIFFERENT, 'full_rate'),
    ('run.json', 'N s', 'N m', DIFFERENT, 'N m'),
    ('run.json', 'true', 'null', DIFFERENT, 'solved'),
    ('run.json', 'The feed of 8 kN is enough.', 'A feed of 8 kN suffices.', TEXTS, 'suffices'),
    ('run.json', 'feed of 8 kN', 'feed of 9 kN', DIFFERENT, '9'),
    ('run.json', '1e-3', '2e-3', SAME, ''),
    ('run.json', '"1.2"', '"1.3"', SAME, ''),
    ('run.txt', 'restitution', 'rebound', TEXTS, 'rebound'),
    ('run.txt', '0.43', '0.44', DIFFERENT, '0.44'),
    ('run.txt', '−1.5', '1.5', DIFFERENT, '-1.5'),
    ('run.txt', '91.3 us', '1.2 ms', SAME, ''),
    ('run.txt', '13 pieces', '14 pieces', DIFFERENT, '14'),
    ('run_de.txt', '0,43', '0,44', DIFFERENT, '0,44'),
    ('run_de.txt', 'Rückprallzahl', 'Stoßzahl', TEXTS, 'Stoßzahl'),
    ('run.exit', '0', '6', DIFFERENT, 'run.exit'),
    ('run.err.txt', 'must be above', 'has to be above', TEXTS, 'has to be'),
    ('stability.err.txt', '38 % done  94 cases/s  24 s left\n', '', SAME, ''),
    ('stability.txt', '0.3', '0.38', SAME, ''),
    ('stability.txt', '12', '13', DIFFERENT, '13'),
    ('help.txt', 'print one', 'Print an', TEXTS, 'Print an'),
    ('help.txt', '--json', '--yaml', DIFFERENT, '--yaml'),
    ('help.txt', 'bit_rock.gap', 'bit_rock.hole', DIFFERENT, 'bit_rock.hole'),
    ('rows.csv', 'gap [mm]', 'gap [m]', DIFFERENT, 'row 1'),
    ('rows.csv', '1,0.5', '1,0.6', DIFFERENT, 'row 2 cor'),
    ('rows.csv', 'full_rate', 'enough', DIFFERENT, 'row 2 feed'),
    ('rows.csv', 'an extension', 'a drill', TEXTS, 'a drill rod'),
    ('rows.csv', '3 m', '4 m', DIFFERENT, '4 m'),
    ('best.yaml', 'length:', 'size:', DIFFERENT, 'size'),
    ('best.yaml', '3.66', '3.67', DIFFERENT, '3.67'),
    ('best.yaml', 'extension', 'drill', TEXTS, 'drill'),
    ('best.yaml', '12 ft', '14 ft', DIFFERENT, '14'),
    ('report.html', 'A report', 'The report', TEXTS, 'The report'),
    ('report.html', 'The head', 'A head', TEXTS, 'A head'),
    ('report.html', 'data-value="1.5"', 'data-value="1.4"', DIFFERENT, 'tags'),
    ('report.html', '1.5 kN', '1.4 kN', DIFFERENT, '1.4'),
    ('plot.svg', 'L 2 3', 'L 2 4', DIFFERENT, 'shapes'),
    ('plot.svg', 'x="5"', 'x="6"', DIFFERENT, 'shapes'),
    ('plot.svg', 'of the bit', 'below the bit', TEXTS, 'below'),
    ('plot.svg', ', 10', ', 20', DIFFERENT, '20'),
    ('plot.png', png(7, b'a'), png(8, b'a'), DIFFERENT, 'pixels'),
    ('plot.png', png(7, b'a'), png(7, b'b'), SAME, ''),
    ('05_command.txt', ' -o -', ' --si -o -', DIFFERENT, '--si'),
    ('05_command.txt', '# a rod', '# the rod', TEXTS, 'the rod'),
    ('05.lines.txt', 'button: Scan', 'button: Run', TEXTS, 'Run'),
    ('05.lines.txt', '10 blows\nbutton: Scan', '20 blows\nbutton: Scan', DIFFERENT, '20'),
    ('05.lines.txt', 'label: gap of the bit\nlabel: 10 blows', 'label: 10 blows\nlabel: gap of the bit', SAME, ''),
    ('x.accuracy.csv', '0.001', '0.002', SAME, ''),
    ('x.accuracy.csv', '1e-14', '2e-14', DIFFERENT, '2e-14'),
    ('x.accuracy.svg', 'M 0 1', 'M 0 2', SAME, ''),
    ('x.accuracy.svg', '10 us', '12 us', SAME, ''),
    ('x.accuracy.svg', 'median', 'mean', TEXTS, 'mean of times'),
    ('drillwave.fish', 'print one object', 'Print an object', TEXTS, 'Print'),
    ('drillwave.fish', "'cor'", "'e'", DIFFERENT, "'e'"),
]


def write(folder, files):
    for name, content in files.items():
        with open(os.path.join(folder, name), 'wb') as file:
            file.write(content if isinstance(content, bytes) else content.encode())


def compared(new_files):
    """Exit code and output of a comparison with FILES."""
    with tempfile.TemporaryDirectory() as old, tempfile.TemporaryDirectory() as new:
        write(old, FILES)
        write(new, new_files)
        output = io.StringIO()
        with contextlib.redirect_stdout(output):
            code = compare_outputs.main([old, new])
    return code, output.getvalue()


def main():
    without_exit = {name: FILES[name] for name in FILES if name != 'run.exit'}
    cases = [('equal folders', FILES, SAME, f'{len(FILES)} files, 0 changed texts'),
             ('missing file', without_exit, DIFFERENT, 'only in the old'),
             ('added file', {**FILES, 'more.txt': ''}, DIFFERENT, 'only in the new'),
             ('picture with other words', {**FILES, 'plot.svg': FILES['plot.svg'].replace('bit', 'rock'),
                                           'plot.png': png(9, b'a')}, TEXTS, 'text in a picture'),
             ('nothing in common', {'more.txt': ''}, IMPOSSIBLE, '')]
    for name, old, new, code, words in CASES:
        assert FILES[name].count(old) == 1, (name, old)
        cases.append((f'{name}: {old} -> {new}', {**FILES, name: FILES[name].replace(old, new)}, code, words))
    failed = 0
    for title, files, code, words in cases:
        with contextlib.redirect_stderr(io.StringIO()):
            found, output = compared(files)
        if found != code or words not in output:
            failed += 1
            print(f'{title}\n  exit code {found}, not {code}; expected `{words}` in\n{output}')
    print(f'{len(cases)} cases, {failed} failed')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
