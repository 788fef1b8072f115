// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences in parts.
#include <QtTest>

#include "core/text/message.h"

using namespace drillwave;

class TestMessage : public QObject {
    Q_OBJECT

  private slots:
    void argumentsTakeTheirPlaces();
    void anArgumentIsNoPattern();
    void nothingIsSaidWithoutAPattern();
};

void TestMessage::argumentsTakeTheirPlaces() {
    const Message message{"%2 and %1, then %2 again", {"one", "two"}};
    QCOMPARE(message.text(), std::string("two and one, then two again"));
    QVERIFY(!message.isEmpty());
}

void TestMessage::anArgumentIsNoPattern() {
    QCOMPARE((Message{"%1: %2", {"90 %2 off", "%1"}}.text()), std::string("90 %2 off: %1"));
}

void TestMessage::nothingIsSaidWithoutAPattern() {
    QVERIFY(Message{}.isEmpty());
    QCOMPARE(Message{}.text(), std::string());
}

QTEST_GUILESS_MAIN(TestMessage)
#include "tst_message.moc"
