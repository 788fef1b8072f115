// SPDX-License-Identifier: GPL-3.0-or-later
// JSON documents: the bytes that Qt's writer gives for the same values, an independent one.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "core/text/json.h"

using namespace drillwave;

namespace {

QByteArray qtText(const QJsonObject& object) {
    return QJsonDocument(object).toJson(QJsonDocument::Indented);
}

QByteArray ownText(const JsonObject& object) {
    return QByteArray::fromStdString(Json(object).text());
}

}  // namespace

class TestJson : public QObject {
    Q_OBJECT

  private slots:
    void documentsAreLaidOutLikeQtDoes();
    void keysAreSortedAndTheLastValueStays();
    void textsAreEscaped_data();
    void textsAreEscaped();
    void whatATerminalObeysIsEscaped();
    void numbersReadBackExactly_data();
    void numbersReadBackExactly();
    void numbersOfEverySizeAreWrittenLikeQtDoes();
    void whatIsNoNumberIsNull();
};

void TestJson::documentsAreLaidOutLikeQtDoes() {
    const JsonObject own{{"empty_array", JsonArray()},
                         {"empty_object", JsonObject()},
                         {"array", JsonArray{1, "two", 3.5, JsonObject{{"four", 4}}, JsonArray{true, false}}},
                         {"nothing", Json()},
                         {"object", JsonObject{{"b", JsonObject{{"c", "deep"}}}, {"a", std::uint64_t{7}}}}};
    const QJsonObject qt{
        {"empty_array", QJsonArray()},
        {"empty_object", QJsonObject()},
        {"array", QJsonArray{1, "two", 3.5, QJsonObject{{"four", 4}}, QJsonArray{true, false}}},
        {"nothing", QJsonValue::Null},
        {"object", QJsonObject{{"b", QJsonObject{{"c", "deep"}}}, {"a", 7}}}};
    QCOMPARE(ownText(own), qtText(qt));
    QCOMPARE(ownText({}), qtText({}));
}

void TestJson::keysAreSortedAndTheLastValueStays() {
    JsonObject object{{"zeta", 1}, {"beta", 2}, {"Zeta", 3}, {"beta", 4}};
    object["alpha"] = "new";
    object["zeta"] = "changed";
    QCOMPARE(ownText(object), QByteArray("{\n    \"Zeta\": 3,\n    \"alpha\": \"new\",\n    \"beta\": 4,\n"
                                         "    \"zeta\": \"changed\"\n}\n"));
}

void TestJson::textsAreEscaped_data() {
    QTest::addColumn<QString>("text");
    QTest::newRow("plain") << "T38, medium rock";
    QTest::newRow("quotes and backslashes") << R"(a "rod" in C:\rods\)";
    QTest::newRow("lines") << "drillwave: 1\n\ttitle: x\r\n";
    QString controls;
    for (char16_t c = 0; c < 0x20; ++c) controls += QChar(c);
    QTest::newRow("every control character") << controls;
    QTest::newRow("two, three and four bytes") << QString::fromUtf8("β ≤ 0,5 — 🪨");
}

void TestJson::textsAreEscaped() {
    QFETCH(QString, text);
    QCOMPARE(ownText({{"text", text.toStdString()}}), qtText({{"text", text}}));
}

void TestJson::whatATerminalObeysIsEscaped() {
    const QString text = QString::fromUtf8("a\x7F\xC2\x9B m\u202Eright\uFEFF");
    const QByteArray json = ownText({{"text", text.toStdString()}});
    QVERIFY2(std::ranges::all_of(json, [](char c) { return c >= ' ' || c == '\n'; }), json);
    QCOMPARE(QJsonDocument::fromJson(json)["text"].toString(), text);
}

void TestJson::numbersReadBackExactly_data() {
    QTest::addColumn<double>("number");
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("zero") << 0.0 << QByteArray("0");
    QTest::newRow("a fraction") << 0.1 << QByteArray("0.1");
    QTest::newRow("small") << 1e-7 << QByteArray("1e-07");
    QTest::newRow("whole") << 210e9 << QByteArray("210000000000");
    QTest::newRow("the largest exact ones") << 9007199254740992.0 << QByteArray("9007199254740992");
    QTest::newRow("too large for 64 bits") << 1e19 << QByteArray("1e+19");
    QTest::newRow("smallest") << std::numeric_limits<double>::denorm_min() << QByteArray("5e-324");
    QTest::newRow("17 digits") << 0.1 + 0.2 << QByteArray("0.30000000000000004");
}

void TestJson::numbersReadBackExactly() {
    QFETCH(double, number);
    QFETCH(QByteArray, text);
    QCOMPARE(ownText({{"n", number}}), "{\n    \"n\": " + text + "\n}\n");
    QCOMPARE(ownText({{"n", -number}}), qtText({{"n", -number}}));
    QCOMPARE(text.toDouble(), number);
}

// Most doubles of random bits are huge or tiny: some are drawn near one too.
void TestJson::numbersOfEverySizeAreWrittenLikeQtDoes() {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> exponent(-25, 25), mantissa(-10, 10);
    for (int i = 0; i < 20000; ++i) {
        const double any = std::bit_cast<double>(random());
        const double usual = mantissa(random) * std::pow(10, exponent(random));
        for (const double number : {any, usual, std::round(usual), std::round(usual * 100) / 100})
            QCOMPARE(ownText({{"n", number}}), qtText({{"n", number}}));
    }
}

void TestJson::whatIsNoNumberIsNull() {
    const QByteArray null("{\n    \"n\": null\n}\n");
    for (const double number : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
        QCOMPARE(ownText({{"n", number}}), null);
        QCOMPARE(ownText({{"n", std::optional(number)}}), null);
    }
    QCOMPARE(ownText({{"n", std::optional<double>()}}), null);
    QCOMPARE(ownText({{"n", std::optional(2.0)}}), QByteArray("{\n    \"n\": 2\n}\n"));
}

QTEST_GUILESS_MAIN(TestJson)
#include "tst_json.moc"
