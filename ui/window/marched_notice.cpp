// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/marched_notice.h"

#include <QPushButton>

#include "ui/window/page_tabs.h"

namespace drillwave {

MarchedNotice::MarchedNotice(PageTabs& pages, QWidget* parent)
    : Notice(Tone::information, parent), m_pages(pages) {
    setObjectName(QStringLiteral("marchedBlow"));
    QPushButton* single =
        addButton(tr("Single blow"), tr("Show the blow again that begins at rest, as in Result"));
    single->setObjectName(QStringLiteral("singleBlow"));
    const auto leave = [this] {
        forget();
        emit singleWanted();
    };
    connect(single, &QPushButton::clicked, this, leave);
    connect(this, &Notice::dismissed, this, leave);
    connect(&pages, &QStackedWidget::currentChanged, this, &MarchedNotice::follow);
}

void MarchedNotice::open(const MarchedQuestion& blow, const QString& what) {
    m_blow = blow;
    setText(what);
    follow();
}

void MarchedNotice::forget() {
    m_blow.reset();
    hide();
}

std::optional<MarchedQuestion> MarchedNotice::blowOf(const Page& page) const {
    return page.showsMarched() ? m_blow : std::nullopt;
}

void MarchedNotice::follow() {
    setVisible(m_pages.count() > 0 && blowOf(m_pages.current()).has_value());
}

}  // namespace drillwave
