// SPDX-License-Identifier: GPL-3.0-or-later
// The window of the manual: chapters, links, search, keys.
#include <QApplication>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBlock>
#include <memory>

#include "core/blow/outputs.h"
#include "core/model/parameter.h"
#include "tests/support/contrast.h"
#include "tests/support/themes.h"
#include "tests/support/window.h"
#include "ui/help/help_topic.h"
#include "ui/help/help_window.h"
#include "ui/help/manual_document.h"
#include "ui/help/manual_search.h"
#include "ui/text/language.h"
#include "ui/text/settings.h"

using namespace drillwave;
using test::contrast, test::leastContrast;

namespace {

QString at(const QString& chapter, const QString& heading = {}) {
    return urlOf({chapter, heading}).toString();
}

/// The text that is a link, and where each leads.
QHash<QString, QString> linksOf(const QTextDocument& document) {
    QHash<QString, QString> links;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
        for (auto each = block.begin(); !each.atEnd(); ++each)
            if (each.fragment().charFormat().isAnchor())
                links.insert(each.fragment().text(), each.fragment().charFormat().anchorHref());
    return links;
}

}  // namespace

class TestHelpWindow : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { test::keepSettingsIn(m_folder.filePath(QStringLiteral("settings"))); }
    void init();
    void cleanup() { m_help.reset(); }

    void everyChapterIsInTheContents();
    void everyHeadingOfTheContentsIsFound();
    void citationsAndNamesAreLinks();
    void linksLeadToPlacesThatAreThere();
    void aCitationBehindAnotherIsOfItsChapter();
    void aLinkLeadsThereAndBackLeadsBack();
    void everyParameterHasItsPlace();
    void searchLooksInAllChaptersForAllWords();
    void whatIsFoundIsMarkedAndInView();
    void nothingFoundIsSaid();
    void zoomIsKeptForTheNextTime();
    void escapeLeavesTheSearchAndThenTheWindow();
    void textAndLinksStandOutInBothThemes();
    void picturesAreThereAndNoWiderThanTheText();
    void formulasKeepTheirLinesWithinTheWidth();
    // The last: what is spoken stays.
    void wordsOfTheWindowAreFoundInEveryLanguage_data();
    void wordsOfTheWindowAreFoundInEveryLanguage();

  private:
    HelpView& view() { return m_help->view(); }

    QTemporaryDir m_folder;
    std::unique_ptr<HelpWindow> m_help;
};

void TestHelpWindow::init() {
    Settings().clear();
    m_help = std::make_unique<HelpWindow>(ManualBook(languages[0]), nullptr);
    m_help->resize(820, 760);
    m_help->open({QStringLiteral("theory"), QStringLiteral("§3")});
    QVERIFY(QTest::qWaitForWindowActive(m_help.get()));
}

void TestHelpWindow::everyChapterIsInTheContents() {
    QCOMPARE(m_help->contents().topLevelItemCount(), int(chapterNames().size()));
    QVERIFY(m_help->contents().currentItem()->text(0).startsWith(QStringLiteral("§3 ")));
}

void TestHelpWindow::everyHeadingOfTheContentsIsFound() {
    const ManualBook book(languages[0]);
    for (const BookChapter& chapter : book.chapters()) {
        QTextDocument document;
        setChapter(document, chapter, book, 600, QApplication::palette());
        for (const BookChapter::Heading& heading : chapter.headings) {
            if (heading.level == 1) continue;
            QCOMPARE(blockOf(document, heading.text).text(), heading.text);
        }
        for (const QString& equation : chapter.equations)
            QVERIFY2(blockOf(document, equation).text().endsWith(equation), qPrintable(equation));
    }
}

void TestHelpWindow::citationsAndNamesAreLinks() {
    view().go({QStringLiteral("window")});
    const QHash<QString, QString> links = linksOf(*view().document());
    QCOMPARE(links.value(QStringLiteral("theory §10")), at("theory", "§10"));
    QCOMPARE(links.value(QStringLiteral("drillwave gap")), at("commands", "gap"));
    view().go({QStringLiteral("files")});
    QCOMPARE(linksOf(*view().document()).value(QStringLiteral("bit_rock.gamma")),
             at("parameters", "bit_rock.gamma"));
    view().go({QStringLiteral("strings")});
    QCOMPARE(linksOf(*view().document()).value(QStringLiteral("theory.md")), at("theory"));
}

void TestHelpWindow::linksLeadToPlacesThatAreThere() {
    const ManualBook book(languages[0]);
    int links = 0;
    for (const BookChapter& chapter : book.chapters()) {
        view().go({chapter.name});
        for (const QString& target : linksOf(*view().document())) {
            QVERIFY2(book.has(placeOf(QUrl(target))), qPrintable(target));
            ++links;
        }
    }
    QVERIFY2(links > 200, QByteArray::number(links));
}

