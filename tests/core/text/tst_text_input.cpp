// SPDX-License-Identifier: GPL-3.0-or-later
// Text before anything interprets it: UTF-8, positions, and edits of its parts.
#include <QTest>

#include <QPoint>
#include <random>

#include "core/text/text_edit.h"
#include "core/text/text_input.h"

using namespace drillwave;

class TestTextInput : public QObject {
    Q_OBJECT

  private slots:
    void utf8IsAcceptedAsQtDecodesIt();
    void positionsCountLinesAndCharacters();
    void editsAreMadeAllAtOnce();
};

// Qt's decoder is the oracle: what it has to replace is no UTF-8.
void TestTextInput::utf8IsAcceptedAsQtDecodesIt() {
    std::mt19937 random(10);
    const QByteArray pieces[] = {"a",    "\xC3\xBC",     "\xE2\x82\xAC", "\xF0\x9F\xAA\xA8", "\x80",
                                 "\xC0", "\xED\xA0\x80", "\xE0\x80",     "\xF4\x90",         "\xF5",
                                 "\xC3", "\xE2\x82",     "\xF0\x9F\xAA"};
    int accepted = 0;
    for (int i = 0; i < 20000; ++i) {
        QByteArray bytes;
        for (unsigned n = 1 + random() % 4; n > 0; --n)
            bytes += pieces[random() % (random() % 2 ? 4 : std::size(pieces))];
        const bool isText = QString::fromUtf8(bytes).toUtf8() == bytes;
        QCOMPARE(checkText(bytes.toStdString()).reason.empty(), isText);
        accepted += isText;
    }
    QVERIFY(accepted > 1000 && accepted < 19000);
}

void TestTextInput::positionsCountLinesAndCharacters() {
    const std::string text =
        "\xEF\xBB\xBF"
        "a\r\n\xC3\xBC"
        "bc\n";
    const auto at = [&](std::size_t offset) {
        return QPoint(positionOf(text, offset).column, positionOf(text, offset).line);
    };
    QCOMPARE(at(0), QPoint(1, 1));
    QCOMPARE(at(3), QPoint(1, 1));
    QCOMPARE(at(4), QPoint(2, 1));
    QCOMPARE(at(6), QPoint(1, 2));
    QCOMPARE(at(8), QPoint(2, 2));
    QCOMPARE(at(text.size()), QPoint(1, 3));
}

void TestTextInput::editsAreMadeAllAtOnce() {
    const std::string text =
        edited("0123456789", {{8, 2, "end"}, {2, 3, ""}, {6, 0, "a"}, {6, 0, "b"}, {0, 1, "start"}});
    QCOMPARE(QString::fromStdString(text), QString("start15ab67end"));
    QCOMPARE(QString::fromStdString(edited("", {{0, 0, "x"}})), QString("x"));
}

QTEST_APPLESS_MAIN(TestTextInput)
#include "tst_text_input.moc"
