// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/taken_notice.h"

#include <QPushButton>

#include "ui/window/page_tabs.h"

namespace drillwave {

TakenNotice::TakenNotice(Document& document, QWidget* parent)
    : Notice(Tone::information, parent), m_document(document) {
    setObjectName(QStringLiteral("taken"));
    QPushButton* undo = addButton(tr("Undo"), tr("Take the value back"));
    undo->setObjectName(QStringLiteral("undoTaken"));
    connect(undo, &QPushButton::clicked, this, [this] {
        if (m_document.undoStack().index() == m_step) m_document.undoStack().undo();
    });
    connect(&document, &Document::stateChanged, this, [this] {
        if (m_document.undoStack().index() != m_step) hide();
    });
    connect(&document, &Document::replaced, this, &QWidget::hide);
}

void TakenNotice::follow(PageTabs& pages) {
    for (int index = 0; index < pages.count(); ++index) {
        const Page& page = pages.page(index);
        connect(&page, &Page::valuesTaken, this, [this, &page](const QString& what) {
            m_step = m_document.undoStack().index();
            say(tr("%1: %2.").arg(page.title(), what));
        });
    }
}

}  // namespace drillwave
