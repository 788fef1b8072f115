// SPDX-License-Identifier: GPL-3.0-or-later
// Mutations of valid scenario files: each is read or refused, and what is read is saved and read back the
// same.
#include <QTest>

#include "tests/support/mutation.h"
#include "tests/support/scenario_reading.h"
#include "tests/support/tries.h"

using namespace drillwave;
using namespace drillwave::test;

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
    const int mutations = tries("DRILLWAVE_MUTATIONS", 3000, 20000);
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
