// SPDX-License-Identifier: GPL-3.0-or-later
// Mutations of valid scenario files: each is read or refused, and what is read is saved and read back the
// same.
#include <QtTest>

#include <map>
#include <random>

#include "core/model/pulse_force.h"
#include "core/model/scales.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "core/yaml/scenario_text.h"

using namespace drillwave;

namespace {

using Random = std::mt19937_64;

std::size_t below(std::size_t limit, Random& random) {
    return limit == 0 ? 0 : random() % limit;
}

/// What a mutation inserts: YAML's punctuation, numbers at the edge, keys and units, bytes that are no text.
const std::vector<std::string> fragments{":",
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

std::vector<std::size_t> lineStarts(const std::string& text) {
    std::vector<std::size_t> starts{0};
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1))
        starts.push_back(at + 1);
    return starts;
}

std::string anyLine(const std::string& text, Random& random) {
    const std::vector<std::size_t> starts = lineStarts(text);
    const std::size_t line = below(starts.size(), random);
    return text.substr(starts[line], text.find('\n', starts[line]) - starts[line]) + "\n";
}

void mutate(std::string& text, const std::vector<std::string>& corpus, Random& random) {
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

std::vector<std::string> corpusOfTexts() {
    std::vector<std::string> corpus;
    for (const Example& example : builtInExamples()) corpus.emplace_back(example.text);
    corpus.push_back(
        "drillwave: 1\ndimensionless: {beta: 0.5, gamma: 0.1, tau: 10}\npulse:\n  shape: table\n"
        "  points:\n  - [0, 0]\n  - [0.5, 1]\n  - [1, 0]\n");
    corpus.push_back(
        "drillwave: 1\nrod: {length: 1 m, area: 10 cm^2, youngs_modulus: 30e6 psi, density: 7.8 g/cm^3}\n"
        "pulse: {shape: trapezoid, duration: 0.1 ms, force: 200 kN, rise: 0.1}\n"
        "bit_rock: {stiffness: \"1 GN/m\", gamma: 1}\n");
    corpus.push_back(
        "drillwave: 2\nend_time: 9 ms\nhammer:\n  sections:\n  - length: 300 mm  # rear\n    area: 20 cm^2\n"
        "  velocity: 9 m/s\n  restrike: false\nstring:\n- repeat: 2\n  of:\n  - name: \"a, b\"\n"
        "    length: 1 ft\n    diameter: 2 in\n    loss: 0.02\n- {length: 1 m, diameter: 3 cm, attenuation: "
        "1 1/km}\n"
        "bit_rock: {stiffness: 1 GN/m, gamma: 1}\n");
    corpus.push_back(
        "\xEF\xBB\xBF{drillwave: 1, dimensionless: {beta: 1, gamma: 1, tau: 1}, pulse: {shape: piston, "
        "impedance_ratio: 3}}\r\n");
    return corpus;
}

/// Number of texts that were read; everything that must hold for each is checked here.
int readAndSaved(const std::string& text) {
    ScenarioDocument document;
    try {
        document = parseScenario(text, "");
    } catch (const ScenarioError& error) {
        if (error.problems().empty()) throw std::logic_error("refused without a reason");
        return 0;
    }
    if (!validate(document.scenario).empty()) throw std::logic_error("an invalid scenario was read");
    if (writeScenario(document) != text) throw std::logic_error("an unchanged text was not kept");
    const Groups groups = groupsOf(document.scenario);
    if (!(groups.beta > 0 && groups.tau > 0)) throw std::logic_error("the groups are no groups");
    const PulseForce force = pulseForceOf(document.scenario);
    if (!force.isRigidBody() && force.impulseUntil(force.end) != 1)
        throw std::logic_error("the impulse is not 1");
    // Written anew, and patched after a change.
    if (parseScenario(scenarioText(document.scenario), "").scenario != document.scenario)
        throw std::logic_error("written anew it is another scenario");
    (hasUnits(document.scenario) ? document.scenario.bitRock.gamma : document.scenario.groups.gamma) = 0.375;
    document.scenario.title = "changed: yes";
    if (parseScenario(writeScenario(document), "").scenario != document.scenario)
        throw std::logic_error("patched it is another scenario");
    return 1;
}

}  // namespace

class TestScenarioFuzz : public QObject {
    Q_OBJECT

  private slots:
    void mutatedFilesAreReadOrRefused();
    void everyPrefixIsReadOrRefused();
    void noiseIsReadOrRefused();
};

void TestScenarioFuzz::mutatedFilesAreReadOrRefused() {
    const std::vector<std::string> corpus = corpusOfTexts();
    Random random(8);
    int read = 0;
    const int mutations = 20000;
    for (int i = 0; i < mutations; ++i) {
        std::string text = corpus[static_cast<std::size_t>(i) % corpus.size()];
        for (std::size_t n = 1 + below(i % 2 == 0 ? 1 : 6, random); n > 0; --n) mutate(text, corpus, random);
        try {
            read += readAndSaved(text);
        } catch (const std::exception& error) {
            QFAIL(qPrintable(QString("%1 in mutation %2:\n%3")
                                 .arg(error.what())
                                 .arg(i)
                                 .arg(QString::fromStdString(text))));
        }
    }
    // The mutations are neither all harmless nor all fatal, or this would test little.
    QVERIFY2(read > mutations / 10 && read < mutations * 9 / 10, qPrintable(QString::number(read)));
}

void TestScenarioFuzz::everyPrefixIsReadOrRefused() {
    for (const std::string& text : corpusOfTexts()) {
        for (std::size_t length = 0; length < text.size(); ++length) {
            try {
                readAndSaved(text.substr(0, length));
            } catch (const std::exception& error) {
                QFAIL(qPrintable(QString("%1 in a prefix of %2 bytes").arg(error.what()).arg(length)));
            }
        }
    }
}

void TestScenarioFuzz::noiseIsReadOrRefused() {
    Random random(9);
    for (int i = 0; i < 3000; ++i) {
        std::string text = i % 2 == 0 ? "" : "drillwave: 1\n";
        for (std::size_t n = below(40, random); n > 0; --n)
            text += random() % 3 == 0 ? std::string(1, static_cast<char>(random() % 256))
                                      : fragments[below(fragments.size(), random)];
        try {
            readAndSaved(text);
        } catch (const std::exception& error) {
            QFAIL(qPrintable(QString("%1 in noise %2").arg(error.what()).arg(i)));
        }
    }
}

QTEST_APPLESS_MAIN(TestScenarioFuzz)
#include "tst_scenario_fuzz.moc"