void TestHelpWindow::aCitationBehindAnotherIsOfItsChapter() {
    const ManualBook book(languages[0]);
    const auto links =
        linksIn(QStringLiteral("see theory §1 and §2, (T34); here §3"), QStringLiteral("files"), book);
    QCOMPARE(links.size(), 4);
    QCOMPARE(links[1].to, (ManualPlace{QStringLiteral("theory"), QStringLiteral("§2")}));
    QCOMPARE(links[2].to, (ManualPlace{QStringLiteral("theory"), QStringLiteral("(T34)")}));
    QCOMPARE(links[3].to, (ManualPlace{QStringLiteral("files"), QStringLiteral("§3")}));
}

void TestHelpWindow::aLinkLeadsThereAndBackLeadsBack() {
    view().verticalScrollBar()->setValue(view().verticalScrollBar()->value() + 40);
    const int before = view().verticalScrollBar()->value();
    emit view().anchorClicked(urlOf({QStringLiteral("files"), QStringLiteral("§4")}));
    QCOMPARE(view().place().chapter, QStringLiteral("files"));
    QVERIFY(view().verticalScrollBar()->value() > 0);
    QTest::keyClick(m_help.get(), Qt::Key_Left, Qt::AltModifier);
    QCOMPARE(view().place().chapter, QStringLiteral("theory"));
    QCOMPARE(view().verticalScrollBar()->value(), before);
    QTest::keyClick(m_help.get(), Qt::Key_Right, Qt::AltModifier);
    QCOMPARE(view().place(), (ManualPlace{QStringLiteral("files"), QStringLiteral("§4")}));
    QVERIFY(!view().hasForward());
}

void TestHelpWindow::everyParameterHasItsPlace() {
    const ManualBook book(languages[0]);
    for (const Parameter& parameter : parameters()) {
        const QString key = QString::fromUtf8(parameter.key.data(), qsizetype(parameter.key.size()));
        QVERIFY2(book.has(placeOfKey(key)), qPrintable(key));
    }
    for (const char* key : {"string.rod.length", "hammer.1.diameter", "bit_rock.corner.3.slope",
                            "pulse.shape", "hammer.restrike"})
        QVERIFY2(book.has(placeOfKey(QLatin1String(key))), key);
    QWidget field;
    QWidget inside(&field);
    field.setObjectName(QStringLiteral("rod.length.slider"));
    QCOMPARE(topicOf(&inside), (ManualPlace{QStringLiteral("parameters"), QStringLiteral("rod.length")}));
}

void TestHelpWindow::searchLooksInAllChaptersForAllWords() {
    QTest::keyClick(m_help.get(), Qt::Key_F, Qt::ControlModifier);
    QCOMPARE(m_help->focusWidget(), &m_help->search());
    QTest::keyClicks(&m_help->search(), QStringLiteral("SUPER rebound"));
    QVERIFY(m_help->hits().count() > 3);
    QVERIFY(m_help->hits().isVisible());
    const ManualSearch sections{ManualBook(languages[0])};
    QStringList chapters;
    for (const ManualHit& hit : sections.find(soughtWords(QStringLiteral("impedance"))))
        chapters << hit.chapter;
    QVERIFY2(QSet<QString>(chapters.begin(), chapters.end()).size() >= 4, qPrintable(chapters.join(u'\n')));
    QVERIFY(sections.find(soughtWords(QStringLiteral("impedance unheardofword"))).isEmpty());
    QVERIFY(sections.find({}).isEmpty());
    QCOMPARE(soughtWords(QStringLiteral("a \"b c\" d")),
             (QStringList{QStringLiteral("a"), QStringLiteral("b c"), QStringLiteral("d")}));
    // A name with a heading of its own is found there first.
    QCOMPARE(sections.find({QStringLiteral("wave_loss")}).first().place.heading,
             QStringLiteral("drill.wave_loss: wave loss η"));
}

void TestHelpWindow::wordsOfTheWindowAreFoundInEveryLanguage_data() {
    QTest::addColumn<QString>("code");
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("english");
    QTest::newRow("thrust, de") << "de"
                                << "andruck"
                                << "thrust";
    QTest::newRow("thrust, sv") << "sv"
                                << "matningskraft"
                                << "thrust";
    QTest::newRow("restitution, de") << "de" << QStringLiteral("Stoßzahl") << "restitution";
    QTest::newRow("restitution, sv") << "sv"
                                     << "studstal"
                                     << "restitution";
    QTest::newRow("stiffness, de") << "de"
                                   << "Steifigkeit"
                                   << "stiffness";
}

void TestHelpWindow::wordsOfTheWindowAreFoundInEveryLanguage() {
    QFETCH(QString, code);
    QFETCH(QString, typed);
    QFETCH(QString, english);
    const Language& language = *findLanguage(code.toStdString());
    QVERIFY2(!englishOf(typed, language).filter(english).isEmpty(),
             qPrintable(englishOf(typed, language).join(u'|')));
    speak(language);
    m_help->search().setText(typed);
    QVERIFY(m_help->hits().count() > 0);
    QVERIFY(m_help->hits().item(0)->flags() != Qt::NoItemFlags);
    QVERIFY(englishOf(typed, languages[0]).isEmpty());
}

