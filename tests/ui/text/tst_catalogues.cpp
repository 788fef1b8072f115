// SPDX-License-Identifier: GPL-3.0-or-later
// The catalogues have all texts of the sources and no others, each translated whole.
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "core/text/languages.h"
#include "tests/support/catalogue.h"
#include "ui/text/shown_text.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

QStringList matches(const QString& text, const char* pattern) {
    QStringList found;
    for (const QRegularExpressionMatch& match : QRegularExpression(QLatin1String(pattern)).globalMatch(text))
        found << match.captured();
    found.sort();
    return found;
}

/// Returns why a translation cannot stand for a text; empty where it can. A text that is laid out for a
/// terminal may have other lines.
QString fault(const QString& source, const CatalogueEntry& entry, bool isLaidOut = false) {
    const QString& text = entry.translation;
    if (!entry.isFinished) return QStringLiteral("is not finished");
    if (text.trimmed().isEmpty() && !source.trimmed().isEmpty()) return QStringLiteral("is empty");
    if (matches(source, "%L?\\d+|%n") != matches(text, "%L?\\d+|%n"))
        return QStringLiteral("has other places for values");
    if (matches(source, "&(?=[^\\s&])").size() != matches(text, "&(?=[^\\s&])").size())
        return QStringLiteral("has other keys");
    if (matches(source, "</?\\w+>") != matches(text, "</?\\w+>")) return QStringLiteral("has other marks");
    if (matches(source, "`[^`]*`") != matches(text, "`[^`]*`"))
        return QStringLiteral("has another command in it");
    if (!isLaidOut && matches(source, "\\n").size() != matches(text, "\\n").size())
        return QStringLiteral("has another number of lines");
    if (source.endsWith(u'…') != text.endsWith(u'…')) return QStringLiteral("ends otherwise");
    if (source.startsWith(u' ') != text.startsWith(u' ') || source.endsWith(u' ') != text.endsWith(u' '))
        return QStringLiteral("has other blanks at an end");
    return {};
}

QString shown(const CatalogueKey& key) {
    return key.first + QStringLiteral(" | ") + key.second;
}

}  // namespace

class TestCatalogues : public QObject {
    Q_OBJECT

  private slots:
    void faultsAreFound_data();
    void faultsAreFound();
    void allIsTranslated_data();
    void allIsTranslated();
    void theCommandsReadThem_data() { allIsTranslated_data(); }
    void theCommandsReadThem();
};

void TestCatalogues::faultsAreFound_data() {
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("translation");
    QTest::addColumn<bool>("isFinished");
    QTest::newRow("unfinished") << "gap"
                                << "Spalt" << false;
    QTest::newRow("empty") << "gap"
                           << "" << true;
    QTest::newRow("a value less") << "%1 of %2"
                                  << "%1" << true;
    QTest::newRow("a value twice") << "%1 of %2"
                                   << "%1 von %1" << true;
    QTest::newRow("no key") << "&Open…"
                            << "Öffnen…" << true;
    QTest::newRow("two keys") << "&Open…"
                              << "&Ö&ffnen…" << true;
    QTest::newRow("no dialog") << "&Open…"
                               << "Ö&ffnen" << true;
    QTest::newRow("no end of a mark") << "<b>%1</b>"
                                      << "<b>%1<b>" << true;
    QTest::newRow("command") << "as `drillwave run`"
                             << "wie `bohrwelle run`" << true;
    QTest::newRow("lines") << "a\nb"
                           << "a b" << true;
    QTest::newRow("blanks") << " · %1"
                            << "· %1" << true;
}

void TestCatalogues::faultsAreFound() {
    QFETCH(QString, source);
    QFETCH(QString, translation);
    QFETCH(bool, isFinished);
    QVERIFY(!fault(source, {translation, isFinished}).isEmpty());
    QCOMPARE(fault(source, {source, true}), QString());
}

void TestCatalogues::allIsTranslated_data() {
    QTest::addColumn<QString>("code");
    for (const Language& language : languages)
        if (!isEnglish(language)) {
            const QString code = fromView(language.code);
            QTest::newRow(qPrintable(code)) << code;
        }
}

/// Where this fails, `cmake --build … --target languages` brings the catalogues up to date; what it adds to
/// them is to be translated.
void TestCatalogues::allIsTranslated() {
    QFETCH(QString, code);
    const QTemporaryDir folder;
    const QString fresh = folder.filePath(QStringLiteral("fresh_%1.ts").arg(code));
    QProcess extract;
    extract.setProcessChannelMode(QProcess::MergedChannels);
    extract.start(
        QStringLiteral(DRILLWAVE_SOURCE_DIR "/resources/languages/extract.sh"),
        {QStringLiteral(DRILLWAVE_LUPDATE), QStringLiteral(DRILLWAVE_CORE_TEXTS), folder.path(), fresh});
    QVERIFY(extract.waitForFinished(120000));
    const QString said = QString::fromUtf8(extract.readAll());
    QVERIFY2(extract.exitCode() == 0, qPrintable(said));
    // Its context would be another one than at run time.
    QVERIFY2(!said.contains(QLatin1String("unknown namespace")), qPrintable(said));

    const CatalogueEntries wanted = readCatalogue(fresh);
    constexpr int leastTexts = 1500;  // that they are found at all
    QVERIFY2(wanted.size() > leastTexts, qPrintable(QString::number(wanted.size())));
    const CatalogueEntries entries = readCatalogue(cataloguePath(code));
    QStringList problems;
    for (const CatalogueKey& key : wanted.keys())
        if (!entries.contains(key))
            problems << QStringLiteral("is missing: ") + shown(key);
        else if (const QString why = fault(key.second, entries[key], key.first == QLatin1String("help"));
                 !why.isEmpty())
            problems << QStringLiteral("%1: %2 → %3").arg(why, shown(key), entries[key].translation);
    for (const CatalogueKey& key : entries.keys())
        if (!wanted.contains(key)) problems << QStringLiteral("is in no source: ") + shown(key);
    QVERIFY2(problems.isEmpty(), qPrintable(problems.join(u'\n')));
}

/// The contexts of the commands, in the order in which they are sought.
void TestCatalogues::theCommandsReadThem() {
    QFETCH(QString, code);
    const CatalogueEntries entries = readCatalogue(cataloguePath(code));
    QMap<QString, QString> wanted;
    for (const char* context : {"help", "core", "drillwave::Message"})
        for (const auto& [key, entry] : entries.asKeyValueRange())
            if (key.first == QLatin1String(context)) wanted[key.second] = entry.translation;
    for (const auto& [english, translation] : wanted.asKeyValueRange())
        QCOMPARE(QString::fromStdString(inLanguage(*findLanguage(code.toStdString()), english.toStdString())),
                 translation);
}

QTEST_GUILESS_MAIN(TestCatalogues)
#include "tst_catalogues.moc"
