// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/help_window.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/text/language.h"
#include "ui/text/settings.h"

namespace drillwave {
namespace {

const QString geometryKey = QStringLiteral("help/geometry");
const QString partsKey = QStringLiteral("help/parts");
const QString zoomKey = QStringLiteral("help/zoom");

constexpr QSize usualSize{820, 760};
constexpr int sideWidth = 220, leastSide = 120, leastView = 240;  // [px]
constexpr int usualZoom = 100, zoomStep = 10;                     // [%]
constexpr int placeRole = Qt::UserRole, wordsRole = placeRole + 1;

QTreeWidgetItem* contentsItem(const QString& text, const ManualPlace& place) {
    auto* item = new QTreeWidgetItem({text});
    item->setData(0, placeRole, urlOf(place));
    item->setToolTip(0, text);
    return item;
}

}  // namespace

HelpWindow::HelpWindow(ManualBook book, QWidget* owner)
    : QWidget(owner, Qt::Window),
      m_book(std::move(book)),
      m_search(new QLineEdit(this)),
      m_contents(new QTreeWidget(this)),
      m_hits(new QListWidget(this)),
      m_side(new QStackedWidget(this)),
      m_parts(new QSplitter(this)),
      m_view(new HelpView(m_book, this)),
      m_back(new QAction(style()->standardIcon(QStyle::SP_ArrowBack), QString(), this)),
      m_forward(new QAction(style()->standardIcon(QStyle::SP_ArrowForward), QString(), this)) {
    setObjectName(QStringLiteral("help"));
    setWindowTitle(tr("Manual — Drillwave"));
    m_back->setToolTip(tr("Back (Alt+Left)"));
    m_forward->setToolTip(tr("On (Alt+Right)"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 0);
    layout->addLayout(makeBar());
    layout->addWidget(m_parts, 1);
    m_side->addWidget(m_contents);
    m_side->addWidget(m_hits);
    m_side->setMinimumWidth(leastSide);
    m_view->setMinimumWidth(leastView);
    m_parts->addWidget(m_side);
    m_parts->addWidget(m_view);
    m_parts->setStretchFactor(1, 1);
    m_parts->setSizes({sideWidth, usualSize.width() - sideWidth});
    m_hits->setAccessibleName(tr("Sections found"));
    m_hits->setWordWrap(true);
    m_hits->setAlternatingRowColors(true);
    m_hits->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    fillContents();

    connect(m_back, &QAction::triggered, m_view, &HelpView::backward);
    connect(m_forward, &QAction::triggered, m_view, &HelpView::forward);
    addAction(tr("Search"), {QKeySequence::Find}, [this] {
        m_search->setFocus();
        m_search->selectAll();
    });
    addAction(tr("Close"), {Qt::Key_Escape}, [this] { leave(); });
    addAction(tr("Larger"), {QKeySequence::ZoomIn, Qt::CTRL | Qt::Key_Equal},
              [this] { m_view->setZoom(m_view->zoom() + zoomStep); });
    addAction(tr("Smaller"), {QKeySequence::ZoomOut}, [this] { m_view->setZoom(m_view->zoom() - zoomStep); });
    addAction(tr("Usual size"), {Qt::CTRL | Qt::Key_0}, [this] { m_view->setZoom(usualZoom); });
    connect(m_search, &QLineEdit::textChanged, this, &HelpWindow::find);
    connect(m_search, &QLineEdit::returnPressed, this, [this] {
        if (m_hits->count() > 0) openHit(m_hits->item(std::max(0, m_hits->currentRow())));
    });
    connect(m_hits, &QListWidget::itemActivated, this, &HelpWindow::openHit);
    connect(m_hits, &QListWidget::itemClicked, this, &HelpWindow::openHit);
    const auto openContents = [this](const QTreeWidgetItem* item) {
        m_view->go(placeOf(item->data(0, placeRole).toUrl()));
    };
    connect(m_contents, &QTreeWidget::itemActivated, this, openContents);
    connect(m_contents, &QTreeWidget::itemClicked, this, openContents);
    connect(m_view, &HelpView::placeChanged, this, &HelpWindow::follow);
    const Settings settings;
    m_view->setZoom(settings.value(zoomKey, usualZoom).toInt());
    m_parts->restoreState(settings.value(partsKey).toByteArray());
    m_view->go({m_book.chapters().first().name});
}

void HelpWindow::addAction(const QString& text, const QList<QKeySequence>& keys,
                           const std::function<void()>& does) {
    auto* action = new QAction(text, this);
    action->setShortcuts(keys);
    connect(action, &QAction::triggered, this, does);
    QWidget::addAction(action);
}

QLayout* HelpWindow::makeBar() {
    auto* bar = new QHBoxLayout;
    m_back->setShortcuts({Qt::ALT | Qt::Key_Left, Qt::Key_Back});
    m_forward->setShortcuts({Qt::ALT | Qt::Key_Right, Qt::Key_Forward});
    for (QAction* action : {m_back, m_forward}) {
        auto* button = new QToolButton(this);
        button->setDefaultAction(action);
        button->setAutoRaise(true);
        button->setAccessibleName(action->toolTip());
        button->setFocusPolicy(Qt::TabFocus);
        action->setEnabled(false);
        bar->addWidget(button);
        QWidget::addAction(action);
    }
    m_search->setPlaceholderText(tr("Search all chapters (Ctrl+F)"));
    m_search->setAccessibleName(tr("Search all chapters"));
    m_search->setClearButtonEnabled(true);
    bar->addWidget(m_search, 1);
    return bar;
}

void HelpWindow::fillContents() {
    m_contents->setAccessibleName(tr("Contents"));
    m_contents->setHeaderHidden(true);
    m_contents->header()->setStretchLastSection(true);
    for (const BookChapter& chapter : m_book.chapters()) {
        QTreeWidgetItem* top = contentsItem(chapter.title, {chapter.name});
        m_contents->addTopLevelItem(top);
        QTreeWidgetItem* above = top;
        for (const BookChapter::Heading& heading : chapter.headings) {
            if (heading.level == 1) continue;
            QTreeWidgetItem* item = contentsItem(heading.text, {chapter.name, heading.text});
            (heading.level == 2 ? top : above)->addChild(item);
            if (heading.level == 2) above = item;
        }
    }
}

void HelpWindow::find(const QString& typed) {
    const QStringList words = soughtWords(typed);
    m_hits->clear();
    const QList<ManualHit> found = m_sections.find(words);
    for (const ManualHit& hit : found) addHit(hit, words);
    // Some chapters are in English; whoever reads the window in another language has its words.
    for (const QString& english : englishOf(typed, spokenLanguage())) {
        const QStringList others = soughtWords(english);
        const QList<ManualHit> more = m_sections.find(others);
        for (const ManualHit& hit : more)
            if (std::ranges::find(found, hit.place, &ManualHit::place) == found.end()) addHit(hit, others);
        if (!more.isEmpty()) break;
    }
    if (!words.isEmpty() && m_hits->count() == 0) {
        auto* none = new QListWidgetItem(tr("No section has all of these words."), m_hits);
        none->setFlags(Qt::NoItemFlags);
    }
    m_side->setCurrentWidget(words.isEmpty() ? static_cast<QWidget*>(m_contents) : m_hits);
    m_view->mark(words);
}

void HelpWindow::addHit(const ManualHit& hit, const QStringList& words) {
    const QString title = hit.heading == hit.chapter ? hit.chapter : hit.chapter + u'\n' + hit.heading;
    auto* item = new QListWidgetItem(hit.excerpt.isEmpty() ? title : title + u'\n' + hit.excerpt, m_hits);
    item->setData(placeRole, urlOf(hit.place));
    item->setData(wordsRole, words);
}

void HelpWindow::openHit(QListWidgetItem* item) {
    const ManualPlace place = placeOf(item->data(placeRole).toUrl());
    if (place.chapter.isEmpty()) return;
    m_hits->setCurrentItem(item);
    m_view->go(place);
    m_view->mark(item->data(wordsRole).toStringList());
}

// The chapter on show is the one that is open in the contents.
void HelpWindow::follow(const ManualPlace& place) {
    m_back->setEnabled(m_view->hasBackward());
    m_forward->setEnabled(m_view->hasForward());
    for (int i = 0; i < m_contents->topLevelItemCount(); ++i) {
        QTreeWidgetItem* chapter = m_contents->topLevelItem(i);
        if (placeOf(chapter->data(0, placeRole).toUrl()).chapter != place.chapter) continue;
        QTreeWidgetItem* found = chapter;
        for (QTreeWidgetItemIterator each(chapter); *each; ++each) {
            const ManualPlace told = placeOf((*each)->data(0, placeRole).toUrl());
            if (told.chapter != place.chapter) break;
            if (place.heading.isEmpty() || !isHeading(told.heading, place.heading)) continue;
            found = *each;
            break;
        }
        m_contents->setCurrentItem(found);
        m_contents->scrollToItem(found);
    }
}

void HelpWindow::open(const ManualPlace& place) {
    show();
    if (isMinimized()) showNormal();
    raise();
    activateWindow();
    m_search->clear();
    m_view->go(m_book.find(place.chapter) ? place : ManualPlace{m_book.chapters().first().name});
    m_view->setFocus();
}

void HelpWindow::leave() {
    if (m_search->text().isEmpty()) {
        close();
        return;
    }
    m_search->clear();
    m_view->setFocus();
}

bool HelpWindow::restorePlace() {
    resize(usualSize);
    return restoreGeometry(Settings().value(geometryKey).toByteArray());
}

void HelpWindow::save() const {
    Settings settings;
    settings.setValue(geometryKey, saveGeometry());
    settings.setValue(partsKey, m_parts->saveState());
    settings.setValue(zoomKey, m_view->zoom());
}

// Distinguishes closing, which hides it, from the end of its owner, which closes nothing.
void HelpWindow::hideEvent(QHideEvent* event) {
    save();
    QWidget::hideEvent(event);
}

}  // namespace drillwave
