// SPDX-License-Identifier: GPL-3.0-or-later
// Long words leave room for what stands below them, and can all be read.
#include <QLabel>
#include <QScrollBar>
#include <QTest>
#include <QVBoxLayout>

#include "ui/text/scrolled_label.h"

using namespace drillwave;

namespace {

/// Words above something that takes the rest of a window.
struct Window {
    QWidget window;
    QLabel* label = new QLabel;
    QWidget* below = new QWidget;
    ScrolledLabel* words = nullptr;

    explicit Window(QSize size) {
        label->setWordWrap(true);
        constexpr double share = 0.1;
        words = new ScrolledLabel(label, share, &window);
        auto* layout = new QVBoxLayout(&window);
        layout->setContentsMargins(0, 0, 0, 0);
        layout->addWidget(words);
        layout->addWidget(below, 1);
        window.resize(size);
        window.show();
    }
    void say(int sentences) {
        words->setText(QStringLiteral("A sentence of a few words that takes its room. ").repeated(sentences));
        window.layout()->activate();
        QCoreApplication::processEvents();
    }
    int line() const { return label->fontMetrics().lineSpacing(); }
};

}  // namespace

class TestScrolledLabel : public QObject {
    Q_OBJECT

  private slots:
    void fewWordsTakeNoMoreThanTheyNeed();
    void manyWordsTakeTheirShareAndScroll();
    void theShareFollowsTheWindow();
    void twoLinesAreAlwaysThere();
};

void TestScrolledLabel::fewWordsTakeNoMoreThanTheyNeed() {
    Window shown({600, 900});
    shown.say(1);
    QVERIFY(shown.words->height() < 2 * shown.line());
    QVERIFY(!shown.words->verticalScrollBar()->isVisible());
}

void TestScrolledLabel::manyWordsTakeTheirShareAndScroll() {
    Window shown({600, 900});
    shown.say(60);
    QCOMPARE(shown.words->height(), 90);
    QCOMPARE(shown.below->height(), 900 - 90 - shown.window.layout()->spacing());
    QVERIFY(shown.words->verticalScrollBar()->isVisible());
    // The last line can be brought there.
    QVERIFY(shown.label->height() >= shown.label->heightForWidth(shown.label->width()));
    shown.words->verticalScrollBar()->setValue(shown.words->verticalScrollBar()->maximum());
    QVERIFY(shown.label->geometry().bottom() <= shown.words->viewport()->height());
    // Other words are read from their beginning.
    shown.say(50);
    QCOMPARE(shown.words->verticalScrollBar()->value(), 0);
}

void TestScrolledLabel::theShareFollowsTheWindow() {
    Window shown({600, 900});
    shown.say(60);
    shown.window.resize(600, 600);
    QCoreApplication::processEvents();
    QCOMPARE(shown.words->height(), 60);
}

void TestScrolledLabel::twoLinesAreAlwaysThere() {
    Window shown({600, 120});
    shown.say(60);
    QVERIFY(shown.words->height() >= 2 * shown.line());
}

QTEST_MAIN(TestScrolledLabel)
#include "tst_scrolled_label.moc"
