// SPDX-License-Identifier: GPL-3.0-or-later
// The manual in other languages says what the English one says: as far as that can be counted.
#include <QRegularExpression>
#include <QTest>

#include "core/manual/chapter.h"
#include "core/manual/markdown.h"
#include "core/manual/reference.h"
#include "core/text/languages.h"

using namespace drillwave;

namespace {

using Kind = ManualBlock::Kind;

// Commands and what they print, without the comments behind them.
QString withoutComments(const std::string& code) {
    static const QRegularExpression comment(QStringLiteral("\\s+# .*$"), QRegularExpression::MultilineOption);
    return QString::fromStdString(code).remove(comment);
}

QStringList codesOf(const std::string& text) {
    QStringList codes;
    for (const std::string_view each : codeIn(text))
        codes << QString::fromUtf8(each.data(), qsizetype(each.size()));
    codes.sort();
    return codes;
}

QStringList allOf(const QString& text, const QRegularExpression& pattern) {
    QStringList found;
    for (auto each = pattern.globalMatch(text); each.hasNext();) found << each.next().captured();
    found.sort();
    return found;
}

// "theory §3", "§3.1", "(T34)".
QStringList citationsOf(const QString& text) {
    static const QRegularExpression citation = [] {
        QStringList names;
        for (const std::string& name : chapterNames()) names << QString::fromStdString(name);
        return QRegularExpression(
            QStringLiteral("(?:\\b(?:%1) )?§[0-9]+(?:\\.[0-9]+)*|\\([TSD][0-9]+\\)").arg(names.join(u'|')));
    }();
    return allOf(text, citation);
}

// Whatever the decimal sign and the blanks between thousands; those in code are compared with it, Pos1 is the
// key Home, and presets stand there by their name and what it is in the language.
QStringList numbersOf(QString text) {
    static const QRegularExpression code(QStringLiteral("`[^`]*`|Pos1| — [^;(]*")),
        groups(QStringLiteral("(?<=\\d)[\\x{a0}\\x{202f}](?=\\d{3})")),
        number(QStringLiteral("\\d+(?:[.,]\\d+)*"));
    QStringList numbers = allOf(text.remove(code).remove(groups), number);
    for (QString& each : numbers) each.replace(u',', u'.');
    numbers.sort();
    return numbers;
}

// Returns lines and cells, without code, with too many words to be names, which are the same everywhere.
QStringList sentencesOf(const std::string& markdown) {
    static const QRegularExpression code(QStringLiteral("`[^`]*`|\\([^)]*\\)")),
        word(QStringLiteral("\\b\\p{Ll}{3,}"));
    QStringList sentences;
    const auto add = [&](const std::string& text) {
        const QString bare = QString::fromStdString(text).remove(code);
        if (allOf(bare, word).size() > 2) sentences << bare;
    };
    for (const ManualBlock& block : readMarkdown(markdown)) {
        if (block.kind == Kind::code) continue;
        add(block.text);
        for (const auto& row : block.rows)
            for (const std::string& cell : row) add(cell);
    }
    return sentences;
}

// Returns the difference between two lines of text, or nothing.
QString differenceOf(const std::string& english, const std::string& translated) {
    const auto first = QString::fromStdString(english), second = QString::fromStdString(translated);
    const auto told = [&](const QString& what, const QStringList& one, const QStringList& other) {
        return one == other ? QString()
                            : QStringLiteral("%1 %2 became %3 in: %4")
                                  .arg(what, one.join(u'|'), other.join(u'|'), second);
    };
    for (const QString& each : {told(QStringLiteral("code"), codesOf(english), codesOf(translated)),
                                told(QStringLiteral("citations"), citationsOf(first), citationsOf(second)),
                                told(QStringLiteral("numbers"), numbersOf(first), numbersOf(second))})
        if (!each.isEmpty()) return each;
    return first.isEmpty() == second.isEmpty() ? QString() : QStringLiteral("an empty text: ") + first;
}

QString differenceOf(const ManualBlock& english, const ManualBlock& translated) {
    if (english.kind != translated.kind || english.level != translated.level ||
        english.mark != translated.mark)
        return QStringLiteral("another kind of block: %1 / %2")
            .arg(QString::fromStdString(english.text), QString::fromStdString(translated.text));
    if (english.kind == Kind::code)
        return withoutComments(english.text) == withoutComments(translated.text)
                   ? QString()
                   : QStringLiteral("other code: ") + QString::fromStdString(translated.text);
    if (english.rows.size() != translated.rows.size())
        return QStringLiteral("a table of %1 rows, not %2")
            .arg(translated.rows.size())
            .arg(english.rows.size());
    for (std::size_t row = 0; row < english.rows.size(); ++row)
        for (std::size_t cell = 0; cell < english.rows[row].size(); ++cell) {
            if (translated.rows[row].size() != english.rows[row].size()) return QStringLiteral("other cells");
            const QString found = differenceOf(english.rows[row][cell], translated.rows[row][cell]);
            if (!found.isEmpty()) return found;
        }
    return differenceOf(english.text, translated.text);
}

}  // namespace

