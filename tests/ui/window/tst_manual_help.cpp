// SPDX-License-Identifier: GPL-3.0-or-later
// The manual beside the window: F1 leads to what one works at.
#include <QAction>
#include <QPointer>
#include <QTest>
#include <QTextBlock>

#include "core/yaml/examples.h"
#include "tests/support/window_fixture.h"
#include "ui/help/help_topic.h"
#include "ui/help/help_window.h"
#include "ui/text/language.h"
#include "ui/window/manual_help.h"
#include "ui/window/page_tabs.h"

using namespace drillwave;
using namespace drillwave::test;

class TestManualHelp : public QObject, WindowFixture {
    Q_OBJECT

  private slots:
    void init() { start(); }
    void cleanup() {
        m_window.reset();
        speak(languages[0]);
    }

    void f1InAFieldOpensItsParameter();
    void f1OnAPageOpensWhatThePageShows();
    void everyPageHasASection_data();
    void everyPageHasASection();
    void theManualSpeaksTheLanguageOfTheWindow();
    void partsOfTheWindowHaveTheirSections();
    void theManualStaysWhileOneWorks();
    void theManualIsThereAgainWhereItWasLeft();
    void theKeysOfMenusAreListed();
    void theManualGoesWithTheWindow();

  private:
    ManualHelp& manual() { return part<ManualHelp>(window()); }
    HelpView& view() { return manual().helpWindow()->view(); }
    void pressF1() { QTest::keyClick(&window(), Qt::Key_F1); }
};

void TestManualHelp::f1InAFieldOpensItsParameter() {
    field("bit_rock.gamma").setFocus();
    pressF1();
    QVERIFY(manual().helpWindow()->isVisible());
    QCOMPARE(view().place(), (ManualPlace{QStringLiteral("parameters"), QStringLiteral("bit_rock.gamma")}));
    QCOMPARE(view().textCursor().block().text(), QStringLiteral("bit_rock.gamma: elasticity γ"));
    QVERIFY(view().viewport()->rect().contains(view().cursorRect().center()));
}

void TestManualHelp::f1OnAPageOpensWhatThePageShows() {
    part<PageTabs>(window()).current().setFocus();
    part<PageTabs>(window()).setFocus();
    pressF1();
    QCOMPARE(view().place(), (ManualPlace{QStringLiteral("window"), QStringLiteral("Blow")}));
    QCOMPARE(view().textCursor().block().text(), QStringLiteral("§4 Blow"));
}

void TestManualHelp::everyPageHasASection_data() {
    QTest::addColumn<QString>("code");
    for (const Language& language : languages)
        QTest::newRow(language.code.data()) << QString::fromLatin1(language.code.data());
}

void TestManualHelp::everyPageHasASection() {
    QFETCH(QString, code);
    const Language& language = *findLanguage(code.toStdString());
    const ManualBook book(language);
    speak(language);
    m_window.reset();
    makeWindow(exactSolve());
    auto& pages = part<PageTabs>(window());
    for (const char* example : {"t38_medium_rock", "t38_string"}) {
        window().openExample(*findExample(example));
        for (int index = 0; index < pages.count(); ++index) {
            pages.setCurrentIndex(index);
            pages.page(index).setFocus();
            const ManualPlace place{QStringLiteral("window"),
                                    pages.page(index).title().section(QStringLiteral(" ("), 0, 0)};
            QVERIFY2(book.has(place), qPrintable(place.heading));
        }
    }
}

void TestManualHelp::theManualSpeaksTheLanguageOfTheWindow() {
    speak(*findLanguage("de"));
    m_window.reset();
    makeWindow(exactSolve());
    part<PageTabs>(window()).current().setFocus();
    part<PageTabs>(window()).setFocus();
    pressF1();
    QCOMPARE(view().textCursor().block().text(), QStringLiteral("§4 Schlag"));
    field("bit_rock.gamma").setFocus();
    pressF1();
    QVERIFY(view().textCursor().block().text().startsWith(QStringLiteral("bit_rock.gamma: Elastizität")));
    manual().showAt({QStringLiteral("keys")});
    QVERIFY(view().toPlainText().contains(QStringLiteral("Strg+Z")));
    QVERIFY(!view().toPlainText().contains(QStringLiteral("Ctrl+")));
    // Words of the window lead to the chapters that are in English, too, behind those of its language.
    HelpWindow& help = *manual().helpWindow();
    help.search().setText(QStringLiteral("Andruck"));
    QListWidgetItem* inEnglish = nullptr;
    for (int i = help.hits().count() - 1; i >= 0; --i)
        if (help.hits().item(i)->text().startsWith(QStringLiteral("Theory"))) inEnglish = help.hits().item(i);
    QVERIFY(help.hits().item(0)->text().contains(QStringLiteral("Andruck")));
    QVERIFY(inEnglish);
    emit help.hits().itemActivated(inEnglish);
    QCOMPARE(view().place().chapter, QStringLiteral("theory"));
    const QList<QTextEdit::ExtraSelection> marks = view().extraSelections();
    QVERIFY(!marks.isEmpty());
    const QString found = marks.first().cursor.selectedText().toLower();
    QVERIFY2(found == "feed" || found == "thrust", qPrintable(found));
}

void TestManualHelp::partsOfTheWindowHaveTheirSections() {
    const ManualBook book(languages[0]);
    int parts = 0;
    for (const QWidget* each : window().findChildren<QWidget*>()) {
        const QString topic = each->property(helpTopicProperty).toString();
        if (topic.isEmpty()) continue;
        QVERIFY2(book.has({topic.section(u' ', 0, 0), topic.section(u' ', 1)}), qPrintable(topic));
        ++parts;
    }
    QCOMPARE(parts, 2);
}

void TestManualHelp::theManualStaysWhileOneWorks() {
    pressF1();
    HelpWindow* first = manual().helpWindow();
    window().activateWindow();
    type(field("rod.length"), QStringLiteral("4 m"));
    QVERIFY(first->isVisible());
    pressF1();
    QCOMPARE(manual().helpWindow(), first);
    QCOMPARE(view().place().heading, QStringLiteral("rod.length"));
}

void TestManualHelp::theManualIsThereAgainWhereItWasLeft() {
    pressF1();
    HelpWindow& help = *manual().helpWindow();
    help.resize(700, 500);
    help.move(40, 50);
    const QPoint place = help.pos();
    help.close();
    m_window.reset();
    makeWindow(exactSolve());
    pressF1();
    QCOMPARE(manual().helpWindow()->size(), QSize(700, 500));
    QCOMPARE(manual().helpWindow()->pos(), place);
}

void TestManualHelp::theKeysOfMenusAreListed() {
    manual().showAt({QStringLiteral("keys")});
    const QString text = view().toPlainText();
    for (const char* key : {"F1", "F7", "Ctrl+Z", "Ctrl+R", "Wheel"})
        QVERIFY2(text.contains(QLatin1String(key)), key);
    int actions = 0;
    for (const QAction* action : window().findChildren<QAction*>())
        if (!action->shortcut().isEmpty() && text.contains(action->shortcut().toString())) ++actions;
    QVERIFY(actions > 20);
}

void TestManualHelp::theManualGoesWithTheWindow() {
    pressF1();
    const QPointer<HelpWindow> help = manual().helpWindow();
    m_window.reset();
    QVERIFY(!help);
}

QTEST_MAIN(TestManualHelp)
#include "tst_manual_help.moc"
