// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/manual_document.h"

#include <QFontMetricsF>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextFrame>
#include <QTextList>
#include <QTextTable>
#include <algorithm>

#include "core/blow/outputs.h"
#include "ui/help/help_topic.h"
#include "ui/text/lightness.h"

namespace drillwave {

namespace {

// Whether a text between two citations joins them to one chapter.
bool goesOn(const QString& between) {
    static const QRegularExpression comma(QStringLiteral("^(, | %1 )$").arg(QStringView(andWords)));
    return comma.match(between).hasMatch();
}

// Links "theory §3" and a bare "§3", which is of this chapter or, after "theory §1 and", of that one.
void addSections(const QString& line, const QString& chapter, const ManualBook& book,
                 QList<ManualLink>& links) {
    static const QRegularExpression citation(
        QStringLiteral("(?:\\b([a-z]+)[ \\x{a0}])?(§[0-9]+(?:\\.[0-9]+)*)"));
    QString last = chapter;
    qsizetype end = -1;
    for (auto found = citation.globalMatch(line); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        const bool isNamed = book.find(match.captured(1));
        const qsizetype begin = match.capturedStart(isNamed ? 0 : 2);
        const QString between = end < 0 ? QString() : line.mid(end, begin - end);
        if (isNamed)
            last = match.captured(1);
        else if (!goesOn(between))
            last = chapter;
        end = match.capturedEnd();
        const ManualPlace to{last, match.captured(2)};
        if (book.has(to)) links.append({begin, end - begin, to});
    }
}

void addEquations(const QString& line, const ManualBook& book, QList<ManualLink>& links) {
    static const QRegularExpression equation(QStringLiteral("\\([TSD][0-9]+\\)"));
    for (auto found = equation.globalMatch(line); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        for (const BookChapter& chapter : book.chapters())
            if (chapter.equations.contains(match.captured()))
                links.append(
                    {match.capturedStart(), match.capturedLength(), {chapter.name, match.captured()}});
    }
}

constexpr qreal narrowGap = 4, usualGap = 10, wideGap = 18;  // [px]
constexpr qreal codeMargin = 16;                             // [px]
constexpr qreal tableWidth = 98;    // per cent of the text, which leaves room for its lines
constexpr qreal lineSpacing = 125;  // per cent of the type

QColor mixed(const QColor& one, const QColor& other, double share) {
    const auto mix = [share](int a, int b) { return int(a + share * (b - a)); };
    return QColor(mix(one.red(), other.red()), mix(one.green(), other.green()),
                  mix(one.blue(), other.blue()));
}

// Moves the number of an equation, which is far to the right of it in a text of fixed width.
QString withNarrowFormulas(const QString& markdown) {
    static const QRegularExpression blanks(QStringLiteral("(?<=\\S) {4,}(?=\\[paper|\\([TSD][0-9]+\\))"));
    return QString(markdown).replace(blanks, QStringLiteral("   "));
}

void link(QTextCursor& cursor, const ManualPlace& to, const QColor& colour) {
    QTextCharFormat format;
    format.setAnchor(true);
    format.setAnchorHref(urlOf(to).toString());
    format.setForeground(colour);
    format.setFontUnderline(true);
    cursor.mergeCharFormat(format);
}

void linkCode(const QTextBlock& block, QTextCursor& cursor, const ManualBook& book,
              const ManualColours& colours) {
    struct Code {
        int begin, length;
        QString text;
    };
    QList<Code> codes;
    for (auto each = block.begin(); !each.atEnd(); ++each) {
        const QTextFragment piece = each.fragment();
        if (piece.charFormat().fontFixedPitch())
            codes.append({piece.position(), piece.length(), piece.text()});
    }
    for (const Code& code : codes) {
        cursor.setPosition(code.begin);
        cursor.setPosition(code.begin + code.length, QTextCursor::KeepAnchor);
        QTextCharFormat ground;
        ground.setBackground(colours.code);
        cursor.mergeCharFormat(ground);
        const ManualPlace to = placeOfCode(code.text, book);
        if (!to.chapter.isEmpty()) link(cursor, to, colours.link);
    }
}

bool isCode(const QTextBlock& block) {
    if (!block.isValid() || block.textList()) return false;
    const QTextBlockFormat format = block.blockFormat();
    if (format.headingLevel() > 0 || QTextCursor(block).currentTable()) return false;
    return format.hasProperty(QTextFormat::BlockCodeFence) || format.nonBreakableLines();
}

// Input to be typed and formulas may go on in the next line; output of a program keeps its columns.
bool mayBreak(const QTextBlock& block) {
    const QString language = block.blockFormat().stringProperty(QTextFormat::BlockCodeLanguage);
    return language == QStringLiteral("sh") || !block.blockFormat().hasProperty(QTextFormat::BlockCodeFence);
}

void layOut(const QTextBlock& block, QTextCursor& cursor, const ManualColours& colours) {
    cursor.setPosition(block.position());
    QTextBlockFormat format = block.blockFormat();
    const int level = format.headingLevel();
    if (level > 0) {
        format.setTopMargin(level < 3 ? wideGap : usualGap);
        format.setBottomMargin(narrowGap);
        cursor.setBlockFormat(format);
        cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
        QTextCharFormat type;
        type.setFontWeight(QFont::Bold);
        return cursor.mergeCharFormat(type);
    }
    if (isCode(block)) {
        format.setBackground(colours.code);
        format.setNonBreakableLines(!mayBreak(block));
        format.setLeftMargin(format.leftMargin() + codeMargin);
        format.setTopMargin(isCode(block.previous()) ? 0 : narrowGap);
        format.setBottomMargin(isCode(block.next()) ? 0 : usualGap);
    } else {
        format.setNonBreakableLines(false);
        format.setLineHeight(lineSpacing, QTextBlockFormat::ProportionalHeight);
        if (block.textList()) {
            format.setTopMargin(narrowGap / 2);
            format.setBottomMargin(narrowGap / 2);
        }
    }
    cursor.setBlockFormat(format);
}

// Returns widths by the words in the columns: each as wide as its longest word at least, and the rest of a
// line of so many characters by their amount of text. A key may go on in the next line at its dots.
QList<QTextLength> columnWidths(const QTextTable& table, qsizetype line) {
    constexpr qsizetype longestWord = 15, longestText = 60, sides = 3;  // characters
    static const QRegularExpression blank(QStringLiteral("[\\s.]"));
    QList<qsizetype> words, texts;
    qsizetype allWords = 0, allTexts = 0;
    for (int column = 0; column < table.columns(); ++column) {
        qsizetype word = 3, text = 3;
        for (int row = 0; row < table.rows(); ++row) {
            const QString cell = table.cellAt(row, column).firstCursorPosition().block().text();
            text = std::max(text, cell.size());
            const qsizetype bold = row == 0 ? 2 : 0;  // which is wider
            for (const QString& each : cell.split(blank)) word = std::max(word, each.size() + bold);
        }
        words.append(std::min(word, longestWord) + sides);
        texts.append(std::min(text, longestText));
        allWords += words.last();
        allTexts += texts.last();
    }
    const double rest = double(std::max<qsizetype>(line - allWords, 0)), all = double(allWords) + rest;
    QList<QTextLength> widths;
    for (int column = 0; column < table.columns(); ++column)
        widths.append(QTextLength(
            QTextLength::PercentageLength,
            100 * (double(words[column]) + rest * double(texts[column]) / double(allTexts)) / all));
    return widths;
}

void layOut(QTextTable& table, const ManualColours& colours, qsizetype line) {
    QTextTableFormat format = table.format();
    format.setBorder(1);
    format.setBorderCollapse(true);
    format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    format.setBorderBrush(colours.line);
    format.setCellPadding(narrowGap);
    format.setCellSpacing(0);
    format.setTopMargin(narrowGap);
    format.setBottomMargin(usualGap);
    format.setWidth(QTextLength(QTextLength::PercentageLength, tableWidth));
    format.setColumnWidthConstraints(columnWidths(table, line));
    table.setFormat(format);
    for (int column = 0; column < table.columns(); ++column) {
        QTextTableCell cell = table.cellAt(0, column);
        QTextCharFormat head = cell.format();
        head.setBackground(colours.code);
        cell.setFormat(head);
    }
}

}  // namespace

QList<ManualLink> linksIn(const QString& line, const QString& chapter, const ManualBook& book) {
    QList<ManualLink> links;
    addSections(line, chapter, book, links);
    addEquations(line, book, links);
    std::ranges::sort(links, {}, &ManualLink::begin);
    return links;
}

ManualPlace placeOfCode(const QString& code, const ManualBook& book) {
    static const QRegularExpression page(QStringLiteral("^([a-z]+)\\.md$")),
        command(QStringLiteral("^drillwave ([a-z]+)"));
    if (const auto match = page.match(code); match.hasMatch() && book.find(match.captured(1)))
        return {match.captured(1)};
    if (const auto match = command.match(code); match.hasMatch()) {
        const ManualPlace to{QStringLiteral("commands"), match.captured(1)};
        return book.has(to) ? to : ManualPlace();
    }
    if (findOutput(code.toStdString())) return {QStringLiteral("outputs"), code};
    const ManualPlace parameter = placeOfKey(code);
    return book.has(parameter) ? parameter : ManualPlace();
}

ManualColours manualColours(const QPalette& palette) {
    const bool dark = isDark(palette.color(QPalette::Base));
    const QColor base = palette.color(QPalette::Base), text = palette.color(QPalette::Text);
    return {.link = dark ? QColor(0x7c, 0xbd, 0xf5) : QColor(0x0b, 0x57, 0xa4),
            .code = mixed(base, text, 0.07),
            .line = mixed(base, text, 0.35),
            .mark = QColor(0xff, 0xd9, 0x66),
            .markedText = Qt::black};
}

void setChapter(QTextDocument& document, const BookChapter& chapter, const ManualBook& book, qreal width,
                const QPalette& palette) {
    const auto charactersOfLine = qsizetype(width / QFontMetricsF(document.defaultFont()).averageCharWidth());
    const ManualColours colours = manualColours(palette);
    document.setMarkdown(withNarrowFormulas(chapter.markdown), QTextDocument::MarkdownDialectGitHub);
    QTextCursor cursor(&document);
    cursor.beginEditBlock();
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        layOut(block, cursor, colours);
        const bool isHeading = block.blockFormat().headingLevel() > 0;
        if (isHeading) continue;
        for (const ManualLink& each : linksIn(block.text(), chapter.name, book)) {
            cursor.setPosition(block.position() + int(each.begin));
            cursor.setPosition(block.position() + int(each.begin + each.length), QTextCursor::KeepAnchor);
            link(cursor, each.to, colours.link);
        }
        linkCode(block, cursor, book, colours);
    }
    cursor.endEditBlock();
    for (QTextFrame* frame : document.rootFrame()->childFrames())
        if (auto* table = qobject_cast<QTextTable*>(frame)) layOut(*table, colours, charactersOfLine);
}

QTextBlock blockOf(const QTextDocument& document, const QString& heading) {
    if (heading.isEmpty()) return document.begin();
    QTextBlock found = document.begin();
    for (QTextBlock block = document.end().previous(); block.isValid(); block = block.previous()) {
        const bool isTitle = block.blockFormat().headingLevel() > 0;
        // A heading with exactly these words comes before those that only begin with them.
        if (isTitle && block.text() == heading) return block;
        if (isTitle ? isHeading(block.text(), heading)
                    : heading.startsWith(u'(') && block.text().endsWith(u' ' + heading))
            found = block;
    }
    return found;
}

}  // namespace drillwave
