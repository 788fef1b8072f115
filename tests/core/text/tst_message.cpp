// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences in parts.
#include <QTest>

#include "core/text/message.h"

using namespace drillwave;

class TestMessage : public QObject {
    Q_OBJECT

  private slots:
    void argumentsTakeTheirPlaces();
    void aNameIsNoPattern();
    void everyPatternInItIsSaid();
    void nothingIsSaidWithoutAPattern();
};

void TestMessage::argumentsTakeTheirPlaces() {
    const Message message{"%2 and %1, then %2 again", {"one", "two"}};
    QCOMPARE(message.text(), std::string("two and one, then two again"));
    QVERIFY(!message.isEmpty());
}

void TestMessage::aNameIsNoPattern() {
    const std::string share = "90 %2 off", name = "%1";
    QCOMPARE((Message{"%1: %2, 5 % of it", {share, name}}.text()), std::string("90 %2 off: %1, 5 % of it"));
}

void TestMessage::everyPatternInItIsSaid() {
    const Message message{"%1 is %2", {std::string("b"), {"up to %1", {std::string("3 mm")}}}};
    QCOMPARE(message.text(), std::string("b is up to 3 mm"));
    const auto say = [](const std::string& pattern) {
        return pattern == "%1 is %2" ? std::string("%2, %1") : "bis %1";
    };
    QCOMPARE(message.said(say), std::string("bis 3 mm, b"));
}

void TestMessage::nothingIsSaidWithoutAPattern() {
    QVERIFY(Message{}.isEmpty());
    QCOMPARE(Message{}.text(), std::string());
}

QTEST_GUILESS_MAIN(TestMessage)
#include "tst_message.moc"