void TestHelpWindow::whatIsFoundIsMarkedAndInView() {
    m_help->search().setText(QStringLiteral("chatter"));
    QTest::keyClick(&m_help->search(), Qt::Key_Return);
    const QList<QTextEdit::ExtraSelection> marks = view().extraSelections();
    QVERIFY(!marks.isEmpty());
    const bool isSeen = std::ranges::any_of(marks, [this](const QTextEdit::ExtraSelection& mark) {
        return view().viewport()->rect().contains(view().cursorRect(mark.cursor).center());
    });
    QVERIFY(isSeen);
    m_help->search().clear();
    QVERIFY(view().extraSelections().isEmpty());
    QVERIFY(m_help->contents().isVisible());
}

void TestHelpWindow::nothingFoundIsSaid() {
    m_help->search().setText(QStringLiteral("unheardofword"));
    QCOMPARE(m_help->hits().count(), 1);
    QVERIFY(m_help->hits().item(0)->text().startsWith(QStringLiteral("No section")));
    QTest::keyClick(&m_help->search(), Qt::Key_Return);
    QCOMPARE(view().place().chapter, QStringLiteral("theory"));
}

void TestHelpWindow::zoomIsKeptForTheNextTime() {
    const qreal usual = view().font().pointSizeF();
    QTest::keyClick(m_help.get(), Qt::Key_Plus, Qt::ControlModifier);
    QTest::keyClick(m_help.get(), Qt::Key_Plus, Qt::ControlModifier);
    QCOMPARE(view().zoom(), 120);
    QVERIFY(view().font().pointSizeF() > usual);
    m_help->close();
    m_help = std::make_unique<HelpWindow>(ManualBook(languages[0]), nullptr);
    QCOMPARE(view().zoom(), 120);
    m_help->show();
    QVERIFY(QTest::qWaitForWindowActive(m_help.get()));
    QTest::keyClick(m_help.get(), Qt::Key_0, Qt::ControlModifier);
    QCOMPARE(view().zoom(), 100);
}

void TestHelpWindow::escapeLeavesTheSearchAndThenTheWindow() {
    m_help->search().setText(QStringLiteral("gap"));
    QTest::keyClick(m_help.get(), Qt::Key_Escape);
    QVERIFY(m_help->isVisible());
    QVERIFY(m_help->search().text().isEmpty());
    QTest::keyClick(m_help.get(), Qt::Key_Escape);
    QVERIFY(!m_help->isVisible());
}

void TestHelpWindow::textAndLinksStandOutInBothThemes() {
    for (const QPalette& palette : {lightPalette(), darkPalette()}) {
        const ManualColours colours = manualColours(palette);
        const QColor base = palette.color(QPalette::Base);
        for (const QColor& ground : {base, colours.code}) {
            QVERIFY2(contrast(colours.link, ground) >= leastContrast, qPrintable(colours.link.name()));
            QVERIFY2(contrast(palette.color(QPalette::Text), ground) >= leastContrast,
                     qPrintable(ground.name()));
        }
        QVERIFY(contrast(colours.markedText, colours.mark) >= leastContrast);
    }
    m_help->setPalette(darkPalette());
    QTRY_COMPARE(linksOf(*view().document()).isEmpty(), false);
    QTRY_VERIFY([this] {
        for (QTextBlock block = view().document()->begin(); block.isValid(); block = block.next())
            for (auto each = block.begin(); !each.atEnd(); ++each)
                if (each.fragment().charFormat().isAnchor())
                    return each.fragment().charFormat().foreground().color() ==
                           manualColours(darkPalette()).link;
        return false;
    }());
}

void TestHelpWindow::picturesAreThereAndNoWiderThanTheText() {
    const QVariant picture =
        view().loadResource(QTextDocument::ImageResource, QUrl(QStringLiteral("../screenshots/blow.png")));
    const auto image = picture.value<QImage>();
    QVERIFY(image.width() > 200);
    QVERIFY(image.deviceIndependentSize().width() <= view().viewport()->width());
    QVERIFY(!view().loadResource(QTextDocument::ImageResource, QUrl(QStringLiteral("/etc/x.png"))).isValid());
}

void TestHelpWindow::formulasKeepTheirLinesWithinTheWidth() {
    // The others have what programs print, whose columns stay.
    for (const char* name : {"theory", "strings", "drilling", "glossary", "keys", "window", "parameters"}) {
        view().go({QLatin1String(name)});
        QTRY_COMPARE(view().horizontalScrollBar()->maximum(), 0);
    }
}

QTEST_MAIN(TestHelpWindow)
#include "tst_help_window.moc"