class TestManualLanguages : public QObject {
    Q_OBJECT

  private slots:
    void everyPageSaysTheSame_data();
    void everyPageSaysTheSame();
    void pagesOfTheWindowAreTranslated_data() { everyPageSaysTheSame_data(); }
    void pagesOfTheWindowAreTranslated();
    void numbersOfTheReferencesHaveTheDecimalSign();
};

void TestManualLanguages::everyPageSaysTheSame_data() {
    QTest::addColumn<QString>("code");
    for (const Language& language : languages)
        if (!isEnglish(language))
            QTest::newRow(language.code.data()) << QString::fromLatin1(language.code.data());
}

void TestManualLanguages::everyPageSaysTheSame() {
    QFETCH(QString, code);
    const std::vector<Chapter> english = manualChapters(plainStyle()),
                               translated = manualChapters(styleOf(*findLanguage(code.toStdString())));
    QStringList found;
    for (const Chapter& chapter : english) {
        const Chapter* other = findChapter(translated, chapter.name);
        QVERIFY(other);
        const std::vector<ManualBlock> first = readMarkdown(chapter.text), second = readMarkdown(other->text);
        const auto said = [&](const QString& what) {
            found << QString::fromStdString(chapter.name) + QStringLiteral(": ") + what;
        };
        for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
            const QString difference = differenceOf(first[i], second[i]);
            if (!difference.isEmpty()) said(difference);
            if (first[i].kind != second[i].kind) break;  // all behind it would differ
        }
        if (first.size() != second.size())
            said(QStringLiteral("%1 blocks, not %2").arg(second.size()).arg(first.size()));
    }
    QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
}

// Pages for the first ten minutes beside the window, and for F1 in a field.
void TestManualLanguages::pagesOfTheWindowAreTranslated() {
    QFETCH(QString, code);
    const std::vector<Chapter> english = manualChapters(plainStyle()),
                               translated = manualChapters(styleOf(*findLanguage(code.toStdString())));
    for (const char* name : {"tutorial", "window", "keys", "glossary", "parameters", "outputs"}) {
        const QStringList first = sentencesOf(findChapter(english, name)->text),
                          second = sentencesOf(findChapter(translated, name)->text);
        QVERIFY2(first.size() > 20, name);
        const QSet<QString> known(first.begin(), first.end());
        QStringList same;
        for (const QString& each : second)
            if (known.contains(each)) same << each;
        QVERIFY2(same.isEmpty(), qPrintable(QLatin1String(name) + QStringLiteral(": ") + same.join(u'|')));
    }
}

void TestManualLanguages::numbersOfTheReferencesHaveTheDecimalSign() {
    const ReadingStyle& german = styleOf(*findLanguage("de"));
    const QString gamma = QString::fromStdString(referenceOf(*findParameter("bit_rock.gamma"), german));
    QVERIFY2(gamma.contains(QStringLiteral("0,01 – 1")), qPrintable(gamma));
    QVERIFY2(!gamma.contains(QStringLiteral("0.")), qPrintable(gamma));
}

QTEST_APPLESS_MAIN(TestManualLanguages)
#include "tst_manual_languages.moc"
