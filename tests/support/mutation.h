// SPDX-License-Identifier: GPL-3.0-or-later
// Random changes of a text that a parser reads. Nearly correct texts find more errors than noise.
#pragma once

#include <random>
#include <string>
#include <vector>

namespace drillwave::test {

using Random = std::mt19937_64;

inline std::size_t below(std::size_t limit, Random& random) {
    return limit == 0 ? 0 : random() % limit;
}

/// Texts to insert: punctuation of YAML, extreme numbers, keys and units, and invalid bytes.
inline const std::vector<std::string> fragments{":",
                                                ": ",
                                                "\n",
                                                "\n  ",
                                                "- ",
                                                "? ",
                                                "[",
                                                "]",
                                                "{",
                                                "}",
                                                ",",
                                                "#",
                                                " #",
                                                "&a ",
                                                "*a",
                                                "!!str ",
                                                "!",
                                                "|",
                                                ">",
                                                "'",
                                                "\"",
                                                "\\",
                                                "%YAML ",
                                                "---",
                                                "...",
                                                "\t",
                                                "\r",
                                                "\r\n",
                                                "~",
                                                "null",
                                                ".nan",
                                                "-.inf",
                                                "1e999",
                                                "1e-999",
                                                "-0",
                                                "0",
                                                "-1",
                                                "1e308",
                                                "1e-308",
                                                "mm",
                                                "GPa",
                                                "N s",
                                                "us",
                                                "<<: ",
                                                "gamma: 1",
                                                "drillwave: 2",
                                                "drillwave: 3",
                                                "repeat: 1000000000",
                                                "repeat: 2\n    of: ",
                                                "- {length: 1 m, area: 2 cm^2}",
                                                "loss: 2 %",
                                                "shape: table",
                                                "points: [[0, 1], [1, 0]]",
                                                "piston",
                                                "trapezoid",
                                                "\xEF\xBB\xBF",
                                                "\xC3\xBC",
                                                "\xFF",
                                                "\xE2\x82",
                                                std::string(1, '\0'),
                                                "\x1B",
                                                std::string(300, '['),
                                                std::string(200, ' '),
                                                std::string(5000, 'x')};

inline std::vector<std::size_t> lineStarts(const std::string& text) {
    std::vector<std::size_t> starts{0};
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1))
        starts.push_back(at + 1);
    return starts;
}

inline std::string anyLine(const std::string& text, Random& random) {
    const std::vector<std::size_t> starts = lineStarts(text);
    const std::size_t line = below(starts.size(), random);
    return text.substr(starts[line], text.find('\n', starts[line]) - starts[line]) + "\n";
}

/// Changes a byte, a word or a line of a text at random; lines may come from other texts of the corpus.
inline void mutate(std::string& text, const std::vector<std::string>& corpus, Random& random) {
    const std::size_t at = below(text.size() + 1, random);
    const std::vector<std::size_t> starts = lineStarts(text);
    const std::size_t line = starts[below(starts.size(), random)];
    switch (below(10, random)) {
        case 0:
            if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(8, random)));
            break;
        case 1:
            if (at < text.size()) text[at] = static_cast<char>(' ' + below(95, random));
            break;
        case 2:
            text.erase(at, 1 + below(6, random));
            break;
        case 3:
            text.insert(at, fragments[below(fragments.size(), random)]);
            break;
        case 4:
            text.insert(line, anyLine(text, random));
            break;
        case 5:
            text.insert(line, anyLine(corpus[below(corpus.size(), random)], random));
            break;
        case 6:
            text.erase(line, text.find('\n', line) - line + 1);
            break;
        case 7:
            if (below(8, random) == 0) text.resize(at);
            break;
        case 8:
            text.insert(line, std::string(below(4, random), ' '));
            break;
        default:
            if (at < text.size() && text[at] >= '0' && text[at] <= '9')
                text[at] = static_cast<char>('0' + below(10, random));
            break;
    }
}

}  // namespace drillwave::test
